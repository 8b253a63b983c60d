// SPDX-License-Identifier: Apache-2.0
#include "core/insight/view_footprint.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/angle.h"
#include "core/base/require.h"

namespace nadir {
namespace {

constexpr double kPixelsOfFan = 4.0;
constexpr double kWallM = 6.0;
constexpr double kPostM = 4.0;
constexpr double kFenceM = 1.1;

/// By class, and 0 for any id that is none.
std::array<float, 256> heights_of_classes() {
  std::array<float, 256> heights{};
  for (ClassId id = 0; id < kClassCount; ++id) {
    heights[id] = static_cast<float>(class_height_m(id));
  }
  return heights;
}

}  // namespace

double class_height_m(ClassId id) {
  switch (id) {
    case kBuilding:
      return kWallM;
    case kFence:
    case kRailing:
      return kFenceM;
    case kPole:
    case kTrafficLight:
    case kTrafficSign:
    case kStreetLight:
      return kPostM;
    default:
      return 0.0;
  }
}

Result<ViewFootprint> ViewFootprint::create(const CameraModel& camera,
                                            double height_m,
                                            const TopviewOptions& topview,
                                            double metres_per_cell) {
  if (const auto valid = validate(camera); !valid) return forward_error(valid);
  if (const auto valid = validate(topview); !valid) return forward_error(valid);
  if (!(height_m > 0.0 && height_m <= kWallM)) {
    return fail(ErrorCode::kInvalidOptions, "a camera {} m above the ground is not in (0, {}] m",
                height_m, kWallM);
  }
  if (!(metres_per_cell > 0.0) || topview.max_range_m / metres_per_cell > kMaxTopviewReachCells) {
    return fail(ErrorCode::kInvalidOptions, "topview: {} m per cell does not fit a range of {} m",
                metres_per_cell, topview.max_range_m);
  }
  ViewFootprint result;
  result.metres_per_cell_ = metres_per_cell;
  result.reach_m_ = topview.max_range_m + metres_per_cell;
  result.fans_ = static_cast<int>(std::ceil(camera.width / kPixelsOfFan));
  result.camera_height_m_ = static_cast<float>(height_m);
  result.least_votes_ = static_cast<float>(topview.min_votes);
  result.lowest_ = static_cast<float>(-(camera.height - camera.centre_y_px) / camera.focal_y_px);
  result.highest_ = static_cast<float>(camera.centre_y_px / camera.focal_y_px);
  result.pixels_of_width_ = static_cast<float>(camera.focal_x_px * metres_per_cell);
  result.pixels_of_elevation_ = static_cast<float>(camera.focal_y_px);
  const double leftmost = camera.centre_x_px / camera.focal_x_px;
  const double rightmost = (camera.width - camera.centre_x_px) / camera.focal_x_px;
  result.half_view_rad_ = std::atan(std::max({leftmost, rightmost, 0.0}));
  const int reach = static_cast<int>(std::ceil(topview.max_range_m / metres_per_cell));
  const auto fan_of = [&](double left_m, double depth_m) {
    return (camera.centre_x_px - camera.focal_x_px * left_m / depth_m) / kPixelsOfFan;
  };
  const auto whole = [&](double fan) {
    return static_cast<std::uint16_t>(std::clamp(fan, 0.0, result.fans_ - 1.0));
  };
  for (int forward = 0; forward < reach; ++forward) {
    const double depth_m = (forward + 0.5) * metres_per_cell;
    const double near_m = std::max(forward * metres_per_cell, 0.5 * metres_per_cell);
    const double elevation = -height_m / depth_m;
    const double votes = camera.focal_x_px * camera.focal_y_px * height_m * metres_per_cell *
                         metres_per_cell / (depth_m * depth_m * depth_m);
    FanRow row{.rightmost = {},
               .first = result.fans_of_cell_.size(),
               .count = 0,
               .is_ground_seen = votes >= topview.min_votes &&
                                 elevation >= static_cast<double>(result.lowest_) &&
                                 elevation <= static_cast<double>(result.highest_),
               .depth_m = static_cast<float>(depth_m),
               .ground_elevation = static_cast<float>(elevation)};
    for (int left = -reach; left < reach; ++left) {
      const double left_m = (left + 0.5) * metres_per_cell;
      const double away_m = std::hypot(depth_m, left_m);
      const double fan = fan_of(left_m, depth_m);
      if (away_m > topview.max_range_m || !(fan >= 0.0 && fan < result.fans_)) continue;
      if (row.count++ == 0) {
        row.rightmost = {static_cast<std::int16_t>(2 * forward + 1),
                         static_cast<std::int16_t>(2 * left + 1)};
      }
      const double first = fan_of(left_m + 0.5 * metres_per_cell, near_m);
      const double last = fan_of(left_m - 0.5 * metres_per_cell, near_m);
      result.fans_of_cell_.push_back(
          {whole(std::min(first, fan)), whole(fan), whole(std::max(last, fan))});
      if (row.is_ground_seen) {
        result.ground_reach_m_ = std::max(result.ground_reach_m_, away_m + metres_per_cell);
      }
    }
    if (row.count > 0) result.rows_.push_back(row);
  }
  return result;
}

bool ViewFootprint::raise(const FanRow& row,
                          const CellFans& fans,
                          float height_m,
                          std::vector<float>& horizon) const {
  const float top = (height_m - camera_height_m_) / row.depth_m;
  const float from = std::max({horizon[fans.middle], lowest_, row.ground_elevation});
  const float height_px = (std::min(top, highest_) - from) * pixels_of_elevation_;
  for (std::size_t fan = fans.first; fan <= fans.last; ++fan) {
    horizon[fan] = std::max(horizon[fan], top);
  }
  return height_px > 0.0F && height_px * pixels_of_width_ / row.depth_m >= least_votes_;
}

void ViewFootprint::see(const OverheadMap& map,
                        const Rigid2& enu_from_body,
                        SeenCells& seen) const {
  NADIR_REQUIRE(std::abs(map.metres_per_cell - metres_per_cell_) < 1e-9 * metres_per_cell_);
  static const std::array<float, 256> heights = heights_of_classes();
  for (auto& cells : seen) cells.clear();
  const FixedPose pose = fixed_pose(enu_from_body, map);
  std::vector<float> horizon(static_cast<std::size_t>(fans_),
                             -std::numeric_limits<float>::infinity());
  const auto width = static_cast<std::uint32_t>(map.labels.width());
  const auto height = static_cast<std::uint32_t>(map.labels.height());
  const ClassId* const labels = map.labels.data();
  for (const FanRow& fan_row : rows_) {
    // The numbers of place_of(), from cell to cell by addition.
    const HalfCell& rightmost = fan_row.rightmost;
    std::int32_t column =
        pose.base_column + pose.cos * rightmost.forward - pose.sin * rightmost.left;
    std::int32_t row = pose.base_row - pose.sin * rightmost.forward - pose.cos * rightmost.left;
    const CellFans* fans = fans_of_cell_.data() + fan_row.first;
    for (std::size_t i = 0; i < fan_row.count; ++i, ++fans) {
      // The kernel's raster has a border of a cell; what lies beyond the map on either side comes out as too large.
      const auto map_column = static_cast<std::uint32_t>((column >> kFractionBits) - 1);
      const auto map_row = static_cast<std::uint32_t>((row >> kFractionBits) - 1);
      column -= 2 * pose.sin;
      row -= 2 * pose.cos;
      if (map_column >= width || map_row >= height) continue;
      const ClassId id = labels[std::size_t{map_row} * width + map_column];
      const bool is_seen = heights[id] > 0.0F
                               ? raise(fan_row, *fans, heights[id], horizon)
                               : fan_row.is_ground_seen && id < kClassCount &&
                                     fan_row.ground_elevation > horizon[fans->middle];
      if (!is_seen) continue;
      seen[id].push_back(
          {rightmost.forward, static_cast<std::int16_t>(rightmost.left + 2 * static_cast<int>(i))});
    }
  }
}

SemanticTopview ViewFootprint::topview(const OverheadMap& map, const Rigid2& enu_from_body) const {
  SeenCells seen;
  see(map, enu_from_body, seen);
  SemanticTopview topview;
  topview.metres_per_cell = metres_per_cell_;
  for (std::size_t id = 0; id < seen.size(); ++id) {
    if (can_lie_in_overhead(static_cast<ClassId>(id))) {
      for (const HalfCell& cell : seen[id]) {
        topview.cells.push_back({static_cast<std::int16_t>((cell.forward - 1) / 2),
                                 static_cast<std::int16_t>((cell.left - 1) / 2)});
      }
    }
    topview.class_begin[id + 1] = static_cast<std::uint32_t>(topview.cells.size());
  }
  return topview;
}

bool ViewFootprint::may_reach(const PlaneBounds& bounds,
                              const Rigid2& enu_from_body,
                              double range_m,
                              double margin_m) const {
  if (bounds.is_empty) return false;
  const Eigen::Vector2d body = enu_from_body.translation_m();
  const double most_m = margin_m + metres_per_cell_;
  if ((body - body.cwiseMax(bounds.low).cwiseMin(bounds.high)).norm() > range_m + most_m) {
    return false;
  }
  // The fan is convex: a rectangle that lies wholly beyond one of its three borders is that far away from it.
  const Rigid2 body_from_enu = enu_from_body.inverse();
  const double sine = std::sin(half_view_rad_);
  const double cosine = std::cos(half_view_rad_);
  double beyond_left_m = std::numeric_limits<double>::infinity();
  double beyond_right_m = beyond_left_m;
  double behind_m = beyond_left_m;
  for (const double x_m : {bounds.low.x(), bounds.high.x()}) {
    for (const double y_m : {bounds.low.y(), bounds.high.y()}) {
      const Eigen::Vector2d corner = body_from_enu * Eigen::Vector2d(x_m, y_m);
      beyond_left_m = std::min(beyond_left_m, corner.y() * cosine - corner.x() * sine);
      beyond_right_m = std::min(beyond_right_m, -corner.y() * cosine - corner.x() * sine);
      behind_m = std::min(behind_m, -corner.x());
    }
  }
  return std::max({beyond_left_m, beyond_right_m, behind_m}) <= most_m;
}

}  // namespace nadir
