// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "widgets/views/chart_axis.h"

namespace nadir {

/// From baseline to baseline, in text sizes; CanvasDevice's too.
inline constexpr double kChartLineSpacing = 1.3;

/// Parts of a text without the separators; no part is empty.
[[nodiscard]] std::vector<std::string> parts_of(const std::string& text, char separator);

/// Of the longest of some lines, pixels; 0 for none.
[[nodiscard]] double widest_of(const std::vector<std::string>& lines, const TextStyle& style);

/// From the top of the first line's capitals to below the last, pixels; 0 for none.
[[nodiscard]] double height_of(const std::vector<std::string>& lines, const TextStyle& style);

/// A title beside an axis so long, its size as it is: on one line, on more if it may, else in fewer words, the unit last
/// ("orientation error [deg]", "error [deg]", "[deg]"). Empty where not even that fits, or there is no unit.
[[nodiscard]] std::vector<std::string> title_lines(const std::string& title,
                                                   const TextStyle& style,
                                                   double most_px,
                                                   std::size_t most_lines);

/// Names below groups of bars `group_px` wide: broken at spaces, else staggered, else cut with an
/// ellipsis; below very narrow groups only every second, third ... has its name. `labels` have lines, parted by '\n'.
[[nodiscard]] Ticks group_ticks(const BarsSpec& bars, const TextStyle& style, double group_px);

/// The style in which all labels can be written: the face of numbers has digits above the line, but no minus there.
[[nodiscard]] TextStyle style_for(const std::vector<std::string>& labels, TextStyle style);

}  // namespace nadir
