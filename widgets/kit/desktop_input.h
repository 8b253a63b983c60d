// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "widgets/kit/input_queue.h"
#include "widgets/kit/ui_context.h"

namespace nadir {
class DesktopWindow;
}

namespace nadir::kit {

/// What a window of the desktop tells the interface: mouse, keys, typed text, size; and what it takes from it: the shape of the
/// pointer and the clipboard. On the main thread, after the window's events were polled or waited for.
class DesktopInput {
 public:
  /// @param window  It and the context outlive this. One per context.
  DesktopInput(UiContext& context, DesktopWindow& window);
  ~DesktopInput();
  DesktopInput(const DesktopInput&) = delete;
  DesktopInput& operator=(const DesktopInput&) = delete;

  /// What has come since the last call, as much of it as one frame can be told, for UiContext::begin_frame().
  [[nodiscard]] FrameInput take();
  /// More has come than that frame was told: the next one should follow at once.
  [[nodiscard]] bool is_waiting() const { return queue_.is_waiting(); }

 private:
  UiContext& context_;
  DesktopWindow& window_;
  InputQueue queue_;
};

}  // namespace nadir::kit
