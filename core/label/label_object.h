// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/field.h"
#include "core/base/result.h"
#include "core/label/label_grid.h"
#include "core/map/semantic_classes.h"

namespace nadir {

/// Names an object in its document for ever: no other gets the number of one that was deleted. From 1.
using ObjectId = std::int64_t;

enum class ObjectKind {
  kArea,     ///< Inside of a ring, without the insides of further ones.
  kLine,     ///< Within half a width of a polyline: road, curb, lane marking.
  kOutline,  ///< As an area, but only a rim of it is of the class and its inside is unclassified: building, wall.
};
template <>
struct EnumNames<ObjectKind> {
  static constexpr std::array<std::string_view, 3> kNames = {"area", "line", "outline"};
};

/// Points in enu, metres. Where it is a closed ring its first point is not repeated.
using Ring = std::vector<Eigen::Vector2d>;

/// One thing that was drawn. Rings may cross themselves and each other: inside is what an odd number of them surrounds.
struct LabelObject {
  ObjectId id = 0;
  ObjectKind kind = ObjectKind::kArea;
  ClassId class_id = kUnclassified;  ///< kUnclassified takes away what lies below.
  std::int64_t order = 0;            ///< Higher covers lower; among equal ones the higher id.
  double width_m = 0.0;  ///< Whole width of a line, thickness of an outline inwards; 0 of an area.
  std::vector<Ring> rings;  ///< Of an area or outline: its border, then holes. Of a line: itself.
  std::string note;
  friend bool operator==(const LabelObject&, const LabelObject&) = default;
};

// What an object may have; farther out, or thicker, a coordinate or a unit is mistaken.
inline constexpr double kMostObjectCoordinateM = 1e6;
inline constexpr double kMostObjectWidthM = 1e4;

/// @errors kMalformed: a number that is not finite or too large, too few places (3 different ones a ring, 2 a line), more
/// than one polyline, a class that no overhead can hold, a width that the kind must have or has not. Begins with kind and
/// id: "line 12: ...".
[[nodiscard]] Result<void> check_object(const LabelObject& object);

/// Where the object draws anything, at any resolution but for half a cell.
[[nodiscard]] PlaneBounds drawn_bounds(const LabelObject& object);

/// Classes are drawn in levels, those of drawing_level(), with unclassified, which takes away, above all. Objects get their
/// place in the level of their class unless somebody raises or lowers them.
inline constexpr std::int64_t kOrdersPerLevel = std::int64_t{1} << 40U;
/// Between neighbours, so that there is room to put others between them.
inline constexpr std::int64_t kOrderStep = std::int64_t{1} << 20U;
[[nodiscard]] constexpr std::int64_t level_of_order(std::int64_t order) {
  return order >> 40U;  // Rounds down, also below 0.
}

}  // namespace nadir
