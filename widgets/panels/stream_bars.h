// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "widgets/panels/timeline_model.h"

namespace nadir {

/// From when to when there was something, in the timeline's time.
struct TimeSpan {
  double from_s = 0.0, to_s = 0.0;
  friend bool operator==(const TimeSpan&, const TimeSpan&) = default;
};

/// One stream of the flight or of the active run. Where there is more than five usual periods between two of its samples, it
/// has a gap.
struct StreamBar {
  std::string name;  ///< "image", "depth", "labels", "truth", "topview".
  std::size_t samples = 0;
  std::vector<TimeSpan>
      spans;  ///< Rising, apart; the last sample of one counts for one period more.

  [[nodiscard]] bool is_there(double moment_s) const;
  /// The longest gap between two spans; nothing where there is none.
  [[nodiscard]] std::optional<TimeSpan> longest_gap() const;
};

/// Streams of the flight, where it is open, then those of the run; one without any sample is missing.
[[nodiscard]] std::vector<StreamBar> stream_bars(const TimelineModel& model);

/// What a tooltip says of a stream: "depth: 1204 samples, 1 gap, the longest 2.1 s at 00:42.0"; "depth: missing".
[[nodiscard]] std::string stream_words(const StreamBar& stream);

}  // namespace nadir
