// SPDX-License-Identifier: Apache-2.0
#include "core/mcl/measurement_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/base/require.h"

namespace nadir {
namespace {

constexpr std::size_t kChunk = 64;
constexpr double kFullCost = 255.0;

/// Cost of each map cell for a topview cell of class `id`.
CostRaster build_cost_raster(const OverheadMap& map, ClassId id, const LocaliserOptions& options) {
  const Raster<ClassId>& labels = map.labels;
  const auto unknown = static_cast<std::uint8_t>(std::lround(options.unknown_cost * kFullCost));
  std::optional<DistanceField> field;
  if (options.match == MatchKind::kDistance) {
    field = build_class_distance_field(map, id, options.truncation_m);
  }
  CostRaster raster{labels.width(), labels.height(), {}};
  const auto stride = static_cast<std::size_t>(raster.stride());
  raster.values.assign(stride * static_cast<std::size_t>(labels.height() + 2) + 3, unknown);
  parallel_for(
      static_cast<std::size_t>(labels.height()), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
          const auto row_labels = labels.row(static_cast<int>(row));
          std::uint8_t* const costs = raster.values.data() + (row + 1) * stride + 1;
          for (std::size_t column = 0; column < row_labels.size(); ++column) {
            const std::uint8_t mismatch =
                field ? field->codes.row(static_cast<int>(row))[column]
                      : static_cast<std::uint8_t>(row_labels[column] == id ? 0 : 255);
            costs[column] =
                row_labels[column] == kUnclassified ? std::min(mismatch, unknown) : mismatch;
          }
        }
      });
  return raster;
}

HalfCell half_cell(const TopviewCell& cell) {
  return {static_cast<std::int16_t>(2 * cell.forward + 1),
          static_cast<std::int16_t>(2 * cell.left + 1)};
}

}  // namespace

Result<MapMatcher> MapMatcher::create(std::shared_ptr<const MapIndex> index,
                                      const LocaliserOptions& options,
                                      InstructionSet set) {
  NADIR_REQUIRE(index != nullptr && is_available(set));
  const OverheadMap& map = index->map();
  if (map.labels.width() > kMaxMapSide || map.labels.height() > kMaxMapSide) {
    return fail(ErrorCode::kUnsupported,
                "map '{}': {} x {} cells, but at most {} on a side can be matched", map.name,
                map.labels.width(), map.labels.height(), kMaxMapSide);
  }
  if (const auto usable = check_usable_for_localising(map); !usable) return forward_error(usable);
  MapMatcher matcher;
  matcher.alpha_ = importance_weights(index->statistics(), options.alpha);
  for (ClassId id = 0; id < kClassCount; ++id) {
    if (matcher.alpha_[id] > 0.0) matcher.rasters_[id] = build_cost_raster(map, id, options);
  }
  matcher.index_ = std::move(index);
  matcher.max_cells_per_class_ = options.max_cells_per_class;
  matcher.set_ = set;
  return matcher;
}

MatchCells MapMatcher::prepare(const SemanticTopview& seen) const {
  NADIR_REQUIRE(std::abs(seen.metres_per_cell - map().metres_per_cell) <
                1e-9 * map().metres_per_cell);
  MatchCells result;
  for (ClassId id = 0; id < kClassCount; ++id) {
    const auto cells = seen.of_class(id);
    if (cells.empty() || alpha_[id] <= 0.0) continue;
    const std::size_t most =
        max_cells_per_class_ > 0 ? static_cast<std::size_t>(max_cells_per_class_) : cells.size();
    const std::size_t kept = std::min(most, cells.size());
    MatchCells::OfClass group{id, {}, 0.0};
    group.cells.reserve(kept);
    for (std::size_t i = 0; i < kept; ++i) {
      group.cells.push_back(half_cell(cells[i * cells.size() / kept]));
    }
    group.weight_per_cell =
        alpha_[id] * static_cast<double>(cells.size()) / static_cast<double>(kept);
    result.total_weight += group.weight_per_cell * static_cast<double>(kept);
    result.area_m2 +=
        static_cast<double>(cells.size()) * seen.metres_per_cell * seen.metres_per_cell;
    result.classes.push_back(std::move(group));
  }
  return result;
}

double MapMatcher::mean_cost(const MatchCells& seen, const Rigid2& enu_from_body) const {
  const FixedPose pose = fixed_pose(enu_from_body, map());
  double cost = 0.0;
  for (const MatchCells::OfClass& group : seen.classes) {
    cost += group.weight_per_cell * sum_costs(rasters_[group.id], group.cells, pose, set_);
  }
  return cost / (kFullCost * seen.total_weight);
}

std::vector<double> MapMatcher::mean_costs(const MatchCells& seen,
                                           const ParticleSet& particles) const {
  NADIR_REQUIRE(!seen.empty());
  std::vector<double> costs(particles.size());
  parallel_for(particles.size(), kChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) costs[i] = mean_cost(seen, particles.pose(i));
  });
  return costs;
}

void apply_likelihood(ParticleSet& particles,
                      const std::vector<double>& mean_costs,
                      double evidence,
                      const LocaliserOptions& options) {
  NADIR_REQUIRE(mean_costs.size() == particles.size() && !particles.empty());
  const auto [best, worst] = std::minmax_element(mean_costs.begin(), mean_costs.end());
  const double scale = options.likelihood == LikelihoodKind::kThesis
                           ? options.gamma0 * *worst
                           : options.temperature / std::max(evidence, 1e-12);
  if (!(scale > 0.0)) return;  // every cost is 0: nothing to tell the particles apart
  // exp(-(cost - best) / scale) is at most 1 and 1 for the best, so the sum can neither overflow
  // nor vanish unless all prior weight lies on hopeless particles; then the largest exponent is
  // taken out instead.
  std::vector<double> log_weight(particles.size());
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < particles.size(); ++i) {
    log_weight[i] = std::log(particles.weight[i]) - (mean_costs[i] - *best) / scale;
    largest = std::max(largest, log_weight[i]);
  }
  NADIR_REQUIRE(std::isfinite(largest));
  double sum = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    particles.weight[i] = std::exp(log_weight[i] - largest);
    sum += particles.weight[i];
  }
  for (double& weight : particles.weight) weight /= sum;
}

std::optional<double> agreement(const SemanticTopview& seen,
                                const OverheadMap& map,
                                const Rigid2& enu_from_body) {
  std::size_t known = 0;
  std::size_t same = 0;
  for (ClassId id = 0; id < kClassCount; ++id) {
    for (const TopviewCell& cell : seen.of_class(id)) {
      const Eigen::Vector2d centre_in_body_m =
          Eigen::Vector2d(cell.forward + 0.5, cell.left + 0.5) * seen.metres_per_cell;
      const ClassId there = map.class_at(enu_from_body * centre_in_body_m);
      if (there == kUnclassified) continue;
      ++known;
      if (there == id) ++same;
    }
  }
  if (known == 0) return std::nullopt;
  return static_cast<double>(same) / static_cast<double>(known);
}

}  // namespace nadir
