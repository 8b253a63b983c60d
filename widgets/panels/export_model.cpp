// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "core/session/typed_path.h"
#include "widgets/panels/export_box.h"
#include "widgets/panels/file_box.h"
#include "widgets/panels/panel_text.h"

namespace nadir {
namespace {

/// The endings that the box offers for what is chosen, the chosen one first.
[[nodiscard]] std::vector<std::string_view> endings_of(const ExportKind& kind,
                                                       const ExportState& state) {
  const auto all = export_endings(kind.form);
  std::vector<std::string_view> endings(all.begin(), all.end());
  const auto chosen = std::find(endings.begin(), endings.end(), state.ending);
  if (chosen != endings.end()) std::rotate(endings.begin(), chosen, chosen + 1);
  return endings;
}

void read_width(const std::string& typed, ExportModel& model) {
  const std::size_t first = typed.find_first_not_of(' ');
  if (first == std::string::npos) return;
  const std::string digits = typed.substr(first, typed.find_last_not_of(' ') - first + 1);
  int width = 0;
  const char* const end = digits.data() + digits.size();
  const auto [at, error] = std::from_chars(digits.data(), end, width);
  const bool is_whole = error == std::errc() && at == end;
  if (is_whole && width >= kLeastFigureWidthPx && width <= kMostFigureWidthPx) {
    model.width_px = width;
  } else {
    model.width_fault = fmt::format("{} is no width in [{}, {}] pixels", digits,
                                    int{kLeastFigureWidthPx}, int{kMostFigureWidthPx});
  }
}

}  // namespace

ExportModel export_model(const Session& session, const ExportState& state, FolderReader& reader) {
  ExportModel model;
  model.is_open = session.overlay() == Overlay::kExport;
  if (!model.is_open) {
    reader.look({});
    return model;
  }
  for (const ExportKind& kind : export_kinds()) {
    model.rows.push_back({&kind, why_no_export(kind, session)});
  }
  model.files = file_browser_model(session.recents(), state.files, reader);
  model.first_folder = first_folder(session.recents(), model.files.home, working_folder());
  if (const OpenRun* const run = session.active_run()) {
    model.first_folder = run->path.parent_path().string();
  }
  const ExportKind* const kind = export_kind(state.chosen);
  if (kind == nullptr) return model;
  model.proposed = export_name(*kind, session);
  const bool has_width =
      kind->form == ExportKind::Form::kFigure || kind->form == ExportKind::Form::kFilm;
  if (has_width) read_width(state.width, model);
  const auto endings = endings_of(*kind, state);
  const SavePlace place = save_place(model.files, state.files, endings);
  model.file = place.file;
  model.replaces = place.replaces;
  model.why_not = why_no_export(*kind, session);
  if (model.why_not.empty()) model.why_not = model.width_fault;
  if (model.why_not.empty()) model.why_not = place.why_not;
  const std::string shown = folder_of(place.file, model.files.home) + "/" +
                            std::filesystem::path(place.file).filename().string();
  model.sentence = export_sentence(*kind, session, shown, model.width_px);
  model.left_out = left_out_sentence(*kind, session);
  return model;
}

}  // namespace nadir
