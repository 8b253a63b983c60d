// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "widgets/panels/settings_panel.h"
#include "widgets/panels/shortcut_hint.h"

namespace nadir {
namespace {

/// The draft without its changes, as far as that can be told without reading a file: what is not changed is the preset's.
RunOptions preset_of(const Session& session, const RunOptions& draft) {
  const RunDraft& wanted = session.view().draft;
  if (const auto preset = run_preset(wanted.preset)) return *preset;
  RunOptions options = draft;
  const OpenRun* const run = session.active_run();
  for (const auto& [name, text] : wanted.changed) {
    if (run == nullptr || !run->document) continue;
    const auto recorded = run->document->header.options.find(name);
    if (recorded == run->document->header.options.end()) continue;
    const auto set = set_option(options, name, recorded->second);
    (void)set;  // of a run of another version
  }
  return options;
}

}  // namespace

SettingsModel settings_model(const Session& session) {
  SettingsModel model;
  const RunDraft& wanted = session.view().draft;
  const auto draft = session.draft_options();
  if (draft) {
    model.rows = setting_rows(*draft, preset_of(session, *draft));
    if (const auto valid = validate_run(*draft); !valid) model.fault = valid.error().message;
  } else {
    model.fault = draft.error().message;
    model.rows = setting_rows({}, {});
  }
  model.preset = wanted.preset;
  model.presets = localiser_preset_names();
  if (session.active_run() != nullptr) model.presets.emplace_back("run");
  if (std::find(model.presets.begin(), model.presets.end(), wanted.preset) == model.presets.end()) {
    model.presets.push_back(wanted.preset);
  }
  model.changed_count = wanted.changed.size();
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
