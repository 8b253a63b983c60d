// SPDX-License-Identifier: Apache-2.0
// The names in a folder, as a table.
#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "core/session/typed_path.h"
#include "widgets/panels/file_browser.h"
#include "widgets/panels/panel_text.h"

namespace nadir {
namespace {

constexpr double kKindWidth = 96.0, kWhenWidth = 140.0, kSizeWidth = 76.0, kLeastName = 128.0;

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

/// What is said of a file beside its name, as far as that leaves the name its room.
struct NameColumns {
  std::vector<kit::Column> columns;
  std::vector<FileOrder> orders;  ///< By which clicks on the first columns' heads sort.
  bool has_when = false, has_kind = false, has_size = false;
};
NameColumns columns_for(const kit::Ui& ui) {
  const double room = ui.room().width;
  const double kind = room < ui.px(520.0) ? ui.px(64.0) : ui.px(kKindWidth);
  NameColumns shown;
  double left = room - ui.px(kLeastName);
  const auto has_room = [&left](double width) { return (left -= width) >= 0.0; };
  shown.has_when = has_room(ui.px(kWhenWidth));
  shown.has_kind = shown.has_when && has_room(kind);  // its icon says it too
  shown.has_size = shown.has_kind && has_room(ui.px(kSizeWidth));
  shown.columns = {{.title = "Name"}};
  shown.orders = {FileOrder::kName};
  if (shown.has_kind) {
    shown.columns.push_back({.title = "Kind", .width = kind});
    shown.orders.push_back(FileOrder::kKind);
  }
  if (shown.has_when) {
    shown.columns.push_back({.title = "Changed", .width = ui.px(kWhenWidth)});
    shown.orders.push_back(FileOrder::kChanged);
  }
  if (shown.has_size) {
    shown.columns.push_back(
        {.title = "Size", .align = kit::Align::kRight, .width = ui.px(kSizeWidth)});
  }
  return shown;
}

void draw_rows(kit::Ui& ui,
               const std::vector<const FolderEntry*>& rows,
               const NameColumns& shown,
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
    if (shown.has_kind) {
      ui.cell(is_pale ? "" : std::string(enum_name(entry.kind)), kit::TextLook::kMuted);
    }
    if (shown.has_when) ui.cell(when_text(entry.changed_s), kit::TextLook::kMutedNumber);
    if (!shown.has_size) return;
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
  const NameColumns shown = columns_for(ui);
  const FolderEntry* opened = nullptr;
  if (const auto table =
          ui.table("Names", shown.columns, {.height = height, .is_sortable = true})) {
    if (const auto sorting = ui.sorting(); sorting && sorting->column < shown.orders.size()) {
      const FileOrder order = shown.orders[sorting->column];
      state.is_reversed = order == state.order && !state.is_reversed;
      state.order = order;
    }
    draw_rows(ui, rows, shown, state, opened);
    const auto at = std::find_if(rows.begin(), rows.end(),
                                 [&](const auto* row) { return row->name == state.chosen; });
    if (std::exchange(state.has_moved, false) && at != rows.end()) {
      ui.keep_row_in_sight(static_cast<std::size_t>(at - rows.begin()));
    }
  }
  return opened;
}

}  // namespace nadir
