// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/chart_plots.h"

#include <vtkBrush.h>
#include <vtkChartXY.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlot.h>
#include <vtkPlotArea.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace nadir {
namespace {

constexpr double kLevelPt = 1.0;
constexpr double kMomentPt = 0.75;

struct Column {
  const char* name;
  const std::vector<double>* values;
};

vtkSmartPointer<vtkTable> table_of(std::initializer_list<Column> columns) {
  auto table = vtkSmartPointer<vtkTable>::New();
  for (const Column& column : columns) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(column.name);
    for (const double value : *column.values) array->InsertNextValue(value);
    table->AddColumn(array);
  }
  return table;
}

void set_pen(vtkPlot& plot, Rgba colour, double width_px, bool is_dashed) {
  plot.GetPen()->SetColor(colour.red, colour.green, colour.blue, colour.alpha);
  plot.GetPen()->SetWidth(static_cast<float>(width_px));
  plot.GetPen()->SetLineType(is_dashed ? vtkPen::DASH_LINE : vtkPen::SOLID_LINE);
}

void set_area(vtkPlot& plot, Rgba colour) {
  plot.GetPen()->SetLineType(vtkPen::NO_PEN);
  plot.GetBrush()->SetColor(colour.red, colour.green, colour.blue, colour.alpha);
}

/// An empty line is kept but hidden, so that plots keep their places.
void set_points(vtkPlot& plot, const std::vector<double>& x, const std::vector<double>& y) {
  plot.SetInputData(table_of({{"x", &x}, {"y", &y}}), "x", "y");
  plot.SetVisible(!x.empty());
}

void add_band(vtkChartXY& chart, const BandSpec& band, const ChartFrame& frame) {
  for (const DrawnBand& piece : drawn_pieces(band, frame)) {
    auto* const area = vtkPlotArea::SafeDownCast(chart.AddPlot(vtkChart::AREA));
    area->SetInputData(table_of({{"x", &piece.x}, {"low", &piece.low}, {"high", &piece.high}}));
    area->SetInputArray(0, "x");
    area->SetInputArray(1, "low");
    area->SetInputArray(2, "high");
    area->SetLabel(band.name);
    set_area(*area, band.colour);
  }
}

void add_bars(vtkChartXY& chart, const BarsSpec& bars, const ChartFrame& frame) {
  for (const BarsSpec::Series& series : bars.series) {
    std::vector<double> groups;
    std::vector<double> heights;
    for (std::size_t i = 0; i < bars.groups.size(); ++i) {
      const double height = i < series.heights.size() ? frame.scale.plotted(series.heights[i])
                                                      : std::numeric_limits<double>::quiet_NaN();
      groups.push_back(static_cast<double>(i));
      // Devices take no NaN; a bar without height is not seen.
      heights.push_back(std::isnan(height) ? 0.0 : height);
      if (frame.scale.is_logarithmic) heights.back() = std::max(0.0, heights.back());
    }
    vtkPlot* const plot = chart.AddPlot(vtkChart::BAR);
    // By their x, VTK makes the bars of a single group a tenth wide, whatever else it was told.
    plot->SetUseIndexForXSeries(true);
    set_points(*plot, groups, heights);
    plot->SetLabel(series.name);
    set_area(*plot, series.colour);
  }
}

void add_line(vtkChartXY& chart, const LineSpec& line, const ChartFrame& frame, double px_per_pt) {
  std::vector<double> x;
  std::vector<double> y;
  for (const DrawnLine& piece : drawn_pieces(line, frame, px_per_pt)) {
    if (!x.empty()) {
      x.push_back(x.back());
      y.push_back(std::numeric_limits<double>::quiet_NaN());
    }
    x.insert(x.end(), piece.x.begin(), piece.x.end());
    y.insert(y.end(), piece.y.begin(), piece.y.end());
  }
  vtkPlot* const plot = chart.AddPlot(vtkChart::LINE);
  set_points(*plot, x, y);
  plot->SetLabel(line.name);
  set_pen(*plot, line.colour, line.width_pt * px_per_pt, line.is_dashed);
}

void add_level(vtkChartXY& chart,
               const LevelSpec& level,
               const ChartFrame& frame,
               double px_per_pt) {
  const double y = frame.scale.plotted(level.y);
  const bool is_in_sight = y >= frame.y.low && y <= frame.y.high;
  vtkPlot* const plot = chart.AddPlot(vtkChart::LINE);
  set_points(*plot, {frame.x.low, frame.x.high},
             std::vector<double>(2, is_in_sight ? y : frame.y.low));
  plot->SetVisible(is_in_sight);
  plot->SetLabel(level.name);
  set_pen(*plot, level.colour, kLevelPt * px_per_pt, level.is_dashed);
}

}  // namespace

MomentLine::MomentLine(vtkPlot& plot, const AxisRange& x, const AxisRange& y)
    : plot_(&plot), x_(x), y_(y) {}

void MomentLine::show(std::optional<double> at) {
  const bool is_in_sight = at && *at >= x_.low && *at <= x_.high;
  const double x = is_in_sight ? *at : x_.low;
  set_points(*plot_, {x, x}, {y_.low, y_.high});
  plot_->SetVisible(is_in_sight);
}

MomentLine add_plots(vtkChartXY& chart,
                     const ChartSpec& spec,
                     const ChartFrame& frame,
                     const Theme& theme,
                     double px_per_pt) {
  chart.ClearPlots();
  for (const BandSpec& band : spec.bands) add_band(chart, band, frame);
  if (spec.bars) add_bars(chart, *spec.bars, frame);
  for (const LevelSpec& level : spec.levels) add_level(chart, level, frame, px_per_pt);
  for (const LineSpec& line : spec.lines) add_line(chart, line, frame, px_per_pt);
  vtkPlot* const moment = chart.AddPlot(vtkChart::LINE);
  set_pen(*moment, theme.text, kMomentPt * px_per_pt, false);
  return {*moment, frame.x, frame.y};
}

}  // namespace nadir
