// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>

#include "core/geo/trajectory_file.h"
#include "tests/fuzz/fuzz_check.h"

namespace {

using nadir::fuzz_check;
using nadir::Result;
using nadir::Trajectory;

constexpr const char* kName = "fuzzed.txt";

void check_trajectory(const Trajectory& trajectory) {
  fuzz_check(!trajectory.empty(), "a parsed trajectory has poses");
  double previous_s = -HUGE_VAL;
  for (const nadir::TimedPose& timed : trajectory.poses()) {
    fuzz_check(std::isfinite(timed.time_s) && previous_s < timed.time_s, "times are increasing");
    fuzz_check(timed.pose.translation_m.allFinite(), "positions are finite");
    fuzz_check(std::abs(timed.pose.rotation.norm() - 1.0) < 1e-9, "quaternions are of unit length");
    previous_s = timed.time_s;
  }
  const double middle_s = 0.5 * trajectory.start_s() + 0.5 * trajectory.end_s();
  fuzz_check(trajectory.at(trajectory.start_s()).has_value(), "the first pose is there");
  fuzz_check(trajectory.at(trajectory.end_s()).has_value(), "the last pose is there");
  if (const auto pose = trajectory.at(middle_s, HUGE_VAL)) {
    fuzz_check(pose->translation_m.allFinite(), "interpolated positions are finite");
    fuzz_check(std::abs(pose->rotation.norm() - 1.0) < 1e-9,
               "interpolated rotations are rotations");
  }
  fuzz_check(trajectory.planar_length_m() >= 0.0, "a length is not negative");
}

/// What was read can be written and is the same when it is read again.
void check_round_trip(const Trajectory& trajectory) {
  const auto again = nadir::parse_tum_trajectory(nadir::tum_text(trajectory, "again"), kName);
  fuzz_check(again.has_value(), "a written trajectory can be read");
  fuzz_check(again->size() == trajectory.size(), "and has the same number of poses");
  for (std::size_t i = 0; i < again->size(); ++i) {
    const nadir::TimedPose& written = trajectory.poses()[i];
    const nadir::TimedPose& read = again->poses()[i];
    fuzz_check(written.time_s == read.time_s, "and the same times");
    fuzz_check(written.pose.translation_m == read.pose.translation_m, "and the same positions");
  }
}

void check(const Result<Trajectory>& trajectory) {
  nadir::fuzz_check_error(trajectory, kName);
  if (!trajectory) return;
  check_trajectory(*trajectory);
  check_round_trip(*trajectory);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = nadir::text_of(data, size);
  check(nadir::parse_tum_trajectory(text, kName));

  const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
  for (const std::size_t poses : {lines, lines - 1}) {  // the last line may lack its end
    std::vector<double> times_s(poses);
    for (std::size_t i = 0; i < poses; ++i) times_s[i] = 0.1 * static_cast<double>(i);
    check(nadir::parse_kitti_trajectory(text, times_s, kName));
  }

  const auto times_s = nadir::parse_times(text, kName);
  nadir::fuzz_check_error(times_s, kName);
  if (times_s) {
    fuzz_check(std::is_sorted(times_s->begin(), times_s->end()), "times are sorted");
  }
  return 0;
}
