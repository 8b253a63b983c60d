// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkNew.h>

#include <memory>
#include <vector>

#include "core/base/result.h"
#include "widgets/canvas/canvas.h"
#include "widgets/gl/offscreen_context.h"
#include "widgets/gl/render_window.h"

class vtkRenderer;

namespace nadir {

/// Draws VTK scenes to pixels without a display. One thread, on which its context stays current: who draws with another one
/// makes that current again.
class OffscreenRenderer {
 public:
  /// Longest side of what is drawn at once, pixels, supersampling included; every OpenGL 3.3 driver in use draws that.
  static constexpr int kMostSide = 16'384;

  /// @errors kUnsupported: no OpenGL, see OffscreenContext::create.
  [[nodiscard]] static Result<std::unique_ptr<OffscreenRenderer>> create();
  ~OffscreenRenderer();
  OffscreenRenderer(const OffscreenRenderer&) = delete;
  OffscreenRenderer& operator=(const OffscreenRenderer&) = delete;

  /// The scene as its camera sees it; transparent where it has no background. The last four renderers stay
  /// attached, so that a film uploads its textures once.
  /// @param supersampling  Drawn that many times larger each way and averaged: edges become smooth.
  /// @errors kUnsupported: larger than the graphics driver can draw.
  [[nodiscard]] Result<Raster<Rgba>> render(vtkRenderer& scene,
                                            int width,
                                            int height,
                                            int supersampling = 1);

 private:
  explicit OffscreenRenderer(std::unique_ptr<OffscreenContext> context);
  void attach(vtkRenderer& scene);

  std::unique_ptr<OffscreenContext> context_;  ///< Before the window, which needs it to the end.
  vtkNew<RenderWindow> window_;
  std::vector<vtkRenderer*> attached_;  ///< The one drawn last at the end; the window keeps them.
};

}  // namespace nadir
