// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/run/localise_flight.h"
#include "core/sim/camera_renderer.h"
#include "tests/core/sim/street_map.h"

namespace nadir {

/// A drive east along y = 30 m at 2 m/s, 4 frames a second, whose frames are rendered from a map when they are asked for. Its odometry
/// says that it went `odometry_scale` times as far.
class DrivenFlight : public FlightRecording {
 public:
  DrivenFlight(const OverheadMap& map, int frames, double odometry_scale)
      : FlightRecording(describe(map, frames, odometry_scale)),
        world_(raise_world(map, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 1)) {}

  [[nodiscard]] Result<SemanticFrame> load(std::size_t frame) const override {
    const double time_s = description().frames.at(frame).time_s;
    const Rigid3 enu_from_camera = pose(time_s, 1.0) * description().body_from_camera;
    SemanticFrame result = render(world_, *description().camera, enu_from_camera, time_s, 20.0);
    result.time_s = time_s;
    return result;
  }

 private:
  static Rigid3 pose(double time_s, double scale) {
    return {Eigen::Quaterniond::Identity(), {12.0 + scale * 2.0 * time_s, 30.0, 2.0}};
  }
  static FlightDescription describe(const OverheadMap& map, int frames, double odometry_scale) {
    FlightDescription description;
    description.name = "drive";
    description.path = "drive-folder";
    description.camera = CameraModel::from_horizontal_view(160, 120, 1.05);
    description.body_from_camera = {forward_body_from_camera(), Eigen::Vector3d::Zero()};
    description.truth_origin = map.plane.origin();
    std::vector<TimedPose> truth;
    std::vector<TimedPose> odometry;
    for (int i = 0; i < frames; ++i) {
      const double time_s = 0.25 * i;
      description.frames.push_back(
          {time_s, std::nullopt, std::filesystem::path("d"), std::filesystem::path("l")});
      truth.push_back({time_s, pose(time_s, 1.0)});
      odometry.push_back({time_s, pose(time_s, odometry_scale)});
    }
    description.truth = Trajectory::create(std::move(truth), "truth").value();
    description.odometry = Trajectory::create(std::move(odometry), "odometry").value();
    return description;
  }

  World world_;
};

/// Options with which a run is made in a moment.
[[nodiscard]] inline RunOptions quick_options() {
  RunOptions options;
  options.localiser.particle_count = 600;
  options.localiser.min_particle_count = 600;
  options.localiser.max_cells_per_class = 60;
  return options;
}

/// Records a run of a flight as the program does; throws where that fails.
inline void record_drive(const FlightRecording& flight,
                         const std::shared_ptr<const MapIndex>& map,
                         const RunOptions& options,
                         const std::filesystem::path& file) {
  LocaliseRequest request;
  request.options = options;
  auto writer = RunWriter::create(file, run_header(flight, map->map(), "map", "default", request));
  if (!writer) throw std::runtime_error(writer.error().message);
  const auto done = localise_flight(flight, map, request,
                                    [&](const RunStep& step) { return writer->write(step); });
  if (!done) throw std::runtime_error(done.error().message);
  if (const auto finished = writer->finish(); !finished) {
    throw std::runtime_error(finished.error().message);
  }
}

/// 80 x 60 m: a road from west to east with bars across it that never repeat, grass on both sides, a copse far from everything.
inline OverheadMap barred_road(double metres_per_cell = 0.2) {
  OverheadMap map = street_map(metres_per_cell);
  for (int row = 0; row < map.labels.height(); ++row) {
    for (int column = 0; column < map.labels.width(); ++column) {
      const Eigen::Vector2d place = map.enu_from_overhead({column + 0.5, row + 0.5});
      ClassId& label = map.labels.at(column, row);
      label = std::abs(place.y() - 30.0) < 4.0 ? kRoad : kTerrain;
      if (place.y() > 57.0) label = kVegetation;
      for (const double bar_m : {17.0, 19.4, 24.0, 27.0, 33.5, 35.1, 41.0, 44.0, 49.5}) {
        if (label == kRoad && std::abs(place.x() - bar_m) < 0.3) label = kLaneMarking;
      }
    }
  }
  return map;
}

}  // namespace nadir
