// SPDX-License-Identifier: Apache-2.0
// One instant of a run: what the filter knew, what the camera saw, and how that fits the map.
#include <fmt/format.h>

#include <cmath>

#include "core/base/angle.h"
#include "core/flight/colour_image.h"
#include "core/flight/flight_recording.h"
#include "core/mcl/map_patch.h"
#include "widgets/figures/chart_panel.h"
#include "widgets/figures/class_pictures.h"
#include "widgets/figures/figures.h"
#include "widgets/figures/page_layout.h"
#include "widgets/figures/run_lines.h"
#include "widgets/views/particle_view.h"
#include "widgets/views/raster_view.h"

namespace nadir {
namespace {

/// The camera's pictures of a run's flight, where they are still there.
class CameraPictures {
 public:
  explicit CameraPictures(const std::filesystem::path& flight) {
    auto opened = open_flight(flight);
    if (!opened) {
      why_not_ = opened.error().message;
    } else {
      flight_ = std::move(*opened);
    }
  }

  /// The picture nearest in time. @errors what to say in its place.
  [[nodiscard]] Result<ColourRaster> at(double time_s) const {
    if (!flight_) return fail(ErrorCode::kNotFound, "no camera image: {}", why_not_);
    const FlightFrame* nearest = nullptr;
    for (const FlightFrame& frame : flight_->description().frames) {
      if (!frame.image) continue;
      if (nearest == nullptr ||
          std::abs(frame.time_s - time_s) < std::abs(nearest->time_s - time_s)) {
        nearest = &frame;
      }
    }
    if (nearest == nullptr) return fail(ErrorCode::kNotFound, "the flight holds no camera images");
    return read_colour_image(*nearest->image);
  }

 private:
  std::unique_ptr<FlightRecording> flight_;
  std::string why_not_;
};

class Moment : public Figure {
 public:
  Moment(std::unique_ptr<MapPanel> map, OverheadMap labels, FigureInputs inputs)
      : map_(std::move(map)),
        labels_(std::move(labels)),
        inputs_(std::move(inputs)),
        camera_(run().reader.header().flight_path),
        particles_(map_->scene()),
        topview_(map_->scene(), MapLayer::kTopview) {
    show_at(inputs_.options.time_s);
  }

  Result<void> draw(Canvas& canvas, FigureContext& context) override {
    const auto step = run().reader.step(run().steps[index_].step);
    if (!step) return forward_error(step);
    const PageFormat& format = context.format();
    const Theme& theme = format.colours();
    const double px = format.px_per_pt();
    lay_on_map(*step);
    PageRect rest = page_inside(format);
    draw_foot(canvas, format, rest, words(*step));
    draw_page_legend(canvas, format, rest, legend(theme, *step));
    const PageRect bottom = take_bottom(rest, 0.24 * rest.height, 8.0 * px);
    auto sides = columns(rest, {1.35, 1.0}, 12.0 * px);
    draw_caption(canvas, format, sides[0], "(a) particles, estimate and topview over the overhead");
    const auto frame = map_->draw_ground(canvas, context, sides[0]);
    if (!frame) return forward_error(frame);
    draw_lines(canvas, *frame, *step, theme);
    map_->draw_furniture(canvas, format, *frame);
    auto right = rows(sides[1], {1.3, 1.0}, 8.0 * px);
    draw_camera(canvas, format, right[0], *step);
    draw_patches(canvas, format, right[1], *step);
    draw_agreement(canvas, format, bottom, *step);
    return {};
  }

  [[nodiscard]] std::optional<FigureTimes> times() const override { return times_of(inputs_.runs); }
  void show_at(double time_s) override { index_ = run().index_at(time_s); }

 private:
  [[nodiscard]] const FigureRun& run() const { return inputs_.runs.front(); }

