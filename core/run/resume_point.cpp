// SPDX-License-Identifier: Apache-2.0
#include "core/run/resume_point.h"

#include <algorithm>

namespace nadir {

Result<ResumePoint> resume_point(const RunReader& run, const std::string& name, double elapsed_s) {
  const auto steps = run.steps();
  if (!steps) return forward_error(steps);
  if (steps->empty()) {
    return fail(ErrorCode::kInvalidOptions, "{}: holds no step to go on from", name);
  }
  const double start_s = steps->front().time_s;
  const double end_s = steps->back().time_s - start_s;
  if (!(elapsed_s >= -kSameTimeS && elapsed_s <= end_s + kSameTimeS)) {
    return fail(ErrorCode::kInvalidOptions,
                "{}: holds 0 to {:.3f} s, and {} s to go on from is not among them", name, end_s,
                elapsed_s);
  }
  const auto later = std::find_if(steps->begin() + 1, steps->end(), [&](const RunStep& step) {
    return step.time_s > start_s + elapsed_s + kSameTimeS;
  });
  auto after = run.step((later - 1)->step);
  if (!after) return forward_error(after);
  if (!after->particles || after->particles->empty()) {
    return fail(ErrorCode::kInvalidOptions,
                "{}: holds no particles of step {}, so nothing can go on from there", name,
                after->step);
  }
  const RunHeader& header = run.header();
  return ResumePoint{
      .run = name,
      .flight_hash = header.flight_hash,
      .plane_origin = Geodetic{header.plane_latitude_deg, header.plane_longitude_deg},
      .elapsed_s = after->time_s - start_s,
      .after = std::move(*after)};
}

Result<RunOptions> recorded_options(const RunHeader& header) {
  RunOptions options;
  for (const OptionText& known : option_texts(options)) {
    const auto recorded = header.options.find(known.name);
    if (recorded == header.options.end()) continue;
    if (const auto set = set_option(options, recorded->first, recorded->second); !set) {
      return fail(ErrorCode::kMalformed, "table about: {}", set.error().message);
    }
  }
  if (const auto valid = validate_run(options); !valid) {
    return fail(ErrorCode::kMalformed, "table about: {}", valid.error().message);
  }
  return options;
}

}  // namespace nadir
