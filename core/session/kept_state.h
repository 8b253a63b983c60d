// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/session/bookmarks.h"
#include "core/session/label_view.h"
#include "core/session/open_run.h"
#include "core/session/session_works.h"
#include "core/session/view_state.h"

namespace nadir {

/// What undo takes back: the view, and what is kept beside it.
struct KeptState {
  ViewState view = default_view_state();
  std::map<std::string, Bookmarks> bookmarks;  ///< By the run's path; only of runs that were read.
  std::map<std::string, WindowLayout> layouts;
  int memory_megabytes = 256;
  friend bool operator==(const KeptState&, const KeptState&) = default;
};

/// What an action that fails halfway leaves as it was.
struct Standing {
  KeptState kept;
  Playback playback;
  LabelView label;
  Overlay overlay = Overlay::kNone;
  std::string followed_run;
  std::optional<ComingRun> coming;
  std::optional<double> wanted_time_s;
  std::map<std::string, MapWish> map_wishes;
};

/// What a run's file of bookmarks holds beside what this session has made of it, for another window has written into it.
struct ForeignBookmarks {
  std::string run;
  Bookmarks expected, found;
};

}  // namespace nadir
