// SPDX-License-Identifier: Apache-2.0
#include "core/flight/kitti_raw_text.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <chrono>
#include <optional>

#include "core/base/angle.h"
#include "core/base/require.h"
#include "core/flight/text_fields.h"

namespace nadir {
namespace {

/// Seconds since 1970 of `2011-09-26 13:04:32.345808896`.
std::optional<double> parse_moment(std::string_view text) {
  const auto words = flight_text::words_of(text);
  if (words.size() != 2 || words[0].size() != 10 || words[1].size() < 8) return {};
  const auto number = [](std::string_view word, std::size_t at, std::size_t length) {
    return flight_text::whole_number(word.substr(at, length)).value_or(-1);
  };
  if (words[0][4] != '-' || words[0][7] != '-' || words[1][2] != ':' || words[1][5] != ':') {
    return {};
  }
  const std::chrono::year_month_day day(
      std::chrono::year(number(words[0], 0, 4)),
      std::chrono::month(static_cast<unsigned>(number(words[0], 5, 2))),
      std::chrono::day(static_cast<unsigned>(number(words[0], 8, 2))));
  const int hour = number(words[1], 0, 2);
  const int minute = number(words[1], 3, 2);
  const auto second = flight_text::finite_number(words[1].substr(6));
  const bool is_time = hour >= 0 && hour < 24 && minute >= 0 && minute < 60 && second &&
                       *second >= 0.0 && *second <= 60.0;
  if (!is_time || number(words[0], 0, 4) < 0 || !day.ok()) return {};
  const auto days = std::chrono::sys_days(day).time_since_epoch().count();
  return static_cast<double>(days) * 86400.0 + hour * 3600.0 + minute * 60.0 + *second;
}

Result<std::vector<double>> values_of(const KittiCalibration& calibration,
                                      std::string_view key,
                                      std::size_t count,
                                      const std::string& file) {
  const auto found = calibration.find(key);
  if (found == calibration.end()) {
    return fail(ErrorCode::kMalformed, "{}: {} is missing", file, key);
  }
  if (found->second.size() != count) {
    return fail(ErrorCode::kMalformed, "{}: {} has {} numbers, not {}", file, key,
                found->second.size(), count);
  }
  return found->second;
}

/// Rotation from nine numbers row by row; calibrations have about seven digits, hence the
/// tolerance.
Result<Eigen::Quaterniond> rotation_from(const std::vector<double>& rows, const std::string& what) {
  const Eigen::Matrix3d matrix =
      Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rows.data());
  const double error = (matrix * matrix.transpose() - Eigen::Matrix3d::Identity()).norm();
  if (!(error < 1e-3) || !(matrix.determinant() > 0.0)) {
    return fail(ErrorCode::kMalformed, "{} is not a rotation", what);
  }
  return Eigen::Quaterniond(matrix).normalized();
}

Result<Rigid3> motion_of(const KittiCalibration& calibration, const std::string& file) {
  const auto rows = values_of(calibration, "R", 9, file);
  if (!rows) return forward_error(rows);
  const auto offset = values_of(calibration, "T", 3, file);
  if (!offset) return forward_error(offset);
  const auto rotation = rotation_from(*rows, file + ": R");
  if (!rotation) return forward_error(rotation);
  return Rigid3{*rotation, {(*offset)[0], (*offset)[1], (*offset)[2]}};
}

}  // namespace

Result<std::vector<double>> parse_kitti_timestamps(std::string_view text, const std::string& name) {
  std::vector<double> times_s;
  for (const std::string_view line : flight_text::lines_of(text)) {
    const auto time_s = parse_moment(line);
    if (!time_s) {
      return fail(ErrorCode::kMalformed,
                  "{}: line {}: '{}' is not a date and time (2011-09-26 13:02:25.594360375)", name,
                  times_s.size() + 1, line.substr(0, 40));
    }
    times_s.push_back(*time_s);
  }
  return times_s;
}

Result<OxtsPacket> parse_oxts_packet(std::string_view text, const std::string& name) {
  // Columns as in dataformat.txt: lat lon alt roll pitch yaw vn ve vf vl vu ... wu is the 23rd.
  std::array<double, 23> columns{};
  const auto words = flight_text::words_of(text);
  if (words.size() < columns.size()) {
    return fail(ErrorCode::kMalformed, "{}: has {} numbers, fewer than {}", name, words.size(),
                columns.size());
  }
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto number = flight_text::finite_number(words[i]);
    if (!number) {
      return fail(ErrorCode::kMalformed, "{}: number {} is '{}', not a finite number", name, i + 1,
                  words[i].substr(0, 40));
    }
    columns[i] = *number;
  }
  OxtsPacket packet;
  packet.position = {columns[0], columns[1]};
  packet.altitude_m = columns[2];
  packet.attitude = {columns[3], columns[4], columns[5]};
  packet.speed_in_level_mps = {columns[8], columns[9], columns[10]};
  packet.turn_rate_radps = columns[22];
  return packet;
}

