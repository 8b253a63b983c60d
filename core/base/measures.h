// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "core/base/angle.h"
#include "core/base/result.h"

namespace nadir {

/// Lengths and angles as somebody types them: a number with a decimal point, then a unit or none.

/// "12.5", "3 m", "450mm", "12 ft"; in metres, also where there is no unit. Units: m, km, cm, mm, ft, in, yd.
/// @errors kInvalidOptions, which begins with what was typed: "3 furlongs: is no length (furlongs is none of m, km, ...)".
[[nodiscard]] Result<double> parse_length_m(std::string_view text);
/// "30", "30 deg", "1.5 rad", "100 gon"; in degrees where there is no unit, and a degree sign is one.
/// @errors kInvalidOptions.
[[nodiscard]] Result<Angle> parse_angle(std::string_view text);

}  // namespace nadir
