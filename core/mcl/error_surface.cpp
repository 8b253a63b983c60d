// SPDX-License-Identifier: Apache-2.0
#include "core/mcl/error_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/angle.h"
#include "core/base/parallel.h"
#include "core/mcl/cost_rows.h"

namespace nadir {
namespace {

using detail::CostWindow;
using detail::kRowLanes;

constexpr double kFullCostOfCell = 255.0;
constexpr std::size_t kRowsPerChunk = 16;
constexpr double kMostWindowBytes = 64e6;

/// A surface whose poses lie a whole number of cells apart, so that all poses of a yaw see the same
/// cells of the map, moved.
class RegularSurface {
 public:
  /// @returns nothing where the poses lie otherwise, also where one is so far off the map that it
  /// was moved nearer, or where the ground that they see is too large to copy.
  static std::optional<RegularSurface> of(const ErrorSurface& surface,
                                          const MapMatcher& matcher,
                                          const MatchCells& cells) {
    const OverheadMap& map = matcher.map();
    const ErrorSurfaceGrid& grid = surface.grid;
    const double step = std::round(grid.step_m / map.metres_per_cell);
    if (!(step >= 1.0 && step <= kMaxMapSide)) return std::nullopt;
    RegularSurface result(matcher, cells, grid, static_cast<int>(step));
    const FixedPose south_west = fixed_pose(surface.pose(0, 0, 0), map);
    const std::int64_t step_fixed = std::int64_t{result.step_cells_} << kFractionBits;
    for (int ix = 0; ix < grid.count_x; ++ix) {
      const FixedPose pose = fixed_pose(surface.pose(ix, 0, 0), map);
      if (pose.base_column != south_west.base_column + ix * step_fixed) return std::nullopt;
    }
    for (int iy = 0; iy < grid.count_y; ++iy) {
      const FixedPose pose = fixed_pose(surface.pose(0, iy, 0), map);
      if (pose.base_row != south_west.base_row - iy * step_fixed) return std::nullopt;
    }
    if (!result.copy_windows(south_west)) return std::nullopt;
    return result;
  }

  /// All mean costs of rows [begin, end): row iyaw * count_y + iy.
  void evaluate(ErrorSurface& surface, std::size_t begin, std::size_t end) const {
    const auto count_y = static_cast<std::size_t>(grid_.count_y);
    while (begin < end) {
      const std::size_t iyaw = begin / count_y;
      const std::size_t last = std::min(end, (iyaw + 1) * count_y);
      evaluate_rows(surface, static_cast<int>(iyaw), begin, last);
      begin = last;
    }
  }

 private:
  RegularSurface(const MapMatcher& matcher,
                 const MatchCells& cells,
                 const ErrorSurfaceGrid& grid,
                 int step_cells)
      : matcher_(&matcher), cells_(&cells), grid_(grid), step_cells_(step_cells) {}

  /// One window a class that holds whatever its cells meet at any pose of the grid.
  bool copy_windows(const FixedPose& south_west) {
    double reach_half_cells = 0.0;
    for (const MatchCells::OfClass& group : cells_->classes) {
      for (const HalfCell& cell : group.cells) {
        reach_half_cells = std::max(reach_half_cells, std::hypot(cell.forward, cell.left));
      }
    }
    const int reach = static_cast<int>(std::ceil(0.5 * reach_half_cells)) + 2;
    const double columns = static_cast<double>(grid_.count_x - 1) * step_cells_ + 2.0 * reach + 1.0;
    const double rows = static_cast<double>(grid_.count_y - 1) * step_cells_ + 2.0 * reach + 1.0;
    if (CostWindow::bytes(columns, rows, step_cells_) *
            static_cast<double>(cells_->classes.size()) >
        kMostWindowBytes) {
      return false;
    }
    const RasterPlace corner = {
        (south_west.base_column >> kFractionBits) - reach,
        (south_west.base_row >> kFractionBits) - reach - (grid_.count_y - 1) * step_cells_};
    std::vector<std::optional<CostWindow>> windows(cells_->classes.size());
    parallel_for(windows.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        windows[i].emplace(matcher_->cost_raster(cells_->classes[i].id), corner,
                           static_cast<int>(columns), static_cast<int>(rows), step_cells_);
      }
    });
    windows_.reserve(windows.size());
    for (auto& window : windows) windows_.push_back(std::move(*window));
    return true;
  }

  /// Rows [first, last) of one yaw.
  void evaluate_rows(ErrorSurface& surface, int iyaw, std::size_t first, std::size_t last) const {
    const auto count_x = static_cast<std::size_t>(grid_.count_x);
    const auto count_y = static_cast<std::size_t>(grid_.count_y);
    const FixedPose north_west =
        fixed_pose(surface.pose(0, grid_.count_y - 1, iyaw), matcher_->map());
    std::vector<double> costs((last - first) * count_x, 0.0);
    std::vector<std::uint32_t> index;
    std::array<std::uint32_t, kRowLanes> sums;
    for (std::size_t k = 0; k < windows_.size(); ++k) {
      const CostWindow& window = windows_[k];
      const MatchCells::OfClass& group = cells_->classes[k];
      index.clear();
      for (const HalfCell& cell : group.cells) {
        index.push_back(static_cast<std::uint32_t>(window.index_of(place_of(cell, north_west))));
      }
      for (std::size_t row = first; row < last; ++row) {
        const std::size_t to_south = count_y - 1 - row % count_y;
        const std::uint8_t* const values = window.data() + to_south * window.index_of_step();
        for (std::size_t x = 0; x < count_x; x += kRowLanes) {
          detail::sum_rows(values + x, index, sums.data(), matcher_->instruction_set());
          double* const to = costs.data() + (row - first) * count_x + x;
          const std::size_t lanes = std::min(kRowLanes, count_x - x);
          for (std::size_t i = 0; i < lanes; ++i) to[i] += group.weight_per_cell * sums[i];
        }
      }
    }
    const double worst = kFullCostOfCell * cells_->total_weight;
    for (std::size_t i = 0; i < costs.size(); ++i) {
      surface.mean_cost[first * count_x + i] = static_cast<float>(costs[i] / worst);
    }
  }

  const MapMatcher* matcher_;
  const MatchCells* cells_;
  ErrorSurfaceGrid grid_;
  int step_cells_;
  std::vector<CostWindow> windows_;  ///< In the order of the cells' classes.
};

}  // namespace

Rigid2 ErrorSurface::pose(int ix, int iy, int iyaw) const {
  const auto offset = [](int index, int count, double step) {
    return (index - 0.5 * (count - 1)) * step;
  };
  return {centre_in_enu.x_m + offset(ix, grid.count_x, grid.step_m),
          centre_in_enu.y_m + offset(iy, grid.count_y, grid.step_m),
          wrap_rad(centre_in_enu.yaw_rad + offset(iyaw, grid.count_yaw, grid.step_rad))};
}

ErrorSurfaceGrid whole_cells(ErrorSurfaceGrid grid, double metres_per_cell) {
  grid.step_m = metres_per_cell * std::max(1.0, std::round(grid.step_m / metres_per_cell));
  return grid;
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
  if (const auto regular = RegularSurface::of(surface, matcher, cells)) {
    const auto rows =
        static_cast<std::size_t>(grid.count_y) * static_cast<std::size_t>(grid.count_yaw);
    parallel_for(rows, kRowsPerChunk, [&](std::size_t begin, std::size_t end) {
      regular->evaluate(surface, begin, end);
    });
    return surface;
  }
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
