// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/xy_chart.h"

#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkContext2D.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkStringArray.h>
#include <vtkTextProperty.h>

#include <array>
#include <cmath>

#include "core/base/require.h"
#include "widgets/canvas/canvas_device.h"
#include "widgets/views/chart_layout.h"
#include "widgets/views/chart_plots.h"
#include "widgets/views/chart_texts.h"
#include "widgets/views/chart_values.h"
#include "widgets/views/no_canvas.h"

namespace nadir {
namespace {

constexpr double kValuePt = 7.0;  ///< Above bars.

void set_text(vtkTextProperty& property, const TextStyle& style) {
  property.SetFontFamily(style.face == FontFace::kNumbers ? VTK_COURIER : VTK_ARIAL);
  property.SetFontSize(static_cast<int>(style.size_px));
  property.SetBold(0);
  property.SetColor(style.colour.red / 255.0, style.colour.green / 255.0,
                    style.colour.blue / 255.0);
  property.SetOpacity(style.colour.alpha / 255.0);
}

void set_pen(vtkPen& pen, Rgba colour, double width_px) {
  pen.SetColor(colour.red, colour.green, colour.blue, colour.alpha);
  pen.SetWidth(static_cast<float>(width_px));
}

void set_range(vtkAxis& axis, const AxisRange& range, const Ticks& ticks) {
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> labels;
  for (const double at : ticks.at) positions->InsertNextValue(at);
  for (const std::string& label : ticks.labels) labels->InsertNextValue(label);
  axis.SetRange(range.low, range.high);
  axis.SetCustomTickPositions(positions, labels);
  axis.SetLabelsVisible(!ticks.at.empty());
}

void draw_titles(Canvas& canvas,
                 const ChartLayout& layout,
                 const TextStyle& x_style,
                 const PageRect& where) {
  const Eigen::Vector2d centre = layout.plot.centre();
  double baseline =
      where.bottom + measure_text("g", x_style).descent +
      kChartLineSpacing * x_style.size_px * static_cast<double>(layout.x_title.size());
  for (const std::string& line : layout.x_title) {
    baseline -= kChartLineSpacing * x_style.size_px;
    canvas.text({centre.x(), baseline}, line, x_style);
  }
  // Turned to the left, so that lines follow each other to the right.
  const TextStyle& y_style = layout.y_title_style;
  baseline = where.left + measure_text("H", y_style).cap_height;
  for (const std::string& line : layout.y_title) {
    canvas.text({baseline, centre.y()}, line, y_style);
    baseline += kChartLineSpacing * y_style.size_px;
  }
}

/// Of a chart that is too small for more; nothing where it has no size.
void draw_small_frame(Canvas& canvas, const PageRect& where, Rgba colour, double line_px) {
  const double inset = line_px / 2.0;
  if (!(where.width > line_px && where.height > line_px)) return;
  const Eigen::Vector2d low(where.left + inset, where.bottom + inset);
  const Eigen::Vector2d high(where.right() - inset, where.top() - inset);
  const std::array<Eigen::Vector2d, 5> outline = {low, Eigen::Vector2d(high.x(), low.y()), high,
                                                  Eigen::Vector2d(low.x(), high.y()), low};
  canvas.stroke(outline, {colour, line_px});
}

}  // namespace

struct XyChart::Implementation {
  ChartSpec spec;
  Theme theme;
  double px_per_pt = 1.0;
  ChartType type;
  vtkNew<vtkContextScene> scene;
  vtkNew<vtkChartXY> chart;
  MomentLine moment;
  std::optional<PageRect> laid_out_for;
  ChartLayout layout;
  bool is_settled = false;  ///< Whether VTK has worked off the layout.

  Implementation(ChartSpec wanted, const Theme& colours, double scale)
      : spec(std::move(wanted)),
        theme(colours),
        px_per_pt(scale),
        type(colours, scale, spec.bars.has_value()) {
    NADIR_REQUIRE(px_per_pt > 0.0);
    scene->AddItem(chart);
    chart->SetLayoutStrategy(vtkChart::AXES_TO_RECT);
    chart->SetAutoAxes(false);
    chart->SetRenderEmpty(true);
    chart->SetShowLegend(false);
    chart->SetBarWidthFraction(static_cast<float>(kBarsShare));
    style_axis(*chart->GetAxis(vtkAxis::BOTTOM), spec.x, type.x_label);
    style_axis(*chart->GetAxis(vtkAxis::LEFT), spec.y, type.y_label);
    chart->GetAxis(vtkAxis::BOTTOM)->SetGridVisible(false);
    chart->GetAxis(vtkAxis::BOTTOM)->SetTicksVisible(type.tick_px > 0.0);
    chart->GetAxis(vtkAxis::LEFT)->SetTicksVisible(false);  // the grid lines lead to the labels
  }

  void style_axis(vtkAxis& axis, const AxisSpec& asked, const TextStyle& label) const {
    axis.SetBehavior(vtkAxis::CUSTOM);
    axis.SetTitle(asked.title);
    axis.SetTitleVisible(false);
    axis.SetTickLength(static_cast<float>(type.tick_px));
    axis.SetLabelOffset(static_cast<float>(type.label_gap_px));
    set_text(*axis.GetLabelProperties(), label);
    set_text(*axis.GetTitleProperties(), type.title);
    set_pen(*axis.GetPen(), theme.muted, type.line_px);
    set_pen(*axis.GetGridPen(), theme.line, type.line_px);
  }