Result<Trajectory> truth_from_oxts(const std::vector<OxtsPacket>& packets,
                                   const std::string& name) {
  NADIR_REQUIRE(!packets.empty());
  const auto plane = ProjectPlane::create(packets.front().position);
  if (!plane) return forward_error(plane, name);
  std::vector<TimedPose> poses;
  poses.reserve(packets.size());
  for (const OxtsPacket& packet : packets) {
    const Eigen::Vector2d position = plane->enu_from_geodetic(packet.position);
    const double height_m = packet.altitude_m - packets.front().altitude_m;
    // Grid north lies `convergence` counter-clockwise of true north, and so does grid east of true
    // east.
    Attitude attitude = packet.attitude;
    attitude.yaw_rad -= Angle::degrees(plane->convergence_deg(position)).radians();
    poses.push_back(
        {packet.time_s, Rigid3{rotation_of(attitude), {position.x(), position.y(), height_m}}});
  }
  return Trajectory::create(std::move(poses), name);
}

Result<Trajectory> odometry_from_oxts(const std::vector<OxtsPacket>& packets,
                                      const std::string& name) {
  NADIR_REQUIRE(!packets.empty());
  std::vector<TimedPose> poses;
  poses.reserve(packets.size());
  Eigen::Vector3d position_in_odom_m = Eigen::Vector3d::Zero();
  double yaw_rad = 0.0;
  for (std::size_t i = 0; i < packets.size(); ++i) {
    if (i > 0) {
      const OxtsPacket& before = packets[i - 1];
      const OxtsPacket& after = packets[i];
      const double elapsed_s = after.time_s - before.time_s;
      const double turn_rad = 0.5 * (before.turn_rate_radps + after.turn_rate_radps) * elapsed_s;
      const Eigen::AngleAxisd heading(yaw_rad + 0.5 * turn_rad, Eigen::Vector3d::UnitZ());
      const Eigen::Vector3d speed_mps =
          0.5 * (before.speed_in_level_mps + after.speed_in_level_mps);
      position_in_odom_m += heading * (speed_mps * elapsed_s);
      yaw_rad = wrap_rad(yaw_rad + turn_rad);
    }
    Attitude attitude = packets[i].attitude;
    attitude.yaw_rad = yaw_rad;
    poses.push_back({packets[i].time_s, Rigid3{rotation_of(attitude), position_in_odom_m}});
  }
  return Trajectory::create(std::move(poses), name);
}

KittiCalibration parse_kitti_calibration(std::string_view text) {
  KittiCalibration calibration;
  for (const std::string_view line : flight_text::lines_of(text)) {
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos) continue;
    std::vector<double> values;
    const auto words = flight_text::words_of(line.substr(colon + 1));
    for (const std::string_view word : words) {
      if (const auto value = flight_text::finite_number(word)) values.push_back(*value);
    }
    if (values.empty() || values.size() != words.size()) continue;
    calibration[std::string(flight_text::trimmed(line.substr(0, colon)))] = std::move(values);
  }
  return calibration;
}

Result<CameraMount> camera_from_kitti(const KittiCalibration& cam_to_cam,
                                      const KittiCalibration& velo_to_cam,
                                      const KittiCalibration& imu_to_velo,
                                      const std::string& folder_name) {
  const std::string file = folder_name + "/calib_cam_to_cam.txt";
  const auto size = values_of(cam_to_cam, "S_rect_02", 2, file);
  if (!size) return forward_error(size);
  const auto projection = values_of(cam_to_cam, "P_rect_02", 12, file);
  if (!projection) return forward_error(projection);
  const auto rows = values_of(cam_to_cam, "R_rect_00", 9, file);
  if (!rows) return forward_error(rows);
  const auto rectified_from_camera0 = rotation_from(*rows, file + ": R_rect_00");
  if (!rectified_from_camera0) return forward_error(rectified_from_camera0);
  const auto camera0_from_velodyne = motion_of(velo_to_cam, folder_name + "/calib_velo_to_cam.txt");
  if (!camera0_from_velodyne) return forward_error(camera0_from_velodyne);
  const auto velodyne_from_body = motion_of(imu_to_velo, folder_name + "/calib_imu_to_velo.txt");
  if (!velodyne_from_body) return forward_error(velodyne_from_body);

  const std::vector<double>& p = *projection;
  const auto pixels = [](double number) {
    return number >= 1.0 && number <= 1e6 ? static_cast<int>(number) : 0;
  };
  CameraMount mount;
  mount.camera = {pixels((*size)[0]), pixels((*size)[1]), p[0], p[5], p[2] + 0.5, p[6] + 0.5};
  if (const auto valid = validate(mount.camera); !valid) return forward_error(valid, file);
  // P = K [I | t]: camera 2 stands t away from the rectified camera 0.
  const Eigen::Vector3d camera_from_rectified_m((p[3] - p[2] * p[11]) / p[0],
                                                (p[7] - p[6] * p[11]) / p[5], p[11]);
  const Rigid3 camera_from_rectified{Eigen::Quaterniond::Identity(), camera_from_rectified_m};
  const Rigid3 rectification{*rectified_from_camera0, Eigen::Vector3d::Zero()};
  const Rigid3 camera_from_body =
      camera_from_rectified * rectification * *camera0_from_velodyne * *velodyne_from_body;
  mount.body_from_camera = camera_from_body.inverse();
  return mount;
}

}  // namespace nadir
