// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "widgets/canvas/canvas.h"
#include "widgets/views/theme.h"

namespace nadir {

/// A name and the sample of what is drawn so: rings stand for ellipses, an outlined bar for an area as pale as the page,
/// a particle is a dot with its heading, particles are three of them by weight, a ramp is viridis from dark to light.
struct LegendEntry {
  enum class Kind {
    kLine,
    kDashed,
    kBand,
    kBar,
    kDot,
    kStripedBar,
    kOutlinedBar,
    kRings,
    kParticle,
    kParticles,
    kRamp
  };
  std::string name;
  Rgba colour;
  Kind kind = Kind::kLine;
  /// Around a line or dot that is drawn so; transparent: none. Of a striped bar, its stripes; of an outlined one, its outline.
  Rgba casing{0, 0, 0, 0};
  friend bool operator==(const LegendEntry&, const LegendEntry&) = default;
};

/// The same; a bar whose colour is about that of the page has an outline.
[[nodiscard]] LegendEntry legible_entry(LegendEntry entry, const Theme& theme);

inline constexpr double kLegendTextPt = 8.5;

/// Where the entries of a legend go: in rows, as many in a row as fit. Words are dear to measure, so whoever draws the same
/// ones again and again keeps it, for as long as names, width and scale stay.
struct LegendLayout {
  std::vector<Eigen::Vector2d>
      places;  ///< An entry: to the right and down from the upper left corner.
  double height_px = 0.0;
  double cap_height_px = 0.0;  ///< Of its text.
};
[[nodiscard]] LegendLayout legend_layout(double width_px,
                                         std::span<const LegendEntry> entries,
                                         double px_per_pt);

/// Draws entries from the upper left of `where`. @param layout  Of their names, and of the width of `where`.
/// @returns the height that they took, pixels; nothing is drawn below `where`.
double draw_legend(Canvas& canvas,
                   const PageRect& where,
                   std::span<const LegendEntry> entries,
                   const LegendLayout& layout,
                   const Theme& theme,
                   double px_per_pt);
/// The same where it is drawn once.
double draw_legend(Canvas& canvas,
                   const PageRect& where,
                   std::span<const LegendEntry> entries,
                   const Theme& theme,
                   double px_per_pt);

}  // namespace nadir
