// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/flight/flight_recording.h"
#include "core/session/bookmarks.h"
#include "core/session/run_document.h"
#include "core/session/view_state.h"
#include "core/session/worst_moments.h"

namespace nadir {

class Session;

/// A run whose lines the timeline shows.
struct TimelineRun {
  int number = 1;  ///< As actions count.
  std::string name;
  int colour = 0;  ///< Of run_colour().
  bool is_active = false, is_live = false;
  double offset_s = 0.0;  ///< Added to the run's own times it gives the timeline's.
  std::shared_ptr<const RunDocument> document;  ///< Not null.
  bool is_incomplete = false;                   ///< It was stopped or killed before its end.
};

/// What the timeline shows. All times are seconds after the active run's first step.
struct TimelineModel {
  double time_s = 0.0;
  bool is_playing = false;
  double speed = 1.0;
  std::optional<double> loop_from_s, loop_to_s;
  std::vector<StripLook> strips;  ///< All of them, from the top.
  std::vector<TimelineRun>
      runs;  ///< The active one is the last, drawn above the others. Empty: none is read yet.
  std::vector<WorstMoment> moments;               ///< Of the active run.
  std::vector<Bookmark> bookmarks;                ///< Likewise.
  std::shared_ptr<const FlightRecording> flight;  ///< Null: none.
  std::string reading;  ///< Name of the active run while it is being read; empty else.
  std::string coming;   ///< The same while it is being made and has no step yet.

  /// Null where none is read.
  [[nodiscard]] const TimelineRun* active() const;
  /// What can be gone to, and what the axis shows: all runs, and of one that is being computed, or was stopped, its flight's
  /// length, so that the axis rests while it grows and shows what is missing. `to_s` is above `from_s`, also with one step.
  struct Extent {
    double from_s = 0.0, to_s = 1.0;  ///< Of the axis.
    double last_s = 0.0;              ///< Of the active run.
    friend bool operator==(const Extent&, const Extent&) = default;
  };
  [[nodiscard]] Extent extent() const;
  /// Where the flight ends, in a run's own time; 0 where the flight is not open.
  [[nodiscard]] double flight_end_s(const TimelineRun& run) const;
};

[[nodiscard]] TimelineModel timeline_model(const Session& session);

}  // namespace nadir
