// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/file_box.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "core/session/typed_path.h"
#include "widgets/panels/panel_text.h"

namespace nadir {
namespace fs = std::filesystem;

namespace {

using Use = FileBoxModel::Use;

constexpr std::array<std::string_view, 1> kRecipeEndings = {".toml"};
constexpr double kBoxWidth = 960.0, kBoxHeight = 600.0, kFootHeight = 76.0, kButtonWidth = 104.0;

[[nodiscard]] Actions closed_with(Action action) {
  return {actions::ShowOverlay{Overlay::kNone}, std::move(action)};
}

[[nodiscard]] std::string path_in(const FileBrowserModel& model, const FolderEntry& entry) {
  return (model.listing->folder / entry.name).string();
}

/// A folder is gone into, anything else opened.
[[nodiscard]] Actions take_entry(const FileBrowserModel& model,
                                 const FolderEntry& entry,
                                 FileBrowserState& state) {
  const std::string path = path_in(model, entry);
  if (entry.kind != FileKind::kFolder) return closed_with(actions::OpenFile{path});
  go_into(state, path);
  return {};
}

/// What Enter or the button takes: the highlighted row, else what is named whole, else the first that fits. Null: nothing.
[[nodiscard]] const FolderEntry* entry_meant(const FileBrowserModel& model,
                                             const FileBrowserState& state) {
  const std::vector<const FolderEntry*> rows = shown_entries(model, state, {});
  const auto chosen = std::find_if(rows.begin(), rows.end(),
                                   [&](const auto* row) { return row->name == state.chosen; });
  if (chosen != rows.end()) return *chosen;
  const TypedPath typed = read_typed_path(state.typed, state.folder, model.home);
  if (typed.last.empty()) return nullptr;
  const FolderEntry* const named = model.listing ? model.listing->find(typed.last) : nullptr;
  if (named != nullptr) return named;
  return rows.empty() ? nullptr : rows.front();
}

[[nodiscard]] Actions draw_open_foot(kit::Ui& ui,
                                     const FileBoxModel& model,
                                     FileBoxState& box,
                                     bool was_entered) {
  FileBrowserState& state = box.files;
  const FolderEntry* const meant = entry_meant(model.files, state);
  const TypedPath typed = read_typed_path(state.typed, state.folder, model.files.home);
  const auto all = ui.checkbox("All files", state.shows_all,
                               {.text = "Also what Nadir cannot open, and hidden names"});
  if (all) state.shows_all = *all;
  ui.same_line(ui.px(16.0));
  const bool is_folder = meant != nullptr && meant->kind == FileKind::kFolder;
  if (meant != nullptr) {
    ui.cut_text(fmt::format("{}: {}", enum_name(meant->kind), meant->name), kit::TextLook::kMuted,
                ui.px(2.0 * kButtonWidth + 24.0));
  } else {
    ui.cut_text(model.files.listing && model.files.listing->is_cut_short
                    ? fmt::format("Only the first {} names are shown", FolderListing::kMostEntries)
                    : "Maps and flights are folders; they open as a whole",
                kit::TextLook::kMuted, ui.px(2.0 * kButtonWidth + 24.0));
  }
  ui.same_line();
  ui.right_align(ui.px(2.0 * kButtonWidth + 8.0));
  ui.next_width(ui.px(kButtonWidth));
  const bool is_left = ui.button("Cancel", kit::ButtonLook::kNormal, {.shortcut = "Escape"});
  ui.same_line();
  bool is_clicked = false;
  {
    const auto pale = ui.disabled(meant == nullptr, "choose something first");
    ui.next_width(ui.px(kButtonWidth));
    is_clicked = ui.button(
        is_folder ? "Go into##take" : "Open##take", kit::ButtonLook::kPrimary,
        {.text = is_folder ? "Show this folder" : "Open it in this window", .shortcut = "Enter"});
  }
  if (is_left) return {actions::ShowOverlay{Overlay::kNone}};
  if (!is_clicked && !was_entered) return {};
  state.goes_on_typing = true;
  if (meant != nullptr) return take_entry(model.files, *meant, state);
  if (typed.is_path && typed.last.empty()) go_into(state, typed.folder.string());
  return {};
}

[[nodiscard]] Actions draw_save_foot(kit::Ui& ui,
                                     const FileBoxModel& model,
                                     FileBoxState& box,
                                     bool was_entered) {
  FileBrowserState& state = box.files;
  const SavePlace place = save_place(model.files, state, kRecipeEndings);
  const std::string shown =
      folder_of(place.file, model.files.home) + "/" + fs::path(place.file).filename().string();
  if (place.replaces) {
    ui.cut_text(box.asked_about == place.file ? "Enter once more replaces " + shown
                                              : shown + " is there already and would be replaced",
                kit::TextLook::kWarning, ui.px(2.0 * kButtonWidth + 24.0));
  } else {
    ui.cut_text(
        place.why_not.empty() ? "Writes the options of the next run into " + shown : place.why_not,
        kit::TextLook::kMuted, ui.px(2.0 * kButtonWidth + 24.0));
  }
  ui.same_line();
  ui.right_align(ui.px(2.0 * kButtonWidth + 8.0));
  ui.next_width(ui.px(kButtonWidth));
  const bool is_left = ui.button("Cancel", kit::ButtonLook::kNormal, {.shortcut = "Escape"});
  ui.same_line();
  bool is_clicked = false;
  {
    const auto pale = ui.disabled(!place.why_not.empty(), place.why_not);
    ui.next_width(ui.px(kButtonWidth));
    is_clicked =
        ui.button(place.replaces ? "Replace##take" : "Save##take", kit::ButtonLook::kPrimary,
                  {.text = "Write the file", .shortcut = "Enter"});
  }
  if (is_left) return {actions::ShowOverlay{Overlay::kNone}};
  if (was_entered) {
    state.goes_on_typing = true;
    const TypedPath typed = read_typed_path(state.typed, state.folder, model.files.home);
    const FolderEntry* const named =
        model.files.listing ? model.files.listing->find(typed.last) : nullptr;
    if (typed.is_path && (typed.last.empty() || (named != nullptr && named->is_folder))) {
      const std::string name = model.proposed_name;
      go_into(state, typed.whole().string());
      state.typed = name;
      return {};
    }
    if (place.replaces && box.asked_about != place.file) {
      box.asked_about = place.file;
      return {};
    }
  }
  if ((!is_clicked && !was_entered) || !place.why_not.empty()) return {};
  return closed_with(actions::SavePreset{place.file});
}

void begin_box(const FileBoxModel& model, FileBoxState& box) {
  box.use = model.use;
  box.asked_about.clear();
  FileBrowserState& state = box.files;
  // Where something was opened since, also by other ways, the next thing is looked for there; else where it was left.
  if (state.folder.empty() || box.begun_in != model.first_folder) state.folder = model.first_folder;
  box.begun_in = model.first_folder;
  state.typed = model.use == Use::kSaveRecipe ? model.proposed_name : std::string();
  state.chosen.clear();
  state.goes_on_typing = false;
}

}  // namespace

SavePlace save_place(const FileBrowserModel& model,
                     const FileBrowserState& state,
                     std::span<const std::string_view> endings) {
  const TypedPath typed = read_typed_path(state.typed, state.folder, model.home);
  if (typed.last.find_first_not_of(" .") == std::string::npos) return {"", "type a name first"};
  std::string name = typed.last;
  const bool has_one = std::any_of(endings.begin(), endings.end(),
                                   [&](std::string_view ending) { return name.ends_with(ending); });
  if (!endings.empty() && !has_one) name += endings.front();
  SavePlace place{(typed.folder / name).string()};
  if (!model.fault.empty()) place.why_not = model.fault;
  if (!model.listing) return place;
  const FolderEntry* const there = model.listing->find(name);
  if (there == nullptr) return place;
  place.replaces = true;
  if (there->is_folder && !endings.empty()) place.why_not = name + " is a folder";
  if (!there->is_folder && endings.empty()) place.why_not = name + " is a file";
  if (!place.why_not.empty()) place.replaces = false;
  return place;
}

FileBoxModel file_box_model(const Session& session,
                            const FileBoxState& state,
                            FolderReader& reader) {
  FileBoxModel model;
  if (session.overlay() == Overlay::kOpen) model.use = Use::kOpen;
  if (session.overlay() == Overlay::kSaveRecipe) model.use = Use::kSaveRecipe;
  if (model.use == Use::kClosed) {
    reader.look({});
    return model;
  }
  model.files = file_browser_model(session.recents(), state.files, reader);
  model.first_folder = first_folder(session.recents(), model.files.home, working_folder());
  const std::string preset = as_file_name(name_of(session.view().draft.preset));
  model.proposed_name = preset == "run" || preset.empty() ? "recipe" : preset;
  const OpenRun* const run = session.active_run();
  if (run != nullptr) model.proposed_name = as_file_name(run->name + "-options");
  model.proposed_name += ".toml";
  return model;
}

Actions draw_file_box(kit::Ui& ui, const FileBoxModel& model, FileBoxState& box) {
  if (model.use == Use::kClosed) {
    box.use = Use::kClosed;
    return {};
  }
  if (box.use != model.use) begin_box(model, box);
  const bool is_saving = model.use == Use::kSaveRecipe;
  const auto overlay = ui.overlay(is_saving ? "Save recipe" : "Open",
                                  {.width = ui.px(kBoxWidth), .height = ui.px(kBoxHeight)});
  if (!overlay) return {};
  FileBrowserState& state = box.files;
  const FileFilter filter{is_saving, is_saving ? std::span<const std::string_view>(kRecipeEndings)
                                               : std::span<const std::string_view>()};
  ui.heading(is_saving ? "Save the options of the next run as a recipe"
                       : "Open a run, a map, a flight, a recipe or a figure");
  ui.space(ui.px(4.0));
  std::string opened;
  const FolderEntry* taken = nullptr;
  kit::TextEdit edit;
  {
    const auto body = ui.scroll_area("Body", -ui.px(kFootHeight - 36.0));
    const auto columns = ui.columns("Sides", {0.26, 0.74});
    opened = draw_places(ui, model.files, state);
    ui.next_column();
    draw_way(ui, model.files, state);
    edit = draw_name_field(ui, "##Name",
                           is_saving ? "Name of the file" : "Type to find a name, or a path",
                           model.files, filter, state);
    ui.space(ui.px(4.0));
    taken = draw_names(ui, model.files, filter, state, ui.room().height);
  }
  ui.space(ui.px(4.0));
  if (!opened.empty() && !is_saving) return closed_with(actions::OpenFile{opened});
  if (taken != nullptr) {
    if (!is_saving) return take_entry(model.files, *taken, state);
    if (taken->is_folder) {
      const std::string name = state.typed;
      go_into(state, path_in(model.files, *taken));
      state.typed = read_typed_path(name, state.folder, model.files.home).last;
    } else {
      state.typed = taken->name;
    }
    state.goes_on_typing = true;
  }
  Actions asked = is_saving ? draw_save_foot(ui, model, box, edit.was_entered)
                            : draw_open_foot(ui, model, box, edit.was_entered);
  if (asked.empty() && (edit.was_cancelled || overlay.wants_close())) {
    return {actions::ShowOverlay{Overlay::kNone}};
  }
  return asked;
}

}  // namespace nadir
