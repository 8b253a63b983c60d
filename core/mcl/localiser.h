// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "core/mcl/localiser_options.h"
#include "core/mcl/measurement_model.h"
#include "core/mcl/motion_model.h"
#include "core/mcl/pose_estimate.h"
#include "core/mcl/prior.h"

namespace nadir {

/// What one update says, beside the particles themselves.
struct LocaliserUpdate {
  PoseEstimate estimate;
  double effective_sample_size = 0.0;  ///< After weighting, before resampling.
  bool was_weighted = false;  ///< False where the topview held nothing that the map could answer.
  bool was_resampled = false;
  std::optional<double> agreement;  ///< At the estimate; see agreement().
};

/// Monte Carlo localisation of a body on a labelled overhead (Rouben 2018, section 3.5; Thrun et
/// al. 2005, chapter 8).
///
/// Feed it every step of the odometry with the topview that was seen after it. One thread at a
/// time; inside, an update uses as many threads as parallel_for may. Same options and inputs, same
/// particles, bit for bit.
class Localiser {
 public:
  /// @errors kInvalidOptions (options, prior), kMalformed or kUnsupported (a map that cannot be
  /// matched).
  [[nodiscard]] static Result<Localiser> create(std::shared_ptr<const MapIndex> index,
                                                const LocaliserOptions& options,
                                                const Prior& prior);

  /// Goes on from particles that an earlier run left after an update, instead of a prior.
  /// @param particles   Not empty; finite poses, weights that sum to 1.
  /// @param first_step  Number of the update that comes next, 1 or more: one more than that of the update that left the particles,
  /// so that no random draw comes twice.
  /// @errors kInvalidOptions (options), kMalformed or kUnsupported (a map that cannot be matched).
  [[nodiscard]] static Result<Localiser> resume(std::shared_ptr<const MapIndex> index,
                                                const LocaliserOptions& options,
                                                ParticleSet particles,
                                                std::uint32_t first_step);

  /// Predicts, weighs, estimates, resamples and blurs. For the very first topview after create()
  /// the step is the identity with 0 s.
  /// @param seen  Of the map's resolution. Empty is allowed: then the particles only move.
  [[nodiscard]] LocaliserUpdate update(const OdometryStep& odometry, const SemanticTopview& seen);

  [[nodiscard]] const ParticleSet& particles() const { return particles_; }
  [[nodiscard]] const LocaliserOptions& options() const { return options_; }
  [[nodiscard]] const MapMatcher& matcher() const { return matcher_; }

 private:
  Localiser(MapMatcher matcher,
            const LocaliserOptions& options,
            ParticleSet particles,
            std::uint32_t first_step)
      : matcher_(std::move(matcher)),
        options_(options),
        particles_(std::move(particles)),
        step_(first_step) {}
  [[nodiscard]] double evidence_of(const MatchCells& seen, const OdometryStep& odometry) const;

  MapMatcher matcher_;
  LocaliserOptions options_;
  ParticleSet particles_;
  std::uint32_t step_;  ///< Number of the next update.
};

}  // namespace nadir
