// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

#include "widgets/kit/ui.h"

namespace nadir::kit {

/// Every kind of control on one screen of 1280 x 800 at scale 1, roughly where the window has it: what the look is judged by.
class DemoSheet {
 public:
  bool shows_palette = false, shows_notices = true;

  void draw(Ui& ui) {
    const Rect screen = ui.screen();
    const double bar = ui.px(40);
    const double rail = ui.px(56);
    const double side = ui.px(300);
    const double foot = ui.px(120);
    draw_bar(ui, {0.0, 0.0, screen.width, bar});
    draw_rail(ui, {0.0, bar, rail, screen.height - bar});
    draw_layers(ui, {rail, bar, side, screen.height - bar - foot});
    draw_settings(ui, {screen.right() - side, bar, side, screen.height - bar});
    const Rect map{rail + side, bar, screen.width - rail - 2.0 * side, screen.height - bar - foot};
    draw_map(ui, map);
    draw_foot(ui, {rail, screen.height - foot, screen.width - rail - side, foot});
    (void)ui.splitter("Side",
                      Rect{rail + side - ui.px(4), bar, ui.px(8), screen.height - bar - foot},
                      Axis::kHorizontal, side, ui.px(200), ui.px(500));
    if (shows_notices) {
      const std::vector<Notice> notices = {
          {"saved", Level::kGood, "The figure was written to moment.svg.", "", "Open the folder"},
          {"map", Level::kBad,
           "maps/town.png: the file ends after 812 of 4,096 rows; fetch it again.",
           "libpng: read error"}};
      (void)ui.notices(notices, map);
    }
    if (shows_palette) draw_palette(ui);
  }

 private:
  static void draw_bar(Ui& ui, const Rect& rect) {
    RegionStyle style;
    style.padding = ui.px(6);
    const auto region = ui.region("Menu", rect, style);
    {
      const auto bar = ui.menu_bar();
      if (const auto file = ui.menu("File")) {
        (void)ui.menu_item("Open…", {"Ctrl+O", Icon::kFolderOpen});
        (void)ui.menu_item("Save the figure…", {"Ctrl+S", Icon::kSave, false, "No run is open"});
        ui.menu_line();
        if (const auto recent = ui.menu("Recent")) (void)ui.menu_item("loop medium 7");
        (void)ui.menu_item("Quit", {"Ctrl+Q"});
      }
      if (const auto view = ui.menu("View"))
        (void)ui.menu_item("North up", {"N", Icon::kNone, true});
      if (const auto run = ui.menu("Run")) (void)ui.menu_item("Localise");
      if (const auto help = ui.menu("Help")) (void)ui.menu_item("Shortcuts", {"?"});
    }
    ui.same_line(ui.px(24));
    ui.text("proving-ground › loop medium 7 › default", TextLook::kMuted);
    ui.same_line();
    ui.right_align(ui.px(28));
    (void)ui.icon_button("Palette", Icon::kSearch, {"Find an action", "Ctrl+P"});
  }

  static void draw_rail(Ui& ui, const Rect& rect) {
    RegionStyle style;
    style.padding = 0.0;
    style.surface = Surface::kWindow;
    const auto region = ui.region("Rail", rect, style);
    (void)ui.rail_button("Replay", Icon::kPlay, {"Replay a run", "Ctrl+1"}, true);
    (void)ui.rail_button("Label", Icon::kPencil, {"Label a map", "Ctrl+2"}, false);
    (void)ui.rail_button("Study", Icon::kChart, {"Compare runs", "Ctrl+3"}, false);
  }

