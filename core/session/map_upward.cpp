// SPDX-License-Identifier: Apache-2.0
#include "core/session/map_upward.h"

#include <charconv>
#include <cmath>
#include <numbers>

#include "core/base/angle.h"

namespace nadir {

MapUpward MapUpward::of(const MapLook& look) {
  if (look.up != MapUp::kFree) return {look.up, 0.0};
  return {MapUp::kFree, compass_deg_from_yaw(Angle::radians(look.up_rad))};
}

Result<MapUpward> MapUpward::from_text(std::string_view text) {
  if (text == enum_name(MapUp::kNorth)) return MapUpward{MapUp::kNorth, 0.0};
  if (text == enum_name(MapUp::kHeading)) return MapUpward{MapUp::kHeading, 0.0};
  double course_deg = 0.0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, course_deg);
  if (text.empty() || error != std::errc() || rest != end || !std::isfinite(course_deg)) {
    return fail(ErrorCode::kInvalidOptions,
                "'{}' is neither north, heading nor a course in degrees", text);
  }
  course_deg = std::fmod(course_deg, 360.0);
  if (course_deg < 0.0) course_deg += 360.0;
  return MapUpward{MapUp::kFree, course_deg < 360.0 ? course_deg : 0.0};
}

std::string MapUpward::text() const {
  return up == MapUp::kFree ? fmt::format("{}", compass_deg) : std::string(enum_name(up));
}

double MapUpward::up_rad(double heading_rad) const {
  constexpr double kNorthRad = std::numbers::pi / 2.0;
  if (up == MapUp::kNorth) return kNorthRad;
  return up == MapUp::kHeading ? heading_rad
                               : wrap_rad(kNorthRad - Angle::degrees(compass_deg).radians());
}

}  // namespace nadir
