// SPDX-License-Identifier: Apache-2.0
#include "core/mcl/motion_model.h"

#include <cmath>

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/base/require.h"

namespace nadir {
namespace {

constexpr std::size_t kParticlesPerChunk = 1024;

/// Three independent normals for particle i.
struct Normals {
  double first, second, third;
};

Normals draw_normals(DrawId id) {
  const auto [first, second] = standard_normals(id);
  ++id.draw;
  return {first, second, standard_normals(id)[0]};
}

/// A step as two rotations and a translation between them.
struct TurnGoTurn {
  double rotation1_rad, translation_m, rotation2_rad;
};

TurnGoTurn turn_go_turn(const Rigid2& before_from_after, double hover_below_m) {
  const double translation_m = std::hypot(before_from_after.x_m, before_from_after.y_m);
  const bool is_hovering = translation_m <= hover_below_m;
  const double rotation1_rad =
      is_hovering ? 0.0 : std::atan2(before_from_after.y_m, before_from_after.x_m);
  return {rotation1_rad, translation_m, wrap_rad(before_from_after.yaw_rad - rotation1_rad)};
}

Rigid2 moved_as_in_thesis(const Rigid2& pose,
                          const TurnGoTurn& step,
                          const LocaliserOptions& options,
                          const Normals& noise) {
  const double rotation1_rad = step.rotation1_rad - options.rotation_noise_rad * noise.first;
  const double translation_m = step.translation_m - options.translation_noise_m * noise.second;
  const double rotation2_rad = step.rotation2_rad - options.rotation_noise_rad * noise.third;
  const double course_rad = pose.yaw_rad + rotation1_rad;
  return {pose.x_m + translation_m * std::cos(course_rad),
          pose.y_m + translation_m * std::sin(course_rad), wrap_rad(course_rad + rotation2_rad)};
}

/// Deviations of one step of the scaled model, in the body frame.
struct StepNoise {
  double along_m, across_m, yaw_rad;
};

StepNoise step_noise(const OdometryStep& odometry, const LocaliserOptions& options) {
  const auto squared = [](double value) { return value * value; };
  const double way_m = odometry.way_m() > options.hover_below_m ? odometry.way_m() : 0.0;
  const double turn_rad = std::abs(odometry.before_from_after.yaw_rad);
  const double drift_m2 = squared(options.position_noise_m_per_sqrt_s) * odometry.elapsed_s;
  return {std::sqrt(drift_m2 + squared(options.along_noise_m_per_sqrt_m) * way_m),
          std::sqrt(drift_m2 + squared(options.across_noise_m_per_sqrt_m) * way_m),
          std::sqrt(squared(options.yaw_noise_rad_per_sqrt_s) * odometry.elapsed_s +
                    squared(options.turn_noise_rad_per_sqrt_rad) * turn_rad)};
}

}  // namespace

void predict(ParticleSet& particles,
             const OdometryStep& odometry,
             const LocaliserOptions& options,
             std::uint32_t step) {
  NADIR_REQUIRE(odometry.elapsed_s >= 0.0);
  const Rigid2& motion = odometry.before_from_after;
  const TurnGoTurn parts = turn_go_turn(motion, options.hover_below_m);
  const StepNoise deviation = step_noise(odometry, options);
  const double course_rad =
      parts.rotation1_rad;  // `along` and `across` are along and across the way flown
  const double along_x = std::cos(course_rad);
  const double along_y = std::sin(course_rad);
  parallel_for(particles.size(), kParticlesPerChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Normals noise = draw_normals({.seed = options.seed,
                                          .stream = kMotionNoise,
                                          .step = step,
                                          .particle = static_cast<std::uint32_t>(i)});
      if (options.motion == MotionKind::kThesis) {
        particles.set_pose(i, moved_as_in_thesis(particles.pose(i), parts, options, noise));
        continue;
      }
      const double along_m = deviation.along_m * noise.first;
      const double across_m = deviation.across_m * noise.second;
      const Rigid2 noisy = {motion.x_m + along_m * along_x - across_m * along_y,
                            motion.y_m + along_m * along_y + across_m * along_x,
                            motion.yaw_rad + deviation.yaw_rad * noise.third};
      particles.set_pose(i, particles.pose(i) * noisy);
    }
  });
}

void blur(ParticleSet& particles,
          double elapsed_s,
          const LocaliserOptions& options,
          std::uint32_t step) {
  if (options.blur_position_m == 0.0 && options.blur_yaw_rad == 0.0) return;
  const double share = options.blur_interval_s > 0.0 ? elapsed_s / options.blur_interval_s : 1.0;
  const double position_m = options.blur_position_m * std::sqrt(share);
  const double yaw_rad = options.blur_yaw_rad * std::sqrt(share);
  parallel_for(particles.size(), kParticlesPerChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Normals noise = draw_normals({.seed = options.seed,
                                          .stream = kBlur,
                                          .step = step,
                                          .particle = static_cast<std::uint32_t>(i)});
      const Rigid2 pose = particles.pose(i);
      particles.set_pose(i,
                         {pose.x_m + position_m * noise.first, pose.y_m + position_m * noise.second,
                          wrap_rad(pose.yaw_rad + yaw_rad * noise.third)});
    }
  });
}

}  // namespace nadir
