// SPDX-License-Identifier: Apache-2.0
#include "core/label/label_object.h"

#include <algorithm>
#include <cmath>

namespace nadir {
namespace {

/// Far outside of any raster, where cells can still be counted.
constexpr double kMostCell = 4e15;

bool is_sound_place(const Eigen::Vector2d& point) {
  // Written so that NaN is refused.
  return std::abs(point.x()) <= kMostObjectCoordinateM &&
         std::abs(point.y()) <= kMostObjectCoordinateM;
}

/// How many places differ from the one before, up to three; a closed ring's last counts as before its first.
std::size_t different_places(const Ring& ring, bool is_closed) {
  std::size_t count = ring.empty() ? 0 : 1;
  for (std::size_t i = 1; i < ring.size(); ++i) count += ring[i] != ring[i - 1] ? 1 : 0;
  if (is_closed && ring.size() > 1 && ring.front() == ring.back() && count > 1) --count;
  return count;
}

Result<void> check_rings(const LabelObject& object) {
  const bool is_line = object.kind == ObjectKind::kLine;
  if (object.rings.empty()) return fail(ErrorCode::kMalformed, "it has no places");
  if (is_line && object.rings.size() > 1) {
    return fail(ErrorCode::kMalformed, "it has {} parts", object.rings.size());
  }
  const std::size_t least = is_line ? 2 : 3;
  for (const Ring& ring : object.rings) {
    if (!std::all_of(ring.begin(), ring.end(), is_sound_place)) {
      return fail(ErrorCode::kMalformed, "it has a place that is not within {:.0f} m of the map",
                  kMostObjectCoordinateM);
    }
    const std::size_t count = different_places(ring, !is_line);
    if (count < least) {
      return fail(ErrorCode::kMalformed, "{} has {} different places, and needs {}",
                  is_line ? "it" : "a ring", count, least);
    }
  }
  return {};
}

Result<void> check_width(const LabelObject& object) {
  if (object.kind == ObjectKind::kArea) {
    if (object.width_m == 0.0) return {};
    return fail(ErrorCode::kMalformed, "an area has no width");
  }
  if (object.width_m > 0.0 && object.width_m <= kMostObjectWidthM) return {};
  return fail(ErrorCode::kMalformed, "its width of {} m is not in (0, {:.0f}]", object.width_m,
              kMostObjectWidthM);
}

Result<void> check_parts(const LabelObject& object) {
  if (object.id < 1) return fail(ErrorCode::kMalformed, "its number is not positive");
  if (object.class_id != kUnclassified && !can_lie_in_overhead(object.class_id)) {
    return fail(ErrorCode::kMalformed, "no overhead can hold its class {}", object.class_id);
  }
  if (const auto width = check_width(object); !width) return forward_error(width);
  return check_rings(object);
}

std::int64_t whole_cell(double cells) {
  return static_cast<std::int64_t>(std::clamp(cells, -kMostCell, kMostCell));
}

}  // namespace

CellRect LabelGrid::cells_of(const PlaneBounds& bounds, std::int64_t margin) const {
  if (bounds.is_empty) return {};
  const Eigen::Vector2d upper_left = cells_from_enu({bounds.low.x(), bounds.high.y()});
  const Eigen::Vector2d lower_right = cells_from_enu({bounds.high.x(), bounds.low.y()});
  return {whole_cell(std::floor(upper_left.x())) - margin,
          whole_cell(std::floor(upper_left.y())) - margin,
          whole_cell(std::floor(lower_right.x())) + 1 + margin,
          whole_cell(std::floor(lower_right.y())) + 1 + margin};
}

Result<void> check_object(const LabelObject& object) {
  const auto checked = check_parts(object);
  if (checked) return {};
  return forward_error(checked, fmt::format("{} {}", enum_name(object.kind), object.id));
}

PlaneBounds drawn_bounds(const LabelObject& object) {
  PlaneBounds bounds;
  for (const Ring& ring : object.rings) {
    for (const Eigen::Vector2d& point : ring) bounds.include(point);
  }
  if (object.kind == ObjectKind::kLine) bounds.grow(object.width_m / 2.0);
  return bounds;
}

}  // namespace nadir
