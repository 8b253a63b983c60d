// SPDX-License-Identifier: Apache-2.0
// Options of the next run.
#include <system_error>

#include "core/base/staged_output.h"
#include "core/run/resume_point.h"
#include "core/session/session_core.h"

namespace nadir {
namespace fs = std::filesystem;

Error without_dashes(Error error) {
  if (error.message.rfind("--", 0) == 0) error.message.erase(0, 2);
  return error;
}

namespace {

/// Those of the options that are not as the preset has them.
std::map<std::string, std::string> changes_from(const RunOptions& preset,
                                                const RunOptions& options) {
  std::map<std::string, std::string> changed;
  const std::vector<OptionText> before = option_texts(preset), after = option_texts(options);
  for (std::size_t i = 0; i < after.size(); ++i) {
    if (before[i].value != after[i].value) changed[after[i].name] = after[i].value;
  }
  return changed;
}

/// A preset by its name; of one that this version does not know, the default one.
std::pair<std::string, RunOptions> known_preset(const std::string& name) {
  if (const auto options = run_preset(name)) return {name, *options};
  return {"default", RunOptions{}};
}

}  // namespace

Result<RunOptions> Session::Implementation::draft_options() const {
  const RunDraft& draft = kept.view.draft;
  auto options = run_preset(draft.preset);
  if (!options) return options;
  for (const auto& [name, value] : draft.changed) {
    if (const auto set = set_option(*options, name, value); !set) {
      return tl::unexpected(without_dashes(set.error()));
    }
  }
  return options;
}

Result<void> Session::Implementation::perform(const actions::SetOption& action) {
  RunDraft& draft = kept.view.draft;
  const auto preset = run_preset(draft.preset);
  if (!preset) return forward_error(preset);
  if (!action.value) {
    RunOptions unchanged = *preset;  // asks whether there is such an option
    for (const OptionText& option : option_texts(unchanged)) {
      if (option.name != action.name) continue;
      draft.changed.erase(action.name);
      return {};
    }
    return set_option(unchanged, action.name, "");
  }
  auto options = draft_options();
  if (!options) {  // a kept change that no longer fits must not be in the way of the others
    draft.changed.clear();
    options = preset;
  }
  if (const auto set = set_option(*options, action.name, *action.value); !set) {
    return tl::unexpected(without_dashes(set.error()));
  }
  draft.changed = changes_from(*preset, *options);
  return {};
}

Result<void> Session::Implementation::perform(const actions::UsePreset& action) {
  RunDraft& draft = kept.view.draft;
  if (action.name == "run") {
    const auto run = need_run();
    if (!run) return forward_error(run);
    const RunHeader& header = (*run)->document->header;
    const auto options = recorded_options(header);
    if (!options) return forward_error(options, (*run)->path.string());
    const auto [name, preset] = known_preset(header.preset);
    draft = {name, changes_from(preset, *options)};
    return {};
  }
  if (const auto preset = run_preset(action.name)) {
    draft = {action.name, {}};
    return {};
  }
  std::error_code error;
  const bool is_file = action.name.find_first_of("/.") != std::string::npos;
  if (!is_file || !fs::exists(action.name, error)) {
    const auto named = run_preset(action.name);
    if (!is_file) return forward_error(named);
    return fail(ErrorCode::kNotFound, "{}: does not exist", action.name);
  }
  const auto recipe = read_run_recipe(action.name);
  if (!recipe) return forward_error(recipe);
  const auto [name, preset] = known_preset(recipe->preset);
  draft = {name, changes_from(preset, recipe->options)};
  return {};
}

Result<void> Session::Implementation::perform(const actions::SavePreset& action) {
  if (action.file.empty()) return fail(ErrorCode::kInvalidOptions, "no file is named");
  const auto options = draft_options();
  if (!options) return forward_error(options);
  const RunDraft& draft = kept.view.draft;
  std::string text =
      "# Options for 'nadir localise --recipe', written by Nadir's window.\npreset = " +
      toml_quoted(draft.preset) + "\n";
  if (!draft.changed.empty()) text += "\n[options]\n";
  for (const OptionText& option : option_texts(*options)) {
    if (!draft.changed.contains(option.name)) continue;
    const bool is_word = option.kind == OptionKind::kChoice || option.kind == OptionKind::kOwnText;
    text += option.name + " = " + (is_word ? toml_quoted(option.value) : option.value) + "\n";
  }
  const std::string path = absolute_path(action.file);
  if (auto written = write_text_file(path, text); !written) return written;
  add_notice(Notice::Kind::kInfo, fmt::format("{} was written", path));
  return {};
}

}  // namespace nadir
