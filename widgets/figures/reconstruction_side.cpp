// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/reconstruction_side.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/base/require.h"
#include "widgets/figures/run_on_map.h"
#include "widgets/views/raster_pictures.h"

namespace nadir {
namespace {

/// Cells from the first to the last pose, at most: more would take gigabytes, and show no more on a page ...
constexpr double kMostCellsOfPoses = 8192.0;
/// ... and with what was seen around them, which every graphics driver draws.
constexpr double kMostCellsDrawn = 16'384.0;
/// No cell of a topview is farther from the body: its indices have 16 bits.
constexpr double kFarthestSeenCells = 65'536.0;

/// Whether a reconstruction in cells of that size has room for what is seen so far away.
bool has_room(const PoseReach& reach, double seen_cell_m, double cell_m) {
  return reach.farthest_m() + kFarthestSeenCells * seen_cell_m <=
         SemanticReconstruction::kFarthestCell * cell_m;
}

/// No cell of the topview reaches farther from the body, metres.
double radius_of(const SemanticTopview& seen) {
  int most = 0;
  for (const TopviewCell& cell : seen.cells) {
    most = std::max({most, std::abs(int{cell.forward}), std::abs(int{cell.left})});
  }
  return std::hypot(1.0, 1.0) * (most + 1) * seen.metres_per_cell;
}

}  // namespace

void PoseReach::include(const Eigen::Vector2d& point_in_enu_m) {
  if (point_in_enu_m.allFinite()) bounds_in_enu_m_.extend(point_in_enu_m);
}

double PoseReach::span_m() const {
  return bounds_in_enu_m_.isEmpty() ? 0.0 : bounds_in_enu_m_.sizes().maxCoeff();
}

double PoseReach::farthest_m() const {
  if (bounds_in_enu_m_.isEmpty()) return 0.0;
  return std::max(bounds_in_enu_m_.min().cwiseAbs().maxCoeff(),
                  bounds_in_enu_m_.max().cwiseAbs().maxCoeff());
}

double reconstruction_cell_m(const PoseReach& reach, double seen_cell_m) {
  NADIR_REQUIRE(seen_cell_m > 0.0);
  double cell_m = seen_cell_m;
  while (reach.span_m() > kMostCellsOfPoses * cell_m || !has_room(reach, seen_cell_m, cell_m)) {
    cell_m *= 2.0;
  }
  return cell_m;
}

ReconstructionSide::ReconstructionSide(std::unique_ptr<MapPanel> map,
                                       Source source,
                                       double metres_per_cell)
    : map_(std::move(map)),
      source_(source),
      seen_(metres_per_cell),
      view_(map_->scene(), MapLayer::kReconstruction) {
  view_.set_visible(false);
  map_->fade_labels();
}

void ReconstructionSide::clear() {
  reach_ = {};
  seen_ = SemanticReconstruction(seen_.metres_per_cell());
  counts_ = {};
  is_changed_ = true;
}

Result<void> ReconstructionSide::add(const RunStep& step, const OverheadMap& labels) {
  const auto pose = pose_of(step, source_);
  if (!pose || !step.topview || step.topview->cells.empty()) return {};
  const SemanticTopview& seen = *step.topview;
  const Eigen::Vector2d around = Eigen::Vector2d::Constant(radius_of(seen));
  PoseReach reach = reach_;
  reach.include(pose->translation_m() - around);
  reach.include(pose->translation_m() + around);
  const double cell_m = seen_.metres_per_cell();
  if (reach.span_m() > kMostCellsDrawn * cell_m || !has_room(reach, seen.metres_per_cell, cell_m)) {
    return fail(ErrorCode::kUnsupported,
                "its topviews reach over {:.0f} m, too far to be drawn in cells of {} m",
                reach.span_m(), cell_m);
  }
  reach_ = reach;
  is_changed_ = true;
  seen_.add(seen, *pose);
  if (unlike_cells(seen, labels)) {
    for (ClassId id = 0; id < kClassCount; ++id) {
      counts_.at(id).unknown += static_cast<std::uint32_t>(seen.of_class(id).size());
    }
    return {};
  }
  const CellAgreement agreement = cell_agreement(seen, labels, *pose);
  for (ClassId id = 0; id < kClassCount; ++id) {
    counts_.at(id).agreeing += agreement.of_class.at(id).agreeing;
    counts_.at(id).disagreeing += agreement.of_class.at(id).disagreeing;
    counts_.at(id).unknown += agreement.of_class.at(id).unknown;
  }
  return {};
}

Result<void> ReconstructionSide::refresh() {
  if (!is_changed_) return {};
  is_changed_ = false;
  view_.set_visible(!seen_.empty());
  if (seen_.empty()) return {};
  const auto labels = seen_.labels();
  if (!labels) return forward_error(labels);
  const Eigen::Vector2d corner = seen_.top_left_in_enu_m();
  view_.show(class_picture(*labels), {corner.x(), corner.y(), 0.0},
             Eigen::Vector2d::Constant(seen_.metres_per_cell()), false);
  return {};
}

}  // namespace nadir
