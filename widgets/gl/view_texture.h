// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <cstdint>

#include "core/base/raster.h"
#include "widgets/canvas/canvas.h"
#include "widgets/gl/render_window.h"

class vtkRenderer;

namespace nadir {

/// Draws a VTK scene into a texture of the OpenGL context that is current, for a window to show. The context must be current
/// whenever this is used, and outlive it. What is drawn with other means in between does no harm; after draw() the frame
/// buffer and the viewport are VTK's, so whoever draws next binds its own.
class ViewTexture {
 public:
  /// @param scene  Stays attached until this goes; a scene is drawn by one ViewTexture only.
  explicit ViewTexture(vtkRenderer& scene);
  ~ViewTexture();
  ViewTexture(const ViewTexture&) = delete;
  ViewTexture& operator=(const ViewTexture&) = delete;

  /// Draws the scene as its camera sees it. @param width, height  Pixels, 1 to OffscreenRenderer::kMostSide.
  /// @returns the texture's name, premultiplied, rows from the bottom; valid until the next draw().
  std::uint32_t draw(int width, int height);
  /// As drawn last; 0 before.
  [[nodiscard]] std::uint32_t texture() const { return texture_; }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  /// What was drawn last, not premultiplied and rows from the *bottom*; empty before. Waits for the graphics card.
  [[nodiscard]] Raster<Rgba> pixels() const;

 private:
  vtkNew<RenderWindow> window_;
  vtkSmartPointer<vtkRenderer> scene_;
  std::uint32_t texture_ = 0;
  int width_ = 0, height_ = 0;
};

}  // namespace nadir