  void draw_layers(Ui& ui, const Rect& rect) {
    RegionStyle style;
    style.has_scroll = true;
    const auto region = ui.region("Layers", rect, style);
    const std::vector<std::string> titles = {"Layers", "Runs", "Bookmarks"};
    if (const auto tab = ui.tabs("Tabs", titles, tab_)) tab_ = *tab;
    if (const auto edit = ui.search_input("Search", search_, {"Find a layer"}); edit.is_changed)
      search_ = edit.value;
    struct Layer {
      const char* name;
      Rgba colour;
      double* opacity;
    };
    const Theme& theme = ui.theme();
    const std::vector<Layer> layers = {{"Particles", theme.estimate, &opacity_},
                                       {"Odometry", theme.odometry, &other_},
                                       {"Truth", theme.truth, &other_},
                                       {"Disagreement", theme.disagreement, &other_}};
    for (std::size_t i = 0; i < layers.size(); ++i) {
      const Layer& layer = layers[i];
      const auto scope = ui.scope(layer.name);
      (void)ui.grip("Move", i, layers.size(), ui.px(28));
      ui.same_line(ui.px(2));
      if (const auto seen = ui.eye("Show", i != 2 && shows_)) shows_ = *seen;
      ui.same_line(ui.px(2));
      ui.next_width(ui.room().width - ui.px(92));
      ListRow row;
      row.colour = layer.colour;
      row.is_selected = i == 0;
      (void)ui.list_row(layer.name, row);
      ui.same_line(ui.px(8));
      NumberOptions share;
      share.least = 0.0;
      share.most = 1.0;
      share.hint = {"Opacity", ""};
      if (const auto edit = ui.small_slider("Opacity", *layer.opacity, share); edit.is_changed)
        *layer.opacity = edit.value;
    }
    ui.space();
    if (const auto section = ui.section("Colours")) {
      if (const auto edit = ui.colour("Estimate", colour_); edit.is_changed) colour_ = edit.value;
      if (const auto on = ui.checkbox("Casing under lines", is_cased_)) is_cased_ = *on;
      if (const auto off = ui.disabled(true, "This run has no truth"))
        (void)ui.checkbox("Truth above all", false);
    }
    if (const auto section = ui.section("Order", false, "by name")) ui.text("hidden");
    ui.line();
    (void)ui.button("Add layer…", ButtonLook::kNormal, {}, Icon::kPlus);
    ui.same_line();
    (void)ui.button("Reset", ButtonLook::kQuiet);
  }

  void draw_settings(Ui& ui, const Rect& rect) {
    RegionStyle style;
    style.has_scroll = true;
    const auto region = ui.region("Settings", rect, style);
    ui.heading("Localiser");
    NumberOptions particles;
    particles.least = 1.0;
    particles.most = 1e6;
    particles.decimals = 0;
    particles.step = 100.0;
    particles.reset = 5000.0;
    particles.hint = {"Particles kept after resampling", ""};
    if (const auto edit = ui.number_input("Particles", particles_, particles); edit.is_changed)
      particles_ = edit.value;
    NumberOptions noise;
    noise.least = 0.0;
    noise.most = 5.0;
    noise.unit = "°/m";
    noise.reset = 0.1;
    if (const auto edit = ui.slider("Heading noise", noise_, noise); edit.is_changed)
      noise_ = edit.value;
    NumberOptions below;
    below.least = 0.0;
    below.most = 1.0;
    if (const auto edit = ui.slider("Resample below", below_, below); edit.is_changed)
      below_ = edit.value;
    const std::vector<std::string> kinds = {"x–y", "yaw", "all"};
    if (const auto kind = ui.choice("Slices", kinds, kind_)) kind_ = *kind;
    const std::vector<std::string> presets = {"default", "careful", "wide search"};
    if (const auto preset = ui.combo("Preset", presets, preset_)) preset_ = *preset;
    if (const auto edit = ui.text_input("Name", name_, {"a name for the run"}); edit.was_committed)
      name_ = edit.value;
    ui.space();
    (void)ui.button("Localise", ButtonLook::kPrimary, {"Run the localiser", "Ctrl+R"}, Icon::kPlay);
    ui.same_line();
    {
      const auto off = ui.disabled(true, "The run is at its start");
      (void)ui.button("From here");
    }
    ui.space();
    (void)ui.progress("Localising", 0.43, "12 s left");
    ui.line();
    ui.heading("Moment");
    ui.read_out("Position error", "1.84", "m", {"Distance from the truth", "", "", "evaluated"});
    ui.read_out("NEES", "11.2", "", {}, TextLook::kWarning);
    ui.read_out("State", "lost", "", {}, TextLook::kBad);
    ui.space();
    draw_table(ui);
    const std::vector<std::string> where = {"at the estimate", "at the truth"};
    if (const auto chosen = ui.radio("Topview", where, where_)) where_ = *chosen;
    ui.wrapped("The true pose would have scored better: the filter had no particle near it.",
               TextLook::kMuted);
  }

  void draw_table(Ui& ui) {
    std::vector<Column> columns = {{"Class"},
                                   {"Agreement", Align::kLeft, ui.px(110)},
                                   {"Error", Align::kDecimal, ui.px(64), 2}};
    if (const auto table = ui.table("Classes", columns)) {
      const auto row = [&](const char* name, double share, const char* error, bool is_selected) {
        (void)ui.row(name, is_selected);
        ui.cell(name);
        ui.bar_cell(share, ui.theme().agreement, fmt::format("{:.0f} %", 100.0 * share));
        ui.number_cell(error);
      };
      row("road", 0.91, "0.4", false);
      row("building", 0.62, "12.25", true);
      row("terrain", 0.08, "3", false);
    }
  }

