// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>

#include "core/base/result.h"
#include "widgets/canvas/canvas.h"
#include "widgets/gl/picture_texture.h"
#include "widgets/kit/ui_context.h"

namespace nadir::kit {

/// Draws finished frames of one UiContext with OpenGL 3.3. Made, used and destroyed with the same OpenGL context current, before
/// the UiContext goes.
class UiRenderer {
 public:
  /// @errors kUnsupported: OpenGL's shaders cannot be made.
  [[nodiscard]] static Result<std::unique_ptr<UiRenderer>> create(UiContext& context);
  ~UiRenderer();
  UiRenderer(const UiRenderer&) = delete;
  UiRenderer& operator=(const UiRenderer&) = delete;

  /// The last finished frame, over what the frame buffer that is bound now has; its whole size is the frame's.
  void draw();
  /// The same into a frame buffer of its own, filled with the window's colour before: a screenshot. Leaves frame buffer 0 bound.
  /// @errors kUnsupported: larger than OpenGL can draw.
  [[nodiscard]] Result<Raster<Rgba>> draw_to_pixels();

 private:
  explicit UiRenderer(UiContext& context);
  [[nodiscard]] std::uint32_t texture_of(std::uint64_t picture);
  void forget_unused();

  UiContext& context_;
  std::map<std::uint64_t, PictureTexture> textures_;  ///< By the number of UiPictures.
  const void* fonts_ = nullptr;                       ///< That texture 1 shows.
};

}  // namespace nadir::kit
