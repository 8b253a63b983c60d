// SPDX-License-Identifier: Apache-2.0
#include "core/geo/trajectory_file.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <cmath>
#include <iterator>
#include <optional>

#include "core/base/staged_output.h"
#include "core/geo/number_lines.h"

namespace nadir {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kTumColumns = 8;
constexpr std::size_t kKittiColumns = 12;

/// How far a recorded rotation may be from a rotation: files have as few as three digits.
constexpr double kRotationTolerance = 1e-2;

/// The rotation nearest to a matrix that almost is one, or nothing where it is farther off than
/// that.
std::optional<Eigen::Quaterniond> nearest_rotation(const Eigen::Matrix3d& recorded) {
  const Eigen::Matrix3d excess = recorded.transpose() * recorded - Eigen::Matrix3d::Identity();
  // Negated, so that an overflow to infinity or NaN is refused too.
  if (!(excess.cwiseAbs().maxCoeff() <= kRotationTolerance) ||
      !(std::abs(recorded.determinant() - 1.0) <= kRotationTolerance)) {
    return std::nullopt;
  }
  // Newton's iteration for the polar decomposition squares the error: 1e-2, 5e-5, 1e-9, below
  // 1e-16.
  constexpr int kIterations = 4;
  Eigen::Matrix3d rotation = recorded;
  for (int i = 0; i < kIterations; ++i) {
    const Eigen::Matrix3d inverse = rotation.inverse();
    rotation = 0.5 * (rotation + inverse.transpose());
  }
  return Eigen::Quaterniond(rotation).normalized();
}

/// Unit quaternions stay as they are to the last bit, so that a file written and read again holds
/// the same numbers.
std::optional<Eigen::Quaterniond> nearest_unit(const Eigen::Quaterniond& recorded) {
  constexpr double kRounding = 1e-14;
  const double excess = recorded.norm() - 1.0;
  if (!(std::abs(excess) <= kRotationTolerance)) return std::nullopt;
  return std::abs(excess) <= kRounding ? recorded : recorded.normalized();
}

Result<Rigid3> tum_pose(std::span<const double> values, const std::string& where) {
  const Eigen::Quaterniond recorded(values[7], values[4], values[5], values[6]);
  const auto rotation = nearest_unit(recorded);
  if (!rotation) {
    return fail(ErrorCode::kMalformed, "{}: the quaternion ({}, {}, {}, {}) is not of unit length",
                where, values[4], values[5], values[6], values[7]);
  }
  return Rigid3{*rotation, {values[1], values[2], values[3]}};
}

/// Twelve numbers of a camera pose turned into `world_from_body` with z up in both frames.
Result<Rigid3> kitti_pose(std::span<const double> values, const std::string& where) {
  const Eigen::Matrix<double, 3, 4, Eigen::RowMajor> matrix =
      Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(values.data());
  const auto rotation = nearest_rotation(matrix.leftCols<3>());
  if (!rotation) {
    return fail(ErrorCode::kMalformed, "{}: the first three columns of the pose are not a rotation",
                where);
  }
  const Rigid3 start_camera_from_camera{*rotation, matrix.col(3)};
  const Rigid3 body_from_camera{forward_body_from_camera(), Eigen::Vector3d::Zero()};
  return body_from_camera * start_camera_from_camera * body_from_camera.inverse();
}

Result<void> check_columns(const NumberLine& line,
                           std::size_t expected,
                           std::string_view kind,
                           const std::string& where) {
  if (line.values.size() == expected) return {};
  return fail(ErrorCode::kMalformed, "{}: has {} numbers, but a {} has {}", where,
              line.values.size(), kind, expected);
}

Result<void> check_order(double time_s,
                         std::optional<double> previous_s,
                         const std::string& where) {
  if (!previous_s || *previous_s < time_s) return {};
  return fail(ErrorCode::kMalformed, "{}: time {} does not come after {}", where, time_s,
              *previous_s);
}

Result<Trajectory> read_kitti_trajectory(std::string_view text,
                                         const fs::path& path,
                                         const fs::path& given_times) {
  const fs::path times_path = given_times.empty() ? path.parent_path() / "times.txt" : given_times;
  std::error_code error;
  if (given_times.empty() && !fs::exists(times_path, error)) {
    return fail(ErrorCode::kNotFound,
                "{}: holds KITTI poses, which have no times, and there is no {}", path.string(),
                times_path.string());
  }
  const auto times_text = read_text_file(times_path);
  if (!times_text) return forward_error(times_text);
  const auto times_s = parse_times(*times_text, times_path.string());
  if (!times_s) return forward_error(times_s);
  return parse_kitti_trajectory(text, *times_s, path.string());
}

}  // namespace

