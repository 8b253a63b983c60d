// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "core/session/session.h"
#include "widgets/kit/ui.h"

namespace nadir {

/// What a user should know, in the lower right corner until it is read.
struct NoticesModel {
  std::vector<Notice> shown;   ///< The newest, oldest first.
  std::vector<int> not_shown;  ///< Numbers of those that there is no room for.
  static constexpr std::size_t kMostShown = 4;
};

[[nodiscard]] NoticesModel notices_model(const Session& session);

/// @param inside  Part of the window in whose lower right corner they stand.
[[nodiscard]] Actions draw_notices(kit::Ui& ui, const NoticesModel& model, const kit::Rect& inside);

}  // namespace nadir
