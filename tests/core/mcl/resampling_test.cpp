// SPDX-License-Identifier: Apache-2.0
#include "core/mcl/resampling.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>

#include "core/base/random.h"

namespace nadir {
namespace resampling_test {

using testing::AllOf;
using testing::Ge;
using testing::Le;

std::vector<double> random_weights(std::size_t count) {
  std::vector<double> weight(count);
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    weight[i] = uniforms({.seed = 9, .particle = static_cast<std::uint32_t>(i)})[0];
    sum += weight[i];
  }
  for (double& value : weight) value /= sum;
  return weight;
}

std::vector<int> copies_of(const std::vector<std::size_t>& ancestors, std::size_t count) {
  std::vector<int> copies(count, 0);
  for (const std::size_t i : ancestors) ++copies[i];
  return copies;
}

ParticleSet particles_with(const std::vector<double>& weight) {
  ParticleSet particles;
  particles.resize(weight.size());
  particles.weight = weight;
  for (std::size_t i = 0; i < weight.size(); ++i) {
    particles.set_pose(i, {static_cast<double>(i), 0.0, 0.0});
  }
  return particles;
}

TEST(SystematicResampling, DrawsEachParticleAsOftenAsItsWeightSaysUpToOne) {
  const auto weight = random_weights(200);
  for (std::uint32_t step = 0; step < 20; ++step) {
    const auto copies =
        copies_of(draw_ancestors(weight, 1000, ResamplingKind::kSystematic, 1, step), 200);
    for (std::size_t i = 0; i < weight.size(); ++i) {
      EXPECT_THAT(copies[i], AllOf(Ge(std::floor(1000 * weight[i] - 1e-9)),
                                   Le(std::ceil(1000 * weight[i] + 1e-9))));
    }
  }
}

TEST(MultinomialResampling, DrawsInProportionToWeight) {
  const std::vector<double> weight = {0.5, 0.0, 0.3, 0.2};
  const auto copies =
      copies_of(draw_ancestors(weight, 40'000, ResamplingKind::kMultinomial, 1, 0), 4);
  EXPECT_NEAR(copies[0], 20'000, 4 * 100);
  EXPECT_EQ(copies[1], 0);
  EXPECT_NEAR(copies[2], 12'000, 4 * 92);
}

TEST(Resampling, NeverDrawsAParticleWithoutWeight) {
  std::vector<double> weight(50, 0.0);
  weight[0] = weight[49] = 0.0;
  weight[17] = 1.0;
  for (const auto kind : {ResamplingKind::kSystematic, ResamplingKind::kMultinomial}) {
    for (std::uint32_t step = 0; step < 50; ++step) {
      EXPECT_THAT(draw_ancestors(weight, 30, kind, 1, step), testing::Each(17U));
    }
  }
}

TEST(Resampling, GivesSurvivorsEqualWeightAndTheirAncestorsPose) {
  const ParticleSet result = survivors(particles_with({0.1, 0.9}), {1, 1, 0});
  EXPECT_THAT(result.weight, testing::Each(1.0 / 3.0));
  EXPECT_THAT(result.x_in_enu_m, testing::ElementsAre(1.0, 1.0, 0.0));
}

TEST(KldParticleCount, AgreesWithTheFormulaOfFoxOnKnownNumbers) {
  // k = 101 bins, error 0.05, 99 %: chi-square quantile of 100 degrees is 135.807, over 2 * 0.05.
  EXPECT_NEAR(static_cast<double>(kld_particle_count(101, 0.05)), 135.807 / 0.1, 2.0);
  EXPECT_NEAR(static_cast<double>(kld_particle_count(11, 0.02)), 23.209 / 0.04, 3.0);
  EXPECT_EQ(kld_particle_count(1, 0.05), 1U);
}

TEST(Resampling, TakesFewerParticlesForAPosteriorThatFillsFewerBins) {
  LocaliserOptions options;
  options.particle_count = 10'000;
  options.min_particle_count = 50;
  ParticleSet tight = particles_with(std::vector<double>(1000, 1e-3));
  std::fill(tight.x_in_enu_m.begin(), tight.x_in_enu_m.end(), 5.0);
  EXPECT_EQ(resample(tight, options, 1).size(), 50U);
  const ParticleSet wide =
      particles_with(std::vector<double>(1000, 1e-3));  // a metre apart: a bin each
  EXPECT_EQ(resample(wide, options, 1).size(), 10'000U);
  options.adapt_particle_count = false;
  options.particle_count = 300;
  EXPECT_EQ(resample(tight, options, 1).size(), 300U);
}

TEST(CountOccupiedBins, CountsPlacesAndHeadingsOnce) {
  ParticleSet particles = particles_with({0.25, 0.25, 0.25, 0.25});
  particles.set_pose(0, {0.1, 0.1, 0.0});
  particles.set_pose(1, {0.2, 0.4, 0.05});
  particles.set_pose(2, {0.2, 0.4, 0.5});
  particles.set_pose(3, {-0.1, 0.4, 0.05});
  EXPECT_EQ(count_occupied_bins(particles, {0, 1, 2, 3}), 3U);
  EXPECT_EQ(count_occupied_bins(particles, {1, 1, 1}), 1U);
}

}  // namespace resampling_test
}  // namespace nadir
