// SPDX-License-Identifier: Apache-2.0
#include "widgets/gl/view_texture.h"

#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkTextureObject.h>
#include <vtk_glew.h>

#include <algorithm>

#include "core/base/require.h"
#include "widgets/gl/offscreen_renderer.h"

namespace nadir {

ViewTexture::ViewTexture(vtkRenderer& scene) : scene_(&scene) {
  window_->SetAlphaBitPlanes(1);
  window_->AddRenderer(scene_);
}

ViewTexture::~ViewTexture() {
  window_->RemoveRenderer(scene_);
  window_->Finalize();
}

std::uint32_t ViewTexture::draw(int width, int height) {
  NADIR_REQUIRE(width > 0 && height > 0 && width <= OffscreenRenderer::kMostSide &&
                height <= OffscreenRenderer::kMostSide);
  window_->SetSize(width, height);
  window_->Render();
  texture_ = window_->GetDisplayFramebuffer()->GetColorAttachmentAsTextureObject(0)->GetHandle();
  width_ = width;
  height_ = height;
  return texture_;
}

Raster<Rgba> ViewTexture::pixels() const {
  if (texture_ == 0) return {};
  Raster<Rgba> read(width_, height_);
  GLint before = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &before);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(before));
  for (Rgba& pixel : read.values()) {
    if (pixel.alpha == 0 || pixel.alpha == 255) continue;
    const int alpha = pixel.alpha;
    const auto straight = [alpha](std::uint8_t channel) {
      return static_cast<std::uint8_t>(std::min(255, (channel * 255 + alpha / 2) / alpha));
    };
    pixel = {straight(pixel.red), straight(pixel.green), straight(pixel.blue), pixel.alpha};
  }
  return read;
}

}  // namespace nadir
