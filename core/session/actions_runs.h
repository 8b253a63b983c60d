// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/session/action_fields.h"
#include "core/session/view_state.h"

/// Open runs, and the next one.
namespace nadir::actions {

struct ActivateRun {
  static constexpr std::string_view kForm = "run RUN";
  static constexpr std::string_view kHelp = "Make an open run the one that all panels speak of";
  int run = 1;
  NADIR_ACTION_FIELDS(run)
  friend bool operator==(const ActivateRun&, const ActivateRun&) = default;
};

struct ShowRun {
  static constexpr std::string_view kForm = "show-run RUN {on|off|toggle}";
  static constexpr std::string_view kHelp = "Draw a run beside the active one, or not";
  int run = 1;
  Switch to = Switch::kToggle;
  NADIR_ACTION_FIELDS(run, to)
  friend bool operator==(const ShowRun&, const ShowRun&) = default;
};

struct GoToDivergence {
  static constexpr std::string_view kForm = "divergence RUN";
  static constexpr std::string_view kHelp = "Go to where a run first leaves the active one";
  int run = 2;
  NADIR_ACTION_FIELDS(run)
  friend bool operator==(const GoToDivergence&, const GoToDivergence&) = default;
};

struct SetOption {
  static constexpr std::string_view kForm = "option NAME [VALUE]";
  static constexpr std::string_view kHelp =
      "Set an option of the next run; without a value, as the preset has it";
  std::string name;
  std::optional<std::string> value;
  NADIR_ACTION_FIELDS(name, value)
  friend bool operator==(const SetOption&, const SetOption&) = default;
};

struct UsePreset {
  static constexpr std::string_view kForm = "preset NAME";
  static constexpr std::string_view kHelp =
      "Take all options of the next run from a preset or recipe file, or 'run' for the active "
      "run's";
  std::string name;
  NADIR_ACTION_FIELDS(name)
  friend bool operator==(const UsePreset&, const UsePreset&) = default;
};

struct SavePreset {
  static constexpr std::string_view kForm = "save-preset FILE";
  static constexpr std::string_view kHelp =
      "Write the options of the next run as a recipe for nadir localise";
  std::string file;
  NADIR_ACTION_FIELDS(file)
  friend bool operator==(const SavePreset&, const SavePreset&) = default;
};

struct Rerun {
  static constexpr std::string_view kForm = "rerun {start|cursor|flight}";
  static constexpr std::string_view kHelp =
      "Localise the active run's flight again, from its start or from here with the recorded "
      "particles, or the opened flight";
  RerunFrom from = RerunFrom::kStart;
  NADIR_ACTION_FIELDS(from)
  friend bool operator==(const Rerun&, const Rerun&) = default;
};

struct CancelJob {
  static constexpr std::string_view kForm = "cancel [JOB]";
  static constexpr std::string_view kHelp =
      "Stop work in the background; without a number, the newest that goes on";
  std::optional<int> job;
  NADIR_ACTION_FIELDS(job)
  friend bool operator==(const CancelJob&, const CancelJob&) = default;
};

}  // namespace nadir::actions
