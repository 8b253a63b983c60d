// SPDX-License-Identifier: Apache-2.0
// One instant in space: the labelled points that the camera saw, standing on the overhead where a pose lays them.
#include <fmt/format.h>

#include <bitset>
#include <cmath>

#include "widgets/figures/flight_moments.h"
#include "widgets/figures/map_panel.h"
#include "widgets/figures/page_layout.h"
#include "widgets/figures/run_lines.h"
#include "widgets/figures/timed_figure.h"
#include "widgets/views/cloud_view.h"
#include "widgets/views/frustum_view.h"
#include "widgets/views/ground_view.h"
#include "widgets/views/map_furniture.h"

namespace nadir {
namespace {

constexpr double kReachM = 50.0;  // depth up to which points are shown
constexpr int kEveryNthPixel = 1;
constexpr double kFrustumDepthM = 12.0;

/// Red: neither a line of a run nor a class of the ground has it.
Rgba camera_colour(const Theme& theme) { return theme.bad; }

/// A trajectory on the ground with its casing, and an arrow where it ends.
class GroundPath {
 public:
  GroundPath(SpaceScene& scene, const PathLook& look)
      : is_dashed_(look.is_dashed),
        casing_(scene, SpaceLayer::kOnGround, look.casing, look.width_pt + 2.0 * look.casing_pt),
        line_(scene, SpaceLayer::kOnGround, look.colour, look.width_pt) {}

  void show(std::span<const Eigen::Vector2d> path_in_enu_m, const std::optional<Rigid2>& end) {
    constexpr double kDashM = 0.8;
    constexpr double kGapM = 0.4;
    std::vector<SpacePath> paths = {on_ground(path_in_enu_m)};
    if (is_dashed_) paths = dashes_of(paths.front(), kDashM, kGapM);
    if (end) {
      const std::array<Eigen::Vector2d, 4> tip = {
          *end * Eigen::Vector2d(1.0, 0.0), *end * Eigen::Vector2d(-0.6, 0.5),
          *end * Eigen::Vector2d(-0.25, 0.0), *end * Eigen::Vector2d(-0.6, -0.5)};
      SpacePath arrow = on_ground(tip);
      arrow.push_back(arrow[0]);
      arrow.push_back(arrow[1]);  // so that the tip is whole
      paths.push_back(std::move(arrow));
    }
    casing_.show(paths);
    line_.show(paths);
  }

 private:
  bool is_dashed_;
  SpaceLines casing_, line_;
};

class Scene : public TimedFigure {
 public:
  Scene(std::vector<OverheadTiles> ground,
        std::span<const OverheadTiles::Layer> layers,
        FlightMoments flight,
        FigureInputs inputs)
      : TimedFigure(std::move(inputs)),
        flight_(std::move(flight)),
        scene_(middle_of(ground.front())),
        cloud_(scene_),
        frustum_(scene_, frustum_look(theme(options().theme))) {
    for (std::size_t i = 0; i < ground.size(); ++i) {
      ground_.push_back(std::make_unique<GroundView>(scene_, std::move(ground[i]), layers[i]));
    }
    if (ground_.size() > 1) ground_[1]->set_opacity(options().label_opacity);
    for (const Source source : {Source::kOdometry, Source::kTruth, Source::kEstimate}) {
      if (!options().layers.has(layer_of(source))) continue;
      paths_.emplace_back(
          source, std::make_unique<GroundPath>(scene_, look_of(source, theme(options().theme))));
    }
  }

