// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <imgui.h>
#include <imgui_internal.h>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "widgets/kit/ui.h"
#include "widgets/kit/ui_context.h"
#include "widgets/kit/ui_focus.h"
#include "widgets/kit/ui_fonts.h"
#include "widgets/kit/ui_look.h"
#include "widgets/kit/ui_pictures.h"

/// What kit keeps from frame to frame. For kit's own sources, as ui_frame.h.
namespace nadir::kit {

/// What the user is changing now: at most one thing.
struct Draft {
  ImGuiID id = 0;
  double number = 0.0, start_number = 0.0;
  std::string text, start_text;
  Rgba colour, start_colour;
  bool is_typing = false;      ///< A number's field takes text.
  bool is_text = false;        ///< What is typed is text, not a number.
  bool takes_tab = false;      ///< Tab completes what is typed and goes nowhere.
  bool begins_at_end = false;  ///< The first sign was typed before the field was.
  bool had_keyboard = false;
  bool was_dragged = false;
  int last_frame = 0;  ///< That drew it: one that is not drawn any more is forgotten.
};

/// A press of a mouse button in an area.
struct AreaPress {
  ImGuiID id = 0;
  MouseButton button = MouseButton::kLeft;
  ImVec2 start;
  bool is_drag = false;
  bool is_second = false;  ///< Of a double click.
};

struct UiContext::State {
  ImGuiContext* imgui = nullptr;
  ThemeName theme = ThemeName::kDark;
  double scale = 1.0;
  bool is_look_new = true;
  bool is_motion_reduced = false;
  bool is_in_frame = false;
  std::shared_ptr<FontSet> fonts;
  Look look;
  UiPictures pictures;
  FrameInput input;
  std::vector<Control> controls;  ///< Of the last finished frame.
  std::string scroll_to;
  std::string tooltip;  ///< Showing in the last frame, in one line.
  std::string hover_path;
  double hovered_s = 0.0;
  double next_frame_within_s = 0.0;
  Draft draft;
  Draft
      abandoned;  ///< Was being typed when another control was pressed; its own control commits it.
  AreaPress area_press;
  ImGuiID hovered_area = 0;
  ImGuiID open_bar = 0;        ///< Window whose menus follow the mouse.
  ImGuiID focused_number = 0;  ///< Arrow keys step it.
  Focus focus;
  std::map<ImGuiID, int>
      last_drawn;  ///< Frame in which a text input that takes the focus was drawn.
  std::string clipboard;
  std::set<std::string> turned_sections;  ///< Paths of those that are not as they are at first.
  std::unique_ptr<Ui> ui;
};

}  // namespace nadir::kit
