// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "core/flight/flight_recording.h"

/// One reader a format. Each is told by what is in the folder; open_flight() asks them in the order
/// below.
namespace nadir {

using FlightResult = Result<std::unique_ptr<FlightRecording>>;

/// Last part of a folder's path, also where it ends in a slash or is ".".
[[nodiscard]] std::string folder_name(const std::filesystem::path& folder);

/// Nadir's own: a folder with flight.toml (core/flight/README.md).
[[nodiscard]] bool is_native_flight(const std::filesystem::path& folder);
[[nodiscard]] FlightResult open_native_flight(const std::filesystem::path& folder);

/// A KITTI raw drive: a folder with image_02/ or oxts/ and the calibration in it or in the folder
/// above. Truth is the path of the GPS/IMU in the plane at its first packet. Odometry is its own
/// speeds and turn rate, integrated: never its positions, so that it drifts as odometry does.
/// `body` is the GPS/IMU unit.
[[nodiscard]] bool is_kitti_raw_flight(const std::filesystem::path& folder);
[[nodiscard]] FlightResult open_kitti_raw_flight(const std::filesystem::path& folder);

/// KITTI odometry: a folder with times.txt and poses*.txt. poses_gt.txt, or the only one, is the
/// truth; the first other one by name is the odometry. `enu` is the frame of the first pose: no
/// north is known.
[[nodiscard]] bool is_kitti_odometry_flight(const std::filesystem::path& folder);
[[nodiscard]] FlightResult open_kitti_odometry_flight(const std::filesystem::path& folder);

/// A trajectory alone, TUM (8 numbers a line) or KITTI (12, with times.txt beside it), taken as
/// odometry.
[[nodiscard]] bool is_trajectory_file(const std::filesystem::path& file);
[[nodiscard]] FlightResult open_trajectory_flight(const std::filesystem::path& file);

/// A recording whose format has no labels: load() is always kUnsupported.
class UnlabelledFlight final : public FlightRecording {
 public:
  explicit UnlabelledFlight(FlightDescription description)
      : FlightRecording(std::move(description)) {}
  [[nodiscard]] Result<SemanticFrame> load(std::size_t frame) const override;
};

}  // namespace nadir
