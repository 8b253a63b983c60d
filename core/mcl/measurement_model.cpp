// SPDX-License-Identifier: Apache-2.0
#include "core/mcl/measurement_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/base/require.h"
#include "core/mcl/cell_agreement.h"

namespace nadir {
namespace {

constexpr std::size_t kPosesPerChunk = 64;
constexpr double kFullCost = 255.0;

/// What each code of a distance field costs: the distance over the truncation, at most everything.
std::array<std::uint8_t, 256> costs_of_codes(double field_truncation_m, double truncation_m) {
  std::array<std::uint8_t, 256> costs{};
  for (std::size_t code = 0; code < costs.size(); ++code) {
    const double cost = static_cast<double>(code) * field_truncation_m / truncation_m;
    costs[code] = static_cast<std::uint8_t>(std::lround(std::min(kFullCost, cost)));
  }
  return costs;
}

HalfCell half_cell(const TopviewCell& cell) {
  return {static_cast<std::int16_t>(2 * cell.forward + 1),
          static_cast<std::int16_t>(2 * cell.left + 1)};
}

}  // namespace

CostRaster class_cost_raster(const MapIndex& index, ClassId id, const LocaliserOptions& options) {
  const Raster<ClassId>& labels = index.map().labels;
  const auto unknown = static_cast<std::uint8_t>(std::lround(options.unknown_cost * kFullCost));
  const DistanceField* const field =
      options.match == MatchKind::kDistance ? &index.distance_field(id) : nullptr;
  const auto cost_of_code = costs_of_codes(index.truncation_m(), options.truncation_m);
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
                field != nullptr ? cost_of_code[field->codes.row(static_cast<int>(row))[column]]
                                 : static_cast<std::uint8_t>(row_labels[column] == id ? 0 : 255);
            costs[column] =
                row_labels[column] == kUnclassified ? std::min(mismatch, unknown) : mismatch;
          }
        }
      });
  return raster;
}

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
  if (options.match == MatchKind::kDistance && options.truncation_m > index->truncation_m()) {
    return fail(ErrorCode::kInvalidOptions,
                "--truncation: {} m is more than the {} m that distances on map '{}' reach",
                options.truncation_m, index->truncation_m(), map.name);
  }
  if (const auto usable = check_usable_for_localising(map); !usable) return forward_error(usable);
  MapMatcher matcher;
  matcher.alpha_ = importance_weights(index->statistics(), options.alpha);
  for (ClassId id = 0; id < kClassCount; ++id) {
    if (matcher.alpha_[id] > 0.0) matcher.rasters_[id] = class_cost_raster(*index, id, options);
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

std::array<double, kClassCount> MapMatcher::class_costs(const MatchCells& seen,
                                                        const Rigid2& enu_from_body) const {
  const FixedPose pose = fixed_pose(enu_from_body, map());
  std::array<double, kClassCount> costs{};
  for (const MatchCells::OfClass& group : seen.classes) {
    costs[group.id] = group.weight_per_cell *
                      sum_costs(rasters_[group.id], group.cells, pose, set_) /
                      (kFullCost * seen.total_weight);
  }
  return costs;
}

std::vector<double> MapMatcher::mean_costs(const MatchCells& seen,
                                           const ParticleSet& particles) const {
  NADIR_REQUIRE(!seen.empty());
  std::vector<double> costs(particles.size());
  parallel_for(particles.size(), kPosesPerChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) costs[i] = mean_cost(seen, particles.pose(i));
  });
  return costs;
}

namespace {

/// Weights times exp(-cost / scale), normalised; computed from the largest exponent, so that nothing underflows.
std::vector<double> reweighted(const std::vector<double>& weight,
                               const std::vector<double>& mean_costs,
                               double scale) {
  std::vector<double> result(weight.size());
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < weight.size(); ++i) {
    result[i] = std::log(weight[i]) - mean_costs[i] / scale;
    largest = std::max(largest, result[i]);
  }
  NADIR_REQUIRE(std::isfinite(largest));
  double sum = 0.0;
  for (double& value : result) sum += value = std::exp(value - largest);
  for (double& value : result) value /= sum;
  return result;
}

double effective_fraction(const std::vector<double>& weight) {
  double sum_of_squares = 0.0;
  for (const double value : weight) sum_of_squares += value * value;
  return 1.0 / (sum_of_squares * static_cast<double>(weight.size()));
}

}  // namespace

void apply_likelihood(ParticleSet& particles,
                      const std::vector<double>& mean_costs,
                      double evidence,
                      const LocaliserOptions& options) {
  NADIR_REQUIRE(mean_costs.size() == particles.size() && !particles.empty());
  if (options.likelihood == LikelihoodKind::kThesis) {
    const double eta = options.gamma0 * *std::max_element(mean_costs.begin(), mean_costs.end());
    if (eta > 0.0) particles.weight = reweighted(particles.weight, mean_costs, eta);
    return;  // otherwise every cost is 0 and nothing tells the particles apart
  }
  constexpr int kMostDoublings = 20;
  const double least =
      std::min(options.min_effective_fraction, effective_fraction(particles.weight));
  double scale = options.temperature / std::max(evidence, 1e-12);
  std::vector<double> weight = reweighted(particles.weight, mean_costs, scale);
  for (int i = 0; i < kMostDoublings && effective_fraction(weight) < least; ++i) {
    scale *= 2.0;
    weight = reweighted(particles.weight, mean_costs, scale);
  }
  particles.weight = std::move(weight);
}

std::optional<double> agreement(const SemanticTopview& seen,
                                const OverheadMap& map,
                                const Rigid2& enu_from_body) {
  return cell_agreement(seen, map, enu_from_body).share();
}

}  // namespace nadir
