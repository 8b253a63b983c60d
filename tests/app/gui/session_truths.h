// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/session/session.h"

namespace nadir {

/// What is true of a session at any time: its cursor lies within its run, what is active is open, its look can be kept as
/// text and read again, the last line of its log can be done again. @returns the first fault; empty: none.
[[nodiscard]] std::string fault_of(const Session& session);

/// Takes the last change back and does it again. @returns what is not as it was before; empty: nothing.
[[nodiscard]] std::string fault_of_undo(Session& session);

}  // namespace nadir
