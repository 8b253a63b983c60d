// SPDX-License-Identifier: Apache-2.0
#include "core/insight/view_matcher.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace nadir::detail {
namespace {

constexpr double kFullCost = 255.0;
constexpr double kSearchStepM = 0.5;
constexpr std::size_t kSectors = 8;
constexpr std::size_t kRefined = 3;

/// Which eighth of the plane an offset lies in.
std::size_t sector_of(int east, int south) {
  return (east < 0 ? 1U : 0U) + (south < 0 ? 2U : 0U) +
         (std::abs(east) < std::abs(south) ? 4U : 0U);
}

void set_deviations(ViewInformation& information, const Eigen::Matrix3d& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(covariance.topLeftCorner<2, 2>());
  const Eigen::Vector2d major = axes.eigenvectors().col(1);
  double axis_rad = std::atan2(major.y(), major.x());
  if (axis_rad < 0.0) axis_rad += std::numbers::pi;
  if (axis_rad >= std::numbers::pi) axis_rad = 0.0;
  information.std_minor_m = static_cast<float>(std::sqrt(axes.eigenvalues()(0)));
  information.std_major_m = static_cast<float>(std::sqrt(axes.eigenvalues()(1)));
  information.major_axis_rad = static_cast<float>(axis_rad);
  information.std_heading_rad = static_cast<float>(std::sqrt(covariance(2, 2)));
}

}  // namespace

ViewMatcher::ViewMatcher(const MatchGround& ground,
                         const ViewFootprint& footprint,
                         const LocalisabilityOptions& options,
                         const PlaneBounds& places)
    : ground_(ground), footprint_(footprint), options_(options), set_(best_instruction_set()) {
  const OverheadMap& map = ground.map();
  const double radius_cells = options.search_radius_m / map.metres_per_cell;
  const double apart_cells = options.apart_m / map.metres_per_cell;
  least_squared_cells_ = apart_cells * apart_cells;
  most_squared_cells_ = radius_cells * radius_cells;
  const double most_steps = (static_cast<double>(kRowLanes) - 1.0) / 2.0;
  step_cells_ = std::max({1, static_cast<int>(std::lround(kSearchStepM / map.metres_per_cell)),
                          static_cast<int>(std::ceil(radius_cells / std::floor(most_steps)))});
  steps_ = static_cast<int>(radius_cells / step_cells_);
  const double reach_cells = footprint.reach_m() / map.metres_per_cell + steps_ * step_cells_ + 3;
  const Eigen::Vector2d north_west = map.overhead_from_enu({places.low.x(), places.high.y()});
  const Eigen::Vector2d south_east = map.overhead_from_enu({places.high.x(), places.low.y()});
  const RasterPlace corner = {static_cast<int>(std::floor(north_west.x() + 1.0 - reach_cells)),
                              static_cast<int>(std::floor(north_west.y() + 1.0 - reach_cells))};
  const int columns =
      static_cast<int>(std::ceil(south_east.x() + 1.0 + reach_cells)) - corner.column;
  const int rows = static_cast<int>(std::ceil(south_east.y() + 1.0 + reach_cells)) - corner.row;
  for (ClassId id = 0; id < kClassCount; ++id) {
    window_of_class_[id] = static_cast<int>(windows_.size());
    if (ground.weights()[id] > 0.0) {
      windows_.emplace_back(ground.cost_raster(id), corner, columns, rows, step_cells_);
    }
  }
}