  static void draw_map(Ui& ui, const Rect& rect) {
    RegionStyle style;
    style.padding = 0.0;
    style.surface = Surface::kWindow;
    const auto region = ui.region("Map", rect, style);
    const AreaInput area = ui.area("map");
    Canvas& canvas = ui.canvas();
    const Theme& theme = ui.theme();
    const double s = ui.scale();
    std::vector<Eigen::Vector2d> loop;
    for (int i = 0; i <= 100; ++i) {
      const double t = 2.0 * std::numbers::pi * i / 100.0;
      loop.emplace_back(area.rect.width * (0.5 + 0.3 * std::sin(t)),
                        area.rect.height * (0.55 + 0.3 * std::sin(2.0 * t)));
    }
    canvas.stroke(loop, {theme.estimate, 2.5 * s, {}});
    for (auto& point : loop) point += Eigen::Vector2d(12.0 * s, 9.0 * s);
    canvas.stroke(loop, {theme.odometry, 2.0 * s, {6.0 * s, 4.0 * s}});
    const std::vector<Eigen::Vector2d> star = {{60 * s, 60 * s},
                                               {80 * s, 100 * s},
                                               {100 * s, 60 * s},
                                               {50 * s, 86 * s},
                                               {110 * s, 86 * s}};
    canvas.fill(star, theme.agreement);
    TextStyle words;
    words.size_px = 12.0 * s;
    words.colour = theme.text;
    canvas.text({20 * s, 20 * s}, "100 m, baseline at 20", words);
    words.rotation_deg = 90.0;
    words.face = FontFace::kNumbers;
    canvas.text({20 * s, 60 * s}, "E 123.45", words);
    RegionStyle plate;
    plate.surface = Surface::kPlate;
    plate.is_above = true;
    plate.padding = ui.px(8);
    const auto legend = ui.region(
        "Legend", {rect.left + ui.px(12), rect.top + ui.px(12), ui.px(130), ui.px(80)}, plate);
    ui.colour_dot(theme.estimate);
    ui.same_line();
    ui.text("estimate");
    ui.colour_dot(theme.odometry);
    ui.same_line();
    ui.text("odometry");
    ui.number("00:42.3", "s");
  }

  static void draw_foot(Ui& ui, const Rect& rect) {
    RegionStyle style;
    style.padding = ui.px(8);
    const auto region = ui.region("Timeline", rect, style);
    (void)ui.icon_button("First", Icon::kFirst, {"To the start", "Home"});
    ui.same_line(ui.px(2));
    (void)ui.icon_button("Back", Icon::kStepBack, {"One step back", "Left"});
    ui.same_line(ui.px(2));
    (void)ui.icon_button("Play", Icon::kPlay, {"Play", "Space"}, true);
    ui.same_line(ui.px(2));
    (void)ui.icon_button("Forward", Icon::kStepForward, {"One step on", "Right"});
    ui.same_line();
    ui.number("00:42.3", "/ 02:30.0");
    ui.same_line();
    ui.right_align(ui.px(28));
    {
      const auto menu = ui.button_menu("More", Icon::kMore, {"Strips", ""});
      if (menu) (void)ui.menu_item("Error", {"", Icon::kNone, true});
    }
    const AreaInput strip = ui.area("strip");
    ui.canvas().fill(
        std::vector<Eigen::Vector2d>{{0, 0}, {strip.rect.width, 0}, {strip.rect.width, 1}, {0, 1}},
        ui.theme().line);
  }

  static void draw_palette(Ui& ui) {
    OverlayStyle style;
    style.width = ui.px(560);
    style.place = OverlayPlace::kUpperThird;
    const auto palette = ui.overlay("Palette", style);
    (void)ui.search_input("Search", "rerun", {"Type what to do", true});
    ui.space(ui.px(4));
    ListRow row;
    row.detail = "Ctrl+Shift+R";
    row.is_selected = true;
    row.icon = Icon::kRefresh;
    (void)ui.list_row("Rerun from the cursor", row);
    row.is_selected = false;
    row.detail = "";
    (void)ui.list_row("Rerun from the start", row);
  }

  std::size_t tab_ = 0, kind_ = 0, preset_ = 0, where_ = 0;
  std::string search_, name_;
  bool shows_ = true, is_cased_ = true;
  double opacity_ = 0.6, other_ = 1.0, particles_ = 10000.0, noise_ = 0.35, below_ = 0.5;
  Rgba colour_{0, 114, 178};
};

}  // namespace nadir::kit
