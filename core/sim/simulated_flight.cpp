// SPDX-License-Identifier: Apache-2.0
#include "core/sim/simulated_flight.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/parallel.h"
#include "core/flight/flight_writer.h"
#include "core/sim/camera_renderer.h"
#include "core/sim/depth_noise.h"
#include "core/sim/label_noise.h"
#include "core/sim/odometry_noise.h"
#include "core/sim/world_colours.h"

namespace nadir {
namespace {

constexpr std::size_t kFramesAtOnce = 8;

std::vector<TimedPose> frame_poses(const FlownPath& path) {
  if (!path.frame_rate_hz) return path.truth.poses();
  std::vector<TimedPose> poses;
  const double duration_s = path.truth.end_s() - path.truth.start_s();
  const auto count = static_cast<std::size_t>(std::floor(duration_s * *path.frame_rate_hz + 1e-9));
  for (std::size_t i = 0; i <= count; ++i) {
    const double time_s = path.truth.start_s() + static_cast<double>(i) / *path.frame_rate_hz;
    if (const auto pose = path.truth.at(time_s)) poses.push_back({time_s, *pose});
  }
  return poses;
}

/// Everything that makes a frame; a frame is a function of its number and pose.
class FrameMaker {
 public:
  FrameMaker(const OverheadMap& map,
             const CameraModel& camera,
             const Rigid3& body_from_camera,
             const SimulationOptions& options,
             const ColourRaster* picture)
      : world_(raise_world(map, options.world, options.seed)),
        label_noise_(options.seed),
        camera_(camera),
        body_from_camera_(body_from_camera),
        options_(options) {
    const LevelNoise level = level_noise(options.level);
    depth_noise_ = {level.inverse_depth_sigma, level.depth_range_m};
    if (options.has_colour) colours_.emplace(world_, picture, options.seed);
  }
  FrameMaker(const FrameMaker&) = delete;  // The colours refer to the world beside them.
  FrameMaker& operator=(const FrameMaker&) = delete;

  [[nodiscard]] Result<EncodedFrame> make(std::uint32_t number, const TimedPose& body) const {
    const Rigid3 enu_from_camera = body.pose * body_from_camera_;
    SurfaceView view =
        render_surfaces(world_, camera_, enu_from_camera, body.time_s, kFarthestLabelM);
    std::optional<ColourRaster> image;
    if (colours_) image = colours_->paint(view, camera_, enu_from_camera);
    SemanticFrame& frame = view.frame;
    if (options_.has_label_noise) {
      frame.labels = label_noise_.apply(frame, camera_, enu_from_camera, number);
    }
    frame.depth_m = measure_depth(frame.depth_m, depth_noise_, options_.seed, number);
    return encode_frame(frame, image);
  }

 private:
  World world_;
  std::optional<WorldColours> colours_;
  LabelNoise label_noise_;
  CameraModel camera_;
  Rigid3 body_from_camera_;
  SimulationOptions options_;
  DepthNoise depth_noise_;
};

Result<void> check_path(const OverheadMap& map, const FlownPath& path) {
  if (path.truth.empty()) {
    return fail(ErrorCode::kInvalidOptions, "{}: the path has no poses", path.name);
  }
  const Eigen::Vector2d start = path.truth.poses().front().pose.translation_m.head<2>();
  if (!map.contains(start)) {
    return fail(ErrorCode::kInvalidOptions,
                "{}: the path starts off the map {} at ({:.1f}, {:.1f}) m", path.name, map.name,
                start.x(), start.y());
  }
  if (!path.odometry) return {};
  if (path.odometry->empty() || path.odometry->start_s() > path.truth.end_s() ||
      path.odometry->end_s() < path.truth.start_s()) {
    return fail(ErrorCode::kInvalidOptions,
                "{}: odometry and true path share no time, are they of the same drive?", path.name);
  }
  return {};
}

Result<void> write_frames(const FrameMaker& maker,
                          const std::vector<TimedPose>& poses,
                          FlightWriter& writer,
                          const WorkContext& work) {
  for (std::size_t first = 0; first < poses.size(); first += kFramesAtOnce) {
    if (work.is_stopped()) return fail(ErrorCode::kCancelled, "the simulation was stopped");
    work.report(static_cast<double>(first) / static_cast<double>(poses.size()), "rendering frames");
    const std::size_t count = std::min(kFramesAtOnce, poses.size() - first);
    std::vector<Result<EncodedFrame>> frames(count);
    parallel_for(count, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        frames[i] = maker.make(static_cast<std::uint32_t>(first + i), poses[first + i]);
      }
    });
    for (const auto& frame : frames) {
      if (!frame) return forward_error(frame);
      if (auto written = writer.write(*frame); !written) return written;
    }
  }
  work.report(1.0, "rendering frames");
  return {};
}

}  // namespace

