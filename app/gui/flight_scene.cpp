// SPDX-License-Identifier: Apache-2.0
#include "app/gui/flight_scene.h"

#include "core/eval/evaluated_step.h"
#include "widgets/figures/flight_moments.h"

namespace nadir {
namespace {

constexpr double kFarthestPointM = 50.0;
constexpr double kFrustumLengthM = 12.0;

FrustumLook frustum_look() {
  const Theme& colours = theme(ThemeName::kDark);
  return {colours.bad, colours.casing_on_imagery, 1.0};
}

}  // namespace

Result<std::unique_ptr<FlightScene>> FlightScene::open(const std::filesystem::path& package) {
  std::error_code error;
  const auto layer = std::filesystem::exists(package / "image.tif", error)
                         ? OverheadTiles::Layer::kPicture
                         : OverheadTiles::Layer::kLabels;
  auto tiles = OverheadTiles::open(package, layer);
  if (!tiles) return forward_error(tiles);
  const Eigen::Vector2d centre =
      tiles->top_left_in_enu_m() +
      tiles->metres_per_cell() / 2.0 * Eigen::Vector2d(tiles->width(), -tiles->height());
  std::unique_ptr<FlightScene> scene(new FlightScene(centre));
  scene->ground_ = std::make_unique<GroundView>(scene->scene_, std::move(*tiles), layer);
  return scene;
}

FlightScene::FlightScene(const Eigen::Vector2d& centre_in_enu_m)
    : scene_(centre_in_enu_m),
      texture_(scene_.renderer()),
      cloud_(scene_),
      frustum_(scene_, frustum_look()) {
  show_cloud(false);
}

void FlightScene::show_cloud(bool shows) {
  shows_cloud_ = shows;
  cloud_.set_visible(shows);
  frustum_.set_visible(shows);
}

Result<void> FlightScene::show(const std::optional<Rigid2>& pose_in_enu,
                               const std::shared_ptr<const CameraMoment>& camera,
                               const FlightRecording* flight) {
  const auto known = pose_in_enu && is_finite(*pose_in_enu) ? pose_in_enu : std::nullopt;
  if (known == pose_in_enu_ && camera == seen_) return {};
  pose_in_enu_ = known;
  seen_ = camera;
  is_changed_ = true;
  const bool has_cloud = pose_in_enu_ && camera && flight != nullptr &&
                         flight->description().camera && !camera->labels.empty() &&
                         !camera->depth_m.empty();
  show_cloud(false);  // what is shown is of another moment
  if (!has_cloud) return {};
  auto moment = flight_moment(flight->description(), camera->clock_s, camera->labels,
                              camera->depth_m, kFarthestPointM, 1);
  if (!moment) return forward_error(moment);
  const Rigid3 enu_from_level{
      Eigen::Quaterniond(Eigen::AngleAxisd(pose_in_enu_->yaw_rad, Eigen::Vector3d::UnitZ())),
      {pose_in_enu_->x_m, pose_in_enu_->y_m, moment->level_height_m}};
  cloud_.show(moment->cloud);
  cloud_.place(enu_from_level);
  frustum_.place(moment->camera, enu_from_level * moment->level_from_camera, kFrustumLengthM);
  show_cloud(true);
  return {};
}

SpaceCamera FlightScene::behind_vehicle(const PageRect& where) const {
  constexpr double kWidthM = 34.0;
  constexpr double kAheadM = 7.0;
  constexpr double kAsideRad = 0.2;
  SpaceCamera camera;
  if (pose_in_enu_) {
    const Eigen::Vector2d ahead = *pose_in_enu_ * Eigen::Vector2d(kAheadM, 0.0);
    camera.target_in_enu_m = {ahead.x(), ahead.y(), 0.0};
    camera.yaw_rad = pose_in_enu_->yaw_rad + kAsideRad;
  } else {
    const OverheadTiles& tiles = ground_->tiles();
    const Eigen::Vector2d middle =
        tiles.top_left_in_enu_m() +
        tiles.metres_per_cell() / 2.0 * Eigen::Vector2d(tiles.width(), -tiles.height());
    camera.target_in_enu_m = {middle.x(), middle.y(), 0.0};
  }
  camera.distance_m = camera.distance_to_show(kWidthM, where);
  return camera;
}

Result<SpaceCamera> FlightScene::draw(const std::optional<SpaceCamera>& wanted,
                                      ThemeName theme_name,
                                      int width,
                                      int height,
                                      double px_per_pt) {
  constexpr double kAroundShare =
      4.0;  // of the width, to every side: beyond the far end of the view
  const PageRect where{0.0, 0.0, 1.0 * width, 1.0 * height};
  const SpaceCamera camera = wanted ? *wanted : behind_vehicle(where);
  const Sight sight{camera, theme_name, width, height, px_per_pt};
  if (drawn_ == sight && !is_changed_) return camera;
  const double width_m = camera.distance_m / camera.distance_to_show(1.0, where);
  const Eigen::Vector2d around = Eigen::Vector2d::Constant(kAroundShare * width_m);
  const Eigen::Vector2d target = camera.target_in_enu_m.head<2>();
  const auto laid = ground_->show({target - around, target + around}, width_m / where.width);
  scene_.set_background(theme(theme_name).window, false);
  scene_.look(camera, px_per_pt);
  texture_.draw(width, height);
  drawn_ = sight;
  is_changed_ = false;
  if (!laid) return forward_error(laid);
  return camera;
}

}  // namespace nadir