bool ViewMatcher::take_cells(const Rigid2& enu_from_body) {
  footprint_.see(ground_.map(), enu_from_body, seen_);
  const double cell_m = ground_.map().metres_per_cell;
  cells_.classes.clear();
  cells_.total_weight = 0.0;
  cells_.area_m2 = 0.0;
  for (ClassId id = 0; id < kClassCount; ++id) {
    const std::vector<HalfCell>& all = seen_[id];
    if (all.empty() || ground_.weights()[id] <= 0.0) continue;
    const std::size_t kept =
        std::min(all.size(), static_cast<std::size_t>(options_.cells_per_class));
    MatchCells::OfClass group{id, {}, 0.0};
    group.cells.reserve(kept);
    for (std::size_t i = 0; i < kept; ++i) group.cells.push_back(all[i * all.size() / kept]);
    group.weight_per_cell =
        ground_.weights()[id] * static_cast<double>(all.size()) / static_cast<double>(kept);
    cells_.total_weight += group.weight_per_cell * static_cast<double>(kept);
    cells_.area_m2 += static_cast<double>(all.size()) * cell_m * cell_m;
    cells_.classes.push_back(std::move(group));
  }
  return !cells_.empty();
}

double ViewMatcher::cost_at(const Rigid2& enu_from_body) const {
  const FixedPose pose = fixed_pose(enu_from_body, ground_.map());
  double cost = 0.0;
  for (const MatchCells::OfClass& group : cells_.classes) {
    cost +=
        group.weight_per_cell * sum_costs(ground_.cost_raster(group.id), group.cells, pose, set_);
  }
  return cost / (kFullCost * cells_.total_weight);
}

double ViewMatcher::cost_of(const Competitor& competitor, const Rigid2& enu_from_body) const {
  const double cell_m = ground_.map().metres_per_cell;
  return cost_at({enu_from_body.x_m + competitor.east_cells * cell_m,
                  enu_from_body.y_m - competitor.south_cells * cell_m, enu_from_body.yaw_rad});
}

void ViewMatcher::cost_around(const Rigid2& enu_from_body) {
  const auto side = 2 * static_cast<std::size_t>(steps_) + 1;
  const std::int32_t to_corner = (steps_ * step_cells_) << kFractionBits;
  FixedPose north_west = fixed_pose(enu_from_body, ground_.map());
  north_west.base_column -= to_corner;
  north_west.base_row -= to_corner;
  costs_.assign(side * side, 0.0);
  std::array<std::uint32_t, kRowLanes> sums;
  for (const MatchCells::OfClass& group : cells_.classes) {
    const CostWindow& window = windows_[static_cast<std::size_t>(window_of_class_[group.id])];
    index_.clear();
    for (const HalfCell& cell : group.cells) {
      index_.push_back(static_cast<std::uint32_t>(window.index_of(place_of(cell, north_west))));
    }
    for (std::size_t row = 0; row < side; ++row) {
      sum_rows(window.data() + row * window.index_of_step(), index_, sums.data(), set_);
      double* const to = costs_.data() + row * side;
      for (std::size_t i = 0; i < side; ++i) to[i] += group.weight_per_cell * sums[i];
    }
  }
  for (double& cost : costs_) cost /= kFullCost * cells_.total_weight;
}

double ViewMatcher::worst_competitor() const {
  double worst = 0.0;
  std::size_t at = 0;
  for (int south = -steps_; south <= steps_; ++south) {
    for (int east = -steps_; east <= steps_; ++east, ++at) {
      if (is_competitor(east * step_cells_, south * step_cells_))
        worst = std::max(worst, costs_[at]);
    }
  }
  return worst;
}

