// SPDX-License-Identifier: Apache-2.0
// What every pose around the estimate costs at one instant: the landscape that the particles climb.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/angle.h"
#include "core/map/map_index.h"
#include "core/mcl/error_surface.h"
#include "core/run/run_options.h"
#include "widgets/figures/chart_panel.h"
#include "widgets/figures/figures.h"
#include "widgets/figures/page_layout.h"
#include "widgets/figures/run_lines.h"
#include "widgets/views/particle_view.h"
#include "widgets/views/raster_view.h"

namespace nadir {
namespace {

constexpr ErrorSurfaceGrid kPlane{.count_x = 121, .count_y = 121, .count_yaw = 1, .step_m = 0.25};
constexpr ErrorSurfaceGrid kTurn{
    .count_x = 1, .count_y = 1, .count_yaw = 121, .step_m = 0.25, .step_rad = 0.0174532925199433};

/// The options that a run was made with. Options that this version does not know are left as they are.
LocaliserOptions options_of(const RunHeader& header) {
  RunOptions options;
  for (const auto& [name, text] : header.options) {
    [[maybe_unused]] const auto ignored = set_option(options, name, text);
  }
  return options.localiser;
}

/// Cheap poses light, dear ones dark.
Raster<Rgba> picture_of(const ErrorSurface& surface) {
  const auto [lowest, highest] =
      std::minmax_element(surface.mean_cost.begin(), surface.mean_cost.end());
  const double range = std::max(1e-12, static_cast<double>(*highest) - *lowest);
  const ErrorSurfaceGrid& grid = surface.grid;
  Raster<Rgba> picture(grid.count_x, grid.count_y);
  for (int y = 0; y < grid.count_y; ++y) {
    for (int x = 0; x < grid.count_x; ++x) {
      const double share = (static_cast<double>(*highest) - surface.at(x, y, 0)) / range;
      picture.at(x, grid.count_y - 1 - y) = value_colour(ValueColours::kViridis, share);
    }
  }
  return picture;
}

LineSpec slice(const ErrorSurface& surface, int axis, const std::string& name, Rgba colour) {
  const ErrorSurfaceGrid& grid = surface.grid;
  LineSpec line{name, {}, {}, colour, 1.5};
  const std::array<int, 3> counts = {grid.count_x, grid.count_y, grid.count_yaw};
  const int count = counts.at(static_cast<std::size_t>(axis));
  for (int i = 0; i < count; ++i) {
    std::array<int, 3> index = {grid.count_x / 2, grid.count_y / 2, grid.count_yaw / 2};
    index.at(static_cast<std::size_t>(axis)) = i;
    const int middle = count / 2;
    const double offset = i - middle;
    line.x.push_back(axis == 2 ? Angle::radians(offset * grid.step_rad).degrees()
                               : offset * grid.step_m);
    line.y.push_back(surface.at(index[0], index[1], index[2]));
  }
  return line;
}

class Surface : public Figure {
 public:
  Surface(std::unique_ptr<MapPanel> map, MapMatcher matcher, FigureInputs inputs)
      : map_(std::move(map)),
        matcher_(std::move(matcher)),
        inputs_(std::move(inputs)),
        surface_(map_->scene(), MapLayer::kSurface),
        particles_(map_->scene()) {
    show_at(inputs_.options.time_s);
  }

  Result<void> draw(Canvas& canvas, FigureContext& context) override {
    const auto step = run().reader.step(run().steps[index_].step);
    if (!step) return forward_error(step);
    const PageFormat& format = context.format();
    const Theme& theme = format.colours();
    const Rigid2 centre = step->estimate.moments.mean;
    PageRect rest = page_inside(format);
    if (!step->topview) {
      draw_message(canvas, format, rest, "the run holds no topviews");
      return {};
    }
    const auto plane = error_surface(matcher_, *step->topview, centre, kPlane);
    if (!plane) {
      draw_message(canvas, format, rest, plane.error().message);
      return {};
    }
    const auto turn = error_surface(matcher_, *step->topview, centre, kTurn);
    if (!turn) return forward_error(turn);
    draw_foot(canvas, format, rest, words(*step));
    draw_page_legend(canvas, format, rest, legend(theme, *step));
    auto sides = columns(rest, {1.0, 0.9}, 12.0 * format.px_per_pt());
    draw_caption(canvas, format, sides[0],
                 "(a) cost over east and north at the estimated heading, light is cheap");
    lay_on_map(*plane, *step);
    const auto frame = map_->draw_ground(canvas, context, sides[0]);
    if (!frame) return forward_error(frame);
    canvas.push_clip(frame->where);
    for (const Source source : {Source::kTruth, Source::kEstimate}) {
      const auto pose = pose_of(*step, source);
      if (!pose) continue;
      draw_pose(canvas, *frame, *pose, 10.0,
                source == Source::kTruth ? truth_look(theme) : estimate_look(theme));
    }
    canvas.pop_clip();
    map_->draw_furniture(canvas, format, *frame);

    ChartSpec along;
    along.x.title = "offset from the estimate [m]";
    along.y.title = "mean cost";
    along.lines = {slice(*plane, 0, "along east", theme.estimate),
                   slice(*plane, 1, "along north", theme.second_run)};
    ChartSpec about;
    about.x.title = "heading offset [deg]";
    about.y.title = "mean cost";
    about.lines = {slice(*turn, 2, "about the vertical", theme.third_run)};
    const std::array<CaptionedChart, 2> charts = {
        CaptionedChart{"(b) slices through the estimate", along},
        CaptionedChart{"(c) heading", about}};
    draw_charts(canvas, format, sides[1], charts, 1);
    return {};
  }

