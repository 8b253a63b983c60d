// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "widgets/views/chart_spec.h"
#include "widgets/views/theme.h"

class vtkChartXY;

namespace nadir {

/// Draws a chart with VTK's vtkChartXY on any Canvas: two axis lines, horizontal grid, no box, no title, no legend (see
/// legend_of()). Only the axis titles are drawn beside VTK, which would put them at a distance that does not grow with
/// the type. The same spec gives the same drawing.
///
/// Where there is little room words give way first, see lay_out(); below 24 points in either direction a chart is only a
/// frame, and nothing where it has no size.
///
/// For one thread. Lines longer than the pixels can show are thinned when they are first drawn at a width. All that is
/// laid out is kept until the chart is drawn elsewhere, so in a film it is made once and marked in every frame.
class XyChart {
 public:
  /// @param px_per_pt  Pixels per point of 1/72 inch, above 0. Labels have 8 points, titles 9.
  XyChart(ChartSpec spec, const Theme& theme, double px_per_pt);
  ~XyChart();
  XyChart(XyChart&&) noexcept;
  XyChart& operator=(XyChart&&) noexcept;

  /// @param where  Room for the whole chart, of any size; nothing is drawn outside. @param page_width, page_height  Pixels.
  void draw(Canvas& canvas, const PageRect& where, int page_width, int page_height) const;

  /// Moves the moment line, or takes it away; outside of the x axis it is not shown. Changes nothing else.
  void mark_x(std::optional<double> x);

  /// What the labels and the title of the y axis need; the largest of several charts as everybody's
  /// ChartSpec::left_margin_px puts their axes below each other. 0 where only a frame is drawn.
  [[nodiscard]] double needed_left_margin_px(const PageRect& where) const;
  /// Between the axes, when drawn there.
  [[nodiscard]] PageRect plot_area(const PageRect& where) const;
  /// Where a point of the data lies on the page when drawn there; may be outside of the plot area. NaN for what a
  /// logarithmic axis cannot show.
  [[nodiscard]] Eigen::Vector2d page_from_data(const Eigen::Vector2d& point,
                                               const PageRect& where) const;

  /// As it was drawn last, else as on a page of 480 x 300 points. Plots, from below: one for each unbroken piece of a
  /// band, each series of bars, each level, each line, and last the moment line, invisible where there is none.
  [[nodiscard]] vtkChartXY& chart();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace nadir
