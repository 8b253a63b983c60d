// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/base/progress.h"
#include "core/flight/flight_recording.h"
#include "core/map/map_index.h"
#include "core/mcl/prior.h"
#include "core/run/resume_point.h"
#include "core/run/run_file.h"
#include "core/run/run_options.h"

namespace nadir {

/// What to run on a flight.
struct LocaliseRequest {
  RunOptions options;
  /// Where the body starts; without one, the truth of the first frame with the thesis's spread.
  std::optional<Prior> prior;
  /// Go on from a moment of an earlier run instead; then there must be no prior. See core/run/resume_point.h.
  std::optional<ResumePoint> resume_after;
  bool record_particles = true;
  bool record_topviews = true;
  std::optional<std::size_t>
      most_frames;  ///< Stop after so many frames, counted from where this run begins.
};

/// What became of the frames.
struct LocaliseSummary {
  int steps = 0;               ///< Updates done.
  int frames_passed_over = 0;  ///< Came sooner than min_update_interval_s.
  int frames_without_odometry = 0;
  int steps_without_evidence = 0;  ///< The topview held nothing that the map could answer.
};

/// Runs the filter over a flight, frame by frame, and hands each step to `record` as it is done.
///
/// Reads one frame ahead in a thread of its own; memory does not grow with the length of the
/// flight. The truth only sets the prior where none is given, and goes into the steps for later
/// evaluation.
///
/// A run that resumes hands out only its new steps, the first one after the resume point; RunWriter::copy_steps() puts those
/// before it into the file.
/// @errors kUnsupported (no odometry, no camera), kInvalidOptions (options; no prior and no truth;
/// a start off the map; a resume point without particles, of another flight or another plane, or behind the last frame),
///         kMalformed (a frame), kCancelled, and whatever `record` returns.
[[nodiscard]] Result<LocaliseSummary> localise_flight(
    const FlightRecording& flight,
    const std::shared_ptr<const MapIndex>& map,
    const LocaliseRequest& request,
    const std::function<Result<void>(const RunStep&)>& record,
    const WorkContext& context = {});

/// Hexadecimal, of everything about a flight but its pixels, for which names and sizes of their files stand: tells whether a
/// flight is still the one that a run was made on.
[[nodiscard]] std::string flight_hash(const FlightDescription& flight);

/// Header of a run file for this request.
[[nodiscard]] RunHeader run_header(const FlightRecording& flight,
                                   const OverheadMap& map,
                                   const std::string& map_path,
                                   const std::string& preset,
                                   const LocaliseRequest& request);

/// The truth of a flight in the map's project plane, where the flight knows in which plane it was given; nothing where
/// it has none. @errors kInvalidOptions, kMalformed: an origin that is no place on Earth.
[[nodiscard]] Result<std::optional<Trajectory>> truth_in_plane(const FlightDescription& flight,
                                                               const ProjectPlane& plane);

}  // namespace nadir
