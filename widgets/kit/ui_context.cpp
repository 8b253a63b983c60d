// SPDX-License-Identifier: Apache-2.0
#include "widgets/kit/ui_context.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/base/require.h"
#include "widgets/kit/ui_canvas.h"
#include "widgets/kit/ui_frame.h"

namespace nadir::kit {
namespace {

constexpr double kFarAway = -std::numeric_limits<float>::max();
constexpr double kCaretBlinksS = 0.3;

void set_key_map(ImGuiIO& io) {
  struct Meaning {
    ImGuiKey key;
    Key ours;
  };
  const std::array<Meaning, 22> meanings = {{{ImGuiKey_Tab, Key::kTab},
                                             {ImGuiKey_LeftArrow, Key::kLeft},
                                             {ImGuiKey_RightArrow, Key::kRight},
                                             {ImGuiKey_UpArrow, Key::kUp},
                                             {ImGuiKey_DownArrow, Key::kDown},
                                             {ImGuiKey_PageUp, Key::kPageUp},
                                             {ImGuiKey_PageDown, Key::kPageDown},
                                             {ImGuiKey_Home, Key::kHome},
                                             {ImGuiKey_End, Key::kEnd},
                                             {ImGuiKey_Insert, Key::kInsert},
                                             {ImGuiKey_Delete, Key::kDelete},
                                             {ImGuiKey_Backspace, Key::kBackspace},
                                             {ImGuiKey_Space, Key::kSpace},
                                             {ImGuiKey_Enter, Key::kEnter},
                                             {ImGuiKey_Escape, Key::kEscape},
                                             {ImGuiKey_KeyPadEnter, Key::kPadEnter},
                                             {ImGuiKey_A, Key::kA},
                                             {ImGuiKey_C, Key::kC},
                                             {ImGuiKey_V, Key::kV},
                                             {ImGuiKey_X, Key::kX},
                                             {ImGuiKey_Y, Key::kY},
                                             {ImGuiKey_Z, Key::kZ}}};
  for (const auto& [key, ours] : meanings) io.KeyMap[key] = static_cast<int>(ours);
}

const char* clipboard_text(void* data) {
  return static_cast<UiContext::State*>(data)->clipboard.c_str();
}
void set_clipboard_text(void* data, const char* text) {
  static_cast<UiContext::State*>(data)->clipboard = text;
}

ImGuiContext* make_context(UiContext::State& state) {
  IMGUI_CHECKVERSION();
  ImGuiContext* const before = ImGui::GetCurrentContext();
  ImGuiContext* const made = ImGui::CreateContext(&state.fonts->atlas());
  ImGui::SetCurrentContext(made);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.BackendPlatformName = "nadir";
  io.ConfigInputTextCursorBlink = true;
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  io.ClipboardUserData = &state;
  io.GetClipboardTextFn = clipboard_text;
  io.SetClipboardTextFn = set_clipboard_text;
  // Lists of more than 65,535 corners, which a map with many particles makes.
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset | ImGuiBackendFlags_HasMouseCursors;
  set_key_map(io);
  ImGui::SetCurrentContext(before == nullptr ? made : before);
  return made;
}

void give_input(ImGuiIO& io, const FrameInput& input) {
  io.DisplaySize = im(input.size_px);
  io.DisplayFramebufferScale = {narrow(input.framebuffer_scale), narrow(input.framebuffer_scale)};
  io.DeltaTime = narrow(std::max(1e-5, input.delta_s));
  io.MousePos = input.mouse_px ? im(*input.mouse_px) : ImVec2(narrow(kFarAway), narrow(kFarAway));
  for (std::size_t i = 0; i < input.buttons.size(); ++i) io.MouseDown[i] = input.buttons.at(i);
  io.MouseWheel = narrow(input.wheel.y());
  io.MouseWheelH = narrow(input.wheel.x());
  std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
  for (const Key key : input.keys) {
    const auto index = static_cast<std::size_t>(key);
    if (index > 0 && index < IM_ARRAYSIZE(io.KeysDown)) io.KeysDown[index] = true;
  }
  io.KeyCtrl = input.modifiers.ctrl;
  io.KeyShift = input.modifiers.shift;
  io.KeyAlt = input.modifiers.alt;
  io.KeySuper = input.modifiers.super;
  io.ClearInputCharacters();
  io.AddInputCharactersUTF8(input.characters.c_str());
}

}  // namespace

UiContext::UiContext(ThemeName theme, double scale) : state_(std::make_unique<State>()) {
  state_->theme = theme;
  state_->scale = std::clamp(scale, kLeastScale, kMostScale);
  state_->fonts = FontSet::of_scale(state_->scale);
  state_->imgui = make_context(*state_);
}

UiContext::~UiContext() {
  abandon_frame();
  ImGuiContext* const before = ImGui::GetCurrentContext();
  ImGui::SetCurrentContext(state_->imgui);
  ImGui::DestroyContext(state_->imgui);
  ImGui::SetCurrentContext(before == state_->imgui ? nullptr : before);
}

void UiContext::set_look(ThemeName theme, double scale) {
  NADIR_REQUIRE(!state_->is_in_frame);
  const double clamped = std::clamp(scale, kLeastScale, kMostScale);
  if (theme == state_->theme && clamped == state_->scale) return;
  state_->theme = theme;
  if (clamped != state_->scale) {
    state_->scale = clamped;
    state_->fonts = FontSet::of_scale(clamped);
    ImGuiContext* const before = ImGui::GetCurrentContext();
    ImGui::SetCurrentContext(state_->imgui);
    ImGui::GetIO().Fonts = &state_->fonts->atlas();
    ImGui::SetCurrentContext(before);
  }
  state_->is_look_new = true;
}

ThemeName UiContext::theme_name() const { return state_->theme; }
double UiContext::scale() const { return state_->scale; }
void UiContext::set_motion_reduced(bool is_reduced) { state_->is_motion_reduced = is_reduced; }

Ui& UiContext::begin_frame(const FrameInput& input) {
  State& state = *state_;
  NADIR_REQUIRE(!state.is_in_frame);
  ImGui::SetCurrentContext(state.imgui);
  ImGuiIO& io = ImGui::GetIO();
  if (state.is_look_new) {
    state.look = look_of(nadir::theme(state.theme));
    set_style(ImGui::GetStyle(), state.look, state.scale);
    state.is_look_new = false;
  }
  io.FontDefault = state.fonts->text;
  io.ConfigInputTextCursorBlink = !state.is_motion_reduced;
  give_input(io, input);
  state.input = input;
  state.is_in_frame = true;
  state.next_frame_within_s = std::numeric_limits<double>::infinity();
  state.pictures.begin_frame();
  ImGui::NewFrame();
  state.ui = std::make_unique<Ui>(*this);
  state.ui->frame().begin_focus();
  return *state.ui;
}

void UiContext::end_frame() {
  State& state = *state_;
  NADIR_REQUIRE(state.is_in_frame);
  ImGui::SetCurrentContext(state.imgui);
  Ui::Frame& frame = state.ui->frame();
  frame.show_tooltip();
  frame.end_focus();
  if (state.imgui->OpenPopupStack.Size > 0 && state.imgui->ActiveId == 0 &&
      ImGui::IsKeyPressed(static_cast<int>(Key::kEscape), false)) {
    ImGui::ClosePopupToLevel(state.imgui->OpenPopupStack.Size - 1, true);
  }
  ImGui::Render();
  state.pictures.end_frame();
  const int frame_count = ImGui::GetFrameCount();
  // An area that is not drawn any more does not see that the button was let go.
  if (std::none_of(state.input.buttons.begin(), state.input.buttons.end(),
                   [](bool is_down) { return is_down; }))
    state.area_press = {};
  if (state.draft.id != 0 && state.draft.last_frame < frame_count - 1) state.draft = {};
  if (state.abandoned.id != 0 && state.abandoned.last_frame < frame_count - 2) state.abandoned = {};
  std::erase_if(state.last_drawn,
                [frame_count](const auto& entry) { return entry.second < frame_count - 1; });
  if (ImGui::GetIO().WantTextInput && !state.is_motion_reduced) {
    state.next_frame_within_s = std::min(state.next_frame_within_s, kCaretBlinksS);
  }
  state.controls = std::move(frame.controls);
  state.is_in_frame = false;
  state.ui.reset();
}

void UiContext::abandon_frame() {
  State& state = *state_;
  if (!state.is_in_frame) return;
  ImGui::SetCurrentContext(state.imgui);
  ImGui::ErrorCheckEndFrameRecover(nullptr);
  ImGui::EndFrame();
  state.pictures.end_frame();
  state.draft = state.abandoned = {};
  state.is_in_frame = false;
  state.ui.reset();
}

const std::vector<Control>& UiContext::controls() const { return state_->controls; }
void UiContext::scroll_to(const std::string& path) { state_->scroll_to = path; }

std::string UiContext::cursor_name() const {
  static constexpr std::array<const char*, 9> kNames = {"arrow",       "text",      "move",
                                                        "resize ns",   "resize ew", "resize nesw",
                                                        "resize nwse", "hand",      "not allowed"};
  const int cursor = state_->imgui->MouseCursor;
  return cursor < 0 ? "none" : kNames.at(static_cast<std::size_t>(cursor));
}

bool UiContext::is_typing() const { return state_->draft.id != 0 && state_->draft.is_typing; }

double UiContext::next_frame_within_s() const { return state_->next_frame_within_s; }

std::string UiContext::clipboard() const {
  const ImGuiIO& io = state_->imgui->IO;
  const char* const text = io.GetClipboardTextFn(io.ClipboardUserData);
  return text == nullptr ? std::string() : text;
}

void UiContext::set_clipboard(const std::string& text) {
  const ImGuiIO& io = state_->imgui->IO;
  io.SetClipboardTextFn(io.ClipboardUserData, text.c_str());
}

}  // namespace nadir::kit
