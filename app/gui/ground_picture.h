// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "core/base/result.h"
#include "core/run/run_file.h"
#include "core/session/ground_reconstruction.h"
#include "core/session/moment_surface.h"
#include "core/session/view_state.h"
#include "widgets/gl/view_texture.h"
#include "widgets/views/agreement_view.h"
#include "widgets/views/map_scene.h"
#include "widgets/views/overhead_view.h"
#include "widgets/views/particle_view.h"
#include "widgets/views/raster_view.h"
#include "widgets/views/theme.h"

namespace nadir {

/// What lies on the ground at a moment. Pointers that are the same mean that nothing has changed.
struct GroundContents {
  MapLook look;
  std::shared_ptr<const RunStep> step;        ///< Null: none, or not decoded yet.
  std::shared_ptr<const OverheadMap> labels;  ///< Null until the map has been read.
  std::shared_ptr<const ReconstructedGround> reconstruction;
  std::shared_ptr<const MomentSurface> surface;
  ThemeName theme = ThemeName::kDark;
};

/// The ground of the window's map: all that VTK draws of it, as a texture. Lines and words lie over it and are the panel's.
/// The context that the window draws with must be current whenever this is used.
class GroundPicture {
 public:
  /// Reads no pixels yet. @errors as OverheadTiles::open.
  [[nodiscard]] static Result<std::unique_ptr<GroundPicture>> open(
      const std::filesystem::path& package);

  /// Cheap where nothing has changed since the last call.
  void show(const GroundContents& contents);

  /// Draws what a camera sees, unless the last drawing shows it already, and brings in a few tiles. @param width, height
  /// Pixels, > 0. @errors kMalformed: the map's file is damaged there; what could be drawn is.
  [[nodiscard]] Result<void> draw(const MapCamera& camera, int width, int height, double px_per_pt);
  [[nodiscard]] std::uint32_t texture() const { return texture_.texture(); }
  /// Whether tiles are still missing, so that the next frame shows more.
  [[nodiscard]] bool wants_more() const { return wants_more_; }

 private:
  explicit GroundPicture(const Eigen::Vector2d& centre_in_enu_m);
  /// Of a map without a picture the labels are the ground.
  [[nodiscard]] bool shows_labels(const MapLook& look) const;
  void show_layers(const MapLook& look);
  void show_topview(const GroundContents& contents);
  void show_surface(const MomentSurface& surface);

  struct Sight {
    MapCamera camera;
    int width = 0, height = 0;
    double px_per_pt = 0.0;
    friend bool operator==(const Sight&, const Sight&) = default;
  };

  MapScene scene_;
  ViewTexture texture_;  ///< Draws the scene.
  std::unique_ptr<OverheadView> picture_, labels_;
  RasterView reconstruction_, surface_, topview_;
  AgreementView agreement_;
  ParticleView particles_;
  std::optional<GroundContents> shown_;
  std::optional<Sight> drawn_;
  bool wants_more_ = false;
};

}  // namespace nadir
