// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "widgets/figures/page.h"
#include "widgets/views/legend.h"
#include "widgets/views/xy_chart.h"

namespace nadir {

struct CaptionedChart {
  std::string caption;
  ChartSpec chart;
};

/// Charts in a grid, from the left and from the top, each below its caption. Charts one above the other begin at the same
/// place.
///
/// Made once and drawn for every frame of a film: the charts are laid out when they are first drawn at a place, and
/// mark_x() moves nothing but the thin line of a moment.
class ChartGrid {
 public:
  ChartGrid(std::vector<CaptionedChart> charts, std::size_t columns_wanted);

  /// Fewer columns than wanted where they would be too narrow; the last rows are left out where all would be too low.
  void draw(Canvas& canvas, const PageFormat& format, const PageRect& where);

  /// Shows a moment in all charts, in units of their x axis; nothing takes the line away.
  void mark_x(std::optional<double> x);

  /// Everything that has a name in some of the charts, once.
  [[nodiscard]] const std::vector<LegendEntry>& legend() const { return legend_; }
  /// As drawn last; empty before.
  [[nodiscard]] std::span<XyChart> charts() { return drawn_; }

 private:
  void lay_out(const PageFormat& format, const PageRect& where);

  std::vector<CaptionedChart> charts_;
  std::size_t columns_wanted_;
  std::vector<LegendEntry> legend_;
  // Of the page that was drawn last.
  std::optional<PageRect> where_;
  double px_per_pt_ = 0.0;
  ThemeName theme_ = ThemeName::kLight;
  std::vector<PageRect> panels_;
  std::vector<XyChart> drawn_;
};

/// Draws charts that are not kept, as ChartGrid does.
void draw_charts(Canvas& canvas,
                 const PageFormat& format,
                 const PageRect& where,
                 std::span<const CaptionedChart> charts,
                 std::size_t columns_wanted);

/// Everything that has a name in some of the charts, once.
[[nodiscard]] std::vector<LegendEntry> legend_of_all(std::span<const CaptionedChart> charts);

}  // namespace nadir