  /// VTK draws at whole pixels; a line of odd width is sharp between them.
  [[nodiscard]] double half_px() const { return std::fmod(type.line_px, 2.0) == 1.0 ? 0.5 : 0.0; }

  void lay_out_for(const PageRect& where) {
    if (laid_out_for == where) return;
    layout = lay_out(spec, type, where);
    const PageRect& plot = layout.plot;
    chart->SetSize(vtkRectf(static_cast<float>(plot.left), static_cast<float>(plot.bottom),
                            static_cast<float>(plot.width), static_cast<float>(plot.height)));
    moment =
        add_plots(*chart, spec, {layout.x, layout.y, layout.scale, plot.width}, theme, px_per_pt);
    moment.show(spec.marked_x);
    set_range(*chart->GetAxis(vtkAxis::BOTTOM), layout.x, layout.x_ticks);
    set_text(*chart->GetAxis(vtkAxis::BOTTOM)->GetLabelProperties(), layout.x_label_style);
    set_range(*chart->GetAxis(vtkAxis::LEFT), layout.y, layout.y_ticks);
    set_text(*chart->GetAxis(vtkAxis::LEFT)->GetLabelProperties(), layout.y_label_style);
    chart->GetAxis(vtkAxis::LEFT)->Modified();  // a younger axis makes the chart lay out anew
    laid_out_for = where;
    is_settled = false;
  }

  void paint(Canvas& canvas, int page_width, int page_height) const {
    vtkNew<CanvasDevice> device;
    device->draw_on(canvas, page_width, page_height);
    vtkNew<vtkMatrix3x3> shift;
    shift->SetElement(0, 2, half_px());
    shift->SetElement(1, 2, half_px());
    device->SetMatrix(shift);
    vtkNew<vtkContext2D> context;
    context->Begin(device);
    scene->SetGeometry(page_width, page_height);
    scene->Paint(context);
    context->End();
  }

  void draw(Canvas& canvas, const PageRect& where, int page_width, int page_height) {
    lay_out_for(where);
    if (layout.is_only_frame) {
      draw_small_frame(canvas, where, theme.line, type.line_px);
      return;
    }
    if (!is_settled) {
      // VTK scales the points of plots by the axes of the paint before: wrong in the first one.
      NoCanvas nothing;
      paint(nothing, page_width, page_height);
      is_settled = true;
    }
    paint(canvas, page_width, page_height);
    draw_titles(canvas, layout, type.title, where);
    if (!spec.bars) return;
    draw_missing(canvas);
    if (spec.bars->shows_values) draw_values(canvas);
  }

  void draw_missing(Canvas& canvas) const {
    TextStyle style = type.x_label;
    style.colour = theme.muted;
    for (const Eigen::Vector2d& baseline : missing_bars(*spec.bars, layout, style)) {
      canvas.text(baseline, kNoBar, style);
    }
  }

  void draw_values(Canvas& canvas) const {
    TextStyle style = type.x_label;
    style.size_px = kValuePt * px_per_pt;
    style.colour = theme.text;
    for (const BarValue& value : bar_values(*spec.bars, layout, style)) {
      canvas.text(value.baseline, value.text, style);
    }
  }
};

XyChart::XyChart(ChartSpec spec, const Theme& theme, double px_per_pt)
    : implementation_(std::make_unique<Implementation>(std::move(spec), theme, px_per_pt)) {}
XyChart::~XyChart() = default;
XyChart::XyChart(XyChart&&) noexcept = default;
XyChart& XyChart::operator=(XyChart&&) noexcept = default;

void XyChart::draw(Canvas& canvas, const PageRect& where, int page_width, int page_height) const {
  implementation_->draw(canvas, where, page_width, page_height);
}

void XyChart::mark_x(std::optional<double> x) {
  implementation_->spec.marked_x = x;
  if (implementation_->laid_out_for) implementation_->moment.show(x);
}

double XyChart::needed_left_margin_px(const PageRect& where) const {
  ChartSpec spec = implementation_->spec;
  spec.left_margin_px = 0.0;
  const ChartLayout layout = lay_out(spec, implementation_->type, where);
  return layout.is_only_frame ? 0.0 : layout.plot.left - where.left;
}

PageRect XyChart::plot_area(const PageRect& where) const {
  implementation_->lay_out_for(where);
  PageRect plot = implementation_->layout.plot;
  plot.left += implementation_->half_px();
  plot.bottom += implementation_->half_px();
  return plot;
}

Eigen::Vector2d XyChart::page_from_data(const Eigen::Vector2d& point, const PageRect& where) const {
  const PageRect plot = plot_area(where);
  const ChartLayout& layout = implementation_->layout;
  const double y = layout.scale.plotted(point.y());
  return {plot.left + (point.x() - layout.x.low) / layout.x.span() * plot.width,
          plot.bottom + (y - layout.y.low) / layout.y.span() * plot.height};
}

vtkChartXY& XyChart::chart() {
  Implementation& made = *implementation_;
  if (!made.laid_out_for)
    made.lay_out_for({0.0, 0.0, 480.0 * made.px_per_pt, 300.0 * made.px_per_pt});
  return *made.chart;
}

}  // namespace nadir
