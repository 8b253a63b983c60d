// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/particle_view.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

#include "widgets/views/theme.h"

namespace nadir {
namespace {

/// A hundred particles are opaque, ten thousand let the ground through.
double opacity_for(std::size_t count) {
  constexpr double kOpaqueUpTo = 100.0;
  return std::clamp(std::pow(kOpaqueUpTo / std::max(1.0, static_cast<double>(count)), 0.25), 0.25,
                    1.0);
}

}  // namespace

ParticleView::ParticleView(MapScene& scene) : scene_(scene) {
  mapper_->SetInputData(cloud_);
  mapper_->SetScalarModeToUseCellData();
  actor_->SetMapper(mapper_);
  actor_->GetProperty()->LightingOff();
  actor_->ForceTranslucentOn();
  scene_.add(*actor_, MapLayer::kParticles);
}

ParticleView::~ParticleView() { scene_.remove(*actor_); }

void ParticleView::show(const ParticleSet& particles, const ParticleLook& look) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> dots;
  vtkNew<vtkCellArray> ticks;
  std::vector<Rgba> colours;
  const std::size_t stride =
      std::max<std::size_t>(1, (particles.size() + look.most_drawn - 1) / look.most_drawn);
  const double heaviest = particles.weight.empty()
                              ? 1.0
                              : *std::max_element(particles.weight.begin(), particles.weight.end());
  const double opacity = opacity_for(particles.size() / stride);
  drawn_ = 0;
  std::vector<Eigen::Vector3d> heads;
  for (std::size_t i = 0; i < particles.size(); i += stride) {
    const Eigen::Vector2d point(particles.x_in_enu_m[i], particles.y_in_enu_m[i]);
    const double yaw = particles.yaw_rad[i];
    if (!point.allFinite() || !std::isfinite(yaw)) continue;
    const Eigen::Vector3d at = scene_.scene_from_enu(point, MapLayer::kParticles);
    const vtkIdType id = points->InsertNextPoint(at.data());
    dots->InsertNextCell(1, &id);
    colours.push_back(with_opacity(
        value_colour(ValueColours::kViridis, heaviest > 0.0 ? particles.weight[i] / heaviest : 1.0),
        opacity));
    heads.emplace_back(at + look.heading_m * Eigen::Vector3d(std::cos(yaw), std::sin(yaw), 0.0));
    ++drawn_;
  }
  // Cells are coloured in the order dots, then lines.
  const std::size_t count = heads.size();
  for (std::size_t i = 0; look.heading_m > 0.0 && i < count; ++i) {
    const std::array<vtkIdType, 2> ends = {static_cast<vtkIdType>(i),
                                           points->InsertNextPoint(heads[i].data())};
    ticks->InsertNextCell(2, ends.data());
    colours.push_back(colours[i]);
  }
  vtkNew<vtkUnsignedCharArray> scalars;
  scalars->SetNumberOfComponents(4);
  scalars->SetNumberOfTuples(static_cast<vtkIdType>(colours.size()));
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const Rgba colour = colours[i];
    const std::array<unsigned char, 4> tuple = {colour.red, colour.green, colour.blue,
                                                colour.alpha};
    scalars->SetTypedTuple(static_cast<vtkIdType>(i), tuple.data());
  }
  cloud_->Initialize();
  cloud_->SetPoints(points);
  cloud_->SetVerts(dots);
  cloud_->SetLines(ticks);
  cloud_->GetCellData()->SetScalars(scalars);
  actor_->GetProperty()->SetPointSize(static_cast<float>(look.size_px));
}

void ParticleView::set_visible(bool visible) { actor_->SetVisibility(visible ? 1 : 0); }

}  // namespace nadir
