// SPDX-License-Identifier: Apache-2.0
#include "core/map/overhead_map.h"

#include <cmath>

#include "core/base/hash.h"
#include "core/map/class_statistics.h"

namespace nadir {
namespace {

/// Whether a point in cells lies on the raster: the left and upper edges belong to it, the right
/// and lower do not.
bool is_on(const Raster<ClassId>& labels, const Eigen::Vector2d& point_in_overhead) {
  // Written so that NaN is outside.
  return point_in_overhead.x() >= 0.0 && point_in_overhead.y() >= 0.0 &&
         point_in_overhead.x() < labels.width() && point_in_overhead.y() < labels.height();
}

}  // namespace

bool OverheadMap::contains(const Eigen::Vector2d& point_in_enu_m) const {
  return is_on(labels, overhead_from_enu(point_in_enu_m));
}

ClassId OverheadMap::class_at(const Eigen::Vector2d& point_in_enu_m) const {
  const Eigen::Vector2d point_in_overhead = overhead_from_enu(point_in_enu_m);
  if (!is_on(labels, point_in_overhead)) return kUnclassified;
  return labels.at(static_cast<int>(point_in_overhead.x()),
                   static_cast<int>(point_in_overhead.y()));
}

std::string content_hash(const OverheadMap& map) {
  return Hash()
      .add_number(map.plane.origin().latitude_deg)
      .add_number(map.plane.origin().longitude_deg)
      .add(map.top_left_in_enu_m.data(), 2 * sizeof(double))
      .add_number(map.metres_per_cell)
      .add_number(map.labels.width())
      .add(map.labels.data(), map.labels.size())
      .text();
}

Result<void> check_usable_for_localising(const OverheadMap& map) {
  if (!(map.metres_per_cell > 0.0 && std::isfinite(map.metres_per_cell))) {
    return fail(ErrorCode::kMalformed,
                "{}: its resolution of {} metres per cell is not a positive number", map.name,
                map.metres_per_cell);
  }
  if (!map.top_left_in_enu_m.allFinite()) {
    return fail(ErrorCode::kMalformed, "{}: its place is not finite", map.name);
  }
  const ClassStatistics statistics = class_statistics(map.labels);
  if (statistics.classified_cells == 0) {
    return fail(ErrorCode::kMalformed, "{}: no cell has a class", map.name);
  }
  if (statistics.present_classes() == 1) {
    ClassId only = 0;
    while (statistics.cells[only] == 0) ++only;
    return fail(ErrorCode::kMalformed, "{}: only one class ({}), so every place looks the same",
                map.name, class_info(only).name);
  }
  return {};
}

}  // namespace nadir
