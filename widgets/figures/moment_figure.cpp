// SPDX-License-Identifier: Apache-2.0
// One instant of a run: what the filter knew, what the camera saw, and how that fits the map.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/map/overhead_map_file.h"
#include "widgets/figures/chart_panel.h"
#include "widgets/figures/moment_panels.h"
#include "widgets/figures/page_layout.h"
#include "widgets/figures/run_lines.h"
#include "widgets/figures/run_on_map.h"
#include "widgets/figures/timed_figure.h"
#include "widgets/views/agreement_view.h"
#include "widgets/views/mode_marks.h"
#include "widgets/views/particle_view.h"
#include "widgets/views/raster_pictures.h"
#include "widgets/views/raster_view.h"

namespace nadir {
namespace {

constexpr double kGapPt = 10.0;

class Moment : public TimedFigure {
 public:
  Moment(std::unique_ptr<MapPanel> map, OverheadMap labels, FigureInputs inputs)
      : TimedFigure(std::move(inputs)),
        map_(std::move(map)),
        labels_(std::move(labels)),
        camera_(run()),
        particles_(map_->scene()),
        topview_(map_->scene(), MapLayer::kTopview) {
    map_->fade_labels();
  }

  Result<void> draw(Canvas& canvas, FigureContext& context) override {
    if (auto read = read_shown_step(); !read) return read;
    const RunStep& step = *step_;
    const PageFormat& format = context.format();
    const double px = format.px_per_pt();
    if (theme_ != format.theme) bars_.reset();
    theme_ = format.theme;
    const auto bars =
        agreement_ ? agreement_bars(*agreement_, format.colours()) : std::optional<ChartSpec>();
    PageRect rest = page_inside(format);
    draw_foot(canvas, format, rest, words(step));
    draw_page_legend(canvas, format, rest, legend(format.colours(), step, bars.has_value()));
    constexpr double kBesidePt = 320.0;
    const bool is_wide = rest.width >= kBesidePt * px;
    constexpr double kBarsPt = 80.0;  // with the names of classes below
    PageRect bottom =
        take_bottom(rest, std::min(0.35 * rest.height, std::max(0.22 * rest.height, kBarsPt * px)),
                    kGapPt * px);
    if (is_wide) {
      auto sides = columns(rest, {1.25, 1.0}, 12.0 * px);
      if (auto drawn = draw_map(canvas, context, sides[0], step); !drawn) return drawn;
      draw_seen(canvas, format, sides[1], step);
    } else {
      auto parts = fitting_rows(rest, {1.0, 1.0}, kGapPt * px, least_map(format));
      if (auto drawn = draw_map(canvas, context, parts[0], step); !drawn) return drawn;
      draw_seen(canvas, format, parts[1], step);
    }
    draw_bars(canvas, format, bottom, bars);
    return {};
  }

 private:
  /// Reads the step that is shown and lays it on the map, once for all frames of a film that show it.
  Result<void> read_shown_step() {
    if (step_ && shown_index_ == index()) return {};
    auto step = read_step();
    if (!step) return forward_error(step);
    step_ = std::move(*step);
    shown_index_ = index();
    agreement_ = moment_agreement(*step_, labels_);
    classes_ = patch_legend(*step_, labels_);
    bars_.reset();
    lay_on_map(*step_);
    return {};
  }

  void lay_on_map(const RunStep& step) {
    // Room for the topview, the truth and three deviations around the estimate.
    constexpr double kLeastSideM = 50.0;
    const Eigen::Vector2d centre = step.estimate.moments.mean.translation_m();
    const Eigen::Matrix3d& covariance = step.estimate.moments.covariance;
    double reach_m = 0.0;
    const auto reach = [&reach_m](double length_m) {
      if (std::isfinite(length_m)) reach_m = std::max(reach_m, length_m);
    };
    reach(3.0 * std::sqrt(covariance(0, 0) + covariance(1, 1)));
    if (step.truth_in_enu) reach((step.truth_in_enu->translation_m() - centre).norm());
    const Eigen::Vector2d size_m = map_->map_bounds_in_enu_m().sizes();
    map_->show_square(centre, std::min(std::max(kLeastSideM, 2.5 * reach_m), size_m.maxCoeff()));
    const bool has_particles = shows_particles(step);
    particles_.set_visible(has_particles);
    if (has_particles) particles_.show(*step.particles);
    const bool has_topview = shows_topview(step);
    topview_.set_visible(has_topview);
    if (!has_topview) return;
    const TopviewRaster raster = topview_raster(*step.topview);
    const double cell_m = step.topview->metres_per_cell;
    topview_.show(class_picture(raster.labels),
                  enu_from_topview_corner(step.estimate.moments.mean, raster, cell_m),
                  Eigen::Vector2d::Constant(cell_m), false);
    topview_.set_opacity(0.8);
  }

