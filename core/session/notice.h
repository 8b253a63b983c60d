// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "core/session/action.h"

namespace nadir {

/// Something that a user should know, until it is dismissed.
struct Notice {
  enum class Kind { kInfo, kWarning, kError };
  int number = 0;
  Kind kind = Kind::kInfo;
  std::string text;              ///< One sentence.
  std::string details;           ///< To copy; may be empty.
  std::optional<Action> remedy;  ///< What the notice's button does.
  std::string remedy_title;
  double shown_s = 0.0;  ///< For how long.
};

/// Work in the background, as the status line shows it.
struct JobStatus {
  int number = 0;
  std::string title;      ///< "localising loop".
  double fraction = 0.0;  ///< In [0, 1].
  std::string activity;
  std::optional<double> left_s;
  bool will_be_shown = false;  ///< What comes of it is waited for: there is nothing else to see.
  bool is_stopping = false;    ///< Somebody has asked for that; it ends in a moment.
};

}  // namespace nadir
