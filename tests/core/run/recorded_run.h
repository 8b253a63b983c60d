// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <stdexcept>

#include "core/run/run_file.h"

namespace nadir {

/// A header with every field set.
[[nodiscard]] inline RunHeader example_header() {
  RunHeader header;
  header.program_version = "0.1.0";
  header.flight = "loop";
  header.map = "proving-ground";
  header.preset = "default";
  header.flight_path = "flights/loop";
  header.map_path = "maps/proving-ground";
  header.flight_hash = "00ff";
  header.map_hash = "ab12";
  header.seed = 18446744073709551615ULL;
  header.plane_latitude_deg = 47.123456789012345;
  header.plane_longitude_deg = -1.0 / 3.0;
  header.options = {{"particle-count", "10000"}, {"blur", "1e-3"}};
  return header;
}

/// Step `number` of a flight east at 1 m a step, with `particle_count` particles where that is
/// above 0. A pure function of its arguments, so that whoever reads a run knows what must be in it.
[[nodiscard]] inline RunStep example_step(int number, int particle_count = 0) {
  const double m = number;
  RunStep step;
  step.step = number;
  step.time_s = 0.1 * m;
  step.odom_from_body = {1.02 * m, 0.01 * m, 0.001 * m};
  step.odometry_in_enu = {500.0 + 1.02 * m, 200.0 + 0.01 * m, 0.001 * m};
  step.truth_in_enu = Rigid2{500.0 + m, 200.0, 0.0};
  step.estimate.moments.mean = {500.0 + m + 0.1, 200.0 - 1.0 / 3.0, 0.01};
  step.estimate.moments.covariance << 0.25, 0.01, 0.002, 0.01, 0.16, -0.003, 0.002, -0.003, 1e-3;
  step.estimate.modes = {{0.75, step.estimate.moments},
                         {0.25, {{510, 210, -3}, Eigen::Matrix3d::Identity()}}};
  step.effective_sample_size = 812.5;
  step.particle_count = particle_count;
  step.was_resampled = number % 2 == 1;
  step.agreement = 0.625;
  step.topview_cells = 3;
  step.update_ms = 12.5;
  if (particle_count > 0) {
    ParticleSet particles;
    for (int i = 0; i < particle_count; ++i) {
      particles.x_in_enu_m.push_back(500.0 + m + 5.0 * std::sin(i));
      particles.y_in_enu_m.push_back(200.0 + 5.0 * std::cos(1.7 * i));
      particles.yaw_rad.push_back(std::sin(0.3 * i));
      particles.weight.push_back(1.0 / particle_count);
    }
    step.particles = particles;
    SemanticTopview topview;
    topview.metres_per_cell = 0.1;
    topview.cells = {{-5, 3}, {200, -200}, {7, 7}};
    topview.class_begin.fill(3);
    topview.class_begin[0] = 0;
    topview.class_begin[1] = 2;  // Two cells of class 0, one of class 1.
    step.topview = topview;
  }
  return step;
}

/// Writes a run of so many steps; throws where that fails, since the test then means nothing.
inline void record_run(const std::filesystem::path& path,
                       int steps,
                       int particle_count = 0,
                       bool is_finished = true) {
  const auto demand = [](const Result<void>& outcome) {
    if (!outcome) throw std::runtime_error(outcome.error().message);
  };
  auto writer = RunWriter::create(path, example_header());
  if (!writer) throw std::runtime_error(writer.error().message);
  for (int i = 0; i < steps; ++i) demand(writer->write(example_step(i, particle_count)));
  if (is_finished) demand(writer->finish());
}

}  // namespace nadir
