// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <stdexcept>

#include "core/base/raster.h"
#include "widgets/gl/offscreen_context.h"
#include "widgets/kit/ui_context.h"
#include "widgets/kit/ui_renderer.h"

namespace nadir {

/// The last frame of a user interface as pixels. Needs no display.
[[nodiscard]] inline Raster<Rgba> picture_of(kit::UiContext& context) {
  const auto opengl = OffscreenContext::create();
  if (!opengl) throw std::runtime_error(opengl.error().message);
  const auto renderer = kit::UiRenderer::create(context);
  if (!renderer) throw std::runtime_error(renderer.error().message);
  auto pixels = (*renderer)->draw_to_pixels();
  if (!pixels) throw std::runtime_error(pixels.error().message);
  return *std::move(pixels);
}

}  // namespace nadir
