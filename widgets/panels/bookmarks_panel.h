// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/session/action.h"
#include "core/session/bookmarks.h"
#include "core/session/moment_value.h"
#include "widgets/kit/ui.h"

namespace nadir {

class Session;

/// Moments of the active run that somebody, or the program, found worth a look. Times are seconds after its first step.
struct BookmarksModel {
  bool has_run = false;
  std::string reading;  ///< Name of the run while it is being read; empty else.
  double time_s = 0.0;  ///< Of the cursor.
  std::vector<Bookmark> bookmarks;
  std::vector<WorstMoment> moments;  ///< In order of time.
  std::vector<MomentValue> values;   ///< What each is about, "2.8 m"; missing ones are not shown.
};

[[nodiscard]] BookmarksModel bookmarks_model(const Session& session);

struct BookmarksState {
  std::optional<double> edited_s;  ///< Time of the bookmark whose note is being typed.
  std::string note;                ///< Typed for the next bookmark.
  bool is_by_time = false;         ///< Worst moments in order of time, not the most severe first.
};

/// Paths: "Bookmarks/##Note", "Bookmarks/Mark this moment"; of the second bookmark "Bookmarks/2/##go", "Bookmarks/2/Edit",
/// "Bookmarks/2/Remove", and "Bookmarks/2/##Note" while it is edited; of the first worst moment in sight "Bookmarks/Worst
/// moments/1/##go"; "Bookmarks/Worst moments/##Order/by time".
[[nodiscard]] Actions draw_bookmarks(kit::Ui& ui,
                                     const BookmarksModel& model,
                                     BookmarksState& state);

}  // namespace nadir
