// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/geo/project_plane.h"
#include "core/geo/rigid3.h"
#include "core/geo/trajectory.h"
#include "core/topview/camera_model.h"

/// The texts of a KITTI raw drive (Geiger et al., "Vision meets robotics: the KITTI dataset", IJRR
/// 2013) and what is made of them. All pure functions; `name` stands for the file in messages.
/// Private to core/flight.
namespace nadir {

/// `2011-09-26 13:04:32.345808896` a line, as seconds since 1970 (the drive's clock is taken for
/// UTC). Lines may not be empty.
/// @errors kMalformed (file, line and fault).
[[nodiscard]] Result<std::vector<double>> parse_kitti_timestamps(std::string_view text,
                                                                 const std::string& name);

/// One GPS/IMU packet: what we use of its thirty numbers.
struct OxtsPacket {
  double time_s = 0.0;  ///< From timestamps.txt; parse_oxts_packet() leaves it 0.
  Geodetic position;
  double altitude_m = 0.0;
  Attitude attitude;  ///< Yaw 0 = true east, counter-clockwise.
  Eigen::Vector3d
      speed_in_level_mps;  ///< Forward, left, up; forward and left are parallel to the ground.
  double turn_rate_radps = 0.0;  ///< Counter-clockwise around the upward axis.
};
/// @errors kMalformed: fewer than 23 numbers, or one that is not finite.
[[nodiscard]] Result<OxtsPacket> parse_oxts_packet(std::string_view text, const std::string& name);

/// enu_from_body in the plane at the first packet's position; height above the first packet.
/// @errors kMalformed: times that go back or repeat, positions at the pole.
[[nodiscard]] Result<Trajectory> truth_from_oxts(const std::vector<OxtsPacket>& packets,
                                                 const std::string& name);
/// odom_from_body from speeds and turn rate alone (trapezoids), starting at the origin with yaw 0;
/// roll and pitch as measured. A stretch without packets is bridged with the speeds at its ends.
/// @errors as above.
[[nodiscard]] Result<Trajectory> odometry_from_oxts(const std::vector<OxtsPacket>& packets,
                                                    const std::string& name);

/// `KEY: number number ...` a line; lines whose values are not numbers (calib_time) are passed
/// over.
using KittiCalibration = std::map<std::string, std::vector<double>, std::less<>>;
[[nodiscard]] KittiCalibration parse_kitti_calibration(std::string_view text);

struct CameraMount {
  CameraModel camera;
  Rigid3 body_from_camera;
};
/// The rectified left colour camera (image_02) on the GPS/IMU unit.
/// P_rect_02 has pixel centres at whole numbers, CameraModel at +0.5: the half pixel is added here.
/// @param folder_name  stands for the folder of the three files in messages.
/// @errors kMalformed: a key is missing or has another number of values, a matrix that is no
/// rotation.
[[nodiscard]] Result<CameraMount> camera_from_kitti(const KittiCalibration& cam_to_cam,
                                                    const KittiCalibration& velo_to_cam,
                                                    const KittiCalibration& imu_to_velo,
                                                    const std::string& folder_name);

}  // namespace nadir