  void lay_on_map(const RunStep& step) {
    // Room for the topview, the truth and three deviations around the estimate.
    constexpr double kLeastSideM = 50.0;
    const Eigen::Vector2d centre = step.estimate.moments.mean.translation_m();
    const Eigen::Matrix3d& covariance = step.estimate.moments.covariance;
    double reach_m = 3.0 * std::sqrt(covariance(0, 0) + covariance(1, 1));
    if (step.truth_in_enu) {
      reach_m = std::max(reach_m, (step.truth_in_enu->translation_m() - centre).norm());
    }
    const Eigen::Vector2d size_m = map_->map_bounds_in_enu_m().sizes();
    map_->show_square(centre, std::min(std::max(kLeastSideM, 2.5 * reach_m), size_m.maxCoeff()));
    const bool has_particles = inputs_.options.shows_particles && step.particles.has_value();
    particles_.set_visible(has_particles);
    if (has_particles) particles_.show(*step.particles);
    const bool has_topview =
        inputs_.options.shows_topview && step.topview && !step.topview->cells.empty();
    topview_.set_visible(has_topview);
    if (!has_topview) return;
    const TopviewRaster raster = topview_raster(*step.topview);
    const double cell_m = step.topview->metres_per_cell;
    // The picture's upper left corner is its farthest left one; its rows run to the right of the heading.
    const Rigid2 body_from_corner{cell_m * raster.body_row, cell_m * raster.body_column,
                                  -std::numbers::pi / 2.0};
    topview_.show(class_picture(raster.labels), step.estimate.moments.mean * body_from_corner,
                  Eigen::Vector2d::Constant(cell_m), false);
    topview_.set_opacity(0.8);
  }

  void draw_lines(Canvas& canvas,
                  const MapFrame& frame,
                  const RunStep& step,
                  const Theme& theme) const {
    constexpr std::array<double, 3> kSigmas = {3.0, 2.0, 1.0};
    canvas.push_clip(frame.where);
    for (const Source source : {Source::kOdometry, Source::kTruth, Source::kEstimate}) {
      const PathLook look = source == Source::kTruth      ? truth_look(theme)
                            : source == Source::kOdometry ? odometry_look(theme)
                                                          : estimate_look(theme);
      std::vector<Eigen::Vector2d> path = path_of(run(), source);
      path.resize(index_ + 1);
      draw_path(canvas, frame, path, look);
      const auto pose = pose_of(step, source);
      if (pose) draw_pose(canvas, frame, *pose, 10.0, look);
    }
    PathLook thin = estimate_look(theme);
    thin.width_pt = 0.9;
    for (const PoseMode& mode : step.estimate.modes) {
      draw_ellipses(canvas, frame, mode.moments.mean.translation_m(),
                    mode.moments.covariance.topLeftCorner<2, 2>(), kSigmas, thin);
    }
    if (step.estimate.modes.size() > 1) {
      TextStyle style;
      style.size_px = 7.5 * frame.px_per_pt;
      style.colour = theme.text;
      for (const PoseMode& mode : step.estimate.modes) {
        const Eigen::Vector2d at = frame.page(mode.moments.mean.translation_m()) +
                                   Eigen::Vector2d(0.0, 14.0 * frame.px_per_pt);
        draw_plate(canvas, at, fmt::format("{:.0f} %", 100.0 * mode.mass), style,
                   with_opacity(theme.page, 0.85), frame.px_per_pt);
      }
    }
    canvas.pop_clip();
  }

  void draw_camera(Canvas& canvas,
                   const PageFormat& format,
                   PageRect panel,
                   const RunStep& step) const {
    draw_caption(canvas, format, panel, "(b) camera");
    const auto picture = camera_.at(step.time_s);
    if (!picture) {
      draw_message(canvas, format, panel, picture.error().message);
      return;
    }
    canvas.image(fitted(picture->width(), picture->height(), panel), colour_picture(*picture));
  }

  /// The topview as seen, and the map's patch at the estimate and at the truth, forward up.
  void draw_patches(Canvas& canvas,
                    const PageFormat& format,
                    PageRect panel,
                    const RunStep& step) const {
    const std::array<std::string, 3> captions = {"(c) topview", "(d) map, estimate",
                                                 "(e) map, truth"};
    auto parts = columns(panel, {1.0, 1.0, 1.0}, 6.0 * format.px_per_pt());
    for (std::size_t i = 0; i < 3; ++i) draw_caption(canvas, format, parts[i], captions.at(i));
    if (!step.topview || step.topview->cells.empty()) {
      draw_message(canvas, format, parts[0],
                   step.topview ? "the topview has no cells" : "the run holds no topviews");
      return;
    }
    const TopviewRaster seen = topview_raster(*step.topview);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto pose =
          i == 0 ? std::nullopt : pose_of(step, i == 1 ? Source::kEstimate : Source::kTruth);
      if (i > 0 && !pose) {
        draw_message(canvas, format, parts[i], "not known");
        continue;
      }
      const Raster<ClassId> labels = i == 0 ? seen.labels : map_patch(labels_, *pose, seen);
      const PageRect where = fitted(labels.width(), labels.height(), parts[i]);
      canvas.image(where, class_picture(labels));
      draw_frame(canvas, format, where);
    }
  }

