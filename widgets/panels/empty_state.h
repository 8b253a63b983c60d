// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "core/session/action.h"
#include "widgets/kit/ui.h"

namespace nadir {

/// What a panel says in place of a content that is not there: what would fill it, and the one button for that.
struct EmptyState {
  kit::Icon icon = kit::Icon::kInfo;
  std::string title;     ///< Two or three words: "No run is open".
  std::string sentence;  ///< What would fill it.
  std::string button;    ///< Empty: none.
  std::string shortcut;
  std::optional<Action> action = {};  ///< Of the button.
};

/// No run is open. @param what  What the panel would then show: "position, covariance and modes of each moment".
[[nodiscard]] EmptyState no_run_state(const std::string& what);
/// A file is being read. @param name  Of the run or map.
[[nodiscard]] EmptyState reading_state(const std::string& name);
/// A run is being made and has no step yet. @param name  Of the run.
[[nodiscard]] EmptyState coming_state(const std::string& name);
/// Nothing fits a search. @param typed  What was looked for.
[[nodiscard]] EmptyState no_match_state(const std::string& typed);

/// In the middle of the room that is left. @returns the button's action where it was clicked.
[[nodiscard]] Actions draw_empty_state(kit::Ui& ui, const EmptyState& state);

}  // namespace nadir
