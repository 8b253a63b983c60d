// SPDX-License-Identifier: Apache-2.0
#include "widgets/kit/desktop_input.h"

#include <backends/imgui_impl_glfw.h>

#include "core/base/require.h"
#include "widgets/kit/ui_canvas.h"
#include "widgets/kit/ui_frame.h"

namespace nadir::kit {

DesktopInput::DesktopInput(UiContext& context, GLFWwindow* window) : context_(context) {
  ImGui::SetCurrentContext(context.state().imgui);
  NADIR_REQUIRE(ImGui::GetIO().BackendPlatformUserData == nullptr);
  ImGui_ImplGlfw_InitForOpenGL(window, true);
}

DesktopInput::~DesktopInput() {
  ImGui::SetCurrentContext(context_.state().imgui);
  ImGui_ImplGlfw_Shutdown();
}

FrameInput DesktopInput::take() {
  ImGui::SetCurrentContext(context_.state().imgui);
  ImGui_ImplGlfw_NewFrame();
  ImGuiIO& io = ImGui::GetIO();
  FrameInput input;
  input.size_px = {io.DisplaySize.x, io.DisplaySize.y};
  input.framebuffer_scale =
      io.DisplayFramebufferScale.x > 0.0F ? io.DisplayFramebufferScale.x : 1.0;
  input.delta_s = io.DeltaTime;
  if (ImGui::IsMousePosValid(&io.MousePos))
    input.mouse_px = Eigen::Vector2d(io.MousePos.x, io.MousePos.y);
  for (std::size_t i = 0; i < input.buttons.size(); ++i) input.buttons.at(i) = io.MouseDown[i];
  input.wheel = {io.MouseWheelH, io.MouseWheel};
  for (int key = 1; key < IM_ARRAYSIZE(io.KeysDown); ++key) {
    if (io.KeysDown[key]) input.keys.push_back(static_cast<Key>(key));
  }
  for (const ImWchar letter : io.InputQueueCharacters) {
    std::array<char, 5> utf8 = {};
    ImTextCharToUtf8(utf8.data(), letter);
    input.characters += utf8.data();
  }
  input.modifiers = {io.KeyCtrl, io.KeyShift, io.KeyAlt, io.KeySuper};
  // begin_frame() gives it all back.
  io.MouseWheel = io.MouseWheelH = 0.0F;
  io.ClearInputCharacters();
  return input;
}

}  // namespace nadir::kit
