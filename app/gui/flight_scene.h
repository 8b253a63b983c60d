// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "core/base/result.h"
#include "core/flight/flight_recording.h"
#include "core/geo/rigid2.h"
#include "core/session/step_cache.h"
#include "widgets/gl/view_texture.h"
#include "widgets/views/cloud_view.h"
#include "widgets/views/frustum_view.h"
#include "widgets/views/ground_view.h"
#include "widgets/views/space_camera.h"
#include "widgets/views/space_scene.h"
#include "widgets/views/theme.h"

namespace nadir {

/// One instant in space, in the window: the labelled points that the camera saw, standing on the overhead where a pose lays
/// them. The context that the window draws with must be current whenever this is used.
class FlightScene {
 public:
  /// @errors as OverheadTiles::open.
  [[nodiscard]] static Result<std::unique_ptr<FlightScene>> open(
      const std::filesystem::path& package);

  /// Cheap where pose and camera moment are those of the last call; keeps what is shown where it is not called.
  /// @param pose_in_enu, camera  Nothing, null: nothing to be seen.
  /// @errors kMalformed: labels or depth do not have the camera's size; then no cloud is shown.
  [[nodiscard]] Result<void> show(const std::optional<Rigid2>& pose_in_enu,
                                  const std::shared_ptr<const CameraMoment>& camera,
                                  const FlightRecording* flight);

  /// @param camera  Nothing: behind and above the vehicle. @returns the camera that was used.
  /// @errors kMalformed: the map's file is damaged there.
  [[nodiscard]] Result<SpaceCamera> draw(const std::optional<SpaceCamera>& camera,
                                         ThemeName theme,
                                         int width,
                                         int height,
                                         double px_per_pt);
  [[nodiscard]] std::uint32_t texture() const { return texture_.texture(); }
  [[nodiscard]] bool shows_cloud() const { return shows_cloud_; }
  /// Of the ground, at most, in main memory and as textures.
  [[nodiscard]] std::size_t tile_bytes() const { return ground_->tile_bytes(); }

 private:
  explicit FlightScene(const Eigen::Vector2d& centre_in_enu_m);
  [[nodiscard]] SpaceCamera behind_vehicle(const PageRect& where) const;
  void show_cloud(bool shows);

  SpaceScene scene_;
  ViewTexture texture_;
  std::unique_ptr<GroundView> ground_;
  CloudView cloud_;
  FrustumView frustum_;
  std::shared_ptr<const CameraMoment> seen_;
  std::optional<Rigid2> pose_in_enu_;
  bool shows_cloud_ = false;
  bool is_changed_ = true;
  struct Sight {
    SpaceCamera camera;
    ThemeName theme;
    int width, height;
    double px_per_pt;
    friend bool operator==(const Sight&, const Sight&) = default;
  };
  std::optional<Sight> drawn_;
};

}  // namespace nadir
