// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/run/run_file.h"
#include "core/session/ground_reconstruction.h"
#include "core/session/moment_surface.h"
#include "core/session/view_state.h"
#include "widgets/gl/picture_texture.h"
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
  bool shows_best_turn =
      false;  ///< The surface of each place's best heading, not of the estimate's.
  ThemeName theme = ThemeName::kDark;
};

/// Layers of the ground that are drawn together, because lines lie between them and the others.
struct GroundPart {
  std::vector<Layer> layers;  ///< In any order; those that are no ground are passed over.
  int number = 0, count = 1;  ///< All parts of a frame are drawn one after the other.
  bool is_lowest = true;      ///< On the window's colour; else it lets through what lies below.
  friend bool operator==(const GroundPart&, const GroundPart&) = default;
};

/// The ground of the window's map: all that VTK draws of it, as a texture. Lines and words lie over it and are the panel's.
/// The context that the window draws with must be current whenever this is used.
class GroundPicture {
 public:
  /// Reads no pixels yet. @param budget  That its tiles share with others; null: one of its own. @errors as
  /// OverheadTiles::open.
  [[nodiscard]] static Result<std::unique_ptr<GroundPicture>> open(
      const std::filesystem::path& package, std::shared_ptr<TileBudget> budget = nullptr);
  /// Without a map: particles, topview and reconstruction alone. @param centre_in_enu_m  Near them.
  [[nodiscard]] static std::unique_ptr<GroundPicture> without_map(
      const Eigen::Vector2d& centre_in_enu_m);

  /// Cheap where nothing has changed since the last call.
  void show(const GroundContents& contents);

  /// Draws what a camera sees of some layers, unless the last drawing shows it already, and brings in a few tiles. A part that
  /// lies on lines, or is one of several, costs a copy. @param width, height  Pixels, > 0.
  /// @errors kMalformed: the map's file is damaged there; what could be drawn is.
  [[nodiscard]] Result<void> draw(
      const MapCamera& camera, int width, int height, double px_per_pt, const GroundPart& part);
  /// As drawn last, rows from the bottom, not premultiplied. @param number  Of the part.
  [[nodiscard]] std::uint32_t texture(int number = 0) const;
  /// Whether tiles are still missing, so that the next frame shows more.
  [[nodiscard]] bool wants_more() const;
  /// False: the map is labels only, or there is none.
  [[nodiscard]] bool has_picture() const { return picture_ != nullptr; }
  /// How often topview and agreement were laid anew: not while only the camera moves.
  [[nodiscard]] std::size_t topviews_laid() const { return topviews_laid_; }

 private:
  explicit GroundPicture(const Eigen::Vector2d& centre_in_enu_m);
  void show_layers(const MapLook& look);
  void show_topview(const GroundContents& contents);
  void show_surface(const MomentSurface& surface, bool shows_best_turn);
  [[nodiscard]] Result<void> update_tiles(const MapCamera& camera,
                                          int width,
                                          int height,
                                          const GroundPart& part);

  struct Sight {
    MapCamera camera;
    int width = 0, height = 0;
    double px_per_pt = 0.0;
    GroundPart part;
    friend bool operator==(const Sight&, const Sight&) = default;
  };
  struct DrawnPart {
    std::optional<Sight> sight;  ///< That the texture shows; nothing: it is to be drawn again.
    bool wants_more = false;
    std::unique_ptr<PictureTexture> copy;  ///< Where the scene's own texture does not do.
    std::uint32_t texture = 0;
  };

  MapScene scene_;
  ViewTexture texture_;                             ///< Draws the scene.
  std::unique_ptr<OverheadView> picture_, labels_;  ///< Null: none.
  RasterView reconstruction_, surface_, topview_;
  AgreementView agreement_;
  ParticleView particles_;
  std::optional<GroundContents> shown_;
  std::vector<DrawnPart> parts_;
  std::size_t topviews_laid_ = 0;
};

}  // namespace nadir
