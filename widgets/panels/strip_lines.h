// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/eval/series.h"
#include "core/session/view_state.h"
#include "widgets/panels/timeline_model.h"

namespace nadir {

/// What there is to say about a strip without any run.
struct StripInfo {
  std::string_view name;  ///< "Position error".
  std::string_view unit;  ///< "m"; empty: none.
  std::string_view help;  ///< For its tooltip, a sentence without a full stop.
};
[[nodiscard]] const StripInfo& strip_info(Strip strip);

/// A line of a strip: times of the timeline, values in the strip's unit, thinned for the pixels.
struct StripCurve {
  /// Of the run; paler, for a second line of it; muted, for what is only a measure of the others; of what is wrong.
  enum class Tone { kRun, kPale, kMuted, kBad };
  PointLine line;  ///< NaN in y breaks it.
  Tone tone = Tone::kRun;
  int colour = 0;  ///< Of run_colour().
};

/// A horizontal line: a bound, which is bad to cross, or a mere expectation.
struct StripLevel {
  double value = 0.0;
  bool is_bound = true;
};

/// What is drawn in a strip, but for its streams (see stream_bars.h).
struct StripPlot {
  std::vector<StripCurve> curves;  ///< The last lies on top.
  std::vector<StripLevel> levels;
  double low = 0.0, high = 1.0;  ///< Values at the lower and upper edge; low < high.
  bool is_logarithmic = false;
  std::optional<double> cut_off;  ///< The largest value, where the strip ends below it.

  /// How high a value lies: 0 at the lower edge, 1 at the upper; beyond them outside of [0, 1], but never infinite.
  [[nodiscard]] double height_of(double value) const;
};

/// Lines of all runs. A few milliseconds at most; keep it while runs and width stay.
/// @param px_per_s  Of the axis: there is a lowest and a highest point for every pixel.
[[nodiscard]] StripPlot strip_plot(Strip strip, std::span<const TimelineRun> runs, double px_per_s);

/// Values of a run at a moment of the timeline, in the strip's unit: the main one, and that of its pale or muted line. Those of
/// the last step not after the moment; NaN where not known, before the run and after its end.
struct StripNumbers {
  double main = std::numeric_limits<double>::quiet_NaN();
  double second = std::numeric_limits<double>::quiet_NaN();
};
[[nodiscard]] StripNumbers strip_numbers(Strip strip, const TimelineRun& run, double moment_s);

/// The same with as many digits as are known, without the unit: "0.42", "0.42 0.31", "1234/10000"; "–" where not known.
[[nodiscard]] std::string strip_value(Strip strip, const TimelineRun& run, double moment_s);

/// The main value alone, where there is little room.
[[nodiscard]] std::string short_strip_value(Strip strip, const TimelineRun& run, double moment_s);

/// The parts of a line above a limit, cut where it crosses it; NaN between them.
[[nodiscard]] PointLine above(const PointLine& line, double limit);

/// The least of 1, 2, 2.5, 5 times a power of ten that is not below. @param value  Finite; 1 for what is not above 0.
[[nodiscard]] double round_up(double value);

}  // namespace nadir
