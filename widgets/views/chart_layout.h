// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "widgets/views/chart_axis.h"
#include "widgets/views/theme.h"

namespace nadir {

/// Type and distances of a chart, in whole pixels as VTK takes them.
struct ChartType {
  ChartType(const Theme& theme, double px_per_pt, bool has_bars);

  TextStyle x_label, y_label, title;
  double tick_px = 0.0;       ///< Length of the marks on the x axis; 0 below bars, which need none.
  double label_gap_px = 0.0;  ///< From the axis to its labels.
  double title_gap_px = 0.0;  ///< From the labels to the title.
  double line_px = 1.0;       ///< Width of axes and grid.
  double least_px =
      0.0;  ///< A chart narrower or lower is only a frame; its plot area keeps as much.
};

/// Where everything of a chart stands on the page.
struct ChartLayout {
  PageRect plot;           ///< Between the axes; corners are whole pixels.
  AxisRange x, y;          ///< As plotted: on a logarithmic axis y begins at 0.
  ValueScale scale;        ///< From values to plotted y.
  Ticks x_ticks, y_ticks;  ///< `at` as plotted; labels of bars may have lines, parted by '\n'.
  std::vector<std::string> x_title, y_title;  ///< Lines.
  TextStyle x_label_style, y_label_style, y_title_style;
  bool is_only_frame = false;  ///< Too small for anything else: no ticks, titles or data.
};

/// Room for ticks and titles first, the plot area takes the rest, but half of the chart at least: where there is less,
/// titles are broken at spaces, lose words, go, and then the numbers go. Text has the same size in every chart. No text
/// covers another or leaves the chart.
/// @param where  Whole chart; may have no size, and is only a frame below 24 points in either direction.
[[nodiscard]] ChartLayout lay_out(const ChartSpec& spec,
                                  const ChartType& type,
                                  const PageRect& where);

}  // namespace nadir
