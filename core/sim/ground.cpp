// SPDX-License-Identifier: Apache-2.0
#include "core/sim/ground.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace nadir {
namespace {

bool is_road(ClassId id) { return id == kRoad || id == kLaneMarking; }
bool is_open_class(ClassId id) { return id == kSidewalk || id == kTerrain || id == kVegetation; }

template <typename Predicate>
Raster<std::uint8_t> distance_to(const Raster<ClassId>& labels, Predicate is_wanted) {
  Raster<std::uint8_t> cells(labels.width(), labels.height());
  std::transform(labels.values().begin(), labels.values().end(), cells.values().begin(),
                 [&](ClassId id) { return static_cast<std::uint8_t>(is_wanted(id) ? 1 : 0); });
  return chessboard_distance(cells);
}

struct CellIndex {
  int column, row;
};

CellIndex cell_of(const OverheadMap& map, const Eigen::Vector2d& place_in_enu_m) {
  const Eigen::Vector2d cell = map.overhead_from_enu(place_in_enu_m);
  return {static_cast<int>(std::floor(cell.x())), static_cast<int>(std::floor(cell.y()))};
}

}  // namespace

Ground::Ground(const OverheadMap& map, const Relief& relief)
    : map_(map),
      relief_(relief),
      cells_to_nonroad_(distance_to(map.labels, [](ClassId id) { return !is_road(id); })),
      cells_to_road_(distance_to(map.labels, is_road)),
      cells_to_nonopen_(distance_to(map.labels, [](ClassId id) { return !is_open_class(id); })) {}

double Ground::distance_m(const Raster<std::uint8_t>& cells,
                          const Eigen::Vector2d& place_in_enu_m,
                          double outside) const {
  const auto [column, row] = cell_of(map_, place_in_enu_m);
  return cells.contains(column, row) ? cells.at(column, row) * map_.metres_per_cell : outside;
}

double Ground::height_m(const Eigen::Vector2d& place_in_enu_m) const {
  const auto [column, row] = cell_of(map_, place_in_enu_m);
  return relief_.height_m.contains(column, row)
             ? static_cast<double>(relief_.height_m.at(column, row))
             : 0.0;
}

double Ground::inside_road_m(const Eigen::Vector2d& place_in_enu_m) const {
  return distance_m(cells_to_nonroad_, place_in_enu_m, 0.0);
}

double Ground::to_road_m(const Eigen::Vector2d& place_in_enu_m) const {
  return distance_m(cells_to_road_, place_in_enu_m, 255.0 * map_.metres_per_cell);
}

double Ground::inside_open_m(const Eigen::Vector2d& place_in_enu_m) const {
  return distance_m(cells_to_nonopen_, place_in_enu_m, 0.0);
}

std::optional<Eigen::Vector2d> Ground::edge_direction(const Eigen::Vector2d& place_in_enu_m) const {
  // The road's outermost cells nearby, as a point set: on a straight edge its spread lies along one
  // line.
  constexpr double kRadiusM = 2.5;
  constexpr double kLargestSpreadRatio = 0.03;
  constexpr int kFewestCells = 8;
  const auto [centre_column, centre_row] = cell_of(map_, place_in_enu_m);
  const int reach = static_cast<int>(std::ceil(kRadiusM / map_.metres_per_cell));
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  int count = 0;
  for (int row = centre_row - reach; row <= centre_row + reach; ++row) {
    for (int column = centre_column - reach; column <= centre_column + reach; ++column) {
      if (!cells_to_nonroad_.contains(column, row) || cells_to_nonroad_.at(column, row) != 1) {
        continue;
      }
      const Eigen::Vector2d offset(column - centre_column, centre_row - row);
      if (offset.squaredNorm() > static_cast<double>(reach) * reach) continue;
      sum += offset;
      squares += offset * offset.transpose();
      ++count;
    }
  }
  if (count < kFewestCells) return std::nullopt;
  const Eigen::Vector2d mean = sum / count;
  const Eigen::Matrix2d covariance = squares / count - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(covariance);
  const Eigen::Vector2d spread = solver.eigenvalues();
  // Half a cell of raggedness is in every slanted edge of a raster.
  if (spread.x() > kLargestSpreadRatio * spread.y() + 0.25) return std::nullopt;
  return solver.eigenvectors().col(1).normalized();
}

std::optional<StraightRun> longest_run(const Eigen::Vector2d& place_in_enu_m,
                                       const std::function<bool(const Eigen::Vector2d&)>& is_free,
                                       double least_m,
                                       double most_m) {
  constexpr int kHeadings = 32;
  constexpr double kStepM = 0.5;
  if (!is_free(place_in_enu_m)) return std::nullopt;
  const auto reach_m = [&](const Eigen::Vector2d& along) {
    double free_m = 0.0;
    while (free_m + kStepM <= most_m && is_free(place_in_enu_m + along * (free_m + kStepM))) {
      free_m += kStepM;
    }
    return free_m;
  };
  double longest_m = 0.0;
  StraightRun best{place_in_enu_m, place_in_enu_m};
  for (int i = 0; i < kHeadings; ++i) {
    const double yaw_rad = std::numbers::pi * i / kHeadings;
    const Eigen::Vector2d along(std::cos(yaw_rad), std::sin(yaw_rad));
    const double ahead_m = reach_m(along);
    const double behind_m = reach_m(-along);
    if (ahead_m + behind_m <= longest_m) continue;
    longest_m = ahead_m + behind_m;
    best = {place_in_enu_m - along * behind_m, place_in_enu_m + along * ahead_m};
  }
  if (longest_m < least_m) return std::nullopt;
  return best;
}

}  // namespace nadir