  Result<void> draw(Canvas& canvas, FigureContext& context) override {
    if (auto read = read_shown_moment(); !read) return read;
    const PageFormat& format = context.format();
    const double px = format.px_per_pt();
    PageRect rest = page_inside(format);
    draw_foot(canvas, format, rest, words());
    draw_page_legend(canvas, format, rest, legend(format.colours()));
    if (!least_map(format).fits_in(rest)) return {};
    draw_caption(canvas, format, rest, caption());
    const PageRect where{std::ceil(rest.left), std::ceil(rest.bottom), std::floor(rest.width - 1.0),
                         std::floor(rest.height - 1.0)};
    const SpaceCamera camera = camera_for(where);
    if (auto laid = lay_ground(camera, where, context.supersampling); !laid) return laid;
    scene_.set_background(format.colours().window, format.is_transparent);
    scene_.look(camera, px * context.supersampling);
    const auto renderer = context.renderer();
    if (!renderer) return forward_error(renderer);
    const auto pixels = (*renderer)->render(scene_.renderer(), static_cast<int>(where.width),
                                            static_cast<int>(where.height), context.supersampling);
    if (!pixels) return forward_error(pixels);
    canvas.image(where, *pixels);
    draw_frame(canvas, format, where);
    draw_camera(canvas, format, where);
    // North as one sees it from above.
    constexpr double kLeastForNorthPt = 96.0;
    if (std::min(where.width, where.height) < kLeastForNorthPt * px) return {};
    draw_north_arrow(canvas, {where, {camera.target_in_enu_m.head<2>(), 1.0, camera.yaw_rad}, px},
                     format.colours());
    return {};
  }

 private:
  static Eigen::Vector2d middle_of(const OverheadTiles& tiles) {
    return tiles.top_left_in_enu_m() +
           tiles.metres_per_cell() / 2.0 * Eigen::Vector2d(tiles.width(), -tiles.height());
  }
  static FrustumLook frustum_look(const Theme& theme) {
    return {camera_colour(theme), theme.casing_on_imagery, 1.0};
  }

  /// Reads the moment that is shown and lays it in the scene, once for all frames of a film that show it.
  Result<void> read_shown_moment() {
    if (moment_ && shown_index_ == index()) return {};
    moment_.reset();
    const RunStep& step = run().steps[index()];
    const auto pose = pose_of(step, source_of(options().laid_at));
    if (!pose) {
      return fail(ErrorCode::kMalformed,
                  "{}: has no {} at {:.3f} s, where the figure lays what the camera saw",
                  run().path.string(), enum_name(options().laid_at), run().elapsed_s(step));
    }
    auto moment = flight_.at(step.time_s, kReachM, kEveryNthPixel);
    if (!moment) return forward_error(moment);
    pose_ = *pose;
    moment_ = std::move(*moment);
    shown_index_ = index();
    const Rigid3 enu_from_level{
        Eigen::Quaterniond(Eigen::AngleAxisd(pose_.yaw_rad, Eigen::Vector3d::UnitZ())),
        {pose_.x_m, pose_.y_m, moment_->level_height_m}};
    cloud_.show(moment_->cloud);
    cloud_.place(enu_from_level);
    frustum_.place(moment_->camera, enu_from_level * moment_->level_from_camera, kFrustumDepthM);
    for (const auto& [source, path] : paths_) {
      std::vector<Eigen::Vector2d> points = path_of(run(), source);
      points.resize(index() + 1);
      path->show(points, pose_of(step, source));
    }
    return {};
  }

  /// From behind and above, a little aside, so that the camera's axis is seen; the options' crop where there is one.
  [[nodiscard]] SpaceCamera camera_for(const PageRect& where) const {
    constexpr double kWidthM = 34.0;
    constexpr double kAheadM = 7.0;
    constexpr double kAsideRad = 0.2;
    SpaceCamera camera;
    const MapCrop& crop = options().crop;
    const Eigen::Vector2d ahead = pose_ * Eigen::Vector2d(kAheadM, 0.0);
    const Eigen::Vector2d target = crop.centre_in_enu_m.value_or(ahead);
    camera.target_in_enu_m = {target.x(), target.y(), 0.0};
    camera.yaw_rad = pose_.yaw_rad + kAsideRad;
    camera.down_rad = 0.5;
    camera.view_rad = 0.6;
    camera.distance_m = camera.distance_to_show(crop.is_all() ? kWidthM : crop.width_m, where);
    return camera;
  }

  Result<void> lay_ground(const SpaceCamera& camera, const PageRect& where, int supersampling) {
    constexpr double kAroundShare =
        4.0;  // of the width, to every side: beyond the far end of the page
    const double width_m = camera.distance_m / camera.distance_to_show(1.0, where);
    const Eigen::Vector2d around = Eigen::Vector2d::Constant(kAroundShare * width_m);
    const Eigen::Vector2d target = camera.target_in_enu_m.head<2>();
    for (const auto& ground : ground_) {
      auto shown =
          ground->show({target - around, target + around}, width_m / where.width / supersampling);
      if (!shown) return shown;
    }
    return {};
  }

