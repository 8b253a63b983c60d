// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/geo/affine2.h"

namespace nadir {

/// The text of a world file (.wld, .pgw, .jgw, .tfw): six numbers, one a line, in the order A D B E C F, where C and F are
/// the *centre* of the upper-left pixel, half a pixel from where Affine2 begins. It names no reference system.

/// @param name  Stands for the file in messages.
/// @errors kMalformed: not six finite numbers, or numbers that give all pixels one place.
[[nodiscard]] Result<Affine2> parse_world_file(std::string_view text, const std::string& name);
/// With 17 digits, so that it comes back to the last bit but for half a pixel's rounding.
[[nodiscard]] std::string world_file_text(const Affine2& plane_from_pixels);

}  // namespace nadir
