// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "core/session/action_fields.h"

/// Opening and leaving.
namespace nadir::actions {

struct OpenFile {
  static constexpr std::string_view kForm = "open PATH";
  static constexpr std::string_view kHelp = "Open a run, a map, a flight, a recipe or a figure";
  std::string path;
  NADIR_ACTION_FIELDS(path)
  friend bool operator==(const OpenFile&, const OpenFile&) = default;
};

struct OpenDemo {
  static constexpr std::string_view kForm = "open-demo";
  static constexpr std::string_view kHelp = "Make and open the demo: a flight over a small town";
  NADIR_ACTION_FIELDS()
  friend bool operator==(const OpenDemo&, const OpenDemo&) = default;
};

struct CloseRun {
  static constexpr std::string_view kForm = "close-run RUN";
  static constexpr std::string_view kHelp = "Close a run; its file stays";
  int run = 1;
  NADIR_ACTION_FIELDS(run)
  friend bool operator==(const CloseRun&, const CloseRun&) = default;
};

struct SaveNow {
  static constexpr std::string_view kForm = "save";
  static constexpr std::string_view kHelp =
      "Write at once what is kept for the next start, as happens every second by itself";
  NADIR_ACTION_FIELDS()
  friend bool operator==(const SaveNow&, const SaveNow&) = default;
};

struct Quit {
  static constexpr std::string_view kForm = "quit";
  static constexpr std::string_view kHelp = "Leave; everything is kept for the next start";
  NADIR_ACTION_FIELDS()
  friend bool operator==(const Quit&, const Quit&) = default;
};

}  // namespace nadir::actions
