// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/session/action.h"
#include "widgets/kit/ui.h"
#include "widgets/panels/stream_bars.h"
#include "widgets/panels/strip_lines.h"
#include "widgets/panels/timeline_model.h"

namespace nadir {

/// Around the timeline, of the design: with that much three of the usual strips are whole in the usual height.
inline constexpr double kTimelinePadding = 8.0;

/// What the timeline keeps from frame to frame; its owner only keeps it alive. Nothing in here can be undone.
struct TimelineState {
  // What the strips show, kept while runs and width stay.
  struct ShownRun {
    std::shared_ptr<const RunDocument> document;
    double offset_s = 0.0;
    int colour = 0;
    friend bool operator==(const ShownRun&, const ShownRun&) = default;
  };
  std::vector<ShownRun> shown_runs;
  std::shared_ptr<const FlightRecording> shown_flight;
  double shown_px_per_s = 0.0;
  std::array<std::optional<StripPlot>, kStripCount> plots;
  std::optional<std::vector<StreamBar>> streams;

  std::string
      fault;  ///< Why what was typed is no time, in a sentence that the owner tells; empty: nothing is wrong.

  // What the user is doing.
  bool is_scrubbing = false;           ///< The left button is held on a strip or on the ruler.
  std::optional<double> loop_start_s;  ///< Where a drag that marks a loop began.
  std::optional<double> menu_s;        ///< Where the ruler's menu was opened.
  std::optional<Strip> moved_strip;    ///< Dragged by its name.
  std::optional<TimeSpan> zoomed_to;   ///< Part of the axis that shows; nothing: all of it.
  std::optional<double> hovered_s;     ///< Moment under the mouse, as of the last frame.
  double last_time_s = 0.0;            ///< Of the cursor in the last frame.
  std::array<std::optional<kit::Rect>, kStripCount> places;  ///< Of the strips, as last drawn.
};

/// Transport, ruler and strips, all on one time axis. Draws into the room that there is; strips that do not fit scroll.
///
/// Paths: "Timeline/First", "Step back", "Play", "Step on", "Last", "Speed", "Time", "Loop off", "Previous worst moment",
/// "Next worst moment", "Bookmark", "Strips/…"; "Timeline/Ruler"; the strips by their names as actions have them,
/// "Timeline/position-error" and "Timeline/position-error height". A left drag on ruler or strips scrubs, one with Shift, or
/// of the right button, on the ruler marks the loop; the wheel on the ruler, or with Ctrl, zooms the axis. In the lower half of
/// the ruler a press on a mark goes to its very moment.
[[nodiscard]] Actions draw_timeline(kit::Ui& ui, const TimelineModel& model, TimelineState& state);

}  // namespace nadir
