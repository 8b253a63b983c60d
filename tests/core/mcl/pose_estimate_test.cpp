// SPDX-License-Identifier: Apache-2.0
#include "core/mcl/pose_estimate.h"

#include <gmock/gmock.h>

#include <numbers>

#include "core/base/random.h"

namespace nadir {
namespace pose_estimate_test {

struct Blob {
  Rigid2 centre;
  double sigma_m, sigma_rad, mass;
};

ParticleSet blobs(const std::vector<Blob>& parts, std::size_t count_each) {
  ParticleSet particles;
  particles.resize(parts.size() * count_each);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Blob& part = parts[i / count_each];
    const auto [x, y] = standard_normals({.seed = 1, .particle = static_cast<std::uint32_t>(i)});
    const double turn = standard_normals({.seed = 2, .particle = static_cast<std::uint32_t>(i)})[0];
    particles.set_pose(i, {part.centre.x_m + part.sigma_m * x, part.centre.y_m + part.sigma_m * y,
                           wrap_rad(part.centre.yaw_rad + part.sigma_rad * turn)});
    particles.weight[i] = part.mass / static_cast<double>(count_each);
  }
  return particles;
}

TEST(PoseMoments, AreTheMeanAndCovarianceOfAGaussian) {
  const auto particles = blobs({{{5000.0, -7000.0, 0.5}, 0.7, 0.2, 1.0}}, 20'000);
  const PoseMoments moments = pose_moments(particles);
  EXPECT_NEAR(moments.mean.x_m, 5000.0, 0.02);
  EXPECT_NEAR(moments.mean.y_m, -7000.0, 0.02);
  EXPECT_NEAR(moments.mean.yaw_rad, 0.5, 0.01);
  EXPECT_NEAR(moments.covariance(0, 0), 0.49, 0.02);
  EXPECT_NEAR(moments.covariance(2, 2), 0.04, 0.002);
  EXPECT_NEAR(moments.covariance(0, 1), 0.0, 0.02);
}

TEST(PoseMoments, HaveTheYawVarianceOfTheWrappedNormal) {  // thesis 3.13
  ParticleSet particles = blobs({{{}, 0.0, 0.0, 1.0}}, 2);
  particles.yaw_rad = {0.3, -0.3};
  EXPECT_NEAR(pose_moments(particles).covariance(2, 2), -2.0 * std::log(std::cos(0.3)), 1e-12);
}

TEST(PoseMoments, AverageHeadingsAcrossTheCutAtPi) {
  ParticleSet particles = blobs({{{}, 0.0, 0.0, 1.0}}, 2);
  particles.yaw_rad = {std::numbers::pi - 0.1, -std::numbers::pi + 0.3};
  const PoseMoments moments = pose_moments(particles);
  EXPECT_NEAR(wrap_rad(moments.mean.yaw_rad - (std::numbers::pi + 0.1)), 0.0, 1e-12);
  EXPECT_LT(moments.covariance(2, 2), 0.05);
}

TEST(PoseMoments, WeighParticles) {
  ParticleSet particles = blobs({{{}, 0.0, 0.0, 1.0}}, 2);
  particles.x_in_enu_m = {0.0, 10.0};
  particles.weight = {0.9, 0.1};
  EXPECT_NEAR(pose_moments(particles).mean.x_m, 1.0, 1e-12);
  EXPECT_NEAR(pose_moments(particles).covariance(0, 0), 0.9 * 1.0 + 0.1 * 81.0, 1e-12);
}

TEST(PoseMoments, StayFiniteWhenHeadingsPointEveryWay) {
  ParticleSet particles = blobs({{{}, 0.0, 0.0, 1.0}}, 2);
  particles.yaw_rad = {0.0, std::numbers::pi};
  EXPECT_TRUE(std::isfinite(pose_moments(particles).covariance(2, 2)));
}

TEST(FindModes, FindsTwoBlobsWithTheirMassAndPlace) {
  const auto particles =
      blobs({{{0.0, 0.0, 0.0}, 0.5, 0.05, 0.3}, {{40.0, 5.0, 2.0}, 0.5, 0.05, 0.7}}, 3000);
  const auto modes = find_modes(particles);
  ASSERT_EQ(modes.size(), 2U);
  EXPECT_NEAR(modes[0].mass, 0.7, 0.01);
  EXPECT_NEAR(modes[0].moments.mean.x_m, 40.0, 0.1);
  EXPECT_NEAR(modes[1].mass, 0.3, 0.01);
  EXPECT_NEAR(modes[1].moments.covariance(0, 0), 0.25, 0.03);
}

TEST(FindModes, TellsOppositeHeadingsAtOnePlaceApart) {
  const auto particles =
      blobs({{{0.0, 0.0, 0.1}, 0.3, 0.05, 0.5}, {{0.0, 0.0, -3.0}, 0.3, 0.05, 0.5}}, 2000);
  EXPECT_EQ(find_modes(particles).size(), 2U);
}

TEST(FindModes, DoesNotCutABlobAtTheHeadingPi) {
  const auto particles = blobs({{{0.0, 0.0, std::numbers::pi}, 0.3, 0.1, 1.0}}, 2000);
  ASSERT_EQ(find_modes(particles).size(), 1U);
  EXPECT_NEAR(std::abs(find_modes(particles)[0].moments.mean.yaw_rad), std::numbers::pi, 0.02);
}

TEST(FindModes, LeavesOutLightModesAndListsNoMoreThanAsked) {
  std::vector<Blob> parts;
  for (int i = 0; i < 12; ++i)
    parts.push_back({{20.0 * i, 0.0, 0.0}, 0.2, 0.02, i == 0 ? 0.001 : 0.0908});
  const auto modes = find_modes(blobs(parts, 300), {.max_modes = 5});
  EXPECT_EQ(modes.size(), 5U);
  for (const PoseMode& mode : modes) EXPECT_GT(mode.moments.mean.x_m, 10.0);
}

TEST(EffectiveSampleSize, IsTheCountForEqualWeightsAndOneForASingleSurvivor) {
  ParticleSet particles = blobs({{{}, 1.0, 0.1, 1.0}}, 400);
  EXPECT_NEAR(effective_sample_size(particles), 400.0, 1e-9);
  std::fill(particles.weight.begin(), particles.weight.end(), 0.0);
  EXPECT_EQ(effective_sample_size(particles), 0.0);
  particles.weight[3] = 1.0;
  EXPECT_EQ(effective_sample_size(particles), 1.0);
}

}  // namespace pose_estimate_test
}  // namespace nadir
