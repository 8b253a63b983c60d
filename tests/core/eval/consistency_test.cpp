// SPDX-License-Identifier: Apache-2.0
#include "core/eval/consistency.h"

#include <gmock/gmock.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/random.h"

namespace nadir {
namespace consistency_test {

Eigen::Matrix3d tilted_covariance() {
  Eigen::Matrix3d covariance;
  covariance << 4.0, 1.5, 0.02, 1.5, 1.0, -0.01, 0.02, -0.01, 0.0025;
  return covariance;
}

/// Errors drawn from `drawn` while the filter claims `claimed`.
std::vector<EvaluatedStep> gaussian_steps(int count,
                                          const Eigen::Matrix3d& drawn,
                                          const Eigen::Matrix3d& claimed) {
  const Eigen::Matrix3d factor = drawn.llt().matrixL();
  std::vector<EvaluatedStep> steps;
  for (int i = 0; i < count; ++i) {
    const auto number = static_cast<std::uint32_t>(i);
    const auto [a, b] = standard_normals({.seed = 5, .stream = 1, .step = number, .draw = 0});
    const auto [c, unused] = standard_normals({.seed = 5, .stream = 1, .step = number, .draw = 1});
    static_cast<void>(unused);
    const Eigen::Vector3d error = factor * Eigen::Vector3d(a, b, c);
    const Rigid2 truth{100.0 + i, -50.0, wrap_rad(0.37 * i)};
    steps.push_back({.time_s = 0.1 * i,
                     .truth_in_enu = truth,
                     .estimate_in_enu = {truth.x_m + error.x(), truth.y_m + error.y(),
                                         wrap_rad(truth.yaw_rad + error.z())},
                     .covariance = claimed,
                     .odometry_in_enu = truth});
  }
  return steps;
}

TEST(ChiSquareQuantile, AgreesWithPrintedTables) {
  EXPECT_NEAR(chi_square_quantile(0.95, 1), 3.8414588, 1e-6);
  EXPECT_NEAR(chi_square_quantile(0.95, 2), 5.9914645, 1e-6);
  EXPECT_NEAR(chi_square_quantile(0.95, 3), 7.8147279, 1e-6);
  EXPECT_NEAR(chi_square_quantile(0.025, 10), 3.2469728, 1e-6);
  EXPECT_NEAR(chi_square_quantile(0.975, 100), 129.5611972, 1e-5);
}

TEST(StepNeesBounds, AreTheQuantilesOfThreeDegreesOfFreedom) {
  const StepNeesBounds bounds = step_nees_bounds();
  EXPECT_EQ(bounds.degrees_of_freedom, 3);
  EXPECT_NEAR(bounds.lower, 0.2158, 1e-4);  // as tables of the distribution have them
  EXPECT_NEAR(bounds.upper, 9.3484, 1e-4);
}

TEST(ChiSquareQuantile, IsExactForTwoDegreesOfFreedomAndNormalForMany) {
  for (const double p : {0.01, 0.5, 0.9, 0.999}) {
    EXPECT_NEAR(chi_square_quantile(p, 2), -2.0 * std::log1p(-p), 1e-9);
  }
  const double n = 3.0 * 4541;  // Wilson & Hilferty 1931, good to 1e-6 here.
  const double root = 1.0 - 2.0 / (9.0 * n) + 1.959963985 * std::sqrt(2.0 / (9.0 * n));
  EXPECT_NEAR(chi_square_quantile(0.975, n) / (n * root * root * root), 1.0, 1e-6);
  EXPECT_THROW(static_cast<void>(chi_square_quantile(1.0, 2)), std::logic_error);
  EXPECT_THROW(static_cast<void>(chi_square_quantile(0.5, 0)), std::logic_error);
}

TEST(NormalisedError, IsTheMahalanobisDistanceSquared) {
  const Eigen::Matrix3d covariance = tilted_covariance();
  const Eigen::Vector3d error(1.0, -2.0, 0.03);
  const auto squared = normalised_error_squared(error, covariance);
  ASSERT_TRUE(squared);
  EXPECT_NEAR(*squared, error.dot(covariance.inverse() * error), 1e-9);
  EXPECT_NEAR(*normalised_error_squared(Eigen::Vector2d(3, 4),
                                        Eigen::Matrix2d(Eigen::Matrix2d::Identity())),
              25.0, 1e-12);
}

TEST(NormalisedError, IsUnknownForACovarianceThatIsNone) {
  const Eigen::Vector3d error(1, 1, 1);
  Eigen::Matrix3d bad = Eigen::Matrix3d::Zero();
  EXPECT_FALSE(normalised_error_squared(error, bad));
  bad = Eigen::Matrix3d::Ones();  // Rank one.
  EXPECT_FALSE(normalised_error_squared(error, bad));
  bad = Eigen::Vector3d(1, 1, -1).asDiagonal();
  EXPECT_FALSE(normalised_error_squared(error, bad));
  bad = Eigen::Vector3d(1, 1, std::nan("")).asDiagonal();
  EXPECT_FALSE(normalised_error_squared(error, bad));
  bad = Eigen::Vector3d(1, 1, std::numeric_limits<double>::infinity()).asDiagonal();
  EXPECT_FALSE(normalised_error_squared(error, bad));
}

TEST(NormalisedError, SmallButSoundCovariancesAreNotSingular) {
  const Eigen::Matrix3d tiny = Eigen::Vector3d(1e-8, 1e-8, 1e-14).asDiagonal();
  EXPECT_NEAR(*normalised_error_squared(Eigen::Vector3d(1e-4, 0, 1e-7), tiny), 2.0, 1e-9);
}

TEST(Consistency, OfAPerfectFilterIsThreeWithNinetyFivePercentCoverage) {
  const int count = 4000;
  const auto result =
      assess_consistency(gaussian_steps(count, tilted_covariance(), tilted_covariance()));
  EXPECT_EQ(result.nees_steps, 4000U);
  EXPECT_EQ(result.excluded_steps, 0U);
  EXPECT_GT(*result.nees_mean, *result.nees_lower_95);
  EXPECT_LT(*result.nees_mean, *result.nees_upper_95);
  EXPECT_NEAR(*result.nees_lower_95, 3.0 - 1.96 * std::sqrt(6.0 / count), 1e-3);
  EXPECT_NEAR(*result.nees_upper_95, 3.0 + 1.96 * std::sqrt(6.0 / count), 1e-3);
  const double sigma = std::sqrt(0.95 * 0.05 / count);  // Binomial.
  EXPECT_NEAR(*result.coverage_95, 0.95, 3.0 * sigma);
}

TEST(Consistency, CoverageComparesSquaredDistances) {
  // Comparing d instead of d^2 with 5.991 would count practically everything as covered.
  const Eigen::Matrix3d unit = Eigen::Matrix3d::Identity() * 0.01;
  std::vector<EvaluatedStep> steps(2);
  for (auto& step : steps) {
    step.truth_in_enu = Rigid2{};
    step.covariance = unit;
  }
  steps[0].estimate_in_enu.x_m = 0.244;  // d^2 = 5.954
  steps[1].estimate_in_enu.x_m = 0.246;  // d^2 = 6.052
  EXPECT_EQ(*assess_consistency(steps).coverage_95, 0.5);
}

TEST(Consistency, OfAnOverconfidentFilterIsOutOfBounds) {
  const auto result =
      assess_consistency(gaussian_steps(1000, tilted_covariance(), tilted_covariance() / 4.0));
  EXPECT_NEAR(*result.nees_mean, 12.0, 1.0);
  EXPECT_GT(*result.nees_mean, *result.nees_upper_95);
  // Inside means d^2 <= 5.991 / 4 of the true covariance: 1 - exp(-5.991 / 8) = 0.527.
  EXPECT_NEAR(*result.coverage_95, 0.527, 0.05);
}

TEST(Consistency, WrapsTheYawError) {
  EvaluatedStep step{.truth_in_enu = Rigid2{0, 0, -3.13}, .estimate_in_enu = {0, 0, 3.13}};
  step.covariance = Eigen::Matrix3d::Identity();
  const auto result = assess_consistency(std::vector{step});
  EXPECT_NEAR(*result.nees_mean, std::pow(2.0 * 3.14159265358979 - 6.26, 2), 1e-9);
}

TEST(Consistency, DoesNotImproveWhereTheFilterCollapses) {
  auto steps = gaussian_steps(100, tilted_covariance(), tilted_covariance());
  const double before = *assess_consistency(steps).coverage_95;
  for (std::size_t i = 0; i < 50; ++i) steps[i].covariance.setZero();
  const auto half = assess_consistency(steps);
  EXPECT_EQ(half.coverage_steps, 100U);
  EXPECT_LE(*half.coverage_95, 0.5);
  EXPECT_LT(*half.coverage_95, before);
  for (EvaluatedStep& step : steps) step.covariance.setZero();
  const auto all = assess_consistency(steps);
  EXPECT_EQ(*all.coverage_95, 0.0);
  EXPECT_EQ(all.excluded_steps, 100U);
  EXPECT_FALSE(all.nees_mean);
}

TEST(Consistency, CountsWhatItLeavesOutAndSkipsStepsWithoutTruth) {
  auto steps = gaussian_steps(4, tilted_covariance(), tilted_covariance());
  steps[1].truth_in_enu.reset();
  steps[2].covariance(2, 2) = 0.0;  // No yaw spread: no NEES, but the ellipse is sound.
  steps[3].covariance.setZero();
  const auto result = assess_consistency(steps);
  EXPECT_EQ(result.nees_steps, 1U);
  EXPECT_EQ(result.excluded_steps, 2U);
  EXPECT_EQ(result.coverage_steps, 3U) << "a singular ellipse counts, with nothing inside it";
  const auto nothing = assess_consistency({});
  EXPECT_FALSE(nothing.nees_mean || nothing.nees_lower_95 || nothing.coverage_95);
}

TEST(NormalisedError, AMatrixThatIsNotSymmetricHasNone) {
  Eigen::Matrix3d covariance = tilted_covariance();
  const Eigen::Vector3d error(1.0, -1.0, 0.01);
  ASSERT_TRUE(normalised_error_squared(error, covariance));
  covariance(0, 1) += 1e-12;
  EXPECT_TRUE(normalised_error_squared(error, covariance)) << "rounding";
  covariance(0, 1) += 1e-3;
  EXPECT_FALSE(normalised_error_squared(error, covariance));
  const Eigen::Vector2d position_error = error.head<2>();
  const Eigen::Matrix2d position = covariance.topLeftCorner<2, 2>();
  EXPECT_FALSE(normalised_error_squared(position_error, position));
}

TEST(NormalisedError, DoesNotDependOnUnitsNearSingularEither) {
  Eigen::Matrix3d covariance = tilted_covariance();
  covariance.col(2).head<2>().setZero();
  covariance.row(2).head<2>().setZero();
  covariance(0, 1) = covariance(1, 0) = 2.0 * (1.0 - 1e-5);  // correlation 0.99999
  const Eigen::Vector3d error(0.5, 0.25, 0.01);
  const auto in_metres = normalised_error_squared(error, covariance);
  ASSERT_TRUE(in_metres);
  const Eigen::Vector3d units(1e3, 1e3, 57.3);  // millimetres and degrees
  const Eigen::Matrix3d scaled = units.asDiagonal() * covariance * units.asDiagonal();
  EXPECT_NEAR(*normalised_error_squared(units.cwiseProduct(error), scaled) / *in_metres, 1.0, 1e-9);
}

TEST(PositionSpread, IsTheRootOfTheDeterminant) {
  const Eigen::Matrix3d covariance = tilted_covariance();
  EXPECT_NEAR(position_spread_m2(covariance), std::sqrt(4.0 * 1.0 - 1.5 * 1.5), 1e-12);
  EXPECT_EQ(position_spread_m2(Eigen::Matrix3d::Zero()), 0.0) << "collapsed to a point";
}

TEST(PositionSpread, OfACovarianceThatRoundingMadeIndefiniteIsNothing) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  covariance(0, 1) = covariance(1, 0) = 1.0 + 1e-12;
  EXPECT_EQ(position_spread_m2(covariance), 0.0);
}

TEST(PositionSpread, OfWhatIsNoCovarianceIsWithoutEnd) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto spread = [](double xx, double xy, double yx, double yy) {
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
    covariance.topLeftCorner<2, 2>() << xx, xy, yx, yy;
    return position_spread_m2(covariance);
  };
  EXPECT_EQ(spread(-1.0, 0.0, 0.0, -1.0), kInfinity) << "its determinant is 1";
  EXPECT_EQ(spread(1.0, 1.1, 1.1, 1.0), kInfinity);
  EXPECT_EQ(spread(1.0, 0.5, -0.5, 1.0), kInfinity);
  EXPECT_EQ(spread(1.0, kNaN, kNaN, 1.0), kInfinity);
  EXPECT_EQ(spread(kNaN, 0.0, 0.0, 1.0), kInfinity);
  EXPECT_EQ(spread(kInfinity, 0.0, 0.0, 1.0), kInfinity);
}

