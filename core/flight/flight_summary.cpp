// SPDX-License-Identifier: Apache-2.0
#include "core/flight/flight_summary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace nadir {
namespace {

constexpr double kLongestRelativeTimeS = 1e7;
constexpr TimeSpan kPlausibleEpoch{946'684'800.0, 4'102'444'800.0};  // 2000 to 2100.

std::vector<double> times_of(const Trajectory& trajectory) {
  std::vector<double> times_s;
  times_s.reserve(trajectory.size());
  for (const TimedPose& timed : trajectory.poses()) times_s.push_back(timed.time_s);
  return times_s;
}

std::vector<double> times_of(const std::vector<FlightFrame>& frames,
                             std::optional<std::filesystem::path> FlightFrame::*file) {
  std::vector<double> times_s;
  for (const FlightFrame& frame : frames) {
    if ((frame.*file).has_value()) times_s.push_back(frame.time_s);
  }
  return times_s;
}

const StreamSummary* find(const FlightSummary& summary, std::string_view name) {
  const auto is_named = [&](const StreamSummary& stream) { return stream.name == name; };
  const auto found = std::find_if(summary.streams.begin(), summary.streams.end(), is_named);
  return found == summary.streams.end() ? nullptr : &*found;
}

/// The stream whose times are those of the frames.
const StreamSummary* leading_stream(const FlightSummary& summary) {
  for (const char* name : {"labels", "images", "depth"}) {
    if (const StreamSummary* stream = find(summary, name)) return stream;
  }
  return nullptr;
}

std::optional<TimeSpan> overlap_of(const FlightSummary& summary) {
  std::optional<TimeSpan> overlap;
  for (const StreamSummary* stream :
       {leading_stream(summary), find(summary, "odometry"), find(summary, "truth")}) {
    if (stream == nullptr) continue;
    if (!overlap) overlap = stream->span;
    overlap->start_s = std::max(overlap->start_s, stream->span.start_s);
    overlap->end_s = std::min(overlap->end_s, stream->span.end_s);
  }
  if (overlap && overlap->end_s < overlap->start_s) return {};
  return overlap;
}

bool lies_in(const TimeSpan& span, double start_s, double end_s) {
  return span.start_s >= start_s && span.end_s <= end_s;
}

/// Notes what is odd about the clock of a stream; false where something is.
bool check_clock(const StreamSummary& stream, std::vector<std::string>& notices) {
  if (lies_in(stream.span, 0.0, kLongestRelativeTimeS)) return true;
  if (lies_in(stream.span, kPlausibleEpoch.start_s, kPlausibleEpoch.end_s)) return true;
  struct Unit {
    std::string_view name;
    double per_s;
  };
  constexpr std::array<Unit, 3> kUnits{Unit{"milliseconds", 1e3}, Unit{"microseconds", 1e6},
                                       Unit{"nanoseconds", 1e9}};
  for (const Unit& unit : kUnits) {
    if (lies_in(stream.span, kPlausibleEpoch.start_s * unit.per_s,
                kPlausibleEpoch.end_s * unit.per_s)) {
      notices.push_back(
          fmt::format("times of the {} look like {}, not seconds", stream.name, unit.name));
      return false;
    }
  }
  notices.push_back(fmt::format(
      "times of the {} ({:.6g} s to {:.6g} s) are neither seconds since a start nor since 1970",
      stream.name, stream.span.start_s, stream.span.end_s));
  return false;
}

/// "odometry ends 12.3 s before the labels", where a stream leaves more than a period of the frames
/// uncovered.
void note_cover(const StreamSummary& stream,
                const StreamSummary& leading,
                std::vector<std::string>& notices) {
  const double period_s = leading.rate_hz ? 1.0 / *leading.rate_hz : 0.1;
  const double late_s = stream.span.start_s - leading.span.start_s;
  const double early_s = leading.span.end_s - stream.span.end_s;
  if (stream.span.start_s > leading.span.end_s || stream.span.end_s < leading.span.start_s) {
    notices.push_back(fmt::format(
        "{} ({:.1f} s to {:.1f} s) and {} ({:.1f} s to {:.1f} s) do not overlap in time",
        stream.name, stream.span.start_s, stream.span.end_s, leading.name, leading.span.start_s,
        leading.span.end_s));
    return;
  }
  if (late_s > period_s) {
    notices.push_back(
        fmt::format("{} starts {:.1f} s after the {}", stream.name, late_s, leading.name));
  }
  if (early_s > period_s) {
    notices.push_back(
        fmt::format("{} ends {:.1f} s before the {}", stream.name, early_s, leading.name));
  }
}

void note_missing(const FlightDescription& flight,
                  const FlightSummary& summary,
                  std::vector<std::string>& notices) {
  const bool has_labels = find(summary, "labels") != nullptr;
  const bool has_depth = find(summary, "depth") != nullptr;
  if (flight.frames.empty()) {
    notices.emplace_back("there are no images, labels or depth, only poses");
  } else if (!has_labels) {
    notices.emplace_back("there are no label images, so there is nothing to localise with");
  } else if (!has_depth) {
    notices.emplace_back("there is no depth, so nobody knows where the labels lie");
  }
  if (!flight.frames.empty() && !flight.camera) {
    notices.emplace_back("the camera is not known");
  }
  if (!flight.odometry) notices.emplace_back("there is no odometry");
  if (!flight.truth) notices.emplace_back("there is no truth, so errors cannot be told");

  const auto is_lost = [](const FlightFrame& f) { return f.labels && !f.depth; };
  const auto lost = std::count_if(flight.frames.begin(), flight.frames.end(), is_lost);
  if (has_labels && has_depth && lost > 0) {
    notices.push_back(fmt::format("{} of {} label images have no depth image of the same time",
                                  lost, find(summary, "labels")->count));
  }
}

void note_gaps(const StreamSummary& stream, std::vector<std::string>& notices) {
  if (stream.gaps.empty()) return;
  const auto longest = std::max_element(
      stream.gaps.begin(), stream.gaps.end(),
      [](const TimeSpan& a, const TimeSpan& b) { return a.length_s() < b.length_s(); });
  const std::string count =
      stream.gaps.size() == 1 ? "a gap" : fmt::format("{} gaps, the longest", stream.gaps.size());
  notices.push_back(fmt::format("{}: {} of {:.2f} s at {:.2f} s", stream.name, count,
                                longest->length_s(), longest->start_s));
}

void note_duplicates(const StreamSummary& stream, std::vector<std::string>& notices) {
  if (stream.duplicates == 0) return;
  notices.push_back(fmt::format(
      "{}: {} of {} samples have practically the time of the one before; rate, jitter and gaps "
      "leave them out",
      stream.name, stream.duplicates, stream.count));
}

/// "the odometry is poses_a.txt, the first by name; poses_b.txt is left aside".
void note_choice(const FlightDescription& flight, std::vector<std::string>& notices) {
  if (flight.other_odometry.empty()) return;
  std::string others;
  for (const auto& file : flight.other_odometry) {
    others += (others.empty() ? "" : ", ") + file.filename().string();
  }
  notices.push_back(fmt::format("the odometry is {}, the first by name; left aside: {}",
                                flight.odometry_source.filename().string(), others));
}

/// As the user would type it: seen from the flight where it lies inside.
std::string shown_source(const std::filesystem::path& source, const std::filesystem::path& flight) {
  const std::filesystem::path inside = source.lexically_relative(flight);
  if (inside.empty() || inside == "." || *inside.begin() == "..") return source.filename().string();
  return inside.string();
}

}  // namespace

double way_in_pieces_m(const Trajectory& trajectory, double piece_m) {
  if (trajectory.empty()) return 0.0;
  const auto place = [](const TimedPose& timed) -> Eigen::Vector2d {
    return timed.pose.translation_m.head<2>();
  };
  Eigen::Vector2d last_m = place(trajectory.poses().front());
  double way_m = 0.0;
  for (const TimedPose& timed : trajectory.poses()) {
    const double step_m = (place(timed) - last_m).norm();
    if (step_m < piece_m) continue;
    way_m += step_m;
    last_m = place(timed);
  }
  return way_m + (place(trajectory.poses().back()) - last_m).norm();
}

std::string centre_text(const CameraModel& camera) {
  return fmt::format(
      "({:.2f}, {:.2f}) px where pixel centres are at +0.5, ({:.2f}, {:.2f}) px where they are "
      "whole "
      "numbers, as in flight.toml, OpenCV and ROS",
      camera.centre_x_px, camera.centre_y_px, camera.centre_x_px - 0.5, camera.centre_y_px - 0.5);
}

FlightSummary summarise_flight(const FlightDescription& flight) {
  FlightSummary summary;
  const auto add = [&](const char* name, const std::vector<double>& times_s) {
    if (!times_s.empty()) summary.streams.push_back(summarise_stream(name, times_s));
  };
  add("images", times_of(flight.frames, &FlightFrame::image));
  add("depth", times_of(flight.frames, &FlightFrame::depth));
  add("labels", times_of(flight.frames, &FlightFrame::labels));
  const auto add_poses = [&](const char* name, const std::optional<Trajectory>& trajectory,
                             const std::filesystem::path& source) {
    if (!trajectory || trajectory->empty()) return;
    add(name, times_of(*trajectory));
    if (!source.empty()) summary.streams.back().source = shown_source(source, flight.path);
  };
  add_poses("odometry", flight.odometry, flight.odometry_source);
  add_poses("truth", flight.truth, flight.truth_source);
  if (flight.odometry && !flight.odometry->empty()) {
    summary.odometry_length_m = way_in_pieces_m(*flight.odometry, kWayPieceM);
    summary.odometry_summed_m = flight.odometry->planar_length_m();
  }
  if (flight.truth && !flight.truth->empty()) {
    summary.truth_length_m = flight.truth->planar_length_m();
  }
  summary.overlap = overlap_of(summary);

  note_missing(flight, summary, summary.notices);
  note_choice(flight, summary.notices);
  for (const StreamSummary& stream : summary.streams) {
    if (!check_clock(stream, summary.notices)) summary.are_times_sane = false;
  }
  if (!summary.overlap && !summary.streams.empty()) summary.are_times_sane = false;
  const StreamSummary* leading = leading_stream(summary);
  const StreamSummary* odometry = find(summary, "odometry");
  const StreamSummary* truth = find(summary, "truth");
  if (leading == nullptr && odometry != nullptr) leading = odometry;
  for (const StreamSummary* stream : {odometry, truth}) {
    if (stream != nullptr && leading != nullptr && stream != leading)
      note_cover(*stream, *leading, summary.notices);
  }
  for (const StreamSummary& stream : summary.streams) {
    note_duplicates(stream, summary.notices);
    note_gaps(stream, summary.notices);
  }
  return summary;
}

}  // namespace nadir
