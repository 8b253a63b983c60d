// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace nadir {

/// A class of ground cover or object: the thesis's ids (Rouben 2018, table 3.1), or kUnclassified.
using ClassId = std::uint8_t;

enum SemanticClass : ClassId {
  kRoad = 0,
  kSidewalk = 1,
  kBuilding = 2,
  kFence = 3,
  kPole = 4,
  kTrafficLight = 5,
  kTrafficSign = 6,
  kVegetation = 7,
  kTerrain = 8,
  kSky = 9,
  kPedestrian = 10,
  kCar = 11,
  kRailing = 12,
  kCurb = 13,
  kLaneMarking = 14,
  kStreetLight = 15,
  kUnclassified = 255,
};

inline constexpr int kClassCount = 16;

struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;
  friend bool operator==(const Colour&, const Colour&) = default;
};

struct ClassInfo {
  std::string_view name;  ///< "lane marking": plain words, singular.
  Colour colour;          ///< From resources/palettes/classes.csv.
};

/// Name and colour of a class, or "unclassified" and black for any id that is no class.
[[nodiscard]] const ClassInfo& class_info(ClassId id);
/// By name; case, '-' , '_' and a plural s do not matter ("Lane Markings").
[[nodiscard]] std::optional<ClassId> class_from_name(std::string_view name);

/// What class_from_name compares: lower case without ' ', '-', '_' and a last 's'.
[[nodiscard]] std::string plain_class_name(std::string_view name);

/// Whether a thing of this class can show in an overhead at all; the sky cannot, so its points
/// never vote in a topview.
[[nodiscard]] constexpr bool can_lie_in_overhead(ClassId id) {
  return id < kClassCount && id != kSky;
}
/// Things that move or may be gone tomorrow: no map holds them.
[[nodiscard]] constexpr bool is_movable(ClassId id) { return id == kCar || id == kPedestrian; }

/// Where classes lie over each other the one of the higher level is seen. From 0: areas first, then what stands on them, then
/// lines, then single things, for what is thin would otherwise vanish; kClassCount for any id that is no class.
[[nodiscard]] int drawing_level(ClassId id);

}  // namespace nadir
