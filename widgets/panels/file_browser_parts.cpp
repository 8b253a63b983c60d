// SPDX-License-Identifier: Apache-2.0
// How a folder is drawn, and what keys do in it.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "core/session/typed_path.h"
#include "widgets/panels/file_browser.h"
#include "widgets/panels/panel_text.h"

namespace nadir {
namespace {

constexpr double kKindWidth = 96.0, kWhenWidth = 140.0, kSizeWidth = 76.0;
constexpr std::ptrdiff_t kRowsOfAPage = 10;

[[nodiscard]] kit::Icon icon_of(FileKind kind) {
  switch (kind) {
    case FileKind::kFolder:
      return kit::Icon::kFolder;
    case FileKind::kRun:
      return kit::Icon::kChart;
    case FileKind::kMap:
      return kit::Icon::kMap;
    case FileKind::kFlight:
      return kit::Icon::kPlane;
    case FileKind::kFigureRecipe:
    case FileKind::kRunRecipe:
      return kit::Icon::kList;
    case FileKind::kFigure:
      return kit::Icon::kBars;
    case FileKind::kLabels:
      return kit::Icon::kPaintBrush;
    case FileKind::kOther:
      break;
  }
  return kit::Icon::kFile;
}

void draw_place_rows(kit::Ui& ui,
                     const std::vector<FilePlace>& places,
                     const std::string& home,
                     FileBrowserState& state,
                     std::string& opened) {
  for (const FilePlace& place : places) {
    const std::string path = place.name.empty() ? place.folder : place.folder + "/" + place.name;
    const bool is_here =
        place.name.empty() ? state.folder == place.folder && state.typed.empty() : false;
    const kit::ListRow look{
        .detail = shortened(place.detail, 20),
        .icon = place.icon,
        .is_selected = is_here,
        .hint = {.text = place.name.empty() ? path : folder_of(path, home) + "/" + place.name}};
    const kit::RowInput input = ui.list_row(label_of(shortened(place.title, 28), path), look);
    if (input.was_double_clicked && !place.name.empty()) opened = path;
    if (!input.was_clicked) continue;
    go_into(state, place.folder);
    state.chosen = place.name;
    state.has_moved = !place.name.empty();
  }
}

/// Moves the highlight by the arrows; it begins at the first.
void move_choice(const kit::Ui& ui,
                 const std::vector<const FolderEntry*>& rows,
                 FileBrowserState& state) {
  std::ptrdiff_t by = 0;
  if (ui.is_pressed("Down", true)) by = 1;
  if (ui.is_pressed("Up", true)) by = -1;
  if (ui.is_pressed("Page Down", true)) by = kRowsOfAPage;
  if (ui.is_pressed("Page Up", true)) by = -kRowsOfAPage;
  if (by == 0 || rows.empty()) return;
  const auto at = std::find_if(rows.begin(), rows.end(),
                               [&](const auto* row) { return row->name == state.chosen; });
  const auto last = static_cast<std::ptrdiff_t>(rows.size()) - 1;
  const std::ptrdiff_t now = at == rows.end() ? (by > 0 ? -1 : last + 1) : at - rows.begin();
  state.chosen =
      rows[static_cast<std::size_t>(std::clamp(now + by, std::ptrdiff_t{0}, last))]->name;
  state.has_moved = true;
}

/// As far as all names that show agree; a folder's name then with its '/'.
void complete(const std::vector<const FolderEntry*>& rows,
              const FileBrowserModel& model,
              FileBrowserState& state) {
  const TypedPath typed = read_typed_path(state.typed, state.folder, model.home);
  std::vector<std::string> names;
  names.reserve(rows.size());
  for (const FolderEntry* const row : rows) names.push_back(row->name);
  std::string completed = completed_name(typed.last, names);
  const FolderEntry* const entry = model.listing ? model.listing->find(completed) : nullptr;
  const auto alike = std::count_if(names.begin(), names.end(), [&](const std::string& name) {
    return name.starts_with(completed);
  });
  if (entry != nullptr && entry->is_folder && alike == 1) completed += '/';
  state.typed.replace(state.typed.size() - typed.last.size(), typed.last.size(), completed);
  state.goes_on_typing = true;
}

void draw_rows(kit::Ui& ui,
               const std::vector<const FolderEntry*>& rows,
               FileBrowserState& state,
               const FolderEntry*& opened) {
  ui.clipped_table_rows(rows.size(), [&](std::size_t i) {
    const FolderEntry& entry = *rows[i];
    const kit::RowInput input = ui.row(entry.name, entry.name == state.chosen);
    if (input.was_clicked) {
      state.chosen = entry.name;
      state.was_clicked = true;
    }
    if (input.was_double_clicked) opened = &entry;
    const bool is_pale = entry.kind == FileKind::kOther;
    const auto look = is_pale ? kit::TextLook::kMuted : kit::TextLook::kNormal;
    ui.icon_cell(icon_of(entry.kind), entry.name, look);
    ui.cell(is_pale ? "" : std::string(enum_name(entry.kind)), kit::TextLook::kMuted);
    ui.cell(when_text(entry.changed_s), kit::TextLook::kMutedNumber);
    ui.cell(entry.is_folder ? "" : file_size_text(entry.bytes), kit::TextLook::kMutedNumber);
  });
}

/// What stands in place of the names.
[[nodiscard]] std::string words_without_names(const FileBrowserModel& model,
                                              const FileBrowserState& state) {
  if (!model.listing) return "The folder is being read.";
  const TypedPath typed = read_typed_path(state.typed, state.folder, model.home);
  if (!typed.last.empty() && !model.listing->entries.empty()) {
    return fmt::format("Nothing here that can be opened has “{}” in its name.",
                       shortened(typed.last, 40));
  }
  return model.listing->entries.empty() ? "The folder is empty."
                                        : "Nothing here can be opened; “All files” shows the rest.";
}

}  // namespace

std::string draw_places(kit::Ui& ui, const FileBrowserModel& model, FileBrowserState& state) {
  const auto scope = ui.scope("Places");
  const auto scroll = ui.scroll_area("Places");
  std::string opened;
  ui.text("Places", kit::TextLook::kMuted);
  draw_place_rows(ui, model.places, model.home, state, opened);
  if (model.recents.empty()) return opened;
  ui.space();
  ui.text("Recent", kit::TextLook::kMuted);
  const auto recent = ui.scope("Recent");
  draw_place_rows(ui, model.recents, model.home, state, opened);
  return opened;
}

void draw_way(kit::Ui& ui, const FileBrowserModel& model, FileBrowserState& state) {
  const auto scope = ui.scope("Way");
  const std::filesystem::path folder =
      read_typed_path(state.typed, state.folder, model.home).folder;
  const bool is_top = folder == folder.root_path();
  {
    const auto pale = ui.disabled(is_top, "this is the top");
    if (ui.icon_button("Folder up", kit::Icon::kArrowUp,
                       {.text = "The folder that this one is in", .shortcut = "Alt+Up"})) {
      go_into(state, folder.parent_path().string());
      state.chosen = folder.filename().string();
    }
  }
  // As many folders from the end as there is room for.
  std::vector<std::filesystem::path> steps;
  double used = 0.0;
  const double room = ui.room().width - ui.px(60.0), gap = ui.px(22.0);
  bool is_cut = false;
  for (std::filesystem::path at = folder;; at = at.parent_path()) {
    const bool is_root = at == at.root_path();
    const double width = ui.text_width(is_root ? "/" : at.filename().string()) + gap;
    if (!steps.empty() && used + width > room) {
      is_cut = true;
      break;
    }
    used += width;
    steps.push_back(at);
    if (is_root || at.string() == model.home) break;
  }
  std::reverse(steps.begin(), steps.end());
  if (is_cut) {
    ui.same_line();
    ui.text("…", kit::TextLook::kMuted);
  }
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::string path = steps[i].string();
    const std::string name = path == model.home        ? "~"
                             : steps[i].has_filename() ? steps[i].filename().string()
                                                       : "/";
    ui.same_line();
    if (i > 0) {
      ui.text("›", kit::TextLook::kMuted);
      ui.same_line();
    }
    if (ui.link(label_of(shortened(name, 40), path), {.text = path})) go_into(state, path);
  }
}

