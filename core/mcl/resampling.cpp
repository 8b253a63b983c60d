// SPDX-License-Identifier: Apache-2.0
#include "core/mcl/resampling.h"

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/base/require.h"
#include "core/mcl/pose_bins.h"

namespace nadir {
namespace {

std::vector<double> cumulative(const std::vector<double>& weight) {
  std::vector<double> sums(weight.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < weight.size(); ++i) sums[i] = sum += weight[i];
  return sums;
}

std::vector<std::size_t> systematic(const std::vector<double>& sums, std::size_t count, DrawId id) {
  const double total = sums.back();
  const double offset = uniforms(id)[0];
  std::vector<std::size_t> ancestors(count);
  std::size_t i = 0;
  for (std::size_t j = 0; j < count; ++j) {
    const double pointer = total * (static_cast<double>(j) + offset) / static_cast<double>(count);
    while (i + 1 < sums.size() && sums[i] <= pointer) ++i;
    ancestors[j] = i;
  }
  return ancestors;
}

std::vector<std::size_t> multinomial(const std::vector<double>& sums,
                                     std::size_t count,
                                     DrawId id) {
  std::vector<std::size_t> ancestors(count);
  for (std::size_t j = 0; j < count; ++j) {
    id.particle = static_cast<std::uint32_t>(j);
    const double pointer = sums.back() * uniforms(id)[0];
    const auto found = std::upper_bound(sums.begin(), sums.end(), pointer);
    ancestors[j] = std::min(static_cast<std::size_t>(found - sums.begin()), sums.size() - 1);
  }
  std::sort(ancestors.begin(), ancestors.end());
  return ancestors;
}

}  // namespace

std::vector<std::size_t> draw_ancestors(const std::vector<double>& weight,
                                        std::size_t count,
                                        ResamplingKind kind,
                                        std::uint64_t seed,
                                        std::uint32_t step) {
  NADIR_REQUIRE(!weight.empty());
  const std::vector<double> sums = cumulative(weight);
  NADIR_REQUIRE(sums.back() > 0.0);
  const DrawId id{.seed = seed, .stream = kResampling, .step = step};
  return kind == ResamplingKind::kSystematic ? systematic(sums, count, id)
                                             : multinomial(sums, count, id);
}

ParticleSet survivors(const ParticleSet& particles, const std::vector<std::size_t>& ancestors) {
  ParticleSet result;
  result.resize(ancestors.size());
  for (std::size_t j = 0; j < ancestors.size(); ++j) {
    result.set_pose(j, particles.pose(ancestors[j]));
    result.weight[j] = 1.0 / static_cast<double>(ancestors.size());
  }
  return result;
}

std::size_t kld_particle_count(std::size_t occupied_bins, double error) {
  NADIR_REQUIRE(error > 0.0);
  if (occupied_bins <= 1) return 1;
  constexpr double kNormalQuantile99 = 2.3263478740408408;
  const auto degrees = static_cast<double>(occupied_bins - 1);
  const double spread = 2.0 / (9.0 * degrees);
  const double root = 1.0 - spread + std::sqrt(spread) * kNormalQuantile99;  // Wilson and Hilferty
  return static_cast<std::size_t>(std::ceil(degrees / (2.0 * error) * root * root * root));
}

std::size_t count_occupied_bins(const ParticleSet& particles,
                                const std::vector<std::size_t>& chosen) {
  const PoseBins bins(0.5, Angle::degrees(10.0).radians());
  std::vector<PoseBins::Bin> occupied(chosen.size());
  for (std::size_t j = 0; j < chosen.size(); ++j) occupied[j] = bins.bin(particles.pose(chosen[j]));
  std::sort(occupied.begin(), occupied.end());
  return static_cast<std::size_t>(std::unique(occupied.begin(), occupied.end()) - occupied.begin());
}

ParticleSet resample(const ParticleSet& particles,
                     const LocaliserOptions& options,
                     std::uint32_t step) {
  const auto draw = [&](std::size_t count) {
    return draw_ancestors(particles.weight, count, options.resampling, options.seed, step);
  };
  const auto most = static_cast<std::size_t>(options.particle_count);
  if (!options.adapt_particle_count) return survivors(particles, draw(most));
  const std::size_t bins = count_occupied_bins(particles, draw(particles.size()));
  const auto least = std::min(most, static_cast<std::size_t>(options.min_particle_count));
  return survivors(particles,
                   draw(std::clamp(kld_particle_count(bins, options.kld_error), least, most)));
}

}  // namespace nadir
