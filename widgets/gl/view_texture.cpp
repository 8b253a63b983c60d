// SPDX-License-Identifier: Apache-2.0
#include "widgets/gl/view_texture.h"

#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkTextureObject.h>
#include <vtk_glew.h>

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

PictureTexture::~PictureTexture() {
  if (texture_ != 0) glDeleteTextures(1, &texture_);
}

std::uint32_t PictureTexture::show(const Raster<Rgba>& pixels, bool is_smooth) {
  if (pixels.empty()) return 0;
  if (texture_ == 0) glGenTextures(1, &texture_);
  glBindTexture(GL_TEXTURE_2D, texture_);
  const GLint filter = is_smooth ? GL_LINEAR : GL_NEAREST;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, pixels.width(), pixels.height(), 0, GL_RGBA,
               GL_UNSIGNED_BYTE, pixels.data());
  return texture_;
}

}  // namespace nadir
