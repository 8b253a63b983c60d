// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/result.h"
#include "core/sim/route.h"

namespace nadir {

/// A stretch of constant curvature: a line, or an arc where the curvature is not 0.
struct PathPiece {
  Eigen::Vector2d start_in_enu_m = Eigen::Vector2d::Zero();
  double yaw_rad = 0.0;  ///< At the start.
  double length_m = 0.0;
  double curvature_per_m = 0.0;  ///< Positive to the left.

  [[nodiscard]] Eigen::Vector2d place_in_enu_m(double along_m) const;
  [[nodiscard]] double yaw_at_rad(double along_m) const {
    return yaw_rad + curvature_per_m * along_m;
  }
};

/// Lines and arcs with continuous heading.
struct FlightPath {
  std::vector<PathPiece> pieces;
  std::vector<double> begin_m;  ///< Where each piece begins along the path.
  double length_m = 0.0;

  struct Station {
    const PathPiece* piece;
    double along_m;  ///< From the start of the piece.
  };
  /// Along the path, in [0, length_m].
  [[nodiscard]] Station at(double along_m) const;
};

/// Rounds a route's corners. @errors kInvalidOptions, see plan_flight.
[[nodiscard]] Result<FlightPath> build_flight_path(const Route& route);

/// Motion along a path at a time.
struct PathMotion {
  double time_s = 0.0;
  double along_m = 0.0;
  double speed_mps = 0.0;
  double acceleration_mps2 = 0.0;  ///< Along the path.
};

/// The fastest motion from rest to rest within the route's limits, sampled every `step_s` and at
/// the end.
[[nodiscard]] std::vector<PathMotion> plan_motion(const FlightPath& path,
                                                  const Route& route,
                                                  double step_s);

}  // namespace nadir
