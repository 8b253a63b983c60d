// SPDX-License-Identifier: Apache-2.0
// What every pose around the estimate costs at one instant: the landscape that the particles climb.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/angle.h"
#include "core/map/map_index.h"
#include "core/mcl/error_surface.h"
#include "core/run/run_options.h"
#include "widgets/figures/chart_panel.h"
#include "widgets/figures/page_layout.h"
#include "widgets/figures/run_lines.h"
#include "widgets/figures/run_on_map.h"
#include "widgets/figures/timed_figure.h"
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

class Surface : public TimedFigure {
 public:
  Surface(std::unique_ptr<MapPanel> map, MapMatcher matcher, FigureInputs inputs)
      : TimedFigure(std::move(inputs)),
        map_(std::move(map)),
        matcher_(std::move(matcher)),
        surface_(map_->scene(), MapLayer::kSurface),
        particles_(map_->scene()) {
    map_->fade_labels();
  }

  Result<void> draw(Canvas& canvas, FigureContext& context) override {
    if (auto computed = compute_shown_step(); !computed) return computed;
    const PageFormat& format = context.format();
    const double px = format.px_per_pt();
    PageRect rest = page_inside(format);
    draw_foot(canvas, format, rest, words_);
    if (!why_not_.empty()) {
      draw_message(canvas, format, rest, why_not_);
      return {};
    }
    constexpr double kBesidePt = 320.0;
    const bool is_wide = rest.width >= kBesidePt * px;
    draw_page_legend(canvas, format, rest, legend(format.colours()));
    const auto parts = is_wide ? fitting_columns(rest, {1.0, 0.9}, 12.0 * px, least_map(format))
                               : fitting_rows(rest, {1.0, 0.9}, 8.0 * px, least_map(format));
    if (auto drawn = draw_map(canvas, context, parts[0]); !drawn) return drawn;
    if (!least_chart(format).fits_in(parts[1])) return {};
    const std::size_t across = is_wide ? 1 : 2;
    if (!charts_ || theme_ != format.theme || across_ != across) {
      charts_.emplace(slices(format.colours()), across);
      theme_ = format.theme;
      across_ = across;
    }
    charts_->draw(canvas, format, parts[1]);
    return {};
  }

 private:
  /// Evaluates the surfaces of the step that is shown, once for all frames of a film that show it.
  Result<void> compute_shown_step() {
    if (step_ && shown_index_ == index()) return {};
    auto step = read_step();
    if (!step) return forward_error(step);
    step_ = std::move(*step);
    shown_index_ = index();
    charts_.reset();
    words_ = fmt::format("{:.1f} s after the start", run().elapsed_s(*step_));
    why_not_.clear();
    if (!step_->topview) {
      why_not_ = "the run holds no topviews";
    } else if (!is_finite(centre())) {
      why_not_ = "the estimate of this step is not a number";
    } else if (const auto unlike = unlike_cells(*step_->topview, matcher_.map())) {
      step_.reset();
      return fail(ErrorCode::kMalformed, "{}: {}", run().path.string(), *unlike);
    } else {
      auto plane = error_surface(matcher_, *step_->topview, centre(), kPlane);
      auto turn = error_surface(matcher_, *step_->topview, centre(), kTurn);
      if (!plane || !turn) {
        why_not_ = !plane ? plane.error().message : turn.error().message;
      } else {
        plane_ = std::move(*plane);
        turn_ = std::move(*turn);
        words_ += costs();
        lay_on_map();
      }
    }
    words_ += " · " + foot_of(run());
    return {};
  }

  [[nodiscard]] Rigid2 centre() const { return step_->estimate.moments.mean; }

  void lay_on_map() {
    const ErrorSurfaceGrid& grid = plane_.grid;
    // A sample stands in the middle of its pixel.
    const Eigen::Vector2d size_m = grid.step_m * Eigen::Vector2d(grid.count_x, grid.count_y);
    surface_.show(picture_of(plane_),
                  {centre().x_m - size_m.x() / 2.0, centre().y_m + size_m.y() / 2.0, 0.0},
                  Eigen::Vector2d::Constant(grid.step_m), false);
    surface_.set_opacity(0.8);
    particles_.set_visible(shows_particles());
    if (shows_particles()) particles_.show(*step_->particles);
    map_->show_square(centre().translation_m(), 1.02 * size_m.maxCoeff());
  }

