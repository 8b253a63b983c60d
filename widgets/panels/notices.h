// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "core/session/session.h"
#include "widgets/kit/ui.h"

namespace nadir {

/// What a user should know, in the lower right corner until it is read.
struct NoticesModel {
  std::vector<Notice> all;                      ///< Oldest first.
  static constexpr std::size_t kMostShown = 3;  ///< Unless all are asked for.
};
/// Kept by the caller.
struct NoticesState {
  bool shows_all = false;  ///< As many as there is room for.
};

[[nodiscard]] NoticesModel notices_model(const Session& session);

/// The newest; those that there is no room for are counted in a line above them: "Notices/more", "Notices/more/Show all". Where
/// even that line has no room, the newest one counts them.
/// @param inside  Part of the window in whose lower right corner they stand.
[[nodiscard]] Actions draw_notices(kit::Ui& ui,
                                   const NoticesModel& model,
                                   NoticesState& state,
                                   const kit::Rect& inside);

}  // namespace nadir