  void draw_agreement(Canvas& canvas,
                      const PageFormat& format,
                      PageRect panel,
                      const RunStep& step) const {
    draw_caption(canvas, format, panel, "(f) cells that agree with the map, by class seen");
    const auto chart = agreement_bars(step, format.colours());
    if (!chart) {
      draw_message(canvas, format, panel,
                   "no cell of the topview lies on ground that the map knows");
      return;
    }
    XyChart(*chart, format.colours(), format.px_per_pt())
        .draw(canvas, panel, format.width, format.height);
  }

  [[nodiscard]] std::optional<ChartSpec> agreement_bars(const RunStep& step,
                                                        const Theme& theme) const {
    if (!step.topview) return std::nullopt;
    BarsSpec bars;
    const CellAgreement at_estimate =
        cell_agreement(*step.topview, labels_, step.estimate.moments.mean);
    std::optional<CellAgreement> at_truth;
    if (step.truth_in_enu) at_truth = cell_agreement(*step.topview, labels_, *step.truth_in_enu);
    bars.series.push_back({"at estimate", {}, theme.estimate});
    if (at_truth) bars.series.push_back({"at truth", {}, theme.muted});
    const auto percent = [](const CellAgreement& agreement, ClassId id) {
      const auto share = agreement.of_class[id].share();
      return share ? 100.0 * *share : std::nan("");
    };
    for (ClassId id = 0; id < kClassCount; ++id) {
      const CellAgreement::Count& count = at_estimate.of_class[id];
      if (count.agreeing + count.disagreeing == 0) continue;
      bars.groups.emplace_back(class_info(id).name);
      bars.series[0].heights.push_back(percent(at_estimate, id));
      if (at_truth) bars.series[1].heights.push_back(percent(*at_truth, id));
    }
    if (bars.groups.empty()) return std::nullopt;
    ChartSpec spec;
    spec.y = {"agreeing [%]", 0.0, 100.0};
    spec.bars = std::move(bars);
    return spec;
  }

  [[nodiscard]] std::vector<LegendEntry> legend(const Theme& theme, const RunStep& step) const {
    std::vector<LegendEntry> entries = run_legend(inputs_.runs, theme);
    entries.back().name = "estimate with 1, 2 and 3 sigma ellipses";
    if (step.particles && inputs_.options.shows_particles) {
      entries.push_back({"particles, light is heavy", value_colour(ValueColours::kViridis, 0.6),
                         LegendEntry::Kind::kDot});
    }
    if (step.topview) {
      entries.push_back({"agreement at estimate", theme.estimate, LegendEntry::Kind::kBar});
    }
    if (step.truth_in_enu) entries.push_back({"at truth", theme.muted, LegendEntry::Kind::kBar});
    return entries;
  }

  [[nodiscard]] std::string words(const RunStep& step) const {
    const PoseMoments& moments = step.estimate.moments;
    std::string text = fmt::format("{:.1f} s after the start", run().elapsed_s(step));
    if (step.truth_in_enu) {
      const double error_m =
          (moments.mean.translation_m() - step.truth_in_enu->translation_m()).norm();
      text += fmt::format(", {:.2f} m from the truth", error_m);
    }
    text +=
        fmt::format(", sigma {:.2f} m and {:.1f} deg, {} modes, effective sample size {:.0f} of {}",
                    std::sqrt(moments.covariance(0, 0) + moments.covariance(1, 1)),
                    Angle::radians(std::sqrt(moments.covariance(2, 2))).degrees(),
                    step.estimate.modes.size(), step.effective_sample_size, step.particle_count);
    return text + " · " + foot_of(run());
  }

  std::unique_ptr<MapPanel> map_;  ///< Before the views, which lie in its scene.
  OverheadMap labels_;
  FigureInputs inputs_;
  CameraPictures camera_;
  ParticleView particles_;
  RasterView topview_;
  std::size_t index_ = 0;
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
