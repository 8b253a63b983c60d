// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/session/action.h"
#include "core/session/figure_request.h"

namespace nadir {

class Session;
struct OpenRun;

/// Something that can be made of what is open.
struct ExportKind {
  enum class Form { kFigure, kFilm, kTable, kReport };
  std::string_view
      name;  ///< As in `nadir figure NAME`; of the last three "film", "table", "report".
  std::string_view title;  ///< "This moment".
  std::string_view line;   ///< What it shows, in one line.
  RunsOfFigure runs = RunsOfFigure::kOne;
  bool needs_map = false, needs_truth = false;
  Form form = Form::kFigure;
};

/// What people ask for first comes first.
[[nodiscard]] std::span<const ExportKind> export_kinds();
/// Null: there is none of that name.
[[nodiscard]] const ExportKind* export_kind(std::string_view name);

/// The endings that its file can have, the proposed one first; of a report, which is a folder, none.
[[nodiscard]] std::span<const std::string_view> export_endings(ExportKind::Form form);

/// Why it cannot be made now, in a few words; empty: it can.
[[nodiscard]] std::string why_no_export(const ExportKind& kind, const Session& session);

/// "loop-moment-12.5s": run (or map), figure and, where it shows one, the moment. Without ending.
[[nodiscard]] std::string export_name(const ExportKind& kind, const Session& session);

/// What the window's map shows and the figure does not, in words: "the error surface", "2 other runs". None for what shows no
/// map, or not that one. @param active  The active run; null: none.
[[nodiscard]] std::vector<std::string> left_out_of_figure(const ExportKind& kind,
                                                          const ViewState& view,
                                                          const OpenRun* active);
/// "the error surface and 2 other runs"; empty: everything is shown.
[[nodiscard]] std::string left_out_words(const ExportKind& kind,
                                         const ViewState& view,
                                         const OpenRun* active);
/// "Not in it: the error surface and 2 other runs." Empty: everything is.
[[nodiscard]] std::string left_out_sentence(const ExportKind& kind, const Session& session);

/// What making it will do, in one sentence. @param file  As it is to be shown. @param width_px  Nothing: the figure's own.
[[nodiscard]] std::string export_sentence(const ExportKind& kind,
                                          const Session& session,
                                          const std::string& file,
                                          const std::optional<int>& width_px);

/// The action that makes it.
[[nodiscard]] Action export_action(const ExportKind& kind,
                                   const std::string& file,
                                   const std::optional<int>& width_px);

}  // namespace nadir
