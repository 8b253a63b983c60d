// SPDX-License-Identifier: Apache-2.0
#include "core/mcl/localiser_options.h"

#include <cmath>

namespace nadir {
namespace {

/// Rouben 2018, section 4.2: N = 10,000; sigma_rot = 0.1 rad; sigma_trans = 0.3 m; blur covariance
/// diag(1, 1, 0.1); gamma0 = 0.01; 0.72 updates a second; resampling with replacement at every
/// step.
LocaliserOptions thesis_options() {
  LocaliserOptions options;
  options.particle_count = 10'000;
  options.global_particle_count = 10'000;
  options.adapt_particle_count = false;
  options.motion = MotionKind::kThesis;
  options.hover_below_m = 0.0;
  options.min_update_interval_s = 1.0 / 0.72;
  options.match = MatchKind::kClass;
  options.alpha = ImportanceReading::kInverseShare;
  options.unknown_cost = 1.0;
  options.likelihood = LikelihoodKind::kThesis;
  options.min_effective_fraction = 0.0;
  options.full_evidence_area_m2 = 0.0;
  options.evidence_spacing_m = 0.0;
  options.max_cells_per_class = 0;
  options.resampling = ResamplingKind::kMultinomial;
  options.resample_below_fraction = 1.0;
  options.estimate_after_resampling = true;
  options.blur_position_m = 1.0;
  options.blur_yaw_rad = std::sqrt(0.1);
  options.blur_interval_s = 0.0;
  return options;
}

}  // namespace

std::vector<std::string> localiser_preset_names() {
  return {"default", "thesis", "thesis-literal-alpha", "thesis-hard"};
}

Result<LocaliserOptions> localiser_preset(std::string_view name) {
  if (name == "default") return LocaliserOptions{};
  LocaliserOptions options = thesis_options();
  if (name == "thesis") return options;
  if (name == "thesis-literal-alpha") {
    options.alpha = ImportanceReading::kShare;
    return options;
  }
  if (name == "thesis-hard") {
    options.blur_position_m = std::sqrt(2.0);
    options.blur_yaw_rad = std::sqrt(0.2);
    return options;
  }
  const std::string nearest = nearest_word(name, localiser_preset_names());
  return fail(ErrorCode::kInvalidOptions, "preset '{}': does not exist{}", name,
              nearest.empty() ? std::string() : fmt::format(" (did you mean {}?)", nearest));
}

}  // namespace nadir
