// SPDX-License-Identifier: Apache-2.0
#include "core/mcl/localiser.h"

#include <algorithm>

#include "core/base/require.h"
#include "core/mcl/resampling.h"

namespace nadir {

Result<Localiser> Localiser::create(std::shared_ptr<const MapIndex> index,
                                    const LocaliserOptions& options,
                                    const Prior& prior) {
  if (const auto valid = validate(options); !valid) return forward_error(valid);
  auto matcher = MapMatcher::create(std::move(index), options);
  if (!matcher) return forward_error(matcher);
  const bool is_global = std::holds_alternative<GlobalPrior>(prior);
  const int count = is_global ? options.global_particle_count : options.particle_count;
  auto particles = draw_particles(prior, matcher->map(), count, options.seed);
  if (!particles) return forward_error(particles);
  return Localiser(std::move(*matcher), options, std::move(*particles), 0);
}

Result<Localiser> Localiser::resume(std::shared_ptr<const MapIndex> index,
                                    const LocaliserOptions& options,
                                    ParticleSet particles,
                                    std::uint32_t first_step) {
  NADIR_REQUIRE(!particles.empty() && first_step > 0);
  if (const auto valid = validate(options); !valid) return forward_error(valid);
  auto matcher = MapMatcher::create(std::move(index), options);
  if (!matcher) return forward_error(matcher);
  return Localiser(std::move(*matcher), options, std::move(particles), first_step);
}

LocaliserUpdate Localiser::update(const OdometryStep& odometry, const SemanticTopview& seen) {
  LocaliserUpdate result;
  if (step_ > 0) predict(particles_, odometry, options_, step_);  // thesis 3.5, step 2

  const MatchCells cells = matcher_.prepare(seen);
  result.was_weighted = !cells.empty();
  if (result.was_weighted) {  // step 3
    apply_likelihood(particles_, matcher_.mean_costs(cells, particles_),
                     evidence_of(cells, odometry), options_);
  }
  result.effective_sample_size = effective_sample_size(particles_);
  const double effective_fraction =
      result.effective_sample_size / static_cast<double>(particles_.size());
  // Rounding may lift the fraction of equal weights above 1.
  result.was_resampled =
      result.was_weighted && std::min(1.0, effective_fraction) <= options_.resample_below_fraction;

  const auto estimate = [&] {
    result.estimate = {pose_moments(particles_), find_modes(particles_)};
  };
  if (!options_.estimate_after_resampling) estimate();
  if (result.was_resampled) particles_ = resample(particles_, options_, step_);  // step 4
  if (options_.estimate_after_resampling) estimate();                            // step 5
  result.agreement = agreement(seen, matcher_.map(), result.estimate.moments.mean);
  blur(particles_, odometry.elapsed_s, options_, step_);  // step 6
  ++step_;
  return result;
}

double Localiser::evidence_of(const MatchCells& seen, const OdometryStep& odometry) const {
  double evidence = 1.0;
  if (options_.full_evidence_area_m2 > 0.0) {
    evidence *= std::min(1.0, seen.area_m2 / options_.full_evidence_area_m2);
  }
  if (step_ > 0 && options_.evidence_spacing_m > 0.0) {
    // A vehicle that stands still sees the same errors again and again.
    evidence *= std::clamp(odometry.way_m() / options_.evidence_spacing_m,
                           options_.standstill_evidence, 1.0);
  }
  return evidence;
}

}  // namespace nadir