  /// What the camera saw, in the upper left corner: the ground there is far away.
  void draw_camera(Canvas& canvas, const PageFormat& format, const PageRect& where) const {
    constexpr double kLeastWidthPt = 200.0;
    const double px = format.px_per_pt();
    if (where.width < kLeastWidthPt * px || where.height < kLeastWidthPt / 2.0 * px) return;
    const Raster<Rgba>& picture = moment_->picture;
    PageRect corner{where.left, where.bottom, 0.25 * where.width, 0.4 * where.height};
    corner = fitted(picture.width(), picture.height(), corner);
    corner.left = where.left + 6.0 * px;
    corner.bottom = where.top() - corner.height - 6.0 * px;
    canvas.image(corner, picture);
    draw_frame(canvas, format, corner);
  }

  [[nodiscard]] std::vector<LegendEntry> legend(const Theme& theme) const {
    std::vector<LegendEntry> entries = source_legend(run(), options(), theme);
    entries.push_back({fmt::format("camera, its view up to {:g} m", kFrustumDepthM),
                       camera_colour(theme), LegendEntry::Kind::kLine});
    std::bitset<256> present;
    for (const ClassId id : moment_->cloud.labels) present.set(id);
    for (ClassId id = 0; id < kClassCount; ++id) {
      if (!present.test(id)) continue;
      entries.push_back(
          {std::string(class_info(id).name), class_colour(id), LegendEntry::Kind::kDot});
    }
    return entries;
  }

  [[nodiscard]] std::string caption() const {
    return fmt::format("what the camera saw (inset) by class, laid at the {}",
                       enum_name(options().laid_at));
  }

  [[nodiscard]] std::string words() const {
    const RunStep& step = run().steps[shown_index_];
    std::string text = fmt::format("{:.1f} s after the start", run().elapsed_s(step));
    if (step.truth_in_enu && options().laid_at != LaidAt::kTruth) {
      text += fmt::format(", {} {:.2f} m from the truth", enum_name(options().laid_at),
                          (pose_.translation_m() - step.truth_in_enu->translation_m()).norm());
    }
    return text + fmt::format(" · {} points up to {:g} m, {:.1f} m above the ground · {}",
                              cloud_.drawn_count(), kReachM, moment_->level_height_m,
                              foot_of(run()));
  }

  FlightMoments flight_;
  SpaceScene scene_;  ///< Before the views, which lie in it.
  std::vector<std::unique_ptr<GroundView>> ground_;
  std::vector<std::pair<Source, std::unique_ptr<GroundPath>>> paths_;
  CloudView cloud_;
  FrustumView frustum_;
  std::optional<FlightMoment> moment_;  ///< The one of shown_index_, as it lies in the scene.
  std::size_t shown_index_ = 0;
  Rigid2 pose_;  ///< enu_from_body that it is laid at.
};

}  // namespace

Result<std::unique_ptr<Figure>> make_scene(FigureInputs inputs) {
  auto flight = FlightMoments::open(inputs.runs.front());
  if (!flight) return forward_error(flight);
  using GroundLayer = OverheadTiles::Layer;
  const FigureOptions& options = inputs.options;
  std::error_code error;
  const bool shows_picture = options.layers.has(FigureLayer::kPicture) &&
                             std::filesystem::exists(inputs.map / "image.tif", error);
  std::vector<GroundLayer> layers;
  if (shows_picture) layers.push_back(GroundLayer::kPicture);
  if (!shows_picture || options.label_opacity > 0.0) layers.push_back(GroundLayer::kLabels);
  std::vector<OverheadTiles> ground;
  for (const GroundLayer layer : layers) {
    auto tiles = OverheadTiles::open(inputs.map, layer);
    if (!tiles) return forward_error(tiles);
    ground.push_back(std::move(*tiles));
  }
  return std::make_unique<Scene>(std::move(ground), layers, std::move(*flight), std::move(inputs));
}

}  // namespace nadir