kit::TextEdit draw_name_field(kit::Ui& ui,
                              const std::string& label,
                              const std::string& placeholder,
                              const FileBrowserModel& model,
                              const FileFilter& filter,
                              FileBrowserState& state) {
  // Not between the two clicks of a double click: whoever types has the mouse taken away.
  const bool is_let_go = state.was_clicked && !ui.is_holding();
  if (is_let_go) state.was_clicked = false;
  const bool goes_on = std::exchange(state.goes_on_typing, false) || is_let_go;
  kit::TextEdit edit =
      ui.text_input(label, state.typed,
                    {.placeholder = placeholder,
                     .takes_focus = true,
                     .takes_focus_now = goes_on,
                     .takes_tab = true,
                     .hint = {.text = "Words of a name, or a path; Tab completes it, the arrows go "
                                      "through the list, Backspace goes up, Shift+Tab leaves"}});
  if (edit.value != state.typed && !edit.was_cancelled) {
    state.typed = edit.value;
    if (!filter.is_for_saving) state.chosen.clear();
  }
  const std::vector<const FolderEntry*> rows = shown_entries(model, state, filter);
  move_choice(ui, rows, state);
  if (edit.wants_completion) complete(rows, model, state);
  const std::filesystem::path folder = state.folder;
  if ((edit.went_back || ui.is_pressed("Alt+Up", false)) && folder != folder.root_path()) {
    go_into(state, folder.parent_path().string());
    state.chosen = folder.filename().string();
  }
  return edit;
}

