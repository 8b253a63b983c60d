// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/session/action.h"
#include "core/session/session.h"
#include "widgets/kit/ui.h"
#include "widgets/panels/setting_rows.h"

namespace nadir {

struct SettingsModel {
  std::vector<SettingRow> rows;
  std::vector<std::string> presets;  ///< To choose from; the chosen one among them.
  std::string preset;
  std::size_t changed_count = 0;  ///< changed_options() of the session.
  std::string fault;              ///< Why these options make no run; empty: they do.
  std::string why_not_from_start, why_not_from_cursor;  ///< Empty: it can be done now.
  std::vector<JobStatus> running;                       ///< Localisations in the background.
};
[[nodiscard]] SettingsModel settings_model(const Session& session);

/// How many options of the next run are not as its preset, or the run that it goes by, has them. One truth for all who say it: what
/// was changed once may be what the active run has by now.
[[nodiscard]] std::size_t changed_options(const Session& session);

struct SettingsState {
  std::string search;
  bool shows_only_changed = false;
  std::map<std::string, std::string>
      refused;                   ///< By option: typed and not taken, until it is corrected.
  std::vector<double> headings;  ///< Of groups, from the top of the list, in the last frame.
  bool is_scrolled = false;      ///< The list, in the last frame.
  double content_height = 0.0;   ///< Of the list, likewise.
};

/// All options of the next run, and the buttons that start it. One step of undo a drag.
[[nodiscard]] Actions draw_settings_panel(kit::Ui& ui,
                                          const SettingsModel& model,
                                          SettingsState& state);

}  // namespace nadir
