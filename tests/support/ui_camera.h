// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <stdexcept>

#include "core/base/raster.h"
#include "widgets/gl/offscreen_context.h"
#include "widgets/kit/ui_context.h"
#include "widgets/kit/ui_renderer.h"

namespace nadir {

/// Takes pictures of user interfaces, all with one OpenGL context, which is current from its making. Needs no display.
class UiCamera {
 public:
  UiCamera() {
    auto opengl = OffscreenContext::create();
    if (!opengl) throw std::runtime_error(opengl.error().message);
    opengl_ = std::move(*opengl);
  }

  /// The last frame as pixels.
  [[nodiscard]] Raster<Rgba> picture_of(kit::UiContext& context) const {
    opengl_->make_current();
    const auto renderer = kit::UiRenderer::create(context);
    if (!renderer) throw std::runtime_error(renderer.error().message);
    auto pixels = (*renderer)->draw_to_pixels();
    if (!pixels) throw std::runtime_error(pixels.error().message);
    return *std::move(pixels);
  }

 private:
  std::unique_ptr<OffscreenContext> opengl_;
};

}  // namespace nadir
