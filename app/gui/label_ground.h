// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "core/desk/coming_stroke.h"
#include "core/desk/label_desk.h"
#include "core/map/overhead_image.h"
#include "widgets/gl/view_texture.h"
#include "widgets/views/label_borders_view.h"
#include "widgets/views/map_scene.h"
#include "widgets/views/tile_pyramid_view.h"

namespace nadir {

/// How what is labelled is shown.
struct LabelGroundLook {
  bool shows_borders = true;
  double picture_opacity = 1.0, labels_opacity = 1.0;
  Rgba background;
  friend bool operator==(const LabelGroundLook&, const LabelGroundLook&) = default;
};

/// The picture, the labels as they are drawn and the borders of their objects, as a texture of the window. What a gesture
/// changes is seen in the next frame. The window's OpenGL context must be current.
class LabelGround {
 public:
  /// @param named  As labels were opened. @param budget  Of tiles, shared.
  LabelGround(const LabelDesk& desk,
              const std::filesystem::path& named,
              std::shared_ptr<TileBudget> budget);

  /// @errors kMalformed: the picture's file is damaged where it was read; what could be drawn is. Once also those of opening the picture.
  [[nodiscard]] Result<void> draw(const LabelDesk& desk,
                                  const LabelGroundLook& look,
                                  const MapCamera& camera,
                                  int width,
                                  int height,
                                  double px_per_pt);
  [[nodiscard]] std::uint32_t texture() const { return texture_.texture(); }
  /// Whether tiles are still missing, so that the next frame shows more.
  [[nodiscard]] bool wants_more() const { return wants_more_; }
  [[nodiscard]] bool has_picture() const { return picture_ != nullptr; }

 private:
  /// All that a drawing depends on beside the tiles that have come.
  struct Drawn {
    LabelGroundLook look;
    MapCamera camera;
    int width = 0, height = 0;
    double px_per_pt = 0.0;
    friend bool operator==(const Drawn&, const Drawn&) = default;
  };
  void open_picture(const LabelDesk& desk, const std::filesystem::path& named);
  /// Whether labels are different from those that were drawn last.
  bool follow(const LabelDesk& desk);

  MapScene scene_;
  ViewTexture texture_;
  std::shared_ptr<TileBudget> budget_;
  std::unique_ptr<TilePyramidView> picture_;  ///< Null: there is none.
  std::optional<Error> picture_fault_;        ///< Why there is none; told once.
  ComingStroke stroke_;
  std::unique_ptr<TilePyramidView> labels_;
  LabelBordersView borders_;
  std::int64_t bordered_ = -1;  ///< Revision of the document whose borders are shown.
  std::optional<Drawn> drawn_;
  bool wants_more_ = false;
};

}  // namespace nadir
