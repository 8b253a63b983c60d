// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/run/localise_flight.h"
#include "core/sim/camera_renderer.h"
#include "tests/core/sim/street_map.h"
#include "tests/support/scenery.h"

namespace nadir {

inline constexpr int kFrames = 24;

/// Where the body is at a time.
inline Rigid3 pose_at(double time_s) {
  const Rigid3 camera_pose = camera_over(10.0 + 2.0 * time_s, 28.0, 0.0, 2.0, 3.0);
  return camera_pose * Rigid3{forward_body_from_camera(), Eigen::Vector3d::Zero()}.inverse();
}

inline Trajectory straight_line(double end_s) {
  std::vector<TimedPose> poses;
  for (double time_s = 0.0; time_s <= end_s + 1e-9; time_s += 0.25)
    poses.push_back({time_s, pose_at(time_s)});
  return Trajectory::create(std::move(poses), "line").value();
}

/// Frames that are rendered when they are asked for: a straight drive along a street.
class RenderedFlight : public FlightRecording {
 public:
  explicit RenderedFlight(FlightDescription description)
      : FlightRecording(std::move(description)), world_(raise_world(street_map(0.2), {}, 1)) {}
  [[nodiscard]] Result<SemanticFrame> load(std::size_t frame) const override {
    const double time_s = description().frames.at(frame).time_s;
    const Rigid3 enu_from_camera = pose_at(time_s) * description().body_from_camera;
    SemanticFrame result = render(world_, *description().camera, enu_from_camera, time_s, 20.0);
    result.time_s = time_s;
    return result;
  }

 private:
  World world_;
};

inline FlightDescription description_of_drive() {
  FlightDescription description;
  description.name = "drive";
  description.path = "drive-folder";
  description.camera = CameraModel::from_horizontal_view(160, 120, 1.05);
  description.body_from_camera = {forward_body_from_camera(), Eigen::Vector3d::Zero()};
  for (int i = 0; i < kFrames; ++i) {
    FlightFrame frame{0.25 * i, std::nullopt, std::filesystem::path("d"),
                      std::filesystem::path("l")};
    description.frames.push_back(frame);
  }
  description.odometry = straight_line(0.25 * kFrames);
  description.truth = description.odometry;
  return description;
}

/// What a run came to, with all its steps.
struct Outcome {
  Result<LocaliseSummary> summary;
  std::vector<RunStep> steps;
};

inline Outcome localise(const FlightDescription& description,
                        const LocaliseRequest& request = {},
                        const WorkContext& context = {}) {
  static const auto index = index_of(street_map(0.2));
  Outcome outcome;
  outcome.summary = localise_flight(
      RenderedFlight(description), index, request,
      [&](const RunStep& step) {
        outcome.steps.push_back(step);
        return Result<void>();
      },
      context);
  return outcome;
}

inline std::string fault(const Outcome& outcome) {
  return outcome.summary ? "none" : outcome.summary.error().message;
}

}  // namespace nadir
