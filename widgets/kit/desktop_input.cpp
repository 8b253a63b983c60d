// SPDX-License-Identifier: Apache-2.0
#include "widgets/kit/desktop_input.h"

#include <backends/imgui_impl_glfw.h>

#include <algorithm>

#include "core/base/require.h"
#include "widgets/gl/desktop_window.h"
#include "widgets/kit/ui_canvas.h"
#include "widgets/kit/ui_frame.h"

namespace nadir::kit {
namespace {

/// What waited came while the frame before was drawn: for the hand, no more time has passed than between two frames.
constexpr double kWaitedS = 1.0 / 60.0;

}  // namespace

DesktopInput::DesktopInput(UiContext& context, DesktopWindow& window)
    : context_(context), window_(window) {
  ImGui::SetCurrentContext(context.state().imgui);
  NADIR_REQUIRE(ImGui::GetIO().BackendPlatformUserData == nullptr);
  // Not its callbacks: they know how things stand when a frame begins, and lose what came and went before.
  ImGui_ImplGlfw_InitForOpenGL(window.handle(), false);
}

DesktopInput::~DesktopInput() {
  ImGui::SetCurrentContext(context_.state().imgui);
  ImGui_ImplGlfw_Shutdown();
}

FrameInput DesktopInput::take() {
  ImGui::SetCurrentContext(context_.state().imgui);
  ImGui_ImplGlfw_NewFrame();
  const bool has_waited = queue_.is_waiting();
  queue_.add(window_.take_events());
  FrameInput input = queue_.next(context_.is_typing());
  const ImGuiIO& io = ImGui::GetIO();
  input.size_px = {io.DisplaySize.x, io.DisplaySize.y};
  input.framebuffer_scale =
      io.DisplayFramebufferScale.x > 0.0F ? io.DisplayFramebufferScale.x : 1.0;
  input.delta_s = has_waited ? std::min(kWaitedS, 1.0 * io.DeltaTime) : io.DeltaTime;
  return input;  // begin_frame() gives it all back
}

}  // namespace nadir::kit
