// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/panels/panel_text.h"
#include "widgets/panels/shortcut_hint.h"
#include "widgets/panels/timeline_parts.h"

namespace nadir::detail {
namespace {

/// A click on the button asks for the action, and its tooltip tells its keys.
void action_button(TimelineFrame& frame,
                   const std::string& name,
                   kit::Icon icon,
                   const std::string& help,
                   const Action& action,
                   bool is_on = false) {
  if (frame.ui.icon_button(name, icon, hint_for(help, action), is_on))
    frame.actions.push_back(action);
}

std::string speed_text(double speed) { return fmt::format("{:g}×", speed); }

void draw_speed(TimelineFrame& frame) {
  std::vector<double> speeds = {0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0};
  const auto place = std::lower_bound(speeds.begin(), speeds.end(), frame.model.speed);
  const auto chosen = static_cast<std::size_t>(place - speeds.begin());
  if (place == speeds.end() || *place != frame.model.speed) speeds.insert(place, frame.model.speed);
  std::vector<std::string> items;
  items.reserve(speeds.size());
  for (const double speed : speeds) items.push_back(speed_text(speed));
  const auto no_label = frame.ui.label_width(0.0);
  frame.ui.next_width(frame.ui.px(68.0));
  const auto asked =
      frame.ui.combo("##Speed", items, chosen, {"Flight seconds per second of playing", ""});
  if (asked) frame.actions.push_back(actions::SetSpeed{speeds[*asked]});
}

void draw_time(TimelineFrame& frame) {
  kit::Ui& ui = frame.ui;
  kit::TextOptions options;
  options.width = ui.px(76.0);
  options.hint = {"Time after the run's first step; type 1:02.5 or 62.5", ""};
  const auto no_label = ui.label_width(0.0);
  const auto typed = ui.text_input("##Time", clock_text(frame.model.time_s), options);
  if (typed.was_entered || typed.was_committed) {
    if (const auto moment_s = parse_clock(typed.value)) {
      frame.actions.push_back(
          actions::Seek{std::clamp(*moment_s, frame.axis.first_s, frame.axis.last_s)});
    } else if (typed.value.find_first_not_of(' ') != std::string::npos) {
      frame.state.fault = fmt::format(
          "'{}' is no time: type seconds, such as 62.5, or minutes and seconds, such as 1:02.5",
          shortened(typed.value, 40));
    }
  }
  ui.same_line(ui.px(6.0));
  ui.text("/ " + clock_text(frame.axis.last_s), kit::TextLook::kMutedNumber);
}

void draw_loop(TimelineFrame& frame) {
  const TimelineModel& model = frame.model;
  if (!model.loop_from_s || !model.loop_to_s) return;
  kit::Ui& ui = frame.ui;
  const std::string range = clock_text(*model.loop_from_s) + " – " + clock_text(*model.loop_to_s);
  ui.same_line(ui.px(16.0));
  constexpr double kBesideIt = 104.0;  // its icon and button, and the button of the menu
  const double room = ui.room().width - ui.px(kBesideIt);
  ui.icon(kit::Icon::kRepeat, kit::TextLook::kAccent);
  ui.same_line(ui.px(6.0));
  if (ui.text_width(range, kit::TextLook::kNumber) <= room) {
    ui.text(range, kit::TextLook::kNumber);
    ui.same_line(ui.px(2.0));
  }
  action_button(frame, "Loop off", kit::Icon::kClose, "Play all again, not only this range",
                actions::SetLoop{});
}

/// A menu of what the line has no room for.
void draw_more(TimelineFrame& frame) {
  kit::Ui& ui = frame.ui;
  ui.right_align(ui.px(28.0));
  const auto menu =
      ui.button_menu("More", kit::Icon::kMore, {"Worst moments, bookmark, strips", ""});
  if (!menu) return;
  const auto line = [&](const std::string& title, kit::Icon icon, const Action& action) {
    kit::MenuItem item;
    item.icon = icon;
    item.shortcut = hint_for(title, action).shortcut;
    if (ui.menu_item(title, item)) frame.actions.push_back(action);
  };
  line("Previous worst moment", kit::Icon::kCaretLeft, actions::GoTo{Moment::kPreviousWorst});
  line("Next worst moment", kit::Icon::kCaretRight, actions::GoTo{Moment::kNextWorst});
  line("Bookmark this moment", kit::Icon::kBookmark, actions::ShowOverlay{Overlay::kBookmark});
  ui.menu_line();
  draw_strip_items(frame);
}

}  // namespace

void draw_strip_items(TimelineFrame& frame) {
  for (const StripLook& look : frame.model.strips) {
    kit::MenuItem item;
    item.is_checked = look.is_visible;
    item.hint = std::string(strip_info(look.strip).help);
    if (frame.ui.menu_item(std::string(strip_info(look.strip).name), item)) {
      frame.actions.push_back(actions::ShowStrip{look.strip, Switch::kToggle});
    }
  }
}

void draw_transport(TimelineFrame& frame) {
  kit::Ui& ui = frame.ui;
  const TimelineModel& model = frame.model;
  const double gap = ui.px(2.0);
  action_button(frame, "First", kit::Icon::kFirst, "Go to the start",
                actions::GoTo{Moment::kStart});
  ui.same_line(gap);
  action_button(frame, "Step back", kit::Icon::kStepBack, "One step back", actions::StepBy{-1});
  ui.same_line(gap);
  if (ui.icon_button("Play", model.is_playing ? kit::Icon::kPause : kit::Icon::kPlay,
                     hint_for(model.is_playing ? "Pause" : "Play", actions::Play{Switch::kToggle}),
                     model.is_playing)) {
    frame.actions.push_back(actions::Play{Switch::kToggle});
  }
  ui.same_line(gap);
  action_button(frame, "Step on", kit::Icon::kStepForward, "One step on", actions::StepBy{1});
  ui.same_line(gap);
  action_button(frame, "Last", kit::Icon::kLast, "Go to the end", actions::GoTo{Moment::kEnd});
  ui.same_line(ui.px(12.0));
  draw_speed(frame);
  ui.same_line(ui.px(12.0));
  draw_time(frame);
  draw_loop(frame);

  constexpr double kButton = 28.0;
  const std::string worst = "worst";
  const double words = ui.text_width(worst, kit::TextLook::kMuted) + 2.0 * gap;
  const double wanted = 4.0 * ui.px(kButton) + words + gap + ui.px(8.0);
  ui.same_line();
  if (ui.room().width < wanted) {
    draw_more(frame);
    return;
  }
  ui.right_align(wanted);
  action_button(frame, "Previous worst moment", kit::Icon::kCaretLeft,
                "To the previous worst moment: the marks on the ruler",
                actions::GoTo{Moment::kPreviousWorst});
  ui.same_line(gap);
  ui.text(worst, kit::TextLook::kMuted);
  ui.same_line(gap);
  action_button(frame, "Next worst moment", kit::Icon::kCaretRight,
                "To the next worst moment: the marks on the ruler",
                actions::GoTo{Moment::kNextWorst});
  ui.same_line(ui.px(8.0));
  if (ui.icon_button(
          "Bookmark", kit::Icon::kBookmark,
          hint_for("Mark this moment with a note", actions::ShowOverlay{Overlay::kBookmark}))) {
    frame.actions.push_back(actions::ShowOverlay{Overlay::kBookmark});
  }
  ui.same_line(gap);
  if (const auto menu =
          ui.button_menu("Strips", kit::Icon::kPlus, {"Choose what the strips show", ""})) {
    draw_strip_items(frame);
  }
}

}  // namespace nadir::detail