  [[nodiscard]] bool shows_particles(const RunStep& step) const {
    return options().layers.has(FigureLayer::kParticles) && step.particles.has_value();
  }
  [[nodiscard]] bool shows_topview(const RunStep& step) const {
    return options().layers.has(FigureLayer::kTopview) && step.topview &&
           !step.topview->cells.empty() && is_finite(step.estimate.moments.mean);
  }
  /// With the layer of modes all of them, else only the heaviest.
  [[nodiscard]] std::span<const PoseMode> shown_modes(const RunStep& step) const {
    const std::span<const PoseMode> modes = step.estimate.modes;
    return options().layers.has(FigureLayer::kModes)
               ? modes
               : modes.first(std::min<std::size_t>(modes.size(), 1));
  }

  Result<void> draw_map(Canvas& canvas,
                        FigureContext& context,
                        PageRect panel,
                        const RunStep& step) {
    const PageFormat& format = context.format();
    if (!least_map(format).fits_in(panel)) return {};
    draw_caption(canvas, format, panel, "(a) over the overhead");
    const auto frame = map_->draw_ground(canvas, context, panel);
    if (!frame) return forward_error(frame);
    canvas.push_clip(frame->where);
    draw_lines(canvas, *frame, step, format.colours());
    canvas.pop_clip();
    std::vector<PageRect> plates;
    if (shown_modes(step).size() > 1) {
      for (const auto& plate :
           mode_plates(*frame, shown_modes(step), mode_look(format.colours()))) {
        if (plate) plates.push_back(*plate);
      }
    }
    map_->draw_furniture(canvas, format, *frame, plates);
    return {};
  }

  void draw_lines(Canvas& canvas,
                  const MapFrame& frame,
                  const RunStep& step,
                  const Theme& theme) const {
    constexpr std::array<double, 3> kSigmas = {3.0, 2.0, 1.0};
    constexpr std::array<Source, 3> kSources = {Source::kOdometry, Source::kTruth,
                                                Source::kEstimate};
    for (const Source source : kSources) {
      if (!options().layers.has(layer_of(source))) continue;
      std::vector<Eigen::Vector2d> path = path_of(run(), source);
      path.resize(index() + 1);
      draw_path(canvas, frame, path, look_of(source, theme));
    }
    if (options().layers.has(FigureLayer::kEllipses)) {
      PathLook thin = estimate_look(theme);
      thin.width_pt = 0.9;
      for (const PoseMode& mode : shown_modes(step)) {
        draw_ellipses(canvas, frame, mode.moments.mean.translation_m(),
                      mode.moments.covariance.topLeftCorner<2, 2>(), kSigmas, thin);
      }
    }
    for (const Source source : kSources) {
      const auto pose = pose_of(step, source);
      if (!pose || !options().layers.has(layer_of(source))) continue;
      draw_pose(canvas, frame, *pose, 10.0, look_of(source, theme));
    }
    if (shown_modes(step).size() > 1) {
      draw_modes(canvas, frame, shown_modes(step), mode_look(theme));
    }
  }

  [[nodiscard]] static ModeLook mode_look(const Theme& theme) {
    ModeLook look;
    look.arrow = estimate_look(theme);
    look.plate = with_opacity(theme.page, 0.85);
    look.words.colour = theme.text;
    return look;
  }

