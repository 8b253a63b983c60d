// SPDX-License-Identifier: Apache-2.0
#include "core/mcl/localiser.h"

#include <gmock/gmock.h>

#include <limits>

#include "core/base/parallel.h"
#include "core/mcl/resampling.h"
#include "tests/support/drawn_map.h"
#include "tests/support/scenery.h"

namespace nadir {
namespace localiser_test {

using testing::HasSubstr;

/// A body that drives a circle on the patchwork map and sees it perfectly.
class CircleDrive {
 public:
  explicit CircleDrive(double metres_per_cell = 0.25)
      : index_(index_of(patchwork_map(400, 400, metres_per_cell))) {}
  [[nodiscard]] const std::shared_ptr<const MapIndex>& index() const { return index_; }
  [[nodiscard]] static Rigid2 truth(int step) {
    const double angle = 0.05 * step;
    return {50.0 + 20.0 * std::cos(angle), 50.0 + 20.0 * std::sin(angle), wrap_rad(angle + 1.5708)};
  }
  /// Odometry whose way is 5 % too long and which turns 0.004 rad too far a step.
  [[nodiscard]] static OdometryStep odometry(int step) {
    if (step == 0) return {};
    Rigid2 motion = truth(step - 1).inverse() * truth(step);
    motion.x_m *= 1.05;
    motion.yaw_rad += 0.004;
    return {motion, 0.25};
  }
  [[nodiscard]] SemanticTopview seen(int step) const {
    return perfect_topview(index_->map(), truth(step), 12.0);
  }

