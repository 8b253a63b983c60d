// SPDX-License-Identifier: Apache-2.0
#include "core/session/moment_surface.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/base/angle.h"
#include "core/session/moment_explanation.h"

namespace nadir {
namespace {

constexpr int kCountAcross = 63, kCountYaw = 37;
constexpr double kSurfaceStepM = 0.2, kMostSurfaceStepM = 1.0;
constexpr double kSurfaceStepDeg = 2.0, kMostSurfaceStepDeg = 10.0;
constexpr double kTruthRoom = 1.2;  ///< The truth is not to lie on the very edge.

/// Cuts the volume through its centre and finds its least cost.
void cut_surface(MomentSurface& surface) {
  const ErrorSurface& volume = surface.volume;
  const ErrorSurfaceGrid& grid = volume.grid;
  const int mid_x = grid.count_x / 2;
  const int mid_y = grid.count_y / 2;
  const int mid_yaw = grid.count_yaw / 2;
  const auto plane_size =
      static_cast<std::size_t>(grid.count_x) * static_cast<std::size_t>(grid.count_y);
  const auto* const middle =
      volume.mean_cost.data() + static_cast<std::size_t>(mid_yaw) * plane_size;
  surface.plane.assign(middle, middle + plane_size);
  surface.best_turn.assign(plane_size, 1.0F);
  std::tuple<float, int, int> least{2.0F, 0, 0};  // cost, then cells and turns from the estimate
  for (int iyaw = 0; iyaw < grid.count_yaw; ++iyaw) {
    surface.turn.push_back(volume.at(mid_x, mid_y, iyaw));
    for (int iy = 0; iy < grid.count_y; ++iy) {
      for (int ix = 0; ix < grid.count_x; ++ix) {
        const float cost = volume.at(ix, iy, iyaw);
        float& best =
            surface
                .best_turn[static_cast<std::size_t>(iy) * static_cast<std::size_t>(grid.count_x) +
                           static_cast<std::size_t>(ix)];
        best = std::min(best, cost);
        if (cost > std::get<0>(least)) continue;
        const int dx = ix - mid_x;
        const int dy = iy - mid_y;
        const std::tuple here{cost, dx * dx + dy * dy, std::abs(iyaw - mid_yaw)};
        if (!(here < least)) continue;
        least = here;
        surface.least_in_enu = volume.pose(ix, iy, iyaw);
      }
    }
  }
  surface.least_cost = std::get<0>(least);
  surface.cost_at_estimate = volume.at(mid_x, mid_y, mid_yaw);
}

}  // namespace

GridPlace MomentSurface::place_of(const Rigid2& enu_from_body) const {
  const ErrorSurfaceGrid& grid = volume.grid;
  const Rigid2& centre = volume.centre_in_enu;
  return {(enu_from_body.x_m - centre.x_m) / grid.step_m + 0.5 * (grid.count_x - 1),
          (enu_from_body.y_m - centre.y_m) / grid.step_m + 0.5 * (grid.count_y - 1),
          wrap_rad(enu_from_body.yaw_rad - centre.yaw_rad) / grid.step_rad +
              0.5 * (grid.count_yaw - 1)};
}

ErrorSurfaceGrid moment_grid(const RunStep& step, double metres_per_cell) {
  double step_m = kSurfaceStepM;
  double step_deg = kSurfaceStepDeg;
  if (step.truth_in_enu) {
    const Rigid2& estimate = step.estimate.moments.mean;
    const Rigid2& truth = *step.truth_in_enu;
    const double away_m =
        std::max(std::abs(truth.x_m - estimate.x_m), std::abs(truth.y_m - estimate.y_m));
    const double away_deg =
        Angle::radians(std::abs(wrap_rad(truth.yaw_rad - estimate.yaw_rad))).degrees();
    const double needed_m = kTruthRoom * away_m / std::floor(kCountAcross / 2.0);
    const double whole_m = std::ceil(needed_m / metres_per_cell) * metres_per_cell;
    step_m = std::clamp(whole_m, kSurfaceStepM, kMostSurfaceStepM);
    step_deg = std::clamp(kTruthRoom * away_deg / std::floor(kCountYaw / 2.0), kSurfaceStepDeg,
                          kMostSurfaceStepDeg);
  }
  return whole_cells({.count_x = kCountAcross,
                      .count_y = kCountAcross,
                      .count_yaw = kCountYaw,
                      .step_m = step_m,
                      .step_rad = Angle::degrees(step_deg).radians()},
                     metres_per_cell);
}

Result<MomentSurface> moment_surface(const RunStep& step,
                                     const MapMatcher& matcher,
                                     const ErrorSurfaceGrid& grid) {
  if (const auto checked = check_seen(step, matcher.map()); !checked) return forward_error(checked);
  for (const int count : {grid.count_x, grid.count_y, grid.count_yaw}) {
    if (count % 2 == 0) {
      return fail(ErrorCode::kInvalidOptions,
                  "error surface: {} poses put none on the estimate; an odd number does", count);
    }
  }
  auto volume = error_surface(matcher, *step.topview, step.estimate.moments.mean, grid);
  if (!volume) return forward_error(volume);
  MomentSurface surface;
  surface.volume = std::move(*volume);
  cut_surface(surface);
  if (step.truth_in_enu) {
    const GridPlace place = surface.place_of(*step.truth_in_enu);
    const auto is_inside = [](double at, int count) { return at >= 0.0 && at <= count - 1.0; };
    surface.truth = place;
    surface.is_truth_inside = is_inside(place.x, grid.count_x) &&
                              is_inside(place.y, grid.count_y) &&
                              is_inside(place.yaw, grid.count_yaw);
    surface.cost_at_truth = matcher.mean_cost(matcher.prepare(*step.topview), *step.truth_in_enu);
  }
  return surface;
}

Result<MomentSurface> moment_surface(const RunStep& step, const MapMatcher& matcher) {
  return moment_surface(step, matcher, moment_grid(step, matcher.map().metres_per_cell));
}

}  // namespace nadir
