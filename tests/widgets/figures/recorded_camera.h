// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <numbers>
#include <stdexcept>

#include "core/flight/flight_writer.h"
#include "core/map/overhead_map.h"

namespace nadir {

inline constexpr double kStreetCameraHeightM = 2.0;

inline CameraModel street_camera() {
  return CameraModel::from_horizontal_view(96, 72, std::numbers::pi / 3.0);
}

/// What a camera that looks along the heading sees of a flat map, up to 40 m: exact classes and depths, sky above.
inline SemanticFrame seen_on(const OverheadMap& map, const Rigid2& enu_from_body, double time_s) {
  constexpr double kFarthestM = 40.0;
  const CameraModel camera = street_camera();
  SemanticFrame frame{time_s, Raster<ClassId>(camera.width, camera.height, kSky),
                      Raster<float>(camera.width, camera.height, 0.0F)};
  for (int row = 0; row < camera.height; ++row) {
    for (int column = 0; column < camera.width; ++column) {
      const Eigen::Vector3d ray = camera.ray({column + 0.5, row + 0.5});
      const double depth_m = kStreetCameraHeightM / ray.y();
      if (!(depth_m > 0.0 && depth_m < kFarthestM)) continue;
      const Eigen::Vector2d on_ground =
          enu_from_body * Eigen::Vector2d(depth_m, -depth_m * ray.x());
      frame.labels.at(column, row) = map.class_at(on_ground);
      frame.depth_m.at(column, row) = static_cast<float>(depth_m);
    }
  }
  return frame;
}

/// A flight whose frames are at the times and true poses of street_step(): east along the street, 1 m and half a second each.
inline void write_street_flight(const OverheadMap& map,
                                const std::filesystem::path& folder,
                                int frames) {
  FlightDescription description;
  description.name = "drive";
  description.camera = street_camera();
  description.body_from_camera = {forward_body_from_camera(), Eigen::Vector3d::Zero()};
  description.altitude_m = kStreetCameraHeightM;
  const auto check = [](const auto& result) {
    if (!result) throw std::runtime_error(result.error().message);
  };
  auto writer = FlightWriter::create(folder, description, "Made for a test");
  check(writer);
  std::vector<TimedPose> odometry;
  for (int i = 0; i < frames; ++i) {
    const double time_s = 100.0 + 0.5 * i;
    const auto frame = encode_frame(seen_on(map, {10.0 + i, 20.0, 0.0}, time_s));
    check(frame);
    check(writer->write(*frame));
    odometry.push_back({time_s, {Eigen::Quaterniond::Identity(), {1.0 * i, 0.1 * i, 0.0}}});
  }
  const auto trajectory = Trajectory::create(odometry, "odometry");
  check(trajectory);
  check(writer->finish(*trajectory, std::nullopt));
}

}  // namespace nadir