 private:
  std::shared_ptr<const MapIndex> index_;
};

double distance_m(const Rigid2& a, const Rigid2& b) {
  return (a.translation_m() - b.translation_m()).norm();
}

TEST(Localiser, FollowsACircleThatItsOdometryLoses) {
  const CircleDrive drive;
  auto localiser =
      Localiser::create(drive.index(), {}, GaussianPrior{.mean_in_enu = CircleDrive::truth(0)})
          .value();
  Rigid2 dead_reckoning = CircleDrive::truth(0);
  double worst_m = 0.0;
  for (int step = 0; step < 120; ++step) {
    dead_reckoning = dead_reckoning * CircleDrive::odometry(step).before_from_after;
    const auto update = localiser.update(CircleDrive::odometry(step), drive.seen(step));
    if (step >= 10) {
      worst_m =
          std::max(worst_m, distance_m(update.estimate.moments.mean, CircleDrive::truth(step)));
    }
  }
  EXPECT_GT(distance_m(dead_reckoning, CircleDrive::truth(119)), 5.0);
  EXPECT_LT(worst_m, 0.5);
}

TEST(Localiser, FollowsTheCircleWithTheThesisPresetToo) {
  const CircleDrive drive;
  auto localiser = Localiser::create(drive.index(), localiser_preset("thesis").value(),
                                     GaussianPrior{.mean_in_enu = CircleDrive::truth(0)})
                       .value();
  double sum_m = 0.0;
  for (int step = 0; step < 40; ++step) {
    const auto update = localiser.update(CircleDrive::odometry(step), drive.seen(step));
    sum_m += distance_m(update.estimate.moments.mean, CircleDrive::truth(step));
  }
  EXPECT_LT(sum_m / 40.0, 1.5);
}

TEST(Localiser, FindsItselfOnTheWholeMapWithoutAPrior) {
  const CircleDrive drive;  // 100 m x 100 m
  LocaliserOptions options;
  const auto truth = [](int step) { return Rigid2{32.0 + 0.5 * step, 40.0, 0.0}; };
  auto localiser = Localiser::create(drive.index(), options, GlobalPrior{}).value();
  LocaliserUpdate update;
  for (int step = 0; step < 25; ++step) {
    const Rigid2 motion = step == 0 ? Rigid2{} : Rigid2{0.5, 0.0, 0.0};
    update = localiser.update({motion, step == 0 ? 0.0 : 0.25},
                              perfect_topview(drive.index()->map(), truth(step), 12.0));
  }
  EXPECT_LT(distance_m(update.estimate.moments.mean, truth(24)), 0.5);
  EXPECT_GT(update.estimate.modes.at(0).mass, 0.9);
}

TEST(Localiser, GivesTheSameBitsOnOneAndOnFourThreads) {
  const CircleDrive drive;
  const auto run_on = [&](int threads) {
    const ThreadLimit limit(threads);
    auto localiser =
        Localiser::create(drive.index(), {}, GaussianPrior{.mean_in_enu = CircleDrive::truth(0)})
            .value();
    for (int step = 0; step < 12; ++step) {
      (void)localiser.update(CircleDrive::odometry(step), drive.seen(step));
    }
    return localiser.particles();
  };
  EXPECT_EQ(run_on(1), run_on(4));
}

TEST(Localiser, GivesOtherParticlesWithAnotherSeed) {
  const CircleDrive drive;
  LocaliserOptions options;
  const GaussianPrior prior{.mean_in_enu = CircleDrive::truth(0)};
  const auto first = Localiser::create(drive.index(), options, prior).value().particles();
  options.seed = 2;
  EXPECT_NE(Localiser::create(drive.index(), options, prior).value().particles(), first);
}

TEST(Localiser, OnlyMovesOnATopviewThatSaysNothing) {
  const CircleDrive drive;
  auto localiser =
      Localiser::create(drive.index(), {}, GaussianPrior{.mean_in_enu = CircleDrive::truth(0)})
          .value();
  SemanticTopview nothing;
  nothing.metres_per_cell = 0.25;
  double before_m2 = 0.0;
  for (int step = 0; step < 10; ++step) {
    const auto update = localiser.update(CircleDrive::odometry(step), nothing);
    EXPECT_FALSE(update.was_weighted);
    EXPECT_FALSE(update.agreement.has_value());
    const double variance_m2 = update.estimate.moments.covariance.topLeftCorner<2, 2>().trace();
    EXPECT_GT(variance_m2, before_m2);  // uncertainty grows as the odometry's does
    before_m2 = variance_m2;
  }
}

TEST(Localiser, KeepsItsWeightsNormalisedAndItsHeadingsWrapped) {
  const CircleDrive drive;
  auto localiser =
      Localiser::create(drive.index(), {}, GaussianPrior{.mean_in_enu = CircleDrive::truth(0)})
          .value();
  for (int step = 0; step < 30; ++step) {
    (void)localiser.update(CircleDrive::odometry(step), drive.seen(step));
    double sum = 0.0;
    for (const double weight : localiser.particles().weight) sum += weight;
    ASSERT_NEAR(sum, 1.0, 1e-9);
    for (const double yaw : localiser.particles().yaw_rad) {
      ASSERT_TRUE(-std::numbers::pi < yaw && yaw <= std::numbers::pi);
    }
  }
}

TEST(Localiser, GoesOnFromItsOwnParticlesAsIfItHadNeverStopped) {
  const CircleDrive drive;
  auto whole =
      Localiser::create(drive.index(), {}, GaussianPrior{.mean_in_enu = CircleDrive::truth(0)})
          .value();
  ParticleSet middle;
  for (int step = 0; step < 12; ++step) {
    (void)whole.update(CircleDrive::odometry(step), drive.seen(step));
    if (step == 5) middle = whole.particles();
  }
  for (const int threads : {1, 3}) {
    const ThreadLimit limit(threads);
    auto resumed = Localiser::resume(drive.index(), {}, middle, 6).value();
    EXPECT_EQ(resumed.particles(), middle);
    for (int step = 6; step < 12; ++step) {
      (void)resumed.update(CircleDrive::odometry(step), drive.seen(step));
    }
    EXPECT_EQ(resumed.particles(), whole.particles());
  }
}

TEST(Localiser, DrawsOtherNumbersInEachStepThatItGoesOnWith) {
  const CircleDrive drive;
  const auto start =
      Localiser::create(drive.index(), {}, GaussianPrior{.mean_in_enu = CircleDrive::truth(0)})
          .value()
          .particles();
  SemanticTopview nothing;
  nothing.metres_per_cell = 0.25;
  const auto moved_in = [&](std::uint32_t step) {
    auto localiser = Localiser::resume(drive.index(), {}, start, step).value();
    (void)localiser.update(CircleDrive::odometry(1), nothing);
    return localiser.particles();
  };
  EXPECT_EQ(moved_in(3), moved_in(3));
  EXPECT_NE(moved_in(3), moved_in(4));
}

TEST(Localiser, RefusesToGoOnWithOptionsThatMakeNoSense) {
  const CircleDrive drive;
  LocaliserOptions options;
  options.particle_count = 0;
  ParticleSet one;
  one.resize(1);
  one.set_pose(0, CircleDrive::truth(0));
  one.weight[0] = 1.0;
  EXPECT_EQ(Localiser::resume(drive.index(), options, one, 1).error().message,
            "--particles: 0 is not in [1, 1000000]");
  EXPECT_THROW(static_cast<void>(Localiser::resume(drive.index(), {}, ParticleSet{}, 1)),
               std::logic_error);
  EXPECT_THROW(static_cast<void>(Localiser::resume(drive.index(), {}, one, 0)), std::logic_error);
}

TEST(Localiser, RefusesParticleCountsThatCannotBe) {
  const CircleDrive drive;
  LocaliserOptions options;
  options.particle_count = 0;
  EXPECT_EQ(Localiser::create(drive.index(), options, GlobalPrior{}).error().message,
            "--particles: 0 is not in [1, 1000000]");
  options.particle_count = 1'000'000'000;
  EXPECT_THAT(Localiser::create(drive.index(), options, GlobalPrior{}).error().message,
              HasSubstr("--particles"));
}

TEST(Localiser, RefusesNotANumberInOptionsAndPrior) {
  const CircleDrive drive;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  LocaliserOptions options;
  options.temperature = nan;
  EXPECT_THAT(Localiser::create(drive.index(), options, GlobalPrior{}).error().message,
              HasSubstr("--temperature: nan"));
  EXPECT_THAT(Localiser::create(drive.index(), {}, GaussianPrior{.mean_in_enu = {nan, 0.0, 0.0}})
                  .error()
                  .message,
              HasSubstr("prior: nan"));
  EXPECT_FALSE(Localiser::create(drive.index(), {},
                                 GaussianPrior{.mean_in_enu = {50, 50, 0}, .yaw_sigma_rad = -1.0})
                   .has_value());
}

TEST(Localiser, RefusesAStartOffTheMap) {
  const CircleDrive drive;
  EXPECT_EQ(Localiser::create(drive.index(), {}, GaussianPrior{.mean_in_enu = {-5.0, 20.0, 0.0}})
                .error()
                .message,
            "prior: -5.0 m east, 20.0 m north is off map 'patchwork'");
}

TEST(Prior, HasTheSpreadOfTheThesis) {
  const auto map = patchwork_map(400, 400, 0.25);
  const auto particles =
      draw_particles(GaussianPrior{.mean_in_enu = {50, 50, 3.0}}, map, 20'000, 1).value();
  const PoseMoments moments = pose_moments(particles);
  EXPECT_NEAR(moments.covariance(0, 0), 5.0, 0.2);
  EXPECT_NEAR(moments.covariance(1, 1), 5.0, 0.2);
  EXPECT_NEAR(moments.covariance(2, 2), 0.25, 0.01);
}

TEST(Prior, FillsTheMapEvenlyWhenNothingIsKnown) {
  const auto map = patchwork_map(400, 200, 0.25);
  const auto particles = draw_particles(GlobalPrior{}, map, 20'000, 1).value();
  int in_left_half = 0;
  int looking_north = 0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    ASSERT_TRUE(map.contains(particles.pose(i).translation_m()));
    in_left_half += particles.x_in_enu_m[i] < 50.0 ? 1 : 0;
    looking_north += particles.yaw_rad[i] > 0.0 ? 1 : 0;
  }
  EXPECT_NEAR(in_left_half, 10'000, 300);
  EXPECT_NEAR(looking_north, 10'000, 300);
}

/// Effective sample size after a second look from the same place, where the first left off.
double size_after_standstill(double standstill_evidence) {
  const CircleDrive drive;
  LocaliserOptions options;
  options.particle_count = 2'000;
  options.standstill_evidence = standstill_evidence;
  options.min_effective_fraction = 0.0;
  options.resample_below_fraction = 0.0;
  auto localiser =
      Localiser::create(drive.index(), options, GaussianPrior{.mean_in_enu = CircleDrive::truth(0)})
          .value();
  SemanticTopview nothing;
  nothing.metres_per_cell = 0.25;
  (void)localiser.update({}, nothing);
  const OdometryStep still{Rigid2{}, 0.25};
  return localiser.update(still, drive.seen(0)).effective_sample_size;
}

TEST(Localiser, LearnsAtAStandstillAsMuchAsItsOptionSays) {
  // With no evidence nothing is learnt; the more there is, the fewer particles stay effective.
  EXPECT_NEAR(size_after_standstill(0.0), 2'000.0, 1e-6);
  EXPECT_LT(size_after_standstill(0.1), 1'999.0);
  EXPECT_LT(size_after_standstill(1.0), size_after_standstill(0.1));
  EXPECT_DOUBLE_EQ(LocaliserOptions{}.standstill_evidence, 0.1);
}

TEST(LocaliserPresets, HoldTheParametersOfTheThesis) {
  const LocaliserOptions thesis = localiser_preset("thesis").value();
  EXPECT_EQ(thesis.particle_count, 10'000);
  EXPECT_FALSE(thesis.adapt_particle_count);
  EXPECT_DOUBLE_EQ(thesis.gamma0, 0.01);
  EXPECT_DOUBLE_EQ(thesis.rotation_noise_rad, 0.1);
  EXPECT_DOUBLE_EQ(thesis.translation_noise_m, 0.3);
  EXPECT_DOUBLE_EQ(thesis.blur_position_m * thesis.blur_position_m, 1.0);
  EXPECT_NEAR(thesis.blur_yaw_rad * thesis.blur_yaw_rad, 0.1, 1e-12);
  EXPECT_NEAR(1.0 / thesis.min_update_interval_s, 0.72, 1e-12);
  EXPECT_EQ(thesis.alpha, ImportanceReading::kInverseShare);
  EXPECT_EQ(localiser_preset("thesis-literal-alpha")->alpha, ImportanceReading::kShare);
  EXPECT_NEAR(std::pow(localiser_preset("thesis-hard")->blur_yaw_rad, 2), 0.2, 1e-12);
  for (const std::string& name : localiser_preset_names()) {
    EXPECT_TRUE(validate(localiser_preset(name).value()).has_value()) << name;
  }
  EXPECT_EQ(localiser_preset("thesys").error().message,
            "preset 'thesys': does not exist (did you mean thesis?)");
}

}  // namespace localiser_test
}  // namespace nadir
