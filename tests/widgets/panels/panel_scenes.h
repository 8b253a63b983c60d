// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/widgets/panels/asked.h"
#include "widgets/kit/ui.h"
#include "widgets/panels/about_overlay.h"
#include "widgets/panels/bookmark_overlay.h"
#include "widgets/panels/left_rail.h"
#include "widgets/panels/log_panel.h"
#include "widgets/panels/menu_bar.h"
#include "widgets/panels/notices.h"
#include "widgets/panels/place_overlay.h"
#include "widgets/panels/preferences_panel.h"
#include "widgets/panels/shortcut_sheet.h"
#include "widgets/panels/status_bar.h"
#include "widgets/panels/welcome_panel.h"

namespace nadir {

/// A window with panels in it, to be looked at.
struct PanelScene {
  std::string name;
  std::function<void(kit::Ui&)> draw;
};

/// Everything that surrounds the map, and in place of the map the welcome.
struct WindowFrame {
  MenuBarModel menus;
  LeftRailModel rail;
  StatusBarModel status;
  WelcomeModel welcome;
  NoticesModel notices;
  PaletteState palette;
  LogState log;
  std::vector<std::string> log_lines;

  WindowFrame() {
    menus.commands = all_offered();
    for (OfferedCommand& offered : menus.commands) {
      if (offered.command->menu == "Run") offered.why_not = "open a run first";
      if (offered.command->text == "theme dark") offered.is_on = true;
    }
    menus.undo_title = "Hide particles";
    menus.open_names = {"proving-ground", "loop medium 7", "default"};
    menus.recents = {"/home/ada/flights/loop medium 7.nadir", "/home/ada/maps/proving-ground"};
    rail.workspaces = {{"Replay", kit::Icon::kPlay, "Replay a flight", "", true},
                       {"Label", kit::Icon::kPaintBrush, "Label maps", "later", false},
                       {"Study", kit::Icon::kChart, "Compare runs", "later", false}};
    PlaceReadOut place;
    place.class_name = "lane marking";
    place.class_colour = Rgba{230, 200, 40, 255};
    place.east_m = -123.45;
    place.north_m = 67.89;
    place.geodetic = "33.450112 N 83.901223 W";
    place.utm = "17S 230567.1 E 3705123.4 N";
    place.mgrs = "17S KT 30567 05123";
    status.place = place;
    status.memory_used_bytes = 212'000'000;
    status.memory_megabytes = 256;
    status.jobs = {{1, "localising loop medium 7", 0.43, "step 43 of 100", 12.0}};
    welcome.home = "/home/ada";
    for (int i = 0; i < 30; ++i) {
      welcome.recents.push_back("/home/ada/flights/2018/loop medium " + std::to_string(i) +
                                ".nadir");
    }
    welcome.offer = WelcomeModel::Offer{
        "loop medium 7 was being localised when Nadir ended; 43 of 100 steps are there.",
        "Open what there is", actions::OpenFile{"/a"}, 1};
    Notice warning;
    warning.number = 1;
    warning.kind = Notice::Kind::kWarning;
    warning.text =
        "loop medium 7.nadir: the flight that it was made of is not at /home/ada/flights/loop";
    warning.details = "Looked for flight.toml in two places";
    Notice error;
    error.number = 2;
    error.kind = Notice::Kind::kError;
    error.text = "town.svg: carries no recipe, so its moment cannot be opened";
    error.remedy = actions::OpenDemo{};
    error.remedy_title = "Open the demo";
    notices.shown = {warning, error};
    notices.not_shown = {7, 8};
    for (int i = 0; i < 40; ++i)
      log_lines.push_back(i % 3 == 0 ? "seek " + std::to_string(i) + ".5"
                                     : "layer particles toggle");
  }

