// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/space_lines.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkProperty.h>

#include <algorithm>

#include "core/base/require.h"

namespace nadir {

SpaceLines::SpaceLines(SpaceScene& scene, SpaceLayer layer, Rgba colour, double width_pt)
    : scene_(scene), width_pt_(width_pt) {
  mapper_->SetInputData(lines_);
  actor_->SetMapper(mapper_);
  vtkProperty* const look = actor_->GetProperty();
  look->LightingOff();
  look->SetColor(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
  if (layer == SpaceLayer::kSolid) {
    actor_->ForceOpaqueOn();
  } else {
    look->SetOpacity(colour.alpha / 255.0);
    actor_->ForceTranslucentOn();
  }
  scene_.add(*actor_, layer);
  scene_.attach(*this);
}

SpaceLines::~SpaceLines() {
  scene_.detach(*this);
  scene_.remove(*actor_);
}

void SpaceLines::show(std::span<const SpacePath> paths_in_enu_m) {
  const vtkNew<vtkPoints> points;
  const vtkNew<vtkCellArray> lines;
  std::vector<vtkIdType> piece;
  const auto finish = [&] {
    if (piece.size() > 1) {
      lines->InsertNextCell(static_cast<vtkIdType>(piece.size()), piece.data());
    }
    piece.clear();
  };
  for (const SpacePath& path : paths_in_enu_m) {
    for (const Eigen::Vector3d& point : path) {
      if (!point.allFinite()) {
        finish();
        continue;
      }
      const Eigen::Vector3d in_scene = scene_.scene_from_enu(point);
      piece.push_back(points->InsertNextPoint(in_scene.data()));
    }
    finish();
  }
  lines_->Initialize();
  if (lines->GetNumberOfCells() == 0) return;
  lines_->SetPoints(points);
  lines_->SetLines(lines);
}

void SpaceLines::set_visible(bool visible) { actor_->SetVisibility(visible ? 1 : 0); }

void SpaceLines::set_px_per_pt(double px_per_pt) {
  actor_->GetProperty()->SetLineWidth(static_cast<float>(std::max(1.0, width_pt_ * px_per_pt)));
}

SpacePath on_ground(std::span<const Eigen::Vector2d> points_in_enu_m) {
  SpacePath path;
  path.reserve(points_in_enu_m.size());
  for (const Eigen::Vector2d& point : points_in_enu_m) path.emplace_back(point.x(), point.y(), 0.0);
  return path;
}

std::vector<SpacePath> dashes_of(const SpacePath& path, double dash_m, double gap_m) {
  NADIR_REQUIRE(dash_m > 0.0 && gap_m > 0.0);
  constexpr double kMostPieces =
      1e5;  // of one stretch: a pose far away is no reason to draw for ever
  std::vector<SpacePath> dashes;
  bool is_drawn = false;
  double left_m = 0.0;  // of the dash or gap that we are in
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Eigen::Vector3d& from = path[i];
    const Eigen::Vector3d& to = path[i + 1];
    if (!from.allFinite() || !to.allFinite()) {
      is_drawn = false;
      left_m = 0.0;
      continue;
    }
    const double length_m = (to - from).norm();
    if (length_m > kMostPieces * (dash_m + gap_m)) {
      is_drawn = false;  // nor is it a reason to join what lies before it and after it
      left_m = 0.0;
      continue;
    }
    if (is_drawn) dashes.back().push_back(from);
    double at_m = 0.0;
    while (at_m + left_m < length_m) {
      at_m += left_m;
      const Eigen::Vector3d place = from + (to - from) * (at_m / length_m);
      if (is_drawn) {
        dashes.back().push_back(place);
      } else {
        dashes.push_back({place});
      }
      is_drawn = !is_drawn;
      left_m = is_drawn ? dash_m : gap_m;
    }
    left_m -= length_m - at_m;
    if (is_drawn) dashes.back().push_back(to);
  }
  return dashes;
}

}  // namespace nadir