  /// The camera's picture above the topview and what the map has in its place.
  void draw_seen(Canvas& canvas,
                 const PageFormat& format,
                 const PageRect& panel,
                 const RunStep& step) {
    if (!least_picture(format).fits_in(panel)) return;
    auto parts = fitting_rows(panel, {1.2, 1.0}, 8.0 * format.px_per_pt(), least_picture(format));
    draw_caption(canvas, format, parts[0], "(b) camera");
    const auto picture = camera_.at(step.time_s);
    if (picture) {
      canvas.image(fitted((*picture)->width(), (*picture)->height(), parts[0]), **picture);
    } else {
      draw_message(canvas, format, parts[0], picture.error().message);
    }
    draw_patches(canvas, format, parts[1], step, labels_, agreement_);
  }

  void draw_bars(Canvas& canvas,
                 const PageFormat& format,
                 PageRect panel,
                 const std::optional<ChartSpec>& bars) {
    if (!least_chart(format).fits_in(panel)) return;
    const std::string caption = "(g) cells that agree with the map, by class seen";
    if (!bars) {
      draw_caption(canvas, format, panel, caption);
      const auto unlike = step_->topview ? unlike_cells(*step_->topview, labels_) : std::nullopt;
      draw_message(canvas, format, panel,
                   unlike.value_or("no cell of the topview lies on ground that the map knows"));
      return;
    }
    if (!bars_) bars_.emplace(std::vector<CaptionedChart>{{caption, *bars}}, 1);
    bars_->draw(canvas, format, panel);
  }

  [[nodiscard]] std::vector<LegendEntry> legend(const Theme& theme,
                                                const RunStep& step,
                                                bool has_bars) const {
    std::vector<LegendEntry> entries = source_legend(run(), options(), theme);
    const auto has_ellipses = [](const PoseMode& mode) {
      return mode.moments.covariance.topLeftCorner<2, 2>().allFinite();
    };
    const std::span<const PoseMode> modes = shown_modes(step);
    if (options().layers.has(FigureLayer::kEllipses) &&
        std::any_of(modes.begin(), modes.end(), has_ellipses)) {
      entries.push_back(ellipse_legend("ellipses: 1, 2 and 3 sigma", 1, theme));
    }
    if (shows_particles(step)) entries.push_back(particle_legend());
    entries.insert(entries.end(), classes_.begin(), classes_.end());
    if (agreement_) {
      for (const LegendEntry& entry : agreement_legend(agreement_->at_estimate, theme)) {
        entries.push_back(entry);
      }
    }
    if (has_bars) {
      entries.push_back({"share at estimate", theme.estimate, LegendEntry::Kind::kBar});
      if (agreement_->at_truth) {
        entries.push_back({"at truth", theme.muted, LegendEntry::Kind::kBar});
      }
    }
    return entries;
  }

  [[nodiscard]] std::string words(const RunStep& step) const {
    return fmt::format("{:.1f} s after the start{} · {}", run().elapsed_s(step), belief_words(step),
                       foot_of(run()));
  }

  std::unique_ptr<MapPanel> map_;  ///< Before the views, which lie in its scene.
  OverheadMap labels_;
  CameraPictures camera_;
  ParticleView particles_;
  RasterView topview_;
  std::optional<RunStep> step_;  ///< The one of shown_index_, as it lies on the map.
  std::size_t shown_index_ = 0;
  std::optional<MomentAgreement> agreement_;
  std::vector<LegendEntry> classes_;
  std::optional<ChartGrid> bars_;  ///< Of the step and this theme.
  ThemeName theme_ = ThemeName::kLight;
};

}  // namespace

Result<std::unique_ptr<Figure>> make_moment(FigureInputs inputs) {
  auto labels = read_overhead_map(inputs.map);
  if (!labels) return forward_error(labels);
  // Close around the vehicle unless the user chose another crop.
  auto panel = MapPanel::create(inputs.map, MapPanel::Ground::kPicture, inputs.options);
  if (!panel) return forward_error(panel);
  return std::make_unique<Moment>(std::move(*panel), std::move(*labels), std::move(inputs));
}

}  // namespace nadir