LevelNoise level_noise(SimulationLevel level) {
  switch (level) {
    case SimulationLevel::kEasy:
      return {7.78, 0.0582, 0.0, 20.0};
    case SimulationLevel::kMedium:
      return {73.2, 0.0576, 0.0, 20.0};
    case SimulationLevel::kHard:
      break;
  }
  return {73.37, 0.230, 0.05, 12.0};
}

Trajectory place_recorded_path(const Trajectory& recorded,
                               const std::optional<Rigid2>& start_in_enu,
                               double camera_height_m) {
  std::vector<TimedPose> poses = recorded.poses();
  if (poses.empty()) return {};
  const Rigid3 first = poses.front().pose;
  for (TimedPose& timed : poses) {
    if (start_in_enu) {
      const Rigid2 placed = *start_in_enu * (planar(first).inverse() * planar(timed.pose));
      Attitude attitude = attitude_of(first.rotation.conjugate() * timed.pose.rotation);
      attitude.yaw_rad = placed.yaw_rad;
      timed.pose.rotation = rotation_of(attitude);
      timed.pose.translation_m.head<2>() = placed.translation_m();
    }
    timed.pose.translation_m.z() = camera_height_m;
  }
  return Trajectory::create(std::move(poses), "placed path").value();
}

Result<SimulatedFlight> simulate_flight(const OverheadMap& map,
                                        const FlownPath& path,
                                        const SimulationOptions& options,
                                        const std::filesystem::path& folder,
                                        const WorkContext& work,
                                        const std::optional<ColourRaster>& picture) {
  if (const auto valid = validate(options); !valid) return forward_error(valid);
  if (const auto usable = check_usable_for_localising(map); !usable) return forward_error(usable);
  if (const auto flyable = check_path(map, path); !flyable) return forward_error(flyable);
  if (picture &&
      (picture->width() != map.labels.width() || picture->height() != map.labels.height())) {
    return fail(ErrorCode::kInvalidOptions,
                "map '{}': its picture is {} x {} pixels, but its labels are {} x {}", map.name,
                picture->width(), picture->height(), map.labels.width(), map.labels.height());
  }

  FlightDescription description;
  description.name = path.name;
  description.camera = CameraModel::from_horizontal_view(
      options.image_width_px, options.image_height_px, Angle::degrees(options.view_deg).radians());
  description.body_from_camera = {forward_body_from_camera(), Eigen::Vector3d::Zero()};
  description.altitude_m = path.truth.poses().front().pose.translation_m.z();
  description.truth_origin = map.plane.origin();
  auto writer = FlightWriter::create(
      folder, description,
      fmt::format("Simulated on the map {}, level {}, seed {}, {} labels, {} odometry", map.name,
                  enum_name(options.level), options.seed,
                  options.has_label_noise ? "noisy" : "perfect",
                  path.odometry ? "recorded" : "made-up"),
      "nadir simulate");
  if (!writer) return forward_error(writer);

  work.report(0.0, "raising the world");
  const FrameMaker maker(map, *description.camera, description.body_from_camera, options,
                         picture ? &*picture : nullptr);
  const std::vector<TimedPose> poses = frame_poses(path);
  if (const auto written = write_frames(maker, poses, *writer, work); !written) {
    return forward_error(written);
  }
  const LevelNoise level = level_noise(options.level);
  const Trajectory odometry =
      path.odometry
          ? *path.odometry
          : drifting_odometry(path.truth,
                              calibrated_diffusion(path.truth, level.odometry_position_mse_m2,
                                                   level.odometry_yaw_mse_rad2),
                              options.seed);
  if (const auto finished = writer->finish(odometry, path.truth); !finished) {
    return forward_error(finished);
  }
  return SimulatedFlight{
      .folder = folder,
      .frames = poses.size(),
      .frames_off_map = static_cast<std::size_t>(std::count_if(
          poses.begin(), poses.end(),
          [&](const TimedPose& body) { return !map.contains(body.pose.translation_m.head<2>()); })),
      .duration_s = path.truth.end_s() - path.truth.start_s(),
      .length_m = path.truth.planar_length_m()};
}

}  // namespace nadir
