// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "core/map/overhead_map_file.h"
#include "core/run/run_file.h"
#include "tests/support/drawn_map.h"
#include "tests/widgets/figures/recorded_camera.h"

namespace nadir {

/// What the run of a test leaves out or spoils.
struct RunFaults {
  bool has_truth = true, has_particles = true, has_topviews = true;
  double shift_m = 0.0;               ///< Of all poses from the map.
  double plane_latitude_deg = 33.45;  ///< That of drawn maps.
  std::string map_hash = {}, flight_hash = {};
  double metres_per_cell = 1.0;  ///< Of the topviews; that of the street's map is 1.
  bool knows_spread = true;      ///< Else neither covariances nor an effective sample size.
  int jumps_at = -1;             ///< From this step on all poses are ...
  double jump_m = 0.0;           ///< ... so much farther east.
  bool has_odometry = true;
  bool is_finished = true;  ///< false: the program was killed after its last step.
  double first_time_s = 100.0;
};

/// Writes a map of 60 m x 40 m, road between curbs and terrain with a building, with a picture: package `folder`.
inline void write_street(const std::filesystem::path& folder, bool has_picture = true) {
  std::vector<std::string> rows(40, std::string(60, 'T'));
  for (int row = 16; row < 24; ++row) rows[static_cast<std::size_t>(row)] = std::string(60, 'R');
  rows[15] = rows[24] = std::string(60, 'C');
  for (int row = 3; row < 10; ++row) rows[static_cast<std::size_t>(row)].replace(5, 12, 12, 'B');
  const OverheadMap map = drawn_map(1.0, rows);
  std::optional<ColourRaster> picture;
  if (has_picture) {
    picture.emplace(60, 40);
    for (int row = 0; row < 40; ++row) {
      for (int column = 0; column < 60; ++column) {
        picture->at(column, row) = class_info(map.labels.at(column, row)).colour;
      }
    }
  }
  const auto written =
      write_overhead_map(map, {"street", "drawn", "CC0-1.0", "2026-11-22"}, picture, folder);
  if (!written) throw std::runtime_error(written.error().message);
}

/// A drive east along the street at 1 m a step and 2 steps a second, the estimate 0.3 m beside the truth and the odometry
/// drifting north.
inline RunStep street_step(int number, const RunFaults& faults) {
  RunStep step;
  step.step = number;
  step.time_s = faults.first_time_s + 0.5 * number;
  const bool has_jumped = faults.jumps_at >= 0 && number >= faults.jumps_at;
  const Rigid2 truth{10.0 + number + faults.shift_m + (has_jumped ? faults.jump_m : 0.0), 20.0,
                     0.0};
  step.odom_from_body = {static_cast<double>(number), 0.1 * number, 0.0};
  if (faults.has_odometry) {
    step.odometry_in_enu = Rigid2{truth.x_m, truth.y_m + 0.1 * number, 0.02};
  }
  if (faults.has_truth) step.truth_in_enu = truth;
  step.estimate.moments.mean = {truth.x_m + 0.2, truth.y_m - 0.2 + 0.1 * std::sin(number), 0.01};
  step.estimate.moments.covariance = Eigen::Vector3d(0.3, 0.1, 0.002).asDiagonal();
  step.effective_sample_size = 60.0;
  if (!faults.knows_spread) {
    step.estimate.moments.covariance.setConstant(std::nan(""));
    step.effective_sample_size = std::nan("");
  }
  step.estimate.modes = {{1.0, step.estimate.moments}};
  step.particle_count = 100;
  step.agreement = 0.8;
  step.topview_cells = 9;
  step.update_ms = 8.0;
  if (faults.has_particles) {
    ParticleSet particles;
    for (int i = 0; i < 100; ++i) {
      particles.x_in_enu_m.push_back(step.estimate.moments.mean.x_m + std::sin(i));
      particles.y_in_enu_m.push_back(step.estimate.moments.mean.y_m + std::cos(1.7 * i));
      particles.yaw_rad.push_back(0.01 * std::sin(0.3 * i));
      particles.weight.push_back(0.01);
    }
    step.particles = particles;
  }
  if (faults.has_topviews) {
    TopviewRaster raster{Raster<ClassId>(9, 10, kUnclassified), 5, 10};
    for (int row = 0; row < 10; ++row) {
      for (int column = 0; column < 9; ++column) {
        raster.labels.at(column, row) = column == 0 || column == 8 ? kCurb : kRoad;
      }
    }
    step.topview = topview_from_raster(raster, faults.metres_per_cell);
  }
  return step;
}

/// Beside the run lies what its camera saw, as `flight`: 40 frames from the first step on.
inline void write_drive(const std::filesystem::path& path,
                        const std::filesystem::path& map,
                        int steps = 30,
                        const RunFaults& faults = {}) {
  RunHeader header;
  header.program_version = "0.1.0";
  header.flight = "drive";
  header.map = "street";
  header.preset = "default";
  header.flight_path = "no/such/flight";
  header.map_path = map.string();
  header.map_hash = faults.map_hash;
  header.flight_hash = faults.flight_hash;
  header.plane_latitude_deg = faults.plane_latitude_deg;
  header.plane_longitude_deg = -83.9;
  auto writer = RunWriter::create(path, header);
  if (!writer) throw std::runtime_error(writer.error().message);
  for (int i = 0; i < steps; ++i) {
    const auto written = writer->write(street_step(i, faults));
    if (!written) throw std::runtime_error(written.error().message);
  }
  if (faults.is_finished) {
    const auto finished = writer->finish();
    if (!finished) throw std::runtime_error(finished.error().message);
  }
  const std::filesystem::path flight = path.parent_path() / "flight";
  if (std::filesystem::exists(flight) || !std::filesystem::exists(map / "map.toml")) return;
  const auto seen = read_overhead_map(map);
  if (!seen) throw std::runtime_error(seen.error().message);
  write_street_flight(*seen, flight, 40);
}

}  // namespace nadir
