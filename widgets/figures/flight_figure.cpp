// SPDX-License-Identifier: Apache-2.0
// Figures of flights in five panels: flight, compare.
#include <optional>

#include "widgets/figures/chart_panel.h"
#include "widgets/figures/error_charts.h"
#include "widgets/figures/page_layout.h"
#include "widgets/figures/run_lines.h"
#include "widgets/figures/timed_figure.h"

namespace nadir {
namespace {

using MakeCharts = std::vector<CaptionedChart> (*)(std::span<const FigureRun>, const Theme&);

/// A map with the runs on top, charts below; a film moves along both.
class MapAndCharts : public TimedFigure {
 public:
  MapAndCharts(std::unique_ptr<MapPanel> map, FigureInputs inputs, MakeCharts make)
      : TimedFigure(std::move(inputs)), map_(std::move(map)), make_(make) {
    for (const FigureRun& each : runs()) include_run(*map_, each);
  }

  Result<void> draw(Canvas& canvas, FigureContext& context) override {
    const PageFormat& format = context.format();
    const Theme& theme = format.colours();
    ChartGrid& charts = charts_for(format.theme);
    PageRect rest = page_inside(format);
    draw_foot(canvas, format, rest, foot_of_all(runs()));
    draw_page_legend(canvas, format, rest, legend(theme, charts));
    const std::vector<PageRect> parts =
        fitting_rows(rest, {1.1, 1.0}, 8.0 * format.px_per_pt(), least_map(format));
    if (auto drawn = draw_map(canvas, context, parts[0]); !drawn) return drawn;
    if (!least_chart(format).fits_in(parts[1])) return {};
    charts.mark_x(is_moment_in_runs() ? std::optional(time_s()) : std::nullopt);
    charts.draw(canvas, format, parts[1]);
    return {};
  }

 private:
  /// The same for every frame of a film: what is told apart by colour is made anew for another theme.
  ChartGrid& charts_for(ThemeName theme_name) {
    if (!charts_ || theme_ != theme_name) {
      constexpr std::size_t kAcross = 2;
      charts_.emplace(make_(runs(), theme(theme_name)), kAcross);
      theme_ = theme_name;
    }
    return *charts_;
  }

  Result<void> draw_map(Canvas& canvas, FigureContext& context, PageRect panel) {
    const PageFormat& format = context.format();
    if (!least_map(format).fits_in(panel)) return {};
    draw_caption(canvas, format, panel, "(a) trajectories");
    const auto frame = map_->draw_ground(canvas, context, panel);
    if (!frame) return forward_error(frame);
    canvas.push_clip(frame->where);
    draw_runs(canvas, *frame, runs(), options(), time_s(), format.colours());
    canvas.pop_clip();
    map_->draw_furniture(canvas, format, *frame);
    return {};
  }

  /// Of runs of other flights than the first, whose odometry is not on the map.
  [[nodiscard]] bool is_odometry(const LegendEntry& entry) const {
    return runs().size() > 1 && entry.name.rfind("odometry (input) of ", 0) == 0;
  }

  /// Lines of charts have the names and colours of those on the map, but for the bands.
  [[nodiscard]] std::vector<LegendEntry> legend(const Theme& theme, const ChartGrid& charts) const {
    std::vector<LegendEntry> entries = run_legend(runs(), options(), theme);
    for (const LegendEntry& entry : charts.legend()) {
      const bool is_named =
          std::any_of(entries.begin(), entries.end(),
                      [&entry](const LegendEntry& listed) { return listed.name == entry.name; });
      if (entry.kind == LegendEntry::Kind::kBand || (!is_named && is_odometry(entry))) {
        entries.push_back(entry);
      }
    }
    return entries;
  }

  std::unique_ptr<MapPanel> map_;
  MakeCharts make_;
  std::optional<ChartGrid> charts_;
  ThemeName theme_ = ThemeName::kLight;
};

std::vector<CaptionedChart> flight_charts(std::span<const FigureRun> runs, const Theme& theme) {
  const FigureRun& run = runs.front();
  return {{"(b) east error", axis_error_chart(run, PoseAxis::kEast, theme)},
          {"(c) north error", axis_error_chart(run, PoseAxis::kNorth, theme)},
          {"(d) yaw error", axis_error_chart(run, PoseAxis::kYaw, theme)},
          {"(e) position error", position_error_chart(runs, true, theme)}};
}

std::vector<CaptionedChart> compare_charts(std::span<const FigureRun> runs, const Theme& theme) {
  return {{"(b) position error", position_error_chart(runs, false, theme)},
          {"(c) orientation error", orientation_error_chart(runs, false, theme)},
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
