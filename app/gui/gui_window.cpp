// SPDX-License-Identifier: Apache-2.0
#include "app/gui/gui_window.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/panels/about_overlay.h"
#include "widgets/panels/left_rail.h"
#include "widgets/panels/menu_bar.h"
#include "widgets/panels/notices.h"
#include "widgets/panels/shortcuts.h"
#include "widgets/panels/status_bar.h"
#include "widgets/panels/welcome_panel.h"

namespace nadir {
namespace {

void join(Actions& all, Actions more) {
  for (Action& action : more) all.push_back(std::move(action));
}

struct Tab {
  Panel panel;
  std::string_view title;
};
constexpr std::array kLeftTabs = {Tab{Panel::kLayers, "Layers"}, Tab{Panel::kRuns, "Runs"},
                                  Tab{Panel::kBookmarks, "Moments"}, Tab{Panel::kLog, "Log"}};
constexpr std::array kRightTabs = {Tab{Panel::kMoment, "Moment"},     Tab{Panel::kWhy, "Why"},
                                   Tab{Panel::kSettings, "Settings"}, Tab{Panel::kCamera, "Camera"},
                                   Tab{Panel::kTopview, "Topview"},   Tab{Panel::kScene, "3D"}};

/// The tabs of a column that are shown, and which of them is in front.
struct Tabs {
  std::vector<std::string> titles;
  std::vector<Panel> panels;
  std::size_t chosen = 0;
};
template <std::size_t N>
Tabs shown_tabs(const std::array<Tab, N>& all, const WindowLayout& layout, Panel front) {
  Tabs tabs;
  for (const Tab& tab : all) {
    if (!layout.shows(tab.panel)) continue;
    if (tab.panel == front) tabs.chosen = tabs.panels.size();
    tabs.titles.emplace_back(tab.title);
    tabs.panels.push_back(tab.panel);
  }
  return tabs;
}

/// Of the design: a column is not made narrower by hand.
constexpr double kLeastColumn = 180.0;

bool is_empty(const Session& session) {
  return session.view().runs.empty() && session.view().map_path.empty();
}

}  // namespace

/// Where everything is in this frame. A rectangle without width or height is not shown.
struct GuiWindow::Places {
  kit::Rect menu, rail, left, map, right, timeline, status;
  double most_left_px = 0.0, most_right_px = 0.0, most_timeline_px = 0.0;
};

GuiWindow::GuiWindow(Session& session) : session_(session) {
  const auto texture_of = [this](const Picture& picture) { return textures_.of(picture); };
  moment_.texture_of = texture_of;
  why_.texture_of = texture_of;
  camera_.texture_of = texture_of;
  topview_.texture_of = texture_of;
}

GuiWindow::~GuiWindow() = default;

GuiWindow::Places GuiWindow::arrange(const kit::Ui& ui) const {
  constexpr double kMostOfWidth = 0.4;
  constexpr double kMostOfHeight = 0.6;
  const WindowLayout& layout = session_.view().layout;
  const kit::Rect screen = ui.screen();
  Places places;
  const bool is_whole = !layout.is_map_only;
  const auto has_any = [&layout](const auto& tabs) {
    return std::any_of(tabs.begin(), tabs.end(),
                       [&layout](const Tab& tab) { return layout.shows(tab.panel); });
  };
  const double menu = is_whole ? ui.px(kMenuBarHeight) : 0.0;
  const double rail = is_whole ? ui.px(kLeftRailWidth) : 0.0;
  const double status = is_whole && layout.shows(Panel::kStatus) ? ui.px(kStatusBarHeight) : 0.0;
  const bool has_content = is_whole && !is_empty(session_);
  places.most_left_px = places.most_right_px = kMostOfWidth * (screen.width - rail);
  places.most_timeline_px = kMostOfHeight * (screen.height - menu - status);
  const auto size = [&ui](bool is_shown, double wanted, double most) {
    return is_shown ? std::round(std::min(ui.px(wanted), most)) : 0.0;
  };
  double left = size(has_content && has_any(kLeftTabs), layout.left_pt, places.most_left_px);
  double right = size(has_content && has_any(kRightTabs), layout.right_pt, places.most_right_px);
  // In a small window the columns give way before the map does.
  constexpr double kLeastMap = 400.0;
  const double room = std::max(screen.width - rail - ui.px(kLeastMap), 2.0 * ui.px(kLeastColumn));
  if (left + right > room) {
    const double share = room / (left + right);
    left = std::floor(left * share);
    right = std::floor(right * share);
  }
  const double timeline = size(has_content && layout.shows(Panel::kTimeline), layout.timeline_pt,
                               places.most_timeline_px);
  const double bottom = screen.height - status - timeline;
  places.menu = {0.0, 0.0, screen.width, menu};
  places.rail = {0.0, menu, rail, screen.height - menu - status};
  places.left = {rail, menu, left, bottom - menu};
  places.right = {screen.width - right, menu, right, bottom - menu};
  places.map = {rail + left, menu, screen.width - rail - left - right, bottom - menu};
  places.timeline = {rail, bottom, screen.width - rail, timeline};
  places.status = {0.0, screen.height - status, screen.width, status};
  return places;
}

void GuiWindow::frame(kit::Ui& ui) {
  wants_more_ = false;
  follow_map();
  Actions asked;
  const Places places = arrange(ui);
  const bool is_overlay_open = session_.overlay() != Overlay::kNone;
  if (const Command* const pressed = pressed_command(ui, is_overlay_open)) {
    if (pressed->text == "paste-view") {  // what it asks for lies on the clipboard
      asked.emplace_back(actions::PasteView{ui.clipboard()});
    } else {
      join(asked, begin_command(*pressed, palette_));
    }
  }
  draw_columns(ui, places, asked);
  draw_splitters(ui, places, asked);
  draw_overlays(ui, asked);
  join(asked, draw_notices(ui, notices_model(session_), places.map));
  textures_.end_frame();
  for (const Action& action : asked) session_.apply(action);  // what fails becomes a notice
  if (!ui.is_holding()) session_.seal_history();
}

void GuiWindow::draw_columns(kit::Ui& ui, const Places& places, Actions& asked) {
  if (places.menu.height > 0.0) {
    const auto region = ui.region("Top", places.menu, {.padding = 0.0});
    join(asked, draw_menu_bar(ui, menu_bar_model(session_), palette_));
  }
  if (places.rail.width > 0.0) {
    const auto region = ui.region("Rail", places.rail, {.padding = 0.0});
    join(asked, draw_left_rail(ui, left_rail_model(session_)));
  }
  if (places.left.width > 0.0) {
    const auto region = ui.region("Left", places.left, {.has_border = true});
    draw_left(ui, asked);
  }
  {
    const auto region =
        ui.region("Middle", places.map, {.surface = kit::Surface::kWindow, .padding = 0.0});
    draw_middle(ui, asked);
  }
  if (places.right.width > 0.0) {
    const auto region = ui.region("Right", places.right, {.has_border = true});
    draw_right(ui, asked);
  }
  if (places.timeline.height > 0.0) {
    const auto region = ui.region("Bottom", places.timeline, {.has_border = true});
    join(asked, draw_timeline(ui, timeline_model(session_), timeline_));
  }
  if (places.status.height > 0.0) {
    const auto region = ui.region("Foot", places.status, {.padding = 0.0});
    const auto under_pointer =
        map_.readout ? std::optional(map_.readout->in_enu_m) : std::optional<Eigen::Vector2d>();
    join(asked, draw_status_bar(ui, status_bar_model(session_, under_pointer)));
  }
}

void GuiWindow::draw_left(kit::Ui& ui, Actions& asked) {
  const WindowLayout& layout = session_.view().layout;
  const Tabs tabs = shown_tabs(kLeftTabs, layout, layout.left_tab);
  if (const auto chosen = ui.tabs("Tabs", tabs.titles, tabs.chosen)) {
    asked.emplace_back(actions::ShowPanel{tabs.panels[*chosen], Switch::kOn});
  }
  const auto content = ui.scroll_area("Content");
  const Panel front = tabs.panels[tabs.chosen];
  if (front == Panel::kLayers) join(asked, draw_layers(ui, layers_model(session_), layers_));
  if (front == Panel::kRuns) join(asked, draw_runs(ui, runs_model(session_), runs_));
  if (front == Panel::kBookmarks) {
    join(asked, draw_bookmarks(ui, bookmarks_model(session_), bookmarks_));
  }
  if (front == Panel::kLog) join(asked, draw_log(ui, log_model(session_), log_));
}

void GuiWindow::draw_right(kit::Ui& ui, Actions& asked) {
  const WindowLayout& layout = session_.view().layout;
  const Tabs tabs = shown_tabs(kRightTabs, layout, layout.right_tab);
  if (const auto chosen = ui.tabs("Tabs", tabs.titles, tabs.chosen)) {
    asked.emplace_back(actions::ShowPanel{tabs.panels[*chosen], Switch::kOn});
  }
  const Panel front = tabs.panels[tabs.chosen];
  switch (front) {
    case Panel::kMoment: {
      const auto content = ui.scroll_area("Content");
      join(asked, draw_moment_panel(ui, moment_model(session_), moment_));
      break;
    }
    case Panel::kWhy: {
      const auto content = ui.scroll_area("Content");
      join(asked, draw_why_panel(ui, why_model(session_, inquiry_), why_));
      break;
    }
    case Panel::kSettings:
      join(asked, draw_settings_panel(ui, settings_model(session_), settings_));
      break;
    case Panel::kCamera:
      join(asked, draw_camera_panel(ui, camera_panel_model(session_), camera_));
      break;
    case Panel::kTopview:
      join(asked, draw_topview_panel(ui, topview_panel_model(session_), topview_));
      break;
    case Panel::kScene:
      scene_state_.scene = [this, &ui](const SceneWish& wish) { return draw_scene(wish, ui); };
      join(asked, draw_scene_panel(ui, scene_panel_model(session_), scene_state_));
      scene_state_.scene = {};
      break;
    default:
      break;
  }
}

void GuiWindow::draw_middle(kit::Ui& ui, Actions& asked) {
  if (is_empty(session_)) {
    join(asked, draw_welcome(ui, welcome_model(session_), palette_));
    return;
  }
  const kit::Rect room = ui.room();
  if (room.height > 0.0) session_.set_map_aspect(room.width / room.height);
  map_.ground = [this, &ui](const MapGround& wanted) { return draw_ground(wanted, ui); };
  join(asked, draw_map_view(ui, map_view_model(session_), map_));
  map_.ground = {};
}

void GuiWindow::draw_splitters(kit::Ui& ui, const Places& places, Actions& asked) {
  const double handle = ui.px(6.0);
  const double scale = ui.px(1.0);
  constexpr double kLeastTimeline = 64.0;
  const auto ask = [&](Splitter splitter, const kit::Edit<double>& edit) {
    if (edit.is_changed) asked.emplace_back(actions::MoveSplitter{splitter, edit.value / scale});
  };
  if (places.left.width > 0.0) {
    const kit::Rect rect{places.left.right() - handle / 2.0, places.left.top, handle,
                         places.left.height};
    ask(Splitter::kLeft, ui.splitter("Left splitter", rect, kit::Axis::kHorizontal,
                                     places.left.width, ui.px(kLeastColumn), places.most_left_px));
  }
  if (places.right.width > 0.0) {
    const kit::Rect rect{places.right.left - handle / 2.0, places.right.top, handle,
                         places.right.height};
    ask(Splitter::kRight,
        ui.splitter("Right splitter", rect, kit::Axis::kHorizontal, places.right.width,
                    ui.px(kLeastColumn), places.most_right_px, true));
  }
  if (places.timeline.height > 0.0) {
    const kit::Rect rect{places.timeline.left, places.timeline.top - handle / 2.0,
                         places.timeline.width, handle};
    ask(Splitter::kTimeline,
        ui.splitter("Timeline splitter", rect, kit::Axis::kVertical, places.timeline.height,
                    ui.px(kLeastTimeline), places.most_timeline_px, true));
  }
}

void GuiWindow::draw_overlays(kit::Ui& ui, Actions& asked) {
  join(asked, draw_command_palette(ui, command_palette_model(session_), palette_));
  join(asked, draw_shortcut_sheet(ui, shortcut_sheet_model(session_), shortcuts_, palette_));
  join(asked, draw_preferences(ui, preferences_model(session_), preferences_));
  join(asked, draw_place_overlay(ui, place_model(session_), place_));
  join(asked, draw_bookmark_note(ui, bookmark_note_model(session_), bookmark_note_));
  join(asked, draw_about(ui, about_model(session_)));
}

bool GuiWindow::wants_more() const {
  return wants_more_ || inquiry_.is_working() || reconstruction_.is_working();
}

}  // namespace nadir
