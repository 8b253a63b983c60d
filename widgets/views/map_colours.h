// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "widgets/views/theme.h"

namespace nadir {

/// The colour with its own opacity times a share.
[[nodiscard]] Rgba faded(Rgba colour, double share);

/// "#RRGGBB" as a colour; nothing for anything else.
[[nodiscard]] std::optional<Rgba> colour_from_hex(const std::string& text);

/// The lightest colour of the theme over imagery, of what is no line of a run: graticules, rims of what is dark.
[[nodiscard]] Rgba light_on_imagery(const Theme& theme);

/// What lies under a line over imagery, so that the line stands out from it: the theme's dark casing, or its lightest colour
/// under a line that is dark itself.
[[nodiscard]] Rgba casing_over_imagery(const Theme& theme, Rgba line);

}  // namespace nadir