  [[nodiscard]] std::optional<FigureTimes> times() const override { return times_of(inputs_.runs); }
  void show_at(double time_s) override { index_ = run().index_at(time_s); }

 private:
  [[nodiscard]] const FigureRun& run() const { return inputs_.runs.front(); }

  void lay_on_map(const ErrorSurface& plane, const RunStep& step) {
    const ErrorSurfaceGrid& grid = plane.grid;
    // A sample stands in the middle of its pixel.
    const Rigid2 centre = step.estimate.moments.mean;
    const Eigen::Vector2d size_m = grid.step_m * Eigen::Vector2d(grid.count_x, grid.count_y);
    surface_.show(picture_of(plane),
                  {centre.x_m - size_m.x() / 2.0, centre.y_m + size_m.y() / 2.0, 0.0},
                  Eigen::Vector2d::Constant(grid.step_m), false);
    surface_.set_opacity(0.8);
    const bool has_particles = inputs_.options.shows_particles && step.particles.has_value();
    particles_.set_visible(has_particles);
    if (has_particles) particles_.show(*step.particles);
    map_->show_square(centre.translation_m(), 1.02 * size_m.maxCoeff());
  }

  [[nodiscard]] std::vector<LegendEntry> legend(const Theme& theme, const RunStep& step) const {
    std::vector<LegendEntry> entries = {
        {"estimate", theme.estimate_on_imagery, LegendEntry::Kind::kDot, theme.casing_on_imagery}};
    if (step.truth_in_enu)
      entries.push_back(
          {"truth", theme.truth_on_imagery, LegendEntry::Kind::kDot, theme.casing_on_imagery});
    entries.push_back({"slice along east", theme.estimate, LegendEntry::Kind::kLine});
    entries.push_back({"along north", theme.second_run, LegendEntry::Kind::kLine});
    entries.push_back({"heading", theme.third_run, LegendEntry::Kind::kLine});
    return entries;
  }

  [[nodiscard]] std::string words(const RunStep& step) const {
    std::string text = fmt::format("{:.1f} s after the start", run().elapsed_s(step));
    const MatchCells cells = matcher_.prepare(*step.topview);
    if (step.truth_in_enu) {
      const double at_truth = matcher_.mean_cost(cells, *step.truth_in_enu);
      const double at_estimate = matcher_.mean_cost(cells, step.estimate.moments.mean);
      text += fmt::format(", mean cost {:.3f} at the estimate and {:.3f} at the truth: {}",
                          at_estimate, at_truth,
                          at_truth < at_estimate ? "the truth would have scored better"
                                                 : "the estimate scores at least as well");
    }
    return text + " · " + foot_of(run());
  }

  std::unique_ptr<MapPanel> map_;  ///< Before the views, which lie in its scene.
  MapMatcher matcher_;
  FigureInputs inputs_;
  RasterView surface_;
  ParticleView particles_;
  std::size_t index_ = 0;
};

}  // namespace

Result<std::unique_ptr<Figure>> make_error_surface(FigureInputs inputs) {
  auto labels = read_overhead_map(inputs.map);
  if (!labels) return forward_error(labels);
  auto matcher = MapMatcher::create(
      std::make_shared<const MapIndex>(std::make_shared<const OverheadMap>(std::move(*labels))),
      options_of(inputs.runs.front().reader.header()));
  if (!matcher) return forward_error(matcher);
  auto panel = MapPanel::create(inputs.map, MapPanel::Ground::kPicture, inputs.options);
  if (!panel) return forward_error(panel);
  return std::make_unique<Surface>(std::move(*panel), std::move(*matcher), std::move(inputs));
}

}  // namespace nadir