  [[nodiscard]] bool shows_particles() const {
    return options().layers.has(FigureLayer::kParticles) && step_->particles.has_value();
  }

  Result<void> draw_map(Canvas& canvas, FigureContext& context, PageRect panel) {
    const PageFormat& format = context.format();
    if (!least_map(format).fits_in(panel)) return {};
    draw_caption(canvas, format, panel, "(a) cost at the estimated heading, light is cheap");
    const auto frame = map_->draw_ground(canvas, context, panel);
    if (!frame) return forward_error(frame);
    canvas.push_clip(frame->where);
    for (const Source source : {Source::kTruth, Source::kEstimate}) {
      const auto pose = pose_of(*step_, source);
      if (!pose || !options().layers.has(layer_of(source))) continue;
      draw_pose(canvas, *frame, *pose, 10.0, look_of(source, format.colours()));
    }
    canvas.pop_clip();
    map_->draw_furniture(canvas, format, *frame);
    return {};
  }

  [[nodiscard]] std::vector<CaptionedChart> slices(const Theme& theme) const {
    ChartSpec along;
    along.x.title = "offset from the estimate [m]";
    along.y.title = "mean cost";
    along.lines = {slice(plane_, 0, "slice along east", theme.estimate),
                   slice(plane_, 1, "along north", theme.second_run)};
    ChartSpec about;
    about.x.title = "heading offset [deg]";
    about.y.title = "mean cost";
    about.lines = {slice(turn_, 2, "heading", theme.third_run)};
    return {{"(b) through the estimate", along}, {"(c) heading", about}};
  }

  [[nodiscard]] std::vector<LegendEntry> legend(const Theme& theme) const {
    std::vector<LegendEntry> entries;
    for (const auto& [source, name] :
         {std::pair(Source::kEstimate, "estimate"), std::pair(Source::kTruth, "truth")}) {
      if (!pose_of(*step_, source) || !options().layers.has(layer_of(source))) continue;
      const PathLook look = look_of(source, theme);
      entries.push_back({name, look.colour, LegendEntry::Kind::kDot, look.casing});
    }
    if (shows_particles()) entries.push_back(particle_legend());
    entries.push_back({"slice along east", theme.estimate, LegendEntry::Kind::kLine});
    entries.push_back({"along north", theme.second_run, LegendEntry::Kind::kLine});
    entries.push_back({"heading", theme.third_run, LegendEntry::Kind::kLine});
    return entries;
  }

  [[nodiscard]] std::string costs() const {
    if (!step_->truth_in_enu) return {};
    const MatchCells cells = matcher_.prepare(*step_->topview);
    const double at_truth = matcher_.mean_cost(cells, *step_->truth_in_enu);
    const double at_estimate = matcher_.mean_cost(cells, centre());
    return fmt::format(", mean cost {:.3f} at the estimate and {:.3f} at the truth: {}",
                       at_estimate, at_truth,
                       at_truth < at_estimate ? "the truth would have scored better"
                                              : "the estimate scores at least as well");
  }

  std::unique_ptr<MapPanel> map_;  ///< Before the views, which lie in its scene.
  MapMatcher matcher_;
  RasterView surface_;
  ParticleView particles_;
  std::optional<RunStep> step_;  ///< The one of shown_index_; what follows is of it.
  std::size_t shown_index_ = 0;
  std::string words_, why_not_;
  ErrorSurface plane_, turn_;
  std::optional<ChartGrid> charts_;  ///< Of this theme and so many beside each other.
  ThemeName theme_ = ThemeName::kLight;
  std::size_t across_ = 0;
};

}  // namespace

Result<std::unique_ptr<Figure>> make_error_surface(FigureInputs inputs) {
  auto labels = read_overhead_map(inputs.map);
  if (!labels) return forward_error(labels);
  auto matcher = MapMatcher::create(
      std::make_shared<const MapIndex>(std::make_shared<const OverheadMap>(std::move(*labels))),
      options_of(inputs.runs.front().reader->header()));
  if (!matcher) return forward_error(matcher);
  auto panel = MapPanel::create(inputs.map, MapPanel::Ground::kPicture, inputs.options);
  if (!panel) return forward_error(panel);
  return std::make_unique<Surface>(std::move(*panel), std::move(*matcher), std::move(inputs));
}

}  // namespace nadir
