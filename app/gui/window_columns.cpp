// SPDX-License-Identifier: Apache-2.0
// Menu, columns, timeline and status of the window: which panels lie where.
#include <algorithm>
#include <array>

#include "app/gui/gui_window.h"
#include "widgets/panels/left_rail.h"
#include "widgets/panels/menu_bar.h"
#include "widgets/panels/status_bar.h"

namespace nadir {
namespace {

void take_wishes(Actions& all, Actions more) {
  for (Action& action : more) all.push_back(std::move(action));
}

struct Tab {
  Panel panel;
  std::string_view title;
  kit::Icon icon;
};
constexpr std::array kLeftTabs = {Tab{Panel::kLayers, "Layers", kit::Icon::kLayers},
                                  Tab{Panel::kRuns, "Runs", kit::Icon::kList},
                                  Tab{Panel::kBookmarks, "Moments", kit::Icon::kBookmark},
                                  Tab{Panel::kLog, "Log", kit::Icon::kTable}};
constexpr std::array kRightTabs = {Tab{Panel::kMoment, "Moment", kit::Icon::kClock},
                                   Tab{Panel::kWhy, "Why", kit::Icon::kQuestion},
                                   Tab{Panel::kSettings, "Settings", kit::Icon::kGear},
                                   Tab{Panel::kCamera, "Camera", kit::Icon::kCamera},
                                   Tab{Panel::kTopview, "Topview", kit::Icon::kMap},
                                   Tab{Panel::kScene, "3D", kit::Icon::kCube}};

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

template <std::size_t N>
bool shows_any(const std::array<Tab, N>& tabs, const WindowLayout& layout) {
  return std::any_of(tabs.begin(), tabs.end(),
                     [&layout](const Tab& tab) { return layout.shows(tab.panel); });
}
template <std::size_t N>
bool has_panel(const std::array<Tab, N>& tabs, Panel panel) {
  return std::any_of(tabs.begin(), tabs.end(),
                     [panel](const Tab& tab) { return tab.panel == panel; });
}

/// A column that there is no room for: a button for each of its panels.
template <std::size_t N>
void draw_strip_of(kit::Ui& ui,
                   const std::array<Tab, N>& all,
                   const WindowLayout& layout,
                   Actions& asked) {
  std::vector<kit::Tool> tools;
  std::vector<Panel> panels;
  for (const Tab& tab : all) {
    if (!layout.shows(tab.panel)) continue;
    kit::Tool tool;
    tool.name = std::string(tab.title);
    tool.icon = tab.icon;
    tool.hint.text = tool.name;
    tools.push_back(std::move(tool));
    panels.push_back(tab.panel);
  }
  if (const auto clicked = ui.tool_column(tools, ui.room().height)) {
    asked.emplace_back(actions::ShowPanel{panels[*clicked], Switch::kOn});
  }
}

/// A column, or the strip in its place. @param draw  Its content.
template <std::size_t N, typename Draw>
void draw_column(kit::Ui& ui,
                 const std::string& name,
                 const kit::Rect& column,
                 const kit::Rect& strip,
                 const std::array<Tab, N>& tabs,
                 const WindowLayout& layout,
                 Actions& asked,
                 const Draw& draw) {
  if (column.width > 0.0) {
    const auto region = ui.region(name, column, {.has_border = true});
    draw();
  }
  if (strip.width > 0.0) {
    const auto region = ui.region(name, strip, {.padding = ui.px(4.0), .has_border = true});
    draw_strip_of(ui, tabs, layout, asked);
  }
}

/// The tabs of a column. @returns the panel below them. @param front  That was asked for last.
template <std::size_t N>
Panel draw_tabs(kit::Ui& ui,
                const std::array<Tab, N>& all,
                const WindowLayout& layout,
                Panel front,
                Actions& asked) {
  const Tabs tabs = shown_tabs(all, layout, front);
  if (const auto chosen = ui.tabs("Tabs", tabs.titles, tabs.chosen)) {
    asked.emplace_back(actions::ShowPanel{tabs.panels[*chosen], Switch::kOn});
  }
  return tabs.panels[tabs.chosen];
}

}  // namespace

WindowPlaces GuiWindow::arrange(const kit::Ui& ui) {
  const WindowLayout& layout = session_.view().layout;
  // What was asked for last stays where there is no room for both columns.
  if (layout.left_tab != shown_left_) front_ = WindowSide::kLeft;
  if (layout.right_tab != shown_right_) front_ = WindowSide::kRight;
  shown_left_ = layout.left_tab;
  shown_right_ = layout.right_tab;
  const kit::Rect screen = ui.screen();
  const bool is_whole = !layout.is_map_only;
  const bool has_content = is_whole && !is_empty();
  WindowWishes wishes;
  wishes.width_px = screen.width;
  wishes.height_px = screen.height;
  wishes.scale = ui.scale();
  wishes.has_frame = is_whole;
  const bool labels = draws_labels();
  wishes.has_left = has_content && (labels || shows_any(kLeftTabs, layout));
  wishes.has_right = has_content && (labels || shows_any(kRightTabs, layout));
  wishes.has_timeline = has_content && !labels && layout.shows(Panel::kTimeline);
  wishes.has_status = is_whole && layout.shows(Panel::kStatus);
  wishes.left_pt = layout.left_pt;
  wishes.right_pt = layout.right_pt;
  wishes.timeline_pt = layout.timeline_pt;
  wishes.front = front_;
  return arrange_window(wishes);
}

void GuiWindow::note_front(const Actions& asked) {
  for (const Action& action : asked) {
    const auto* const shown = std::get_if<actions::ShowPanel>(&action);
    if (shown == nullptr) continue;
    if (has_panel(kLeftTabs, shown->panel)) front_ = WindowSide::kLeft;
    if (has_panel(kRightTabs, shown->panel)) front_ = WindowSide::kRight;
  }
}

void GuiWindow::draw_columns(kit::Ui& ui, const WindowPlaces& places, Actions& asked) {
  if (places.menu.height > 0.0) {
    const auto region = ui.region("Top", places.menu, {.padding = 0.0});
    take_wishes(asked, draw_menu_bar(ui, menu_bar_model(session_), palette_));
  }
  if (places.rail.width > 0.0) {
    const auto region = ui.region("Rail", places.rail, {.padding = 0.0});
    take_wishes(asked, draw_left_rail(ui, left_rail_model(session_)));
  }
  const WindowLayout& layout = session_.view().layout;
  const bool labels = draws_labels();
  if (labels) {
    draw_label_columns(ui, places, asked);
  } else {
    draw_column(ui, "Left", places.left, places.left_strip, kLeftTabs, layout, asked,
                [&] { draw_left(ui, asked); });
  }
  {
    const auto region =
        ui.region("Middle", places.map,
                  {.surface = kit::Surface::kWindow, .padding = 0.0, .has_scroll = is_empty()});
    draw_middle(ui, asked);
  }
  if (!labels) {
    draw_column(ui, "Right", places.right, places.right_strip, kRightTabs, layout, asked,
                [&] { draw_right(ui, asked); });
  }
  if (places.timeline.height > 0.0) {
    const auto region = ui.region("Bottom", places.timeline,
                                  {.padding = ui.px(kTimelinePadding), .has_border = true});
    take_wishes(asked, draw_timeline(ui, timeline_model(session_), timeline_));
    if (!timeline_.fault.empty()) {
      session_.notify(Notice::Kind::kError, std::exchange(timeline_.fault, {}));
    }
  }
  if (places.status.height > 0.0) {
    const auto region = ui.region("Foot", places.status, {.padding = 0.0});
    const auto under_pointer =
        map_.readout ? std::optional(map_.readout->in_enu_m) : std::optional<Eigen::Vector2d>();
    StatusBarModel status = status_bar_model(session_, under_pointer);
    status.drawn_bytes = drawn_bytes();
    take_wishes(asked, draw_status_bar(ui, status));
  }
}

void GuiWindow::draw_left(kit::Ui& ui, Actions& asked) {
  const WindowLayout& layout = session_.view().layout;
  const Panel front = draw_tabs(ui, kLeftTabs, layout, layout.left_tab, asked);
  const auto content = ui.scroll_area("Content");
  if (front == Panel::kLayers) take_wishes(asked, draw_layers(ui, layers_model(session_), layers_));
  if (front == Panel::kRuns) take_wishes(asked, draw_runs(ui, runs_model(session_), runs_));
  if (front == Panel::kBookmarks) {
    take_wishes(asked, draw_bookmarks(ui, bookmarks_model(session_), bookmarks_));
  }
  if (front == Panel::kLog) take_wishes(asked, draw_log(ui, log_model(session_), log_));
}

void GuiWindow::draw_right(kit::Ui& ui, Actions& asked) {
  const WindowLayout& layout = session_.view().layout;
  const Panel front = draw_tabs(ui, kRightTabs, layout, layout.right_tab, asked);
  switch (front) {
    case Panel::kMoment: {
      const auto content = ui.scroll_area("Content");
      take_wishes(asked, draw_moment_panel(ui, moment_model(session_), moment_));
      break;
    }
    case Panel::kWhy: {
      const auto content = ui.scroll_area("Content");
      take_wishes(asked, draw_why_panel(ui, why_model(session_, inquiry_), why_));
      break;
    }
    case Panel::kSettings:
      take_wishes(asked, draw_settings_panel(ui, settings_model(session_), settings_));
      break;
    case Panel::kCamera:
      take_wishes(asked, draw_camera_panel(ui, camera_panel_model(session_), camera_));
      break;
    case Panel::kTopview:
      take_wishes(asked, draw_topview_panel(ui, topview_panel_model(session_), topview_));
      break;
    case Panel::kScene:
      scene_state_.scene = [this, &ui](const SceneWish& wish) { return draw_scene(wish, ui); };
      take_wishes(asked, draw_scene_panel(ui, scene_panel_model(session_), scene_state_));
      scene_state_.scene = {};
      break;
    default:
      break;
  }
}

}  // namespace nadir
