// SPDX-License-Identifier: Apache-2.0
// Figures of flights in five panels: flight, compare.
#include "widgets/figures/chart_panel.h"
#include "widgets/figures/error_charts.h"
#include "widgets/figures/figures.h"
#include "widgets/figures/page_layout.h"
#include "widgets/figures/run_lines.h"

namespace nadir {
namespace {

using MakeCharts = std::vector<CaptionedChart> (*)(std::span<const FigureRun>, const Theme&);

/// A map with the runs on top, charts below; a film moves along both.
class MapAndCharts : public Figure {
 public:
  MapAndCharts(std::unique_ptr<MapPanel> map, FigureInputs inputs, MakeCharts make)
      : map_(std::move(map)), inputs_(std::move(inputs)), make_(make) {
    for (const FigureRun& run : inputs_.runs) include_run(*map_, run);
  }

  Result<void> draw(Canvas& canvas, FigureContext& context) override {
    const PageFormat& format = context.format();
    const Theme& theme = format.colours();
    std::vector<CaptionedChart> charts = make_(inputs_.runs, theme);
    if (is_moment_shown_) {
      for (CaptionedChart& chart : charts) chart.chart.marked_x = time_s_;
    }
    PageRect rest = page_inside(format);
    draw_foot(canvas, format, rest, foot_of_all(inputs_.runs));
    std::vector<LegendEntry> legend = run_legend(inputs_.runs, theme);
    for (const LegendEntry& entry : legend_of_all(charts)) {
      if (entry.kind == LegendEntry::Kind::kBand) legend.push_back(entry);
    }
    draw_page_legend(canvas, format, rest, legend);
    std::vector<PageRect> parts = rows(rest, {1.1, 1.0}, 8.0 * format.px_per_pt());
    draw_caption(canvas, format, parts[0], "(a) trajectories");
    const auto frame = map_->draw_ground(canvas, context, parts[0]);
    if (!frame) return forward_error(frame);
    canvas.push_clip(frame->where);
    draw_runs(canvas, *frame, inputs_.runs, inputs_.options, time_s_, theme);
    canvas.pop_clip();
    map_->draw_furniture(canvas, format, *frame);
    draw_charts(canvas, format, parts[1], charts, 2);
    return {};
  }

  [[nodiscard]] std::optional<FigureTimes> times() const override { return times_of(inputs_.runs); }
  void show_at(double time_s) override {
    time_s_ = time_s;
    is_moment_shown_ = true;
  }

 private:
  std::unique_ptr<MapPanel> map_;
  FigureInputs inputs_;
  MakeCharts make_;
  double time_s_ = 1e9;
  bool is_moment_shown_ = false;
};

std::vector<CaptionedChart> flight_charts(std::span<const FigureRun> runs, const Theme& theme) {
  const FigureRun& run = runs.front();
  return {{"(b) east", axis_error_chart(run, PoseAxis::kEast, theme)},
          {"(c) north", axis_error_chart(run, PoseAxis::kNorth, theme)},
          {"(d) yaw", axis_error_chart(run, PoseAxis::kYaw, theme)},
          {"(e) distance", position_error_chart(runs, true, theme)}};
}

std::vector<CaptionedChart> compare_charts(std::span<const FigureRun> runs, const Theme& theme) {
  return {{"(b) position", position_error_chart(runs, false, theme)},
          {"(c) orientation", orientation_error_chart(runs, false, theme)},
          {"(d) agreement with the map", agreement_chart(runs, theme)},
          {"(e) distribution of position errors", cdf_chart(runs, ErrorKind::kPosition, theme)}};
}

Result<std::unique_ptr<Figure>> make_map_and_charts(FigureInputs inputs, MakeCharts make) {
  auto panel = MapPanel::create(inputs.map, MapPanel::Ground::kPicture, inputs.options);
  if (!panel) return forward_error(panel);
  return std::make_unique<MapAndCharts>(std::move(*panel), std::move(inputs), make);
}

}  // namespace

Result<std::unique_ptr<Figure>> make_flight(FigureInputs inputs) {
  return make_map_and_charts(std::move(inputs), flight_charts);
}

Result<std::unique_ptr<Figure>> make_compare(FigureInputs inputs) {
  return make_map_and_charts(std::move(inputs), compare_charts);
}

}  // namespace nadir
