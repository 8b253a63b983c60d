// SPDX-License-Identifier: Apache-2.0
// Options of the next run.
#include <algorithm>
#include <system_error>

#include "core/base/staged_output.h"
#include "core/run/resume_point.h"
#include "core/run/run_prior.h"
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

std::optional<std::string> text_of_option(const RunOptions& options, const std::string& name) {
  for (const OptionText& option : option_texts(options)) {
    if (option.name == name) return option.value;
  }
  return std::nullopt;
}

/// A preset by its name; of one that this version does not know, the default one.
std::pair<std::string, RunOptions> known_preset(const std::string& name) {
  if (const auto options = run_preset(name)) return {name, *options};
  return {"default", RunOptions{}};
}

}  // namespace

const LiveRun* Session::Implementation::live(const OpenRun& run) const {
  const auto& of_run = works[static_cast<std::size_t>(&run - runs.data())].live;
  return of_run ? &*of_run : nullptr;
}

const OpenRun* Session::Implementation::run_to_repeat() const {
  const auto found = std::find_if(runs.begin(), runs.end(), [this](const OpenRun& run) {
    return coming && run.path == coming->path;
  });
  return found != runs.end() ? &*found : active();
}

std::string Session::Implementation::draft_prior() const {
  const OpenRun* const run = run_to_repeat();
  if (run == nullptr) return {};
  if (run->document) {
    const RunHeader& header = run->document->header;
    const auto prior = header.options.find(kPriorOption);
    return prior == header.options.end() || !header.parent_run.empty() ? "" : prior->second;
  }
  const LiveRun* const made = live(*run);
  return made != nullptr && made->origin.prior ? prior_text(*made->origin.prior) : "";
}

Result<OptionsBase> Session::Implementation::draft_base() const {
  const std::string& name = kept.view.draft.preset;
  const OpenRun* const run = run_to_repeat();
  if (name != kOptionsOfRun || run == nullptr) {
    const std::string preset = name == kOptionsOfRun ? "default" : name;
    const auto options = run_preset(preset);
    if (!options) return forward_error(options);
    return OptionsBase{preset, *options};
  }
  if (run->document) {
    const auto options = recorded_options(run->document->header);
    if (!options) return forward_error(options, run->path.string());
    return OptionsBase{run->document->header.preset, *options};
  }
  if (const LiveRun* const made = live(*run)) return made->origin.base;
  return fail(ErrorCode::kInvalidOptions, "{} is still being read", run->name);
}

Result<RunOptions> Session::Implementation::draft_options() const {
  auto base = draft_base();
  if (!base) return forward_error(base);
  for (const auto& [name, value] : kept.view.draft.changed) {
    if (const auto set = set_option(base->options, name, value); !set) {
      return tl::unexpected(without_dashes(set.error()));
    }
  }
  return base->options;
}

Result<void> Session::Implementation::perform(const actions::SetOption& action) {
  RunDraft& draft = kept.view.draft;
  const auto base = draft_base();
  // Of a run that is still being read nobody knows yet what differs: then the change is kept as it is.
  if (!base && draft.preset != kOptionsOfRun) return forward_error(base);
  RunOptions options = base ? base->options : RunOptions();
  const auto unchanged = text_of_option(options, action.name);
  if (!action.value && unchanged) {
    draft.changed.erase(action.name);
    return {};
  }
  const auto set = set_option(options, action.name, action.value.value_or(""));
  if (!set) return tl::unexpected(without_dashes(set.error()));
  const auto changed = text_of_option(options, action.name);
  if (base && changed == unchanged) {
    draft.changed.erase(action.name);
  } else {
    draft.changed[action.name] = changed.value_or("");
  }
  // A kept change that no longer fits must not be in the way of the others.
  std::erase_if(draft.changed, [&options](const auto& change) {
    return !set_option(options, change.first, change.second);
  });
  return {};
}

Result<void> Session::Implementation::perform(const actions::UsePreset& action) {
  RunDraft& draft = kept.view.draft;
  if (action.name == kOptionsOfRun) {
    const auto run = need_run();
    if (!run) return forward_error(run);
    const auto options = recorded_options((*run)->document->header);
    if (!options) return forward_error(options, (*run)->path.string());
    draft = {kOptionsOfRun, {}};
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
  const auto base = draft_base();
  const auto options = draft_options();
  if (!base || !options) return tl::unexpected(base ? options.error() : base.error());
  const auto [name, preset] = known_preset(base->preset);
  const auto changed = changes_from(preset, *options);
  std::string text =
      "# Options for 'nadir localise --recipe', written by Nadir's window.\npreset = " +
      toml_quoted(name) + "\n";
  if (!changed.empty()) text += "\n[options]\n";
  for (const OptionText& option : option_texts(*options)) {
    if (!changed.contains(option.name)) continue;
    const bool is_word = option.kind == OptionKind::kChoice || option.kind == OptionKind::kOwnText;
    text += option.name + " = " + (is_word ? toml_quoted(option.value) : option.value) + "\n";
  }
  const std::string path = absolute_path(action.file);
  if (auto written = write_text_file(path, text); !written) return written;
  add_notice(Notice::Kind::kInfo, fmt::format("{} was written", path));
  return {};
}

}  // namespace nadir
