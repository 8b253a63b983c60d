// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/export_box.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "core/session/typed_path.h"
#include "widgets/panels/panel_text.h"

namespace nadir {
namespace {

constexpr double kExportWidth = 1120.0, kExportHeight = 640.0, kExportFoot = 116.0,
                 kExportButton = 104.0;

/// ".png" as "PNG".
[[nodiscard]] std::string format_name(std::string_view ending) {
  std::string name(ending.substr(1));
  for (char& letter : name)
    letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  return name;
}

/// The name that goes with what is chosen now, unless another one was typed.
void propose_name(const ExportModel& model, ExportState& state) {
  const ExportKind* const kind = export_kind(state.chosen);
  if (kind == nullptr || model.proposed.empty()) return;
  const auto endings = export_endings(kind->form);
  const bool has_ending = std::find(endings.begin(), endings.end(), state.ending) != endings.end();
  const std::string ending =
      endings.empty() ? "" : std::string(has_ending ? state.ending : endings.front());
  std::string wanted = model.proposed + ending;
  if (wanted == state.proposed) return;
  if (state.files.typed == state.proposed) {
    state.files.typed = wanted;
    state.files.goes_on_typing = true;
  }
  state.proposed = std::move(wanted);
}

void choose_kind(const std::string& name, ExportState& state) {
  state.chosen = name;
  state.asked_about.clear();
}

void draw_kinds(kit::Ui& ui, const ExportModel& model, ExportState& state) {
  const std::array<kit::Column, 2> columns = {
      {{.title = "What", .width = ui.px(150.0)}, {.title = "It shows"}}};
  const auto table = ui.table("Kinds", columns, {.height = ui.room().height, .has_header = false});
  if (!table) return;
  for (const ExportModel::Row& row : model.rows) {
    const bool is_chosen = row.kind->name == state.chosen;
    const bool can_be = row.why_not.empty();
    if (ui.row(std::string(row.kind->name), is_chosen).was_clicked) {
      choose_kind(std::string(row.kind->name), state);
    }
    ui.cell(std::string(row.kind->title), can_be ? kit::TextLook::kNormal : kit::TextLook::kMuted);
    ui.cell(can_be ? std::string(row.kind->line) : row.why_not, kit::TextLook::kMuted);
  }
}

void draw_format(kit::Ui& ui,
                 const ExportModel& model,
                 const ExportKind& kind,
                 ExportState& state) {
  const auto endings = export_endings(kind.form);
  if (endings.size() > 1) {
    std::vector<std::string> names;
    for (const std::string_view ending : endings) names.push_back(format_name(ending));
    const auto now = std::find(endings.begin(), endings.end(), state.ending) - endings.begin();
    const auto chosen =
        ui.choice("Format", names, static_cast<std::size_t>(now) % endings.size(),
                  {.text = "PNG for screens, SVG and PDF for print; PNG and SVG open here again"});
    if (chosen) {
      const std::string ending(endings[*chosen]);
      std::string& typed = state.files.typed;
      if (typed.ends_with(state.ending)) {
        typed.replace(typed.size() - state.ending.size(), state.ending.size(), ending);
        state.files.goes_on_typing = true;
      }
      if (state.proposed.ends_with(state.ending)) {
        state.proposed.replace(state.proposed.size() - state.ending.size(), state.ending.size(),
                               ending);
      }
      state.ending = ending;
    }
  }
  if (kind.form != ExportKind::Form::kFigure && kind.form != ExportKind::Form::kFilm) return;
  state.width =
      ui.text_input("Width", state.width,
                    {.placeholder = "the figure's own, in pixels",
                     .hint = {.text = "Pixels; the height follows from the figure", .unit = "px"}})
          .value;
  if (!model.width_fault.empty()) ui.wrapped(model.width_fault, kit::TextLook::kBad);
}

/// Folder and name. @returns whether Enter was pressed in the name; `is_left`: Escape.
[[nodiscard]] bool draw_where(kit::Ui& ui,
                              const ExportModel& model,
                              const ExportKind& kind,
                              ExportState& state,
                              bool& is_left) {
  const FileFilter filter{true, export_endings(kind.form)};
  draw_way(ui, model.files, state.files);
  const std::string before = state.files.typed;
  const kit::TextEdit edit = draw_name_field(
      ui, "##Name",
      kind.form == ExportKind::Form::kReport ? "Name of the folder" : "Name of the file",
      model.files, filter, state.files);
  if (state.files.typed != before) state.asked_about.clear();
  ui.space(ui.px(4.0));
  const FolderEntry* const taken =
      draw_names(ui, model.files, filter, state.files, ui.room().height);
  if (taken != nullptr) {
    const std::string name =
        read_typed_path(state.files.typed, state.files.folder, model.files.home).last;
    if (taken->is_folder) {
      go_into(state.files, (model.files.listing->folder / taken->name).string());
      state.files.typed = name;
    } else {
      state.files.typed = taken->name;
    }
    state.files.goes_on_typing = true;
  }
  is_left = edit.was_cancelled;
  return edit.was_entered;
}

[[nodiscard]] Actions draw_export_foot(kit::Ui& ui,
                                       const ExportModel& model,
                                       const ExportKind& kind,
                                       ExportState& state,
                                       bool was_entered) {
  const bool is_again = state.asked_about == model.file && !model.file.empty();
  if (!model.why_not.empty()) {
    ui.cut_text(model.why_not, kit::TextLook::kWarning);
  } else {
    ui.cut_text(model.sentence);
  }
  ui.space(ui.px(4.0));
  ui.cut_text(model.left_out, kit::TextLook::kWarning);
  ui.space(ui.px(4.0));
  if (model.replaces) {
    ui.cut_text(is_again ? "Enter once more replaces what is there"
                : kind.form == ExportKind::Form::kReport
                    ? "There is such a folder; only a report that Nadir wrote is replaced"
                    : "There is such a file already; it would be replaced",
                kit::TextLook::kWarning, ui.px(2.0 * kExportButton + 24.0));
  } else {
    ui.text("It is made in the background; the status line shows how far it is.",
            kit::TextLook::kMuted);
  }
  ui.same_line();
  ui.right_align(ui.px(2.0 * kExportButton + 8.0));
  ui.next_width(ui.px(kExportButton));
  const bool is_left = ui.button("Cancel", kit::ButtonLook::kNormal, {.shortcut = "Escape"});
  ui.same_line();
  bool is_clicked = false;
  {
    const auto pale = ui.disabled(!model.why_not.empty(), model.why_not);
    ui.next_width(ui.px(kExportButton));
    is_clicked = ui.button(model.replaces ? "Replace##take" : "Export##take",
                           kit::ButtonLook::kPrimary, {.text = "Make it", .shortcut = "Enter"});
  }
  if (is_left) return {actions::ShowOverlay{Overlay::kNone}};
  if (was_entered) {
    state.files.goes_on_typing = true;
    if (model.replaces && !is_again) {
      state.asked_about = model.file;
      return {};
    }
  }
  if ((!is_clicked && !was_entered) || !model.why_not.empty()) return {};
  return {actions::ShowOverlay{Overlay::kNone}, export_action(kind, model.file, model.width_px)};
}

/// What the palette or a menu began: "export-table" is the table.
void begin_export(const ExportModel& model, ExportState& state, PaletteState& palette) {
  state.is_open = true;
  state.asked_about.clear();
  if (palette.begun == "export-table") state.chosen = "table";
  if (palette.begun == "report") state.chosen = "report";
  if (palette.begun == "export" && (state.chosen == "table" || state.chosen == "report")) {
    state.chosen = "moment";
  }
  palette.begun.clear();
  if (state.files.folder.empty()) state.files.folder = model.first_folder;
  state.files.typed.clear();  // a name of its own is proposed
  state.proposed.clear();
}

}  // namespace

Actions draw_export_box(kit::Ui& ui,
                        const ExportModel& model,
                        ExportState& state,
                        PaletteState& palette) {
  if (!model.is_open) {
    state.is_open = false;
    return {};
  }
  if (!state.is_open) {
    begin_export(model, state, palette);
  } else {
    propose_name(model, state);
  }
  const auto overlay =
      ui.overlay("Export", {.width = ui.px(kExportWidth), .height = ui.px(kExportHeight)});
  if (!overlay) return {};
  const ExportKind* const kind = export_kind(state.chosen);
  if (kind == nullptr) return {actions::ShowOverlay{Overlay::kNone}};
  ui.heading("Export");
  ui.space(ui.px(4.0));
  bool was_entered = false, is_left = false;
  {
    const auto body = ui.scroll_area("Body", -ui.px(kExportFoot - 28.0));
    const auto columns = ui.columns("Sides", {0.52, 0.48});
    draw_kinds(ui, model, state);
    ui.next_column();
    draw_format(ui, model, *kind, state);
    ui.space(ui.px(4.0));
    was_entered = draw_where(ui, model, *kind, state, is_left);
  }
  ui.space(ui.px(4.0));
  Actions asked = draw_export_foot(ui, model, *kind, state, was_entered);
  if (asked.empty() && (is_left || overlay.wants_close())) {
    return {actions::ShowOverlay{Overlay::kNone}};
  }
  return asked;
}

}  // namespace nadir