  void draw_around(kit::Ui& ui) {
    const kit::Rect all = ui.screen();
    const double top = ui.px(kMenuBarHeight), foot = ui.px(kStatusBarHeight),
                 rail_width = ui.px(kLeftRailWidth);
    {
      const auto region = ui.region("menu", {0.0, 0.0, all.width, top}, {.padding = ui.px(4.0)});
      (void)draw_menu_bar(ui, menus, palette);
    }
    {
      const auto region =
          ui.region("rail", {0.0, top, rail_width, all.height - top - foot}, {.padding = 0.0});
      (void)draw_left_rail(ui, rail);
    }
    {
      const auto region =
          ui.region("status", {0.0, all.height - foot, all.width, foot}, {.padding = 0.0});
      (void)draw_status_bar(ui, status);
    }
  }
  [[nodiscard]] static kit::Rect middle(const kit::Ui& ui) {
    const kit::Rect all = ui.screen();
    const double top = ui.px(kMenuBarHeight), left = ui.px(kLeftRailWidth);
    return {left, top, all.width - left, all.height - top - ui.px(kStatusBarHeight)};
  }
  void draw_welcome_page(kit::Ui& ui) {
    draw_around(ui);
    const auto region = ui.region("map", middle(ui), {.surface = kit::Surface::kWindow});
    (void)draw_welcome(ui, welcome, palette);
  }
};

/// Scenes whose state lives in them; call each many times.
[[nodiscard]] inline std::vector<PanelScene> panel_scenes() {
  const auto frame = std::make_shared<WindowFrame>();
  const auto over = [frame](auto model, auto state, auto draw) {
    return [=](kit::Ui& ui) mutable {
      frame->draw_welcome_page(ui);
      (void)draw(ui, model, state);
    };
  };
  std::vector<PanelScene> scenes;
  scenes.push_back({"welcome", [frame](kit::Ui& ui) { frame->draw_welcome_page(ui); }});
  scenes.push_back({"notices", [frame](kit::Ui& ui) {
                      frame->draw_welcome_page(ui);
                      (void)draw_notices(ui, frame->notices, WindowFrame::middle(ui));
                    }});
  scenes.push_back({"log", [frame](kit::Ui& ui) {
                      frame->draw_around(ui);
                      const auto region = ui.region("log", WindowFrame::middle(ui));
                      (void)draw_log(ui, {frame->log_lines}, frame->log);
                    }});
  CommandPaletteModel palette;
  palette.is_open = true;
  palette.commands = frame->menus.commands;
  palette.recents = frame->welcome.recents;
  PaletteState looked_for;
  looked_for.is_open = true;
  looked_for.typed = "the";
  scenes.push_back({"palette", over(palette, looked_for, draw_command_palette)});
  PaletteState begun;
  begun.begun = "open";
  scenes.push_back({"palette-arguments", over(palette, begun, draw_command_palette)});
  ShortcutSheetModel sheet{true, frame->menus.commands};
  scenes.push_back(
      {"shortcuts",
       over(sheet, ShortcutSheetState{}, [frame](kit::Ui& ui, const auto& model, auto& state) {
         return draw_shortcut_sheet(ui, model, state, frame->palette);
       })});
  PreferencesModel preferences;
  preferences.is_open = true;
  preferences.memory_used_bytes = 212'000'000;
  preferences.layout_names = {"default", "wide map", "for figures"};
  scenes.push_back({"preferences", over(preferences, PreferencesState{}, draw_preferences)});
  PlaceModel place;
  place.is_open = true;
  place.plane = ProjectPlane::create({33.45, -83.9}).value();
  scenes.push_back({"place", over(place, PlaceState{}, draw_place_overlay)});
  BookmarkNoteModel note{true, "loop medium 7", 42.34};
  scenes.push_back({"bookmark", over(note, BookmarkNoteState{}, draw_bookmark_note)});
  const AboutModel about{true, "0.4.0"};
  scenes.push_back({"about", [frame, about](kit::Ui& ui) {
                      frame->draw_welcome_page(ui);
                      (void)draw_about(ui, about);
                    }});
  return scenes;
}

}  // namespace nadir
