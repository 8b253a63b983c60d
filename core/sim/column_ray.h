// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "core/sim/world.h"

namespace nadir {

/// A ray over the cells of a world: at t it is above the point `start + t * rate` in cells (column,
/// row), at height `z_m + t * z_rate_m`. t is depth along the optical axis in metres.
struct ColumnRay {
  Eigen::Vector2d start, rate;
  double z_m = 0.0;
  double z_rate_m = 0.0;
};

struct ColumnHit {
  double t = 0.0;
  ClassId label = kUnclassified;
};

/// First column, curb-high ground or bare ground that a ray hits, with t infinite and label kSky
/// where there is none up to `t_end`. Tall columns are found by leaps over the chessboard distance
/// field, the low relief only where the ray is between its height and the ground.
[[nodiscard]] ColumnHit trace_columns(const World& world, const ColumnRay& ray, double t_end);

}  // namespace nadir
