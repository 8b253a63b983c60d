// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <imgui.h>
#include <imgui_internal.h>

#include <cstddef>
#include <map>
#include <vector>

#include "widgets/kit/chord.h"

/// Where the keyboard is among the controls. Shared by kit's own sources only, as ui_frame.h.
///
/// Dear ImGui's own navigation (NavEnableKeyboard) is off: it takes Space and the arrows as soon as anything is in focus, which
/// mean play and step here, walks within one window only, and draws its frame at once. Here a control has keys only while its
/// frame shows, and says which; all others stay shortcuts.
namespace nadir::kit {

enum class Arrows { kNone, kSideways, kUpDown, kAll };

/// How a control takes part in walking with the keyboard.
struct Stop {
  bool is_stop = true;            ///< False: areas, which have only the mouse.
  bool takes_press = true;        ///< Space and Enter press it.
  Arrows arrows = Arrows::kNone;  ///< It takes itself; in a group: that go to its neighbours.
  /// Controls of one group are one stop for Tab: the one that is selected, else the first. 0: none.
  ImGuiID group = 0;
  bool is_selected = false;
  bool is_chosen_by_arrows = false;  ///< Coming to it by an arrow presses it.
  bool takes_delete = false, takes_digits = false;
  bool opens_down = false;  ///< An arrow down opens what hangs on it.
  bool opens_menu = false;  ///< Within a menu: an arrow to the right does.
  bool is_handle = false;   ///< Between two parts of the window, itself none.
};

struct PlacedStop : Stop {
  ImGuiID id = 0;
  ImGuiID region = 0;
  int layer = 0;
};

struct Focus {
  ImGuiID id = 0;                                ///< Also of what the mouse pressed last.
  bool is_shown = false;                         ///< It has a frame around it, and its keys.
  bool has_arrived = false, was_chosen = false;  ///< In this frame; by an arrow.
  Key took = Key::kNone;                         ///< Key that has moved it in this frame.
  bool wants_first = false;  ///< Something opened: its first control, once it is there.
  ImGuiID wanted_menu = 0;   ///< Of a bar: opens in the frame that draws it.
  Stop stop;                 ///< Of `id`, as it was drawn last.
  std::size_t place = 0;     ///< Of `id` among `stops`: where it goes on when that is gone.
  int layer = 0;             ///< Uppermost one of the last frame: of a box, of a popup.
  ImGuiID box = 0;           ///< Uppermost one of the last frame; 0: none.
  /// Of the last frame, in the order in which they were drawn: of the uppermost layer, and of those below.
  std::vector<PlacedStop> stops, lower;
  /// On its way to the first (-1) or last (1) row of a list that draws only what is in sight, for so many frames.
  int to_end = 0, frames_to_end = 0;
  struct Left {
    ImGuiID id = 0;
    bool is_shown = false;
    std::size_t place = 0;
  };
  std::map<int, Left> below;  ///< Where it was before something opened above, by layer.
};

using Stops = std::vector<PlacedStop>;

[[nodiscard]] bool went_down(Key key, bool with_repeats);
/// Keys of a control are those without these; with them they are the window's.
[[nodiscard]] inline bool is_plain(const Modifiers& held) {
  return !held.ctrl && !held.alt && !held.super;
}
[[nodiscard]] inline bool goes_sideways(Arrows arrows) {
  return arrows == Arrows::kSideways || arrows == Arrows::kAll;
}
[[nodiscard]] inline bool goes_up_and_down(Arrows arrows) {
  return arrows == Arrows::kUpDown || arrows == Arrows::kAll;
}
/// Place of a control; their number where it is not among them.
[[nodiscard]] std::size_t place_of(const Stops& stops, ImGuiID id);
/// What Tab comes to first in a group: what is selected, else the first.
[[nodiscard]] bool stands_for_group(const Stops& stops, const PlacedStop& stop);
/// Where Tab goes; nullptr: nowhere.
[[nodiscard]] const PlacedStop* next_stop(const Stops& stops, const Focus& focus, bool is_back);
/// The first control of the next region; nullptr: none.
[[nodiscard]] const PlacedStop* next_region(const Stops& stops, const Focus& focus, bool is_back);
/// The first one of a group that is there, or the last.
[[nodiscard]] const PlacedStop* end_of_group(const Stops& stops, ImGuiID group, bool is_last);
/// Where an arrow goes within a group, or Home and End; nullptr where none of its keys was pressed.
[[nodiscard]] const PlacedStop* next_in_group(const Stops& stops, const PlacedStop& here);

/// Boxes lie above each other, popups above what they were opened from.
inline constexpr int kLayersOfABox = 64;

}  // namespace nadir::kit
