// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/action.h"
#include "core/session/notice.h"
#include "widgets/kit/ui.h"

namespace nadir {

/// Work that a user waits for: what is being done, a bar, the time that is left, and Cancel. At the current place. Paths begin
/// with "Work/".
[[nodiscard]] Actions draw_work(kit::Ui& ui, const JobStatus& job);

/// The same on a plate in the middle of a part of the window; left out where that is too small for it.
[[nodiscard]] Actions draw_work_card(kit::Ui& ui, const JobStatus& job, const kit::Rect& inside);

}  // namespace nadir
