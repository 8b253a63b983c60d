// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/session/session.h"
#include "widgets/kit/ui.h"

namespace nadir {

/// Words of all that was done and said. A view of the session's log: valid until the session does something.
struct LogModel {
  std::span<const std::string> lines;  ///< Oldest first.
};

struct LogState {
  std::string typed;                  ///< What is looked for.
  std::vector<std::size_t> selected;  ///< Lines, rising; what is copied. Empty: all that are shown.
};

[[nodiscard]] LogModel log_model(const Session& session);

/// The newest on top. A click selects a line, with Ctrl one more, with Shift all up to it; Ctrl+C copies.
[[nodiscard]] Actions draw_log(kit::Ui& ui, const LogModel& model, LogState& state);

}  // namespace nadir
