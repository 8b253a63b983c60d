// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

namespace nadir::detail {

/// Marks a SQLite file as a run: "NADR" in ASCII, at byte 68 of the file.
inline constexpr std::int32_t kRunApplicationId = 0x4E414452;
/// Rises when a reader of the old format could misread the new one.
inline constexpr int kRunFormatVersion = 1;

/// The comments stay in the file: `sqlite3 R.nadir .schema` shows them.
inline constexpr std::string_view kRunSchema = R"(
CREATE TABLE about (  -- What was run; localiser options as 'option.NAME'
  key TEXT PRIMARY KEY,
  value TEXT NOT NULL
);
CREATE TABLE step (  -- One update of the localiser; poses in the project plane, yaw counter-clockwise from east
  step INTEGER PRIMARY KEY,
  time_s REAL NOT NULL,
  odom_x_m REAL NOT NULL,  -- Odometry input, in its own frame
  odom_y_m REAL NOT NULL,
  odom_yaw_rad REAL NOT NULL,
  odometry_x_m REAL,  -- The same, laid at the start of the run; NULL where that is not known
  odometry_y_m REAL,
  odometry_yaw_rad REAL,
  truth_x_m REAL,  -- NULL where not known
  truth_y_m REAL,
  truth_yaw_rad REAL,
  estimate_x_m REAL NOT NULL,
  estimate_y_m REAL NOT NULL,
  estimate_yaw_rad REAL NOT NULL,
  covariance_xx_m2 REAL,  -- Of the estimate
  covariance_xy_m2 REAL,
  covariance_x_yaw_m_rad REAL,
  covariance_yy_m2 REAL,
  covariance_y_yaw_m_rad REAL,
  covariance_yaw_yaw_rad2 REAL,
  effective_sample_size REAL,
  particle_count INTEGER NOT NULL,
  was_resampled INTEGER NOT NULL,
  agreement REAL,  -- Share of known topview cells whose class is the map's; NULL where not known
  topview_cells INTEGER NOT NULL,
  update_ms REAL
);
CREATE TABLE mode (  -- Clusters of the posterior by falling mass
  step INTEGER NOT NULL REFERENCES step,
  rank INTEGER NOT NULL,
  mass REAL NOT NULL,
  x_m REAL NOT NULL,
  y_m REAL NOT NULL,
  yaw_rad REAL NOT NULL,
  covariance_xx_m2 REAL,
  covariance_xy_m2 REAL,
  covariance_x_yaw_m_rad REAL,
  covariance_yy_m2 REAL,
  covariance_y_yaw_m_rad REAL,
  covariance_yaw_yaw_rad2 REAL,
  PRIMARY KEY (step, rank)
) WITHOUT ROWID;
CREATE TABLE particles (  -- zstd of four float32 arrays: x and y relative to the estimate (m), yaw (rad), weight
  step INTEGER PRIMARY KEY REFERENCES step,
  count INTEGER NOT NULL,
  data BLOB NOT NULL
);
CREATE TABLE topview (  -- zstd of three arrays: forward (int16), left (int16), class (uint8)
  step INTEGER PRIMARY KEY REFERENCES step,
  metres_per_cell REAL NOT NULL,
  count INTEGER NOT NULL,
  data BLOB NOT NULL
);
)";

inline constexpr std::string_view kStepColumns =
    "step, time_s, odom_x_m, odom_y_m, odom_yaw_rad, odometry_x_m, odometry_y_m, odometry_yaw_rad, "
    "truth_x_m, truth_y_m, truth_yaw_rad, estimate_x_m, estimate_y_m, estimate_yaw_rad, "
    "covariance_xx_m2, covariance_xy_m2, covariance_x_yaw_m_rad, covariance_yy_m2, "
    "covariance_y_yaw_m_rad, covariance_yaw_yaw_rad2, effective_sample_size, particle_count, "
    "was_resampled, agreement, topview_cells, update_ms";

inline constexpr std::string_view kModeColumns =
    "step, rank, mass, x_m, y_m, yaw_rad, covariance_xx_m2, covariance_xy_m2, "
    "covariance_x_yaw_m_rad, covariance_yy_m2, covariance_y_yaw_m_rad, covariance_yaw_yaw_rad2";

}  // namespace nadir::detail