const FolderEntry* draw_names(kit::Ui& ui,
                              const FileBrowserModel& model,
                              const FileFilter& filter,
                              FileBrowserState& state,
                              double height) {
  const std::vector<const FolderEntry*> rows = shown_entries(model, state, filter);
  if (!model.fault.empty() || rows.empty()) {
    const auto scroll = ui.scroll_area("Names", height);
    ui.space();
    if (!model.fault.empty()) {
      ui.icon(kit::Icon::kWarning, kit::TextLook::kWarning);
      ui.same_line();
      ui.wrapped(model.fault, kit::TextLook::kWarning);
    } else if (!filter.is_for_saving || !model.listing) {
      ui.wrapped(words_without_names(model, state), kit::TextLook::kMuted);
    } else {
      ui.text("No such files here yet.", kit::TextLook::kMuted);
    }
    return nullptr;
  }
  const bool is_narrow = ui.room().width < ui.px(520.0);
  const std::array<kit::Column, 4> columns = {
      {{.title = "Name"},
       {.title = "Kind", .width = is_narrow ? ui.px(64.0) : ui.px(kKindWidth)},
       {.title = "Changed", .width = ui.px(kWhenWidth)},
       {.title = "Size", .align = kit::Align::kRight, .width = ui.px(kSizeWidth)}}};
  const FolderEntry* opened = nullptr;
  if (const auto table = ui.table("Names", columns, {.height = height, .is_sortable = true})) {
    if (const auto sorting = ui.sorting(); sorting && sorting->column < 3) {
      const auto order = static_cast<FileOrder>(sorting->column);
      state.is_reversed = order == state.order && !state.is_reversed;
      state.order = order;
    }
    draw_rows(ui, rows, state, opened);
    const auto at = std::find_if(rows.begin(), rows.end(),
                                 [&](const auto* row) { return row->name == state.chosen; });
    if (std::exchange(state.has_moved, false) && at != rows.end()) {
      ui.keep_row_in_sight(static_cast<std::size_t>(at - rows.begin()));
    }
  }
  return opened;
}

}  // namespace nadir
