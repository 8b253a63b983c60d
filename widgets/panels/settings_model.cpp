// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "widgets/panels/settings_panel.h"
#include "widgets/panels/shortcut_hint.h"

namespace nadir {
std::size_t changed_options(const Session& session) {
  if (session.view().draft.changed.empty()) return 0;
  const auto base = session.draft_base();
  const auto draft = session.draft_options();
  if (!base || !draft) return session.view().draft.changed.size();
  const std::vector<OptionText> before = option_texts(*base), after = option_texts(*draft);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < after.size(); ++i) changed += after[i].value != before[i].value;
  return changed;
}

SettingsModel settings_model(const Session& session) {
  SettingsModel model;
  const RunDraft& wanted = session.view().draft;
  const bool is_of_run = wanted.preset == kOptionsOfRun && session.active_run() != nullptr;
  const auto base = session.draft_base();
  const auto draft = session.draft_options();
  if (draft && base) {
    model.rows = setting_rows(*draft, *base, session.draft_prior());
    if (is_of_run) {
      for (SettingRow& row : model.rows) row.base = "run";
    }
    if (const auto valid = validate_run(*draft); !valid) model.fault = valid.error().message;
  } else {
    const OpenRun* const run = session.active_run();
    const bool is_being_read = is_of_run && !run->document;  // that is said where it is in the way
    if (!is_being_read) model.fault = base ? draft.error().message : base.error().message;
    model.rows = setting_rows({}, {});
  }
  model.preset = wanted.preset != kOptionsOfRun || is_of_run ? wanted.preset : "default";
  model.presets = localiser_preset_names();
  if (session.active_run() != nullptr) model.presets.emplace_back("run");
  if (std::find(model.presets.begin(), model.presets.end(), model.preset) == model.presets.end()) {
    model.presets.push_back(model.preset);
  }
  model.changed_count = changed_options(session);
  model.why_not_from_start = why_not_now(actions::Rerun{RerunFrom::kStart}, session);
  model.why_not_from_cursor = why_not_now(actions::Rerun{RerunFrom::kCursor}, session);
  for (std::string* const why : {&model.why_not_from_start, &model.why_not_from_cursor}) {
    if (why->empty()) *why = model.fault;
  }
  for (JobStatus& job : session.jobs()) {
    if (job.title.starts_with("localising") || job.title.starts_with("stopping"))
      model.running.push_back(std::move(job));
  }
  return model;
}

}  // namespace nadir
