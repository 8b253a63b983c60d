// SPDX-License-Identifier: Apache-2.0
#include "core/mcl/error_surface.h"

#include "core/base/angle.h"
#include "core/base/parallel.h"

namespace nadir {

Rigid2 ErrorSurface::pose(int ix, int iy, int iyaw) const {
  const auto offset = [](int index, int count, double step) {
    return (index - 0.5 * (count - 1)) * step;
  };
  return {centre_in_enu.x_m + offset(ix, grid.count_x, grid.step_m),
          centre_in_enu.y_m + offset(iy, grid.count_y, grid.step_m),
          wrap_rad(centre_in_enu.yaw_rad + offset(iyaw, grid.count_yaw, grid.step_rad))};
}

Result<ErrorSurface> error_surface(const MapMatcher& matcher,
                                   const SemanticTopview& seen,
                                   const Rigid2& centre_in_enu,
                                   const ErrorSurfaceGrid& grid) {
  constexpr double kMostPoses = 1e8;
  const double poses = static_cast<double>(grid.count_x) * grid.count_y * grid.count_yaw;
  if (grid.count_x < 1 || grid.count_y < 1 || grid.count_yaw < 1 || poses > kMostPoses) {
    return fail(ErrorCode::kInvalidOptions, "error surface: {} x {} x {} poses are not in [1, {}]",
                grid.count_x, grid.count_y, grid.count_yaw, kMostPoses);
  }
  if (!(grid.step_m > 0.0) || !(grid.step_rad > 0.0)) {
    return fail(ErrorCode::kInvalidOptions,
                "error surface: steps of {} m and {} rad are not positive", grid.step_m,
                grid.step_rad);
  }
  const MatchCells cells = matcher.prepare(seen);
  if (cells.empty()) {
    return fail(ErrorCode::kInvalidOptions,
                "error surface: the topview has no cell of a class that map '{}' holds",
                matcher.map().name);
  }
  ErrorSurface surface{centre_in_enu, grid, {}};
  surface.mean_cost.resize(static_cast<std::size_t>(poses));
  parallel_for(surface.mean_cost.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto index = static_cast<int>(i);
      const Rigid2 pose = surface.pose(index % grid.count_x, index / grid.count_x % grid.count_y,
                                       index / (grid.count_x * grid.count_y));
      surface.mean_cost[i] = static_cast<float>(matcher.mean_cost(cells, pose));
    }
  });
  return surface;
}

}  // namespace nadir
