// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/session/export_kinds.h"
#include "widgets/panels/command_palette.h"
#include "widgets/panels/file_browser.h"

namespace nadir {

/// Kept by the caller.
struct ExportState {
  FileBrowserState files = {};
  std::string chosen = "moment";  ///< Of export_kinds().
  std::string ending = ".png";    ///< Of a figure.
  std::string width = {};         ///< Typed; empty: the figure's own.
  std::string proposed = {};      ///< Name that was proposed last: a name that differs was typed.
  std::string asked_about = {};   ///< A file that is there already: Enter once more replaces it.
  bool is_open = false;           ///< As in the last frame.
};

/// Asks what is to be made of what is open, and where.
struct ExportModel {
  bool is_open = false;
  struct Row {
    const ExportKind* kind = nullptr;
    std::string why_not;  ///< Empty: it can be made.
  };
  std::vector<Row> rows;
  FileBrowserModel files;
  std::string first_folder;
  std::string proposed;   ///< Name for the chosen one, without ending.
  std::string file;       ///< Where it would be written; empty: no name is typed.
  std::string sentence;   ///< What making it will do.
  std::string left_out;   ///< What the map shows and it will not; empty: nothing.
  std::string why_not;    ///< Why it cannot be made there; empty: it can.
  bool replaces = false;  ///< There is such a file now.
  std::optional<int> width_px;
  std::string width_fault;  ///< Why the width typed cannot be; empty: it can.
};
/// @param reader  Only of this box.
[[nodiscard]] ExportModel export_model(const Session& session,
                                       const ExportState& state,
                                       FolderReader& reader);

/// Lies over the window where the model says so; call it in every frame, before the palette.
/// @param palette  "export-table" that was begun there chooses the table.
[[nodiscard]] Actions draw_export_box(kit::Ui& ui,
                                      const ExportModel& model,
                                      ExportState& state,
                                      PaletteState& palette);

}  // namespace nadir
