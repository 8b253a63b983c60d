// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "widgets/views/chart_axis.h"

namespace nadir {

/// Where a chart's data come to lie.
struct ChartFrame {
  AxisRange x, y;         ///< As plotted: on a logarithmic axis y begins at 0.
  ValueScale scale;       ///< From values to plotted y.
  double width_px = 1.0;  ///< Of the plot area.
};

/// The points of one unbroken line.
struct DrawnLine {
  std::vector<double> x, y;  ///< Plotted units, finite, not empty.
};

/// The outline of one unbroken area.
struct DrawnBand {
  std::vector<double> x, low, high;  ///< Plotted units, finite, two points or more.
};

/// The pieces of a line that are in sight: breaks taken out, thinned to what the pixels can show (each pixel keeps its
/// lowest and highest point), steps made corners. A piece of one point becomes a dash as long as the line is wide. What
/// lies far outside is moved nearer, for devices have no pixels there; all else keeps its place.
[[nodiscard]] std::vector<DrawnLine> drawn_pieces(const LineSpec& line,
                                                  const ChartFrame& frame,
                                                  double px_per_pt);

/// The same of a band; each pixel keeps its lowest low and its highest high.
[[nodiscard]] std::vector<DrawnBand> drawn_pieces(const BandSpec& band, const ChartFrame& frame);

}  // namespace nadir
