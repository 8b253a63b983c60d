// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <system_error>

#include "core/base/hash.h"
#include "core/base/version.h"
#include "core/mcl/option_effects.h"
#include "core/run/localise_flight.h"
#include "core/run/run_prior.h"

namespace nadir {
namespace {

void add_pose(Hash& hash, const Rigid3& pose) {
  hash.add(pose.translation_m.data(), 3 * sizeof(double));
  hash.add(pose.rotation.coeffs().data(), 4 * sizeof(double));
}

/// The start as text, so that the run can be made again.
std::string start_text(const LocaliseRequest& request) {
  if (const auto& resumed = request.resume_after) {
    return fmt::format("{} {} of {}", kGoesOnPrior, resumed->after.step, resumed->run);
  }
  return prior_text(request.prior);
}

}  // namespace

std::string flight_hash(const FlightDescription& flight) {
  Hash hash;
  if (flight.camera) {
    const CameraModel& camera = *flight.camera;
    hash.add_number(camera.width).add_number(camera.height);
    hash.add_number(camera.focal_x_px).add_number(camera.focal_y_px);
    hash.add_number(camera.centre_x_px).add_number(camera.centre_y_px);
  }
  add_pose(hash, flight.body_from_camera);
  for (const FlightFrame& frame : flight.frames) {
    hash.add_number(frame.time_s);
    for (const auto& file : {frame.labels, frame.depth}) {
      std::error_code missing;
      if (!file) continue;
      hash.add(file->filename().string()).add_number(std::filesystem::file_size(*file, missing));
    }
  }
  for (const auto* trajectory : {&flight.odometry, &flight.truth}) {
    if (!*trajectory) continue;
    for (const TimedPose& timed : (*trajectory)->poses()) {
      hash.add_number(timed.time_s);
      add_pose(hash, timed.pose);
    }
  }
  return hash.text();
}

RunHeader run_header(const FlightRecording& flight,
                     const OverheadMap& map,
                     const std::string& map_path,
                     const std::string& preset,
                     const LocaliseRequest& request) {
  const FlightDescription& description = flight.description();
  RunHeader header;
  header.program_version = kVersion;
  header.flight = description.name;
  header.flight_path = description.path.string();
  header.map = map.name;
  header.map_path = map_path;
  header.preset = preset;
  header.seed = request.options.localiser.seed;
  header.plane_latitude_deg = map.plane.origin().latitude_deg;
  header.plane_longitude_deg = map.plane.origin().longitude_deg;
  header.map_hash = content_hash(map);
  header.flight_hash = flight_hash(description);
  for (const OptionText& option : option_texts(request.options)) {
    header.options[option.name] = option.value;
  }
  header.options[kPriorOption] = start_text(request);
  if (request.resume_after) {
    header.parent_run = request.resume_after->run;
    header.started_at_s = request.resume_after->after.time_s;
  }
  if (request.most_frames) header.options["frames"] = std::to_string(*request.most_frames);
  return header;
}

}  // namespace nadir