Result<Trajectory> parse_tum_trajectory(std::string_view text, const std::string& name) {
  NumberLines lines(text, name);
  std::vector<TimedPose> poses;
  std::optional<double> previous_s;
  while (true) {
    const auto line = lines.next();
    if (!line) return forward_error(line);
    if (!line->has_value()) break;
    const std::string where = lines.where((*line)->line);
    if (const auto columns = check_columns(**line, kTumColumns, "TUM pose", where); !columns) {
      return forward_error(columns);
    }
    const double time_s = (*line)->values[0];
    if (const auto order = check_order(time_s, previous_s, where); !order) {
      return forward_error(order);
    }
    previous_s = time_s;
    const auto pose = tum_pose((*line)->values, where);
    if (!pose) return forward_error(pose);
    poses.push_back({time_s, *pose});
  }
  if (poses.empty()) return fail(ErrorCode::kMalformed, "{}: holds no poses", name);
  return Trajectory::create(std::move(poses), name);
}

Result<Trajectory> parse_kitti_trajectory(std::string_view text,
                                          const std::vector<double>& times_s,
                                          const std::string& name) {
  NumberLines lines(text, name);
  std::vector<TimedPose> poses;
  while (true) {
    const auto line = lines.next();
    if (!line) return forward_error(line);
    if (!line->has_value()) break;
    const std::string where = lines.where((*line)->line);
    if (const auto columns = check_columns(**line, kKittiColumns, "KITTI pose", where); !columns) {
      return forward_error(columns);
    }
    const auto pose = kitti_pose((*line)->values, where);
    if (!pose) return forward_error(pose);
    const std::size_t i = poses.size();
    poses.push_back({i < times_s.size() ? times_s[i] : 0.0, *pose});
  }
  if (poses.empty()) return fail(ErrorCode::kMalformed, "{}: holds no poses", name);
  if (poses.size() != times_s.size()) {
    return fail(ErrorCode::kMalformed, "{}: holds {} poses, but there are {} times", name,
                poses.size(), times_s.size());
  }
  return Trajectory::create(std::move(poses), name);
}

Result<std::vector<double>> parse_times(std::string_view text, const std::string& name) {
  NumberLines lines(text, name);
  std::vector<double> times_s;
  std::optional<double> previous_s;
  while (true) {
    const auto line = lines.next();
    if (!line) return forward_error(line);
    if (!line->has_value()) break;
    const std::string where = lines.where((*line)->line);
    if (const auto columns = check_columns(**line, 1, "line of times", where); !columns) {
      return forward_error(columns);
    }
    const double time_s = (*line)->values[0];
    if (const auto order = check_order(time_s, previous_s, where); !order) {
      return forward_error(order);
    }
    previous_s = time_s;
    times_s.push_back(time_s);
  }
  if (times_s.empty()) return fail(ErrorCode::kMalformed, "{}: holds no times", name);
  return times_s;
}

Result<Trajectory> read_trajectory(const fs::path& path, const fs::path& kitti_times) {
  const auto text = read_text_file(path);
  if (!text) return forward_error(text);
  NumberLines lines(*text, path.string());
  const auto first = lines.next();
  if (!first) return forward_error(first);
  if (!first->has_value()) {
    return fail(ErrorCode::kMalformed, "{}: holds no poses", path.string());
  }
  const std::size_t columns = (*first)->values.size();
  if (columns == kTumColumns) return parse_tum_trajectory(*text, path.string());
  if (columns == kKittiColumns) return read_kitti_trajectory(*text, path, kitti_times);
  return fail(ErrorCode::kUnsupported,
              "{}: has {} numbers, but a TUM pose has {} and a KITTI pose has {}",
              lines.where((*first)->line), columns, kTumColumns, kKittiColumns);
}

std::string tum_text(const Trajectory& trajectory, std::string_view comment) {
  std::string text;
  while (!comment.empty()) {
    const std::size_t end = comment.find('\n');
    fmt::format_to(std::back_inserter(text), "# {}\n", comment.substr(0, end));
    comment.remove_prefix(end == std::string_view::npos ? comment.size() : end + 1);
  }
  text += "# time_s x y z qx qy qz qw\n";
  for (const TimedPose& timed : trajectory.poses()) {
    const Eigen::Vector3d& at_m = timed.pose.translation_m;
    const Eigen::Quaterniond& q = timed.pose.rotation;
    // The shortest text that reads back as the same double.
    fmt::format_to(std::back_inserter(text), "{} {} {} {} {} {} {} {}\n", timed.time_s, at_m.x(),
                   at_m.y(), at_m.z(), q.x(), q.y(), q.z(), q.w());
  }
  return text;
}

}  // namespace nadir
