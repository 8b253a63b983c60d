// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "widgets/canvas/canvas.h"
#include "widgets/views/legend.h"

namespace nadir {

/// Quantity with its unit, and the ends of the axis where they are not to be fitted to the data.
struct AxisSpec {
  std::string title =
      {};  ///< "position error [m]"; of an axis in "[s]" no tick parts a second in vain.
  std::optional<double> low = {}, high = {};  ///< Finite; low < high where both are given.
};

/// A line through points (x, y), in the units of the axes. What is not finite breaks it.
struct LineSpec {
  std::string name = {};
  std::vector<double> x = {}, y = {};  ///< As long as each other.
  Rgba colour = {};
  double width_pt = 1.5;
  bool is_dashed = false;
  bool is_stepped = false;  ///< Stays at y[i] until x[i + 1], as a distribution of samples does.
};

/// The area between two lines; what is not finite breaks it. The colour carries the opacity.
struct BandSpec {
  std::string name = {};
  std::vector<double> x = {}, low = {}, high = {};  ///< As long as each other.
  Rgba colour = {};
};

/// A horizontal line over the whole width.
struct LevelSpec {
  std::string name = {};
  double y = 0.0;
  Rgba colour = {};
  bool is_dashed = true;
};

/// Bars side by side, a group of them for each name below the axis.
struct BarsSpec {
  struct Series {
    std::string name = {};
    std::vector<double> heights = {};  ///< One a group; what is not finite has a dash for a bar.
    Rgba colour = {};
  };
  std::vector<std::string> groups = {};
  std::vector<Series> series = {};
  bool is_logarithmic = false;  ///< Of the whole y axis, which then shows what is above 0.
  bool shows_values = false;    ///< The height above each bar, where all of them have room.
};

/// A chart as data. Magnitudes beyond 1e100 count as infinite, and nothing infinite is drawn.
struct ChartSpec {
  AxisSpec x = {}, y = {};
  std::vector<LineSpec> lines = {};
  std::vector<BandSpec> bands = {};
  std::vector<LevelSpec> levels = {};
  std::optional<BarsSpec> bars = {};    ///< Group i stands at x = i.
  std::optional<double> marked_x = {};  ///< A thin vertical line at a moment.
  /// From the chart's left end to its y axis; 0, or more than half of the chart: as the labels need.
  double left_margin_px = 0.0;
};

/// What has a name in the chart and something to draw: lines, bands, bars, levels. Equal entries are listed once.
[[nodiscard]] std::vector<LegendEntry> legend_of(const ChartSpec& spec);

}  // namespace nadir
