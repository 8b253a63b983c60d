// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/mcl/localiser_options.h"
#include "core/mcl/particle_set.h"

namespace nadir {

/// Which particle each of `count` survivors descends from, drawn in proportion to weight; indices
/// do not fall. Systematic: one random offset and equal spacing, O(N + count) (Thrun et al. 2005,
/// table 4.4). Multinomial: independent draws, O(count log N).
[[nodiscard]] std::vector<std::size_t> draw_ancestors(const std::vector<double>& weight,
                                                      std::size_t count,
                                                      ResamplingKind kind,
                                                      std::uint64_t seed,
                                                      std::uint32_t step);

/// Survivors of equal weight.
[[nodiscard]] ParticleSet survivors(const ParticleSet& particles,
                                    const std::vector<std::size_t>& ancestors);

/// How many particles bound the Kullback-Leibler distance between the sampled and the true
/// posterior by `error` with 99 % probability, when samples fall into `occupied_bins` bins (Fox,
/// "Adapting the sample size in particle filters through KLD-sampling", IJRR 2003, equation 6). 1
/// for one bin or none.
[[nodiscard]] std::size_t kld_particle_count(std::size_t occupied_bins, double error);

/// Bins of 0.5 m x 0.5 m x 10 degrees that the particles named by `chosen` occupy.
[[nodiscard]] std::size_t count_occupied_bins(const ParticleSet& particles,
                                              const std::vector<std::size_t>& chosen);

/// Draws survivors as the options say; their number adapts where `adapt_particle_count` is set.
[[nodiscard]] ParticleSet resample(const ParticleSet& particles,
                                   const LocaliserOptions& options,
                                   std::uint32_t step);

}  // namespace nadir
