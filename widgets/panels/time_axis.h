// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace nadir {

/// Where moments lie across the strips of a timeline: one straight line from seconds to pixels. Times are seconds after the
/// active run's first step.
struct TimeAxis {
  double from_s = 0.0, to_s = 1.0;       ///< from_s < to_s.
  double left_px = 0.0, width_px = 1.0;  ///< Of from_s; up to to_s.
  double first_s = 0.0,
         last_s = 1.0;  ///< What can be gone to: the active run; within [from_s, to_s].

  [[nodiscard]] double right_px() const { return left_px + width_px; }
  [[nodiscard]] double px_per_s() const { return width_px / (to_s - from_s); }
  [[nodiscard]] double x_px(double moment_s) const {
    return left_px + (moment_s - from_s) * px_per_s();
  }
  /// Of any pixel, also beside the axis.
  [[nodiscard]] double time_s(double at_px) const {
    return from_s + (at_px - left_px) / px_per_s();
  }
  /// The moment that a drag to a pixel goes to: inside of the active run.
  [[nodiscard]] double seek_s(double at_px) const;
};

/// A mark on the ruler.
struct TimeTick {
  double time_s = 0.0;
  std::string label;  ///< "1:30", "0:00.5"; empty: a small mark between two others.
};

/// Marks at round times, those with a label at least so far apart. Rising; none outside of the axis.
[[nodiscard]] std::vector<TimeTick> time_ticks(const TimeAxis& axis, double least_px);

/// "00:42.3", "75:03.0", "-00:03.2": minutes, seconds and tenths. What rounds up to a minute is one. NaN gives "--:--.-".
[[nodiscard]] std::string clock_text(double moment_s);

/// Reads what clock_text() writes, and "42.3", "42.3 s", "1:02", "1:02:03.5". Nothing where it is no time.
[[nodiscard]] std::optional<double> parse_clock(std::string_view text);

}  // namespace nadir
