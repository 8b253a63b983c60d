// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/geo/rigid2.h"
#include "core/mcl/particle_set.h"
#include "core/topview/semantic_topview.h"

namespace nadir::detail {

using Bytes = std::vector<std::uint8_t>;

/// Particles as zstd of four little-endian float32 arrays: x and y relative to the estimate (m),
/// yaw (rad), weight. Positions come back to 0.6 mm within 8 km of the estimate, yaw to 2e-7 rad,
/// weights to 1 part in 10^7; below 1e-38 of the heaviest a weight may become 0.
/// @errors kMalformed, without a file name: what decode_particles would refuse.
[[nodiscard]] Result<Bytes> encode_particles(const ParticleSet& particles,
                                             const Rigid2& estimate_in_enu);

/// Weights are made to sum to 1 again. @errors kMalformed, without a file name: the blob is not
/// what `count` says, a value is not finite, or the weights sum to nothing.
[[nodiscard]] Result<ParticleSet> decode_particles(std::span<const std::uint8_t> blob,
                                                   std::int64_t count,
                                                   const Rigid2& estimate_in_enu);

/// A topview as zstd of three arrays: forward and left as little-endian int16, class as uint8.
/// Lossless. @errors kMalformed, without a file name: what decode_topview would refuse.
[[nodiscard]] Result<Bytes> encode_topview(const SemanticTopview& topview);

/// @errors kMalformed, without a file name: as above, or the classes do not rise.
[[nodiscard]] Result<SemanticTopview> decode_topview(std::span<const std::uint8_t> blob,
                                                     std::int64_t count,
                                                     double metres_per_cell);

}  // namespace nadir::detail
