// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/base/field.h"
#include "core/base/result.h"
#include "core/map/class_statistics.h"

namespace nadir {

/// What a topview cell costs where the map says something else.
enum class MatchKind {
  kClass,     ///< 0 or 1: the thesis's binary semantic photometric error (3.5).
  kDistance,  ///< Distance from the cell to the nearest map cell of its class, over the truncation
              ///< distance.
};
/// How costs become weights.
enum class LikelihoodKind {
  kThesis,    ///< 1 / exp(w / (gamma0 max w)) (thesis, Algorithm 3).
  kTempered,  ///< exp(-mean cost / temperature): neighbouring cells are not independent.
};
/// How the odometry's step is spread over the particles.
enum class MotionKind {
  kThesis,  ///< rot1, trans, rot2 with fixed deviations a step (Thrun et al. 2005, table 5.6).
  kScaled,  ///< Deviations that grow with the time and the way of the step.
};
enum class ResamplingKind {
  kMultinomial,  ///< Independent draws with replacement (thesis).
  kSystematic,   ///< One draw, equal spacing (Thrun et al. 2005, table 4.4): less variance, linear
                 ///< time.
};

template <>
struct EnumNames<MatchKind> {
  static constexpr std::array<std::string_view, 2> kNames = {"class", "distance"};
};
template <>
struct EnumNames<LikelihoodKind> {
  static constexpr std::array<std::string_view, 2> kNames = {"thesis", "tempered"};
};
template <>
struct EnumNames<MotionKind> {
  static constexpr std::array<std::string_view, 2> kNames = {"thesis", "scaled"};
};
template <>
struct EnumNames<ResamplingKind> {
  static constexpr std::array<std::string_view, 2> kNames = {"multinomial", "systematic"};
};

/// Everything that can be set about the filter. The defaults are the preset `default`.
struct LocaliserOptions {
  std::uint64_t seed = 1;
  // How many particles.
  int particle_count = 10'000;
  int min_particle_count = 2'000;
  int global_particle_count = 100'000;
  bool adapt_particle_count = true;
  double kld_error = 0.02;
  // Prediction.
  MotionKind motion = MotionKind::kScaled;
  double rotation_noise_rad = 0.1;
  double translation_noise_m = 0.3;
  double position_noise_m_per_sqrt_s = 0.9;
  double along_noise_m_per_sqrt_m = 0.1;
  double across_noise_m_per_sqrt_m = 0.4;
  double yaw_noise_rad_per_sqrt_s = 0.04;
  double turn_noise_rad_per_sqrt_rad = 0.05;
  double hover_below_m = 0.01;
  // Correction.
  double min_update_interval_s = 0.0;
  MatchKind match = MatchKind::kDistance;
  double truncation_m = 1.0;
  ImportanceReading alpha = ImportanceReading::kInverseRootShare;
  double unknown_cost = 0.5;
  LikelihoodKind likelihood = LikelihoodKind::kTempered;
  double gamma0 = 0.01;
  double temperature = 0.01;
  double min_effective_fraction = 0.05;
  double full_evidence_area_m2 = 10.0;
  double evidence_spacing_m = 1.0;
  double standstill_evidence = 0.1;
  int max_cells_per_class = 400;
  // Resampling and blur.
  ResamplingKind resampling = ResamplingKind::kSystematic;
  double resample_below_fraction = 0.5;
  bool estimate_after_resampling = false;
  double blur_position_m = 0.0;
  double blur_yaw_rad = 0.0;
  double blur_interval_s = 1.0;
};

template <typename Options, typename Visitor>
requires std::same_as<std::remove_const_t<Options>, LocaliserOptions>
void visit_fields(Options& options, Visitor&& visit) {
  visit(options.seed, Field{"seed", "", "Root of every random draw in the run", 0});
  visit(options.particle_count,
        Field{"particles", "", "Particles, or the most there may be where their number adapts", 1,
              1e6});
  visit(options.min_particle_count,
        Field{"min-particles", "", "Fewest particles where their number adapts", 1, 1e6});
  visit(options.global_particle_count,
        Field{"global-particles", "",
              "Particles drawn over the whole map where the start is not known", 1, 1e6});
  visit(options.adapt_particle_count,
        Field{"adapt-particles", "", "Choose the number of particles by KLD sampling (Fox 2003)"});
  visit(options.kld_error,
        Field{"kld-error", "", "Bound on the Kullback-Leibler distance to the posterior, at 99 %",
              1e-4, 1});
  visit(options.motion,
        Field{"motion", "", "Fixed noise a step, or noise that grows with time and way"});
  visit(options.rotation_noise_rad,
        Field{"rotation-noise", "rad", "Deviation of both rotations of a step (motion thesis)", 0,
              3.2});
  visit(options.translation_noise_m,
        Field{"translation-noise", "m", "Deviation of the way of a step (motion thesis)", 0, 100});
  visit(options.position_noise_m_per_sqrt_s,
        Field{"position-noise", "m/sqrt(s)", "Drift of the odometry's position with time", 0, 100});
  visit(options.along_noise_m_per_sqrt_m,
        Field{"along-noise", "m/sqrt(m)", "Drift of the odometry along the way", 0, 100});
  visit(options.across_noise_m_per_sqrt_m,
        Field{"across-noise", "m/sqrt(m)",
              "Drift of the odometry across the way, as from a wrong direction of travel", 0, 100});
  visit(options.yaw_noise_rad_per_sqrt_s,
        Field{"yaw-noise", "rad/sqrt(s)", "Drift of the odometry's heading with time", 0, 10});
  visit(
      options.turn_noise_rad_per_sqrt_rad,
      Field{"turn-noise", "rad/sqrt(rad)", "Drift of the odometry's heading with turning", 0, 10});
  visit(options.hover_below_m,
        Field{"hover-below", "m", "A shorter step has no direction of travel", 0, 10});
  visit(options.min_update_interval_s,
        Field{"min-update-interval", "s",
              "Frames that come sooner after the last used one are passed over", 0, 3600});
  visit(options.match, Field{"match", "", "Cost of a cell: wrong class, or distance to its class"});
  visit(options.truncation_m,
        Field{"truncation", "m", "Distance that costs as much as a missing class (match distance)",
              0.01, 4});
  visit(options.alpha, Field{"alpha", "", "Weight of a class by its share of the map"});
  visit(options.unknown_cost,
        Field{"unknown-cost", "",
              "Cost of a cell on unclassified ground or off the map; 1 is an error", 0, 1});
  visit(options.likelihood, Field{"likelihood", "", "How costs become weights"});
  visit(
      options.gamma0,
      Field{"gamma0", "", "Smallness of eta against the worst cost (likelihood thesis)", 1e-6, 1});
  visit(options.temperature,
        Field{"temperature", "", "Mean cost that lowers the weight e-fold (likelihood tempered)",
              1e-6, 100});
  visit(options.min_effective_fraction,
        Field{"min-effective", "",
              "A topview never leaves a smaller effective share of particles: it is trusted less "
              "instead (likelihood tempered)",
              0, 1});
  visit(options.full_evidence_area_m2,
        Field{"full-evidence-area", "m^2",
              "A smaller topview says proportionally less (likelihood tempered)", 0, 1e6});
  visit(options.evidence_spacing_m,
        Field{"evidence-spacing", "m",
              "After a shorter way the same errors are seen again, so the topview says less", 0,
              1e3});
  visit(options.standstill_evidence,
        Field{"standstill-evidence", "",
              "What a topview says at least, however short the way was, so that a vehicle that "
              "hovers does not go blind; 1 is as much as any",
              0, 1});
  visit(options.max_cells_per_class,
        Field{"max-cells", "",
              "Cells of one class that are matched at most, spread evenly; 0 is all", 0, 1e6});
  visit(options.resampling, Field{"resampling", "", "How survivors are drawn"});
  visit(options.resample_below_fraction,
        Field{"resample-below", "",
              "Resample when the effective share of particles is lower; 1 is always", 0, 1});
  visit(options.estimate_after_resampling,
        Field{"estimate-after-resampling", "",
              "Estimate from the survivors, as the thesis does, instead of the weighted set"});
  visit(options.blur_position_m,
        Field{"blur-position", "m", "Deviation of the blur after resampling, a blur interval", 0,
              100});
  visit(
      options.blur_yaw_rad,
      Field{"blur-yaw", "rad", "Deviation of the blur after resampling, a blur interval", 0, 3.2});
  visit(options.blur_interval_s,
        Field{"blur-interval", "s", "Time over which one blur accrues; 0 is one blur a step", 0,
              3600});
}

/// Options of a named preset: "default", "thesis" (as published, with our reading of alpha and of
/// "error"), "thesis-literal-alpha" (alpha_k as printed in 3.6) or "thesis-hard" (twice the blur,
/// for hard and real flights).
/// @errors kInvalidOptions, naming the nearest preset.
[[nodiscard]] Result<LocaliserOptions> localiser_preset(std::string_view name);
[[nodiscard]] std::vector<std::string> localiser_preset_names();

}  // namespace nadir
