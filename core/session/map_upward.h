// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/session/view_state.h"

namespace nadir {

/// What is up on a map: an option whose text is "north", "heading" (of the estimate), or a compass course in degrees ("90":
/// east is up).
struct MapUpward {
  MapUp up = MapUp::kNorth;
  double compass_deg = 0.0;  ///< In [0, 360); of kFree.

  static constexpr std::string_view kForm = "north|heading|DEGREES";

  /// @param look  Resolved.
  [[nodiscard]] static MapUpward of(const MapLook& look);
  /// @errors kInvalidOptions: "'up' is neither north, heading nor a course in degrees".
  [[nodiscard]] static Result<MapUpward> from_text(std::string_view text);
  [[nodiscard]] std::string text() const;
  [[nodiscard]] Result<void> check() const { return {}; }

  /// Counter-clockwise from east, as MapCamera::up_rad. @param heading_rad  Likewise, for kHeading.
  [[nodiscard]] double up_rad(double heading_rad) const;
  friend bool operator==(const MapUpward&, const MapUpward&) = default;
};

}  // namespace nadir
