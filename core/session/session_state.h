// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/job.h"
#include "core/session/history.h"
#include "core/session/kept_state.h"
#include "core/session/label_view.h"
#include "core/session/saved_files.h"
#include "core/session/session.h"
#include "core/session/session_works.h"
#include "core/session/unfinished_runs.h"

namespace nadir {

/// All that a session remembers: what its functions (session_core.h) read and write.
struct SessionState {
  explicit SessionState(SessionPlaces where) : places(std::move(where)) {}

  SessionPlaces places;
  KeptState kept;
  History<KeptState> history;
  Playback playback;
  Overlay overlay = Overlay::kNone;
  std::vector<OpenRun> runs;   ///< As kept.view.runs.
  std::vector<RunWork> works;  ///< Beside each run.
  std::optional<OpenMap> map;
  ReadingJob<ReadMap> map_reading;
  std::string last_good_map;                  ///< Path of the last one that could be read.
  std::map<std::string, MapWish> map_wishes;  ///< By the path of an open run that is not read yet.
  std::map<std::string, FlightWork> flights;  ///< By path.
  std::vector<RerunWork> reruns;
  std::vector<SmallWork> small_works;
  std::vector<EffectWork> effect_works;
  std::vector<std::function<bool()>> leaving;  ///< What was asked to stop; true once it has.
  std::vector<Effect> effects;
  std::vector<int> cancelled_effects;
  std::vector<Notice> notices;
  std::vector<std::string> log;
  std::string log_key;  ///< Of the last line, while a drag goes on.
  std::vector<std::string> recents, recent_commands;
  std::vector<std::string> turned_sections;  ///< Of panels; by path.
  int offer_number = 0;  ///< Of the notice that offers to localise a flight; 0: none was made.
  std::string offered;   ///< Flight and map that it was made for.
  int last_number = 0;   ///< Of jobs and notices.
  MapRoom map_room;
  LabelView label;
  std::optional<LabelWork> labels;  ///< As label.path says.
  int direction = 1;                ///< In which time went last.

  // The active run as it was when time was last set, for another one may have other times.
  std::string timed_path;
  std::optional<TimedRun> timed_run;
  std::optional<double> wanted_time_s;  ///< To be set once the active run is settled.
  std::string followed_run;  ///< Path of a run that grows, to whose end the cursor keeps; or empty.
  std::optional<ComingRun> coming;
  std::vector<ForeignBookmarks> foreign_bookmarks;  ///< That the action at work has come upon.
  /// Run and step at which a particle was selected: it is no other step's.
  std::optional<std::pair<std::string, int>> particle_step;

  // What is written into the user's folder.
  std::string saved_session;  ///< As the file holds it, or would have held it at the start.
  Preferences
      saved_preferences;  ///< This session's as it last wrote or read them; another one may have written since.
  Savings being_saved;
  bool is_saving_due = false;  ///< Somebody has asked for it.
  WritingList writing{places.config};
  std::vector<std::string> unfinished;  ///< Runs that a killed program left, and that are offered.
  double since_saving_s = 0.0;
  std::optional<Job<int, int>> saving;
  std::string saving_fault;  ///< Why the last attempt failed; empty: it did not.
};

}  // namespace nadir