ViewMatcher::Competitor ViewMatcher::best_competitor(const Rigid2& enu_from_body) const {
  std::array<Competitor, kSectors> best_of_sector;
  std::size_t at = 0;
  for (int south = -steps_; south <= steps_; ++south) {
    for (int east = -steps_; east <= steps_; ++east, ++at) {
      Competitor& best = best_of_sector[sector_of(east, south)];
      if (costs_[at] >= best.cost || !is_competitor(east * step_cells_, south * step_cells_))
        continue;
      best = {east * step_cells_, south * step_cells_, costs_[at]};
    }
  }
  std::stable_sort(best_of_sector.begin(), best_of_sector.end(),
                   [](const Competitor& a, const Competitor& b) { return a.cost < b.cost; });
  Competitor best = best_of_sector.front();
  for (std::size_t i = 0; i < kRefined; ++i) {
    Competitor found = best_of_sector[i];
    if (found.cost > 1.0) break;  // there is none in that sector
    for (int step = step_cells_ / 2; step > 0; step /= 2) {
      const Competitor centre = found;
      for (int south = -step; south <= step; south += step) {
        for (int east = -step; east <= step; east += step) {
          Competitor beside{centre.east_cells + east, centre.south_cells + south};
          if ((east == 0 && south == 0) || !is_competitor(beside.east_cells, beside.south_cells)) {
            continue;
          }
          beside.cost = cost_of(beside, enu_from_body);
          if (beside.cost < found.cost) found = beside;
        }
      }
    }
    if (found.cost < best.cost) best = found;
  }
  return best;
}

double ViewMatcher::seen_reach_m() const {
  double most = 0.0;  // squared half cells
  for (const MatchCells::OfClass& group : cells_.classes) {
    for (const HalfCell& cell : group.cells) {
      most = std::max(most, static_cast<double>(cell.forward) * cell.forward +
                                static_cast<double>(cell.left) * cell.left);
    }
  }
  return 0.5 * std::sqrt(most) * ground_.map().metres_per_cell;
}

MadeView ViewMatcher::look(const Rigid2& enu_from_body) {
  const SpreadRule rule{.position_sigma_m = options_.prior_sigma_m,
                        .yaw_sigma_rad = Angle::degrees(options_.prior_yaw_sigma_deg).radians()};
  MadeView result{.information = {.std_major_m = static_cast<float>(rule.position_sigma_m),
                                  .std_minor_m = static_cast<float>(rule.position_sigma_m),
                                  .std_heading_rad = static_cast<float>(rule.yaw_sigma_rad)}};
  if (!take_cells(enu_from_body)) return result;
  const double reach_m = seen_reach_m();
  double margin_m = options_.search_radius_m;
  cost_around(enu_from_body);
  const LocaliserOptions& filter = ground_.options();
  const double evidence = filter.full_evidence_area_m2 > 0.0
                              ? std::min(1.0, cells_.area_m2 / filter.full_evidence_area_m2)
                              : 1.0;
  const double scale = filter.likelihood == LikelihoodKind::kThesis
                           ? filter.gamma0 * worst_competitor()
                           : filter.temperature / evidence;
  if (scale > 0.0) {
    set_ambiguity(result.information, enu_from_body, scale);
    const Eigen::Matrix3d covariance = pose_spread(
        [&](const Eigen::Vector3d& offset) {
          margin_m = std::max(margin_m, offset.head<2>().norm() + std::abs(offset.z()) * reach_m);
          return cost_at({enu_from_body.x_m + offset.x(), enu_from_body.y_m + offset.y(),
                          enu_from_body.yaw_rad + offset.z()}) /
                 scale;
        },
        rule);
    set_deviations(result.information, covariance);
  }
  result.seen_reach_m = static_cast<float>(reach_m);
  result.margin_m = static_cast<float>(margin_m);
  return result;
}

void ViewMatcher::set_ambiguity(ViewInformation& information,
                                const Rigid2& enu_from_body,
                                double scale) const {
  const Competitor other = best_competitor(enu_from_body);
  information.ambiguity = 0.0F;
  if (other.cost > 1.0) return;  // the search radius leaves none
  const double cell_m = ground_.map().metres_per_cell;
  const double lead = (other.cost - cost_at(enu_from_body)) / scale;
  information.ambiguity = static_cast<float>(std::exp(-std::max(0.0, lead)));
  information.competitor_east_m = static_cast<float>(other.east_cells * cell_m);
  information.competitor_north_m = static_cast<float>(-other.south_cells * cell_m);
}

}  // namespace nadir::detail
