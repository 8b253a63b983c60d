// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "widgets/kit/ui_context.h"

struct GLFWwindow;

namespace nadir::kit {

/// What a window of the desktop tells the interface: mouse, keys, typed text, size; and what it takes from it: the shape of the
/// pointer and the clipboard. On the main thread, after the window's events were polled or waited for.
class DesktopInput {
 public:
  /// @param window  Of DesktopWindow::handle(); it and the context outlive this. One per context.
  DesktopInput(UiContext& context, GLFWwindow* window);
  ~DesktopInput();
  DesktopInput(const DesktopInput&) = delete;
  DesktopInput& operator=(const DesktopInput&) = delete;

  /// All that came since the last call, for UiContext::begin_frame().
  [[nodiscard]] FrameInput take();

 private:
  UiContext& context_;
};

}  // namespace nadir::kit
