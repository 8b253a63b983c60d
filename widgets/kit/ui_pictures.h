// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>

#include "widgets/canvas/canvas.h"

namespace nadir::kit {

/// Pictures that a frame shows and that are no textures yet: drawing needs no OpenGL, UiRenderer makes the textures later. The same
/// pixels are one picture, in this frame and the next; one that a frame does not show is forgotten.
class UiPictures {
 public:
  using Id = void*;  ///< Dear ImGui's.

  struct Picture {
    Raster<Rgba> pixels;
    bool is_used = true;
  };

  /// What stands for the picture in the list of triangles.
  Id add(const Raster<Rgba>& pixels);
  void begin_frame();
  void end_frame();
  [[nodiscard]] const std::map<std::uint64_t, Picture>& all() const { return pictures_; }

  /// What stands for the fonts.
  [[nodiscard]] static Id font_id();
  /// A texture of OpenGL, which needs no picture.
  [[nodiscard]] static Id texture_id(std::uint32_t texture);
  /// The number that `all()` has it under, 0 for a texture of OpenGL; of font_id() 1.
  [[nodiscard]] static std::uint64_t picture_of(Id id);

 private:
  std::map<std::uint64_t, Picture> pictures_;
};

}  // namespace nadir::kit
