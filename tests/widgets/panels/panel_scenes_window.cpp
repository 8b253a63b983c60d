// SPDX-License-Identifier: Apache-2.0
// What surrounds the map, and what lies over the window.
#include <algorithm>

#include "tests/widgets/panels/asked.h"
#include "tests/widgets/panels/panel_scene_parts.h"
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
#include "widgets/panels/work_card.h"

namespace nadir::scenes {
namespace {

/// As after a while of work: some commands can be done, some are on.
std::vector<OfferedCommand> offered() {
  std::vector<OfferedCommand> commands = all_offered();
  for (OfferedCommand& one : commands) {
    if (one.command->menu == "Run") one.why_not = "open a run first";
    if (one.command->text == "theme dark") one.is_on = true;
  }
  return commands;
}

std::vector<std::string> recents() {
  return {"/home/ada/flights/loop medium 7.nadir", "/home/ada/flights/town.nadir",
          "/home/ada/maps/proving-ground", "/home/ada/flights/2018/loop large 12, at dusk.nadir"};
}

MenuBarModel menus() {
  MenuBarModel model;
  model.commands = offered();
  model.undo_title = "Hide particles";
  model.open_names = {"proving-ground", "loop medium 7", "default"};
  model.recents = recents();
  return model;
}

LeftRailModel rail() {
  LeftRailModel model;
  model.workspaces = {{"Replay", kit::Icon::kPlay, "Replay a flight", "", true},
                      {"Label", kit::Icon::kPaintBrush, "Label maps", "later", false},
                      {"Study", kit::Icon::kChart, "Compare runs", "later", false}};
  return model;
}

StatusBarModel status() {
  PlaceReadOut place;
  place.class_name = "lane marking";
  place.class_colour = Rgba{230, 200, 40, 255};
  place.east_m = -123.45;
  place.north_m = 67.89;
  place.geodetic = "33.450112 N 83.901223 W";
  place.utm = "17S 230567.1 E 3705123.4 N";
  place.mgrs = "17S KT 30567 05123";
  StatusBarModel model;
  model.place = place;
  model.memory_used_bytes = 212'000'000;
  model.memory_megabytes = 256;
  model.jobs = {{1, "localising loop medium 7", 0.43, "step 43 of 100", 12.0}};
  return model;
}

WelcomeModel welcome() {
  WelcomeModel model;
  model.home = "/home/ada";
  model.recents = recents();
  model.offer = WelcomeModel::Offer{
      "loop medium 7 was being localised when Nadir ended; 43 of 100 steps are there.",
      "Open what there is", actions::OpenFile{"/a"}, 1};
  return model;
}

NoticesModel some_notices() {
  Notice done;
  done.number = 1;
  done.text = "/home/ada/figures/moment.svg was written";
  Notice warning;
  warning.number = 2;
  warning.kind = Notice::Kind::kWarning;
  warning.text =
      "loop medium 7.nadir: the flight that it was made of is not at /home/ada/flights/loop";
  warning.details = "Looked for flight.toml in two places";
  Notice error;
  error.number = 3;
  error.kind = Notice::Kind::kError;
  error.text = "town.svg: carries no recipe, so its moment cannot be opened";
  error.remedy = actions::OpenDemo{};
  error.remedy_title = "Open the demo";
  NoticesModel model;
  model.all = {done, done, done, warning, error};
  for (std::size_t i = 0; i < 3; ++i) model.all[i].number = static_cast<int>(i) + 5;
  return model;
}

std::vector<std::string> log_lines() {
  std::vector<std::string> lines = {"open /home/ada/flights/loop.nadir", "layer particles off"};
  for (int i = 0; i < 8; ++i) lines.push_back("seek " + std::to_string(i) + ".5");
  lines.emplace_back("# export town.gif: /home/ada/town.gif: does not end in .png, .svg or .pdf");
  return lines;
}

CommandPaletteModel palette() {
  CommandPaletteModel model;
  model.is_open = true;
  model.commands = offered();
  model.recents = recents();
  model.layout_names = {"default", "wide map"};
  model.home = "/home/ada";
  return model;
}

WelcomeModel lone_flight() {
  WelcomeModel model = welcome();
  model.offer.reset();
  model.flight =
      WelcomeModel::LoneFlight{"loop",
                               "nadir flight, 100 pictures in 25 s",
                               "",
                               {"/home/ada/flights/proving-ground", "/home/ada/maps/town"}};
  return model;
}

PlaceModel place() {
  PlaceModel model;
  model.is_open = true;
  model.plane = ProjectPlane::create({33.45, -83.9}).value();
  return model;
}

PreferencesModel preferences() {
  PreferencesModel model;
  model.is_open = true;
  model.memory_used_bytes = 212'000'000;
  model.layout_names = {"default", "wide map", "for figures"};
  return model;
}

PaletteState typed_in_palette(const std::string& typed, const std::string& begun) {
  PaletteState state;
  state.typed = typed;
  state.begun = begun;
  state.is_open = true;
  return state;
}

template <typename State>
State typed_in(const std::string& typed) {
  State state;
  state.typed = typed;
  state.is_open = true;
  return state;
}

const auto kDrawSheet = [](kit::Ui& ui, const auto& model, ShortcutSheetState& state) {
  PaletteState begun;
  return draw_shortcut_sheet(ui, model, state, begun);
};
const auto kDrawLog = [](kit::Ui& ui, const std::vector<std::string>& lines, LogState& state) {
  return draw_log(ui, {lines}, state);
};
const auto kDrawWelcome = [](kit::Ui& ui, const WelcomeModel& model, Nothing& /*state*/) {
  return draw_welcome(ui, model);
};
const auto kDrawRail = [](kit::Ui& ui, const LeftRailModel& model, Nothing& /*state*/) {
  return draw_left_rail(ui, model);
};
const auto kDrawStatus = [](kit::Ui& ui, const StatusBarModel& model, Nothing& /*state*/) {
  return draw_status_bar(ui, model);
};
const auto kDrawNotices = [](kit::Ui& ui, const NoticesModel& model, NoticesState& state) {
  return draw_notices(ui, model, state, ui.screen());
};
const auto kDrawWork = [](kit::Ui& ui, const JobStatus& job, Nothing& /*state*/) {
  return draw_work_card(ui, job, ui.room());
};
const auto kDrawAbout = [](kit::Ui& ui, const AboutModel& model, Nothing& /*state*/) {
  return draw_about(ui, model);
};

}  // namespace

void add_window_scenes(std::vector<PanelScene>& scenes) {
  const Eigen::Vector2d bar(1120.0, kMenuBarHeight), window(760.0, 520.0);
  scenes.push_back(
      panel("menu-bar", "menu_bar", bar, Room::kBare, menus(), PaletteState{}, draw_menu_bar));
  PanelScene open_menu = panel("menu-go", "menu_bar", {620.0, 560.0}, Room::kBare, menus(),
                               PaletteState{}, draw_menu_bar);
  open_menu.pressed = "Panel/Menu/Go";
  scenes.push_back(variant(std::move(open_menu)));
  scenes.push_back(panel("left-rail", "left_rail", {kLeftRailWidth, 420.0}, Room::kBare, rail(),
                         Nothing(), kDrawRail));
  scenes.push_back(panel("status-bar", "status_bar", {1120.0, kStatusBarHeight}, Room::kBare,
                         status(), Nothing(), kDrawStatus));
  scenes.push_back(panel("welcome", "welcome_panel", {720.0, 560.0}, Room::kBare, welcome(),
                         Nothing(), kDrawWelcome));
  scenes.push_back(panel("log", "log_panel", {320.0, 400.0}, Room::kScrolled, log_lines(),
                         LogState{}, kDrawLog));
  scenes.push_back(
      overlay("notices", "notices", {460.0, 480.0}, some_notices(), NoticesState{}, kDrawNotices));
  scenes.push_back(overlay("palette", "command_palette", window, palette(),
                           typed_in_palette("the", ""), draw_command_palette));
  scenes.push_back(variant(overlay("palette-arguments", "command_palette", window, palette(),
                                   typed_in_palette("", "open"), draw_command_palette)));
  scenes.push_back(overlay("shortcuts", "shortcut_sheet", {880.0, 480.0},
                           ShortcutSheetModel{true, offered()}, ShortcutSheetState{}, kDrawSheet));
  scenes.push_back(overlay("preferences", "preferences_panel", {760.0, 640.0}, preferences(),
                           PreferencesState{}, draw_preferences));
  scenes.push_back(overlay("place", "place_overlay", window, place(),
                           typed_in<PlaceState>("33.4512, -83.9005"), draw_place_overlay));
  scenes.push_back(overlay("bookmark", "bookmark_overlay", window,
                           BookmarkNoteModel{true, "loop medium 7", 42.34}, BookmarkNoteState{},
                           draw_bookmark_note));
  scenes.push_back(
      overlay("about", "about_overlay", window, AboutModel{true, "1.2.3"}, Nothing(), kDrawAbout));
  scenes.push_back(variant(panel("welcome-flight", "welcome_panel", {720.0, 640.0}, Room::kBare,
                                 lone_flight(), Nothing(), kDrawWelcome)));
  StatusBarModel unsaved = status();
  unsaved.saving_fault = "/home/ada/.config/nadir: Permission denied";
  scenes.push_back(variant(panel("status-unsaved", "status_bar", {1120.0, kStatusBarHeight},
                                 Room::kBare, unsaved, Nothing(), kDrawStatus)));
  StatusBarModel fresh;
  fresh.hint = "Nothing is open";
  fresh.keeps_session = false;
  fresh.memory_megabytes = 256;
  scenes.push_back(without_data(panel("status-fresh", "status_bar", {1120.0, kStatusBarHeight},
                                      Room::kBare, fresh, Nothing(), kDrawStatus)));
  // What of these has nothing to say.
  scenes.push_back(without_data(panel("log-empty", "log_panel", {320.0, 280.0}, Room::kScrolled,
                                      std::vector<std::string>(), LogState{}, kDrawLog)));
  StatusBarModel idle;
  idle.hint = "Wheel zooms, drag pans";
  idle.memory_megabytes = 256;
  scenes.push_back(without_data(panel("status-idle", "status_bar", {1120.0, kStatusBarHeight},
                                      Room::kBare, idle, Nothing(), kDrawStatus)));
  scenes.push_back(without_data(panel("welcome-first", "welcome_panel", {560.0, 420.0}, Room::kBare,
                                      WelcomeModel{}, Nothing(), kDrawWelcome)));
  const JobStatus demo{7, "making the demo", 0.4, "rendering frames", 18.0, true};
  scenes.push_back(
      panel("work", "work_card", {480.0, 180.0}, Room::kFilled, demo, Nothing(), kDrawWork));
  WelcomeModel busy;
  busy.busy = "making the demo";
  busy.work = demo;
  scenes.push_back(without_data(panel("welcome-busy", "welcome_panel", {560.0, 420.0}, Room::kBare,
                                      busy, Nothing(), kDrawWelcome)));
  scenes.push_back(without_data(overlay("palette-no-match", "command_palette", window, palette(),
                                        typed_in_palette("zzz", ""), draw_command_palette)));
  scenes.push_back(without_data(overlay("shortcuts-no-match", "shortcut_sheet", window,
                                        ShortcutSheetModel{true, offered()},
                                        typed_in<ShortcutSheetState>("zzz"), kDrawSheet)));
  scenes.push_back(
      without_data(overlay("place-without-map", "place_overlay", window,
                           PlaceModel{true, std::nullopt}, PlaceState{}, draw_place_overlay)));
  scenes.push_back(without_data(overlay("bookmark-without-run", "bookmark_overlay", window,
                                        BookmarkNoteModel{true, "", 0.0}, BookmarkNoteState{},
                                        draw_bookmark_note)));
}

}  // namespace nadir::scenes
