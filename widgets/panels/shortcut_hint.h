// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/session/action.h"
#include "widgets/kit/ui_parts.h"

namespace nadir {

class Session;

/// A tooltip with the shortcut that the table of commands has for an action; without one where it has none.
[[nodiscard]] kit::Hint hint_for(const std::string& text, const Action& action);

/// Whether and why the command of an action cannot be done now; empty: it can.
[[nodiscard]] std::string why_not_now(const Action& action, const Session& session);

}  // namespace nadir