TEST(Consistency, CountsStepsWithoutACovarianceNeitherInNorOutOfTheEllipse) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  std::vector<EvaluatedStep> steps = gaussian_steps(60, tilted_covariance(), tilted_covariance());
  const Consistency whole = assess_consistency(std::span(steps).subspan(20));
  for (std::size_t i = 0; i < 20; ++i) steps[i].covariance.setConstant(kNaN);  // NULL in a run
  const Consistency result = assess_consistency(steps);
  EXPECT_EQ(result.coverage_steps, 40U);
  EXPECT_EQ(result.coverage_excluded_steps, 20U);
  EXPECT_EQ(result.coverage_95, whole.coverage_95);
  EXPECT_EQ(result.excluded_steps, 20U);
  for (EvaluatedStep& step : steps) step.covariance.setConstant(kNaN);
  EXPECT_FALSE(assess_consistency(steps).coverage_95.has_value());
  EXPECT_EQ(assess_consistency(steps).coverage_excluded_steps, 60U);
}

TEST(IsEllipseKnown, AsksOnlyWhetherSomebodyWroteThePositionsNumbers) {
  EXPECT_TRUE(is_ellipse_known(Eigen::Matrix3d::Zero())) << "sure, though wrongly";
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  covariance(2, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(is_ellipse_known(covariance));
  covariance(1, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(is_ellipse_known(covariance));
  covariance(1, 0) = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(is_ellipse_known(covariance));
}

TEST(Consistency, LeavesOutAndCountsWhatIsNoCovariance) {
  std::vector<EvaluatedStep> steps = gaussian_steps(40, tilted_covariance(), tilted_covariance());
  const Consistency whole = assess_consistency(std::span(steps).subspan(4));
  steps[0].covariance(0, 0) = -4.0;
  steps[1].covariance(1, 2) = std::numeric_limits<double>::quiet_NaN();
  steps[2].covariance(0, 1) = 0.0;  // and (1, 0) is not
  steps[3].covariance.setZero();
  const Consistency result = assess_consistency(steps);
  EXPECT_EQ(result.excluded_steps, 4U);
  EXPECT_EQ(result.nees_steps, 36U);
  EXPECT_EQ(result.nees_mean, whole.nees_mean);
  EXPECT_EQ(result.coverage_steps, 40U) << "and those count as outside";
  EXPECT_EQ(result.coverage_excluded_steps, 0U) << "their positions have an ellipse of some kind";
  EXPECT_LE(*result.coverage_95, 37.0 / 40.0);
}

}  // namespace consistency_test
}  // namespace nadir
