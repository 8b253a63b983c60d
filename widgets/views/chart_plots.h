// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkPlot.h>
#include <vtkSmartPointer.h>

#include <optional>

#include "widgets/views/chart_series.h"
#include "widgets/views/theme.h"

class vtkChartXY;

namespace nadir {

/// The thin vertical line of a chart.
class MomentLine {
 public:
  MomentLine() = default;
  MomentLine(vtkPlot& plot, const AxisRange& x, const AxisRange& y);
  /// Nothing, or a place outside of the axis, hides it.
  void show(std::optional<double> at);

 private:
  vtkSmartPointer<vtkPlot> plot_;
  AxisRange x_, y_;
};

/// Gives the chart the plots of the spec instead of those that it has, in the order that XyChart::chart() tells.
[[nodiscard]] MomentLine add_plots(vtkChartXY& chart,
                                   const ChartSpec& spec,
                                   const ChartFrame& frame,
                                   const Theme& theme,
                                   double px_per_pt);

}  // namespace nadir
