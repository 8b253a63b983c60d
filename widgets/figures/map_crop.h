// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace nadir {

/// Which part of a map a figure shows: an option whose text is "all", "40" or "40@12.5,-30" (40 m across, in the middle of what
/// the figure shows by itself, or around a point of the plane).
struct MapCrop {
  double width_m = 0.0;  ///< Ground across the map; 0: all that belongs to the figure.
  std::optional<Eigen::Vector2d> centre_in_enu_m = {};

  static constexpr double kLeastWidthM =
      0.1;  ///< Less is no ground that a map shows, and no ticks fit.
  static constexpr double kMostM = 1e6;
  static constexpr std::string_view kForm = "WIDTH[@EAST,NORTH]";

  [[nodiscard]] bool is_all() const { return width_m == 0.0; }
  /// @errors kInvalidOptions: "'40,3' is neither all, WIDTH nor WIDTH@EAST,NORTH in metres".
  [[nodiscard]] static Result<MapCrop> from_text(std::string_view text);
  [[nodiscard]] std::string text() const;
  /// @errors kInvalidOptions: "a width of 0.01 m is not in [0.1, 1e+06]".
  [[nodiscard]] Result<void> check() const;
  friend bool operator==(const MapCrop&, const MapCrop&) = default;
};

}  // namespace nadir
