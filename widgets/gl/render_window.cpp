// SPDX-License-Identifier: Apache-2.0
#include "widgets/gl/render_window.h"

#include <vtkObjectFactory.h>
#include <vtk_glew.h>

#include <array>

#include "widgets/gl/vtk_messages.h"

namespace nadir {

RenderWindow* RenderWindow::New() { VTK_STANDARD_NEW_BODY(RenderWindow); }

RenderWindow::RenderWindow() {
  send_vtk_messages_to_log();
  SetFrameBlitModeToNoBlit();
  SetMultiSamples(0);
  SetOffScreenRendering(1);
}

void RenderWindow::OpenGLInitContext() {
  if (Initialized != 0) return;
  // Without an X display GLEW answers that there is none, after it has loaded every entry point.
  constexpr GLenum kNoGlxDisplay = 4;
  const GLenum answer = glewInit();
  GlewInitValid = answer == GLEW_OK || answer == kNoGlxDisplay;
  if (!GlewInitValid) {
    vtkErrorMacro("GLEW cannot be initialised: " << glewGetErrorString(answer));
    return;
  }
  Initialized = true;
  std::array<GLfloat, 2> widths{};
  glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, widths.data());
  MaximumHardwareLineWidth = widths[1];
}

}  // namespace nadir
