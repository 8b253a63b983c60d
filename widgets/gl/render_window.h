// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkGenericOpenGLRenderWindow.h>

namespace nadir {

/// VTK's render window on a context that somebody else owns (OffscreenContext, or a window of the desktop): it draws into
/// frame buffers of its own and never touches a display. The context must be current whenever it draws, and must outlive it.
class RenderWindow : public vtkGenericOpenGLRenderWindow {
 public:
  static RenderWindow* New();
  vtkTypeMacro(RenderWindow, vtkGenericOpenGLRenderWindow)
      RenderWindow(const RenderWindow&) = delete;
  RenderWindow& operator=(const RenderWindow&) = delete;

  void OpenGLInitContext() override;
  void MakeCurrent() override {}
  bool IsCurrent() override { return true; }
  int SupportsOpenGL() override { return 1; }
  vtkTypeBool IsDirect() override { return 1; }

 protected:
  RenderWindow();
  ~RenderWindow() override = default;
};

}  // namespace nadir
