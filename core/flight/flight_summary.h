// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/flight/flight_recording.h"

namespace nadir {

struct TimeSpan {
  double start_s = 0.0;
  double end_s = 0.0;
  [[nodiscard]] double length_s() const { return end_s - start_s; }
  friend bool operator==(const TimeSpan&, const TimeSpan&) = default;
};

/// What one stream of a flight is like. Always at least one sample.
struct StreamSummary {
  std::string name;  ///< "images", "depth", "labels", "odometry" or "truth".
  std::size_t count = 0;
  TimeSpan span;
  std::optional<double> rate_hz;   ///< One over the median interval; nothing for a single sample.
  std::optional<double> jitter_s;  ///< Root mean square of interval minus median, gaps left out.
  std::vector<TimeSpan> gaps;      ///< Intervals longer than 1.8 medians, in order of time.
  /// Samples that have practically the time of the one before: within a tenth of the interval that
  /// three quarters of all stay below. They count in `count` alone: neither rate, nor jitter, nor
  /// gaps know of them.
  std::size_t duplicates = 0;
  /// What a trajectory was read from, as seen from the flight ("odometry.txt"); else empty.
  std::string source = {};
};

/// Ways are measured between places this far apart, where single steps are mostly noise.
inline constexpr double kWayPieceM = 1.0;

/// A flight at a glance: what `nadir flight info` prints and a window shows before anything is
/// localised.
struct FlightSummary {
  std::vector<StreamSummary>
      streams;  ///< Those that are there: images, depth, labels, odometry, truth.
  /// Time in which labels (where there are none, images or depth), odometry and truth are all
  /// there; nothing where they do not meet. Streams that the flight has not do not count.
  std::optional<TimeSpan> overlap;
  std::optional<double> truth_length_m;  ///< Travelled in the plane, all steps summed.
  /// Way of the odometry in the plane from place to place at least kWayPieceM apart. Noise of single
  /// poses lengthens it a little.
  std::optional<double> odometry_length_m;
  /// All steps of the odometry summed, their noise with them: the faster its poses come, the more
  /// this is too long. Steps forth and back while hovering count too.
  std::optional<double> odometry_summed_m;
  /// All times are seconds since some start, under 10^7 (116 days), or all are seconds since 1970
  /// in 2000 to 2100, and the streams meet.
  bool are_times_sane = true;
  /// What a user should know before localising, in plain words, without full stops. Empty for a
  /// flight without fault.
  std::vector<std::string> notices;
};

/// Pure; looks at times and poses only, at no pixel. O(n log n) in the number of samples.
[[nodiscard]] FlightSummary summarise_flight(const FlightDescription& flight);

/// One stream by itself. `times_s` is not empty and never goes back; times may repeat.
[[nodiscard]] StreamSummary summarise_stream(std::string name, const std::vector<double>& times_s);

/// Metres from the first to the last pose in the plane by way of poses of which each is at least
/// `piece_m` from the one before; so noise of less than that adds little. 0 for less than two poses.
[[nodiscard]] double way_in_pieces_m(const Trajectory& trajectory, double piece_m);

/// Principal point in both conventions, in words: "(320.00, 240.00) px where pixel centres are at
/// +0.5, (319.50, 239.50) px where they are whole numbers, as in flight.toml, OpenCV and ROS".
[[nodiscard]] std::string centre_text(const CameraModel& camera);

}  // namespace nadir
