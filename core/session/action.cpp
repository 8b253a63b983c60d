// SPDX-License-Identifier: Apache-2.0
#include "core/session/action.h"

namespace nadir {

Action::Action(const Action& other) = default;
Action::Action(Action&& other) noexcept = default;
Action& Action::operator=(const Action& other) = default;
Action& Action::operator=(Action&& other) noexcept = default;
Action::~Action() = default;

}  // namespace nadir
