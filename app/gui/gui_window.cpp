// SPDX-License-Identifier: Apache-2.0
#include "app/gui/gui_window.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/panels/about_overlay.h"
#include "widgets/panels/map_cards.h"
#include "widgets/panels/shortcuts.h"
#include "widgets/panels/welcome_panel.h"

namespace nadir {
namespace {

void join(Actions& all, Actions more) {
  for (Action& action : more) all.push_back(std::move(action));
}

}  // namespace

GuiWindow::GuiWindow(Session& session) : session_(session) {
  const auto texture_of = [this](const Picture& picture) { return textures_.of(picture); };
  moment_.texture_of = texture_of;
  why_.texture_of = texture_of;
  camera_.texture_of = texture_of;
  topview_.texture_of = texture_of;
}

GuiWindow::~GuiWindow() = default;

bool GuiWindow::is_empty() const {
  return session_.view().runs.empty() && session_.view().map_path.empty() && !draws_labels();
}

void GuiWindow::frame(kit::Ui& ui, double elapsed_s) {
  wants_more_ = false;
  if (undo_pace_.is_over(elapsed_s)) session_.seal_history();
  follow_map();
  Actions asked;
  const WindowPlaces places = arrange(ui);
  const bool is_overlay_open = session_.overlay() != Overlay::kNone;
  if (const Command* const pressed = pressed_command(ui, is_overlay_open, draws_labels())) {
    if (pressed->text == "paste-view") {  // what it asks for lies on the clipboard
      asked.emplace_back(actions::PasteView{ui.clipboard()});
    } else if (pressed->text == "paste-labels") {
      asked.emplace_back(actions::PasteLabels{ui.clipboard()});
    } else {
      join(asked, begin_command(*pressed, palette_));
    }
  }
  draw_columns(ui, places, asked);
  draw_splitters(ui, places, asked);
  draw_overlays(ui, asked);
  // Beside a box that lies over the window there is more room in all of it; else they stand above the legend, and right of the
  // tools.
  kit::Rect beside = is_overlay_open ? ui.screen() : places.map;
  if (!is_overlay_open && !is_empty()) {
    beside = beside_map_tools(ui, beside);
    beside.height -= map_.legend_height_px;
  }
  join(asked, draw_notices(ui, notices_model(session_), notices_, beside));
  forget_unseen();
  note_front(asked);
  for (const Action& action : asked) session_.apply(action);  // what fails becomes a notice
  undo_pace_.note(!asked.empty(), ui.is_holding());
}

void GuiWindow::draw_middle(kit::Ui& ui, Actions& asked) {
  if (is_empty()) {
    join(asked, draw_welcome(ui, welcome_model(session_)));
    return;
  }
  // What the map's controls cover is known once they are drawn; its size is known now.
  const kit::Rect room = ui.room();
  const double panes = session_.view().map.is_split ? 2.0 : 1.0;
  map_.room.aspect = room.width / panes / std::max(1.0, room.height);
  session_.set_map_room(map_.room);
  map_.ground = [this, &ui](const MapGround& wanted) { return draw_ground(wanted, ui); };
  MapViewModel model = map_view_model(session_);
  if (const auto surface = surface_now()) {
    model.surface_costs = cost_range(why_.shows_best_turn ? surface->best_turn : surface->plane);
  }
  if (const auto& ground = grounds_.front().picture) model.has_picture = ground->has_picture();
  join(asked, draw_map_view(ui, model, map_));
  map_.ground = {};
  session_.set_map_room(map_.room);
}

void GuiWindow::draw_splitters(kit::Ui& ui, const WindowPlaces& places, Actions& asked) {
  const double handle = ui.px(6.0);
  const double scale = ui.scale();
  const WindowLayout& layout = session_.view().layout;
  const auto ask = [&](Splitter splitter, const kit::Edit<double>& edit) {
    if (edit.is_changed) asked.emplace_back(actions::MoveSplitter{splitter, edit.value / scale});
    return edit.is_changed;
  };
  // A column that had given way stays as it is while the other one is sized.
  const auto keep = [&](Splitter splitter, double shown_px, double wanted_pt) {
    if (shown_px <= 0.0 || shown_px >= std::round(ui.px(wanted_pt))) return;
    asked.emplace_back(actions::MoveSplitter{splitter, shown_px / scale});
  };
  if (places.left.width > 0.0) {
    const kit::Rect rect{places.left.right() - handle / 2.0, places.left.top, handle,
                         places.left.height};
    const auto edit = ui.splitter("Left splitter", rect, kit::Axis::kHorizontal, places.left.width,
                                  ui.px(kLeastColumn), places.most_left_px);
    if (ask(Splitter::kLeft, edit)) keep(Splitter::kRight, places.right.width, layout.right_pt);
  }
  if (places.right.width > 0.0) {
    const kit::Rect rect{places.right.left - handle / 2.0, places.right.top, handle,
                         places.right.height};
    const auto edit =
        ui.splitter("Right splitter", rect, kit::Axis::kHorizontal, places.right.width,
                    ui.px(kLeastColumn), places.most_right_px, true);
    if (ask(Splitter::kRight, edit)) keep(Splitter::kLeft, places.left.width, layout.left_pt);
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
  join(asked,
       draw_export_box(ui, export_model(session_, export_, export_folder_), export_, palette_));
  join(asked, draw_file_box(ui, file_box_model(session_, file_box_, box_folder_), file_box_));
  join(asked, draw_command_palette(ui, command_palette_model(session_), palette_));
  if (!palette_.chosen.empty()) session_.remember_command(std::exchange(palette_.chosen, {}));
  join(asked, draw_shortcut_sheet(ui, shortcut_sheet_model(session_), shortcuts_, palette_));
  join(asked, draw_preferences(ui, preferences_model(session_), preferences_));
  join(asked, draw_place_overlay(ui, place_model(session_), place_));
  join(asked, draw_bookmark_note(ui, bookmark_note_model(session_), bookmark_note_));
  join(asked, draw_about(ui, about_model(session_)));
}

bool GuiWindow::is_working() const {
  return box_folder_.is_reading() || export_folder_.is_reading() || inquiry_.is_working() ||
         reconstruction_.is_working();
}

}  // namespace nadir
