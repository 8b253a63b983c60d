// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "core/base/field.h"
#include "core/map/semantic_classes.h"
#include "widgets/canvas/canvas.h"

namespace nadir {

enum class ThemeName { kLight, kDark };

template <>
struct EnumNames<ThemeName> {
  static constexpr std::array<std::string_view, 2> kNames = {"light", "dark"};
};

/// Colours of things, the same in the window and in figures, from resources/palettes/themes.csv. What is drawn over a
/// picture or over labels takes the `on_imagery` colour and the casing.
struct Theme {
  Rgba window, page, line, text, muted, accent, good, warning, bad;
  Rgba truth, truth_on_imagery, odometry, odometry_on_imagery, estimate, estimate_on_imagery;
  Rgba second_run, third_run, fourth_run, agreement, disagreement, casing_on_imagery;
};

[[nodiscard]] const Theme& theme(ThemeName name);

/// Runs of one figure look different by their colour and, from the fifth on, by dashes: eight do, the ninth looks like the
/// first. Charts and maps ask here, so that a run looks the same in both. @param run  0 for the first of a figure.
[[nodiscard]] Rgba run_colour(const Theme& theme, std::size_t run);
/// The same run over imagery: its colour there too, on a casing of casing_over_imagery().
[[nodiscard]] Rgba run_colour_on_imagery(const Theme& theme, std::size_t run);
[[nodiscard]] bool is_run_dashed(std::size_t run);

/// The same colour with another opacity in [0, 1].
[[nodiscard]] Rgba with_opacity(Rgba colour, double opacity);

/// Colour of a class from resources/palettes/classes.csv; transparent for kUnclassified.
[[nodiscard]] Rgba class_colour(ClassId id);

/// Colour maps whose lightness rises evenly, readable in greyscale and with every colour vision.
enum class ValueColours { kViridis, kCividis };
/// Where all weigh the same: neither heavy nor light.
inline constexpr double kEqualWeightShare = 0.6;
/// @param share  From 0 (darkest) to 1 (lightest); clamped, NaN gives transparent.
[[nodiscard]] Rgba value_colour(ValueColours colours, double share);

}  // namespace nadir
