// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/session/action.h"

namespace nadir {

/// What an action has done to a view, for "Undo ...": "Hide particles", "Dark theme". @param after  The view as it is now.
[[nodiscard]] std::string change_title(const Action& action, const ViewState& after);

/// Actions with the same key that follow each other are one change: a drag, or a text that is typed. Empty: a change of its
/// own.
[[nodiscard]] std::string merge_key(const Action& action);

}  // namespace nadir
