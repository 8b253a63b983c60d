// SPDX-License-Identifier: Apache-2.0
#include "core/session/moment_explanation.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

#include "tests/support/drawn_map.h"
#include "tests/support/error_text.h"
#include "tests/support/made_topview.h"
#include "tests/support/scenery.h"

namespace nadir {
namespace moment_explanation_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

MapMatcher matcher_of(OverheadMap map) {
  return MapMatcher::create(index_of(std::move(map)), {}).value();
}

/// A street to the east, 3 cells of 1 m wide: a curb stands across it at x = 5 and x = 25, none at x = 15.
OverheadMap street_with_curbs() {
  return drawn_map(1.0, {"TTTTTTTTTTTTTTTTTTTTTTTTTTTTTT", "RRRRRCSSRRRRRRRSSSRRRRRRRCSSRR",
                         "RRRRRCSSRRRRRRRSSSRRRRRRRCSSRR", "RRRRRCSSRRRRRRRSSSRRRRRRRCSSRR",
                         "TTTTTTTTTTTTTTTTTTTTTTTTTTTTTT"});
}

/// What a body at (2, 2.5) that looks east sees there: road to x = 5, the curb, two cells of sidewalk.
SemanticTopview curb_ahead() {
  std::vector<std::pair<TopviewCell, ClassId>> cells;
  for (std::int16_t left = -1; left < 1; ++left) {
    for (std::int16_t forward = 0; forward < 3; ++forward)
      cells.push_back({{forward, left}, kRoad});
    cells.push_back({{3, left}, kCurb});
    for (std::int16_t forward = 4; forward < 6; ++forward) {
      cells.push_back({{forward, left}, kSidewalk});
    }
  }
  return topview_of(std::move(cells), 1.0);
}

RunStep step_at(const Rigid2& estimate, std::optional<Rigid2> truth, SemanticTopview seen) {
  RunStep step;
  step.step = 7;
  step.time_s = 1.75;
  step.estimate.moments.mean = estimate;
  step.estimate.moments.covariance = Eigen::Vector3d(100.0, 100.0, 0.01).asDiagonal();
  step.truth_in_enu = truth;
  step.topview = std::move(seen);
  return step;
}

/// `near` of 100 equal particles at one place, the others at another.
ParticleSet hundred_particles(int near, const Rigid2& place, const Rigid2& elsewhere) {
  ParticleSet particles;
  particles.resize(100);
  for (std::size_t i = 0; i < 100; ++i) {
    particles.set_pose(i, static_cast<int>(i) < near ? place : elsewhere);
    particles.weight[i] = 0.01;
  }
  return particles;
}

const Rigid2 kAtFirstCurb{2.0, 2.5, 0.0};
const Rigid2 kWithoutCurb{12.0, 2.5, 0.0};
const Rigid2 kAtSecondCurb{22.0, 2.5, 0.0};

TEST(ExplainMoment, FindsThatTheTruthFitsBetterAndThatHardlyAParticleWasThere) {
  RunStep step = step_at(kWithoutCurb, kAtFirstCurb, curb_ahead());
  step.particles = hundred_particles(3, {3.0, 3.5, 2.0}, kWithoutCurb);
  const auto moment = explain_moment(step, matcher_of(street_with_curbs())).value();
  EXPECT_EQ(moment.verdict, MomentVerdict::kTruthFitsBetter);
  EXPECT_EQ(moment.does_truth_score_better(), true);
  EXPECT_DOUBLE_EQ(*moment.truth->mean_cost, 0.0);
  EXPECT_DOUBLE_EQ(*moment.error_m, 10.0);
  EXPECT_NEAR(*moment.share_near_truth, 0.03, 1e-12);
  EXPECT_EQ(moment.truth->agreement.share(), 1.0);
  EXPECT_EQ(moment.by_class.front().id, kCurb);
  EXPECT_LT(moment.by_class.front().cost_difference, 0.0);
  EXPECT_THAT(
      in_words(moment),
      AllOf(HasSubstr("The true pose, 10 m and 0.0° away, would have scored better (mean cost 0.00 "
                      "against 0."),
            HasSubstr("; lower is better; a clear difference of 0."),
            HasSubstr("), but only 3 % of the particles were within 2 m of it. Curb cells tell "
                      "most: 0 % agree at the estimate, 100 % at the truth.")));
}

TEST(ExplainMoment, SaysHowManyParticlesWereAtTheTruth) {
  RunStep step = step_at(kWithoutCurb, kAtFirstCurb, curb_ahead());
  const auto matcher = matcher_of(street_with_curbs());
  const auto words = [&] { return in_words(explain_moment(step, matcher).value()); };
  EXPECT_THAT(words(), Not(HasSubstr("particle")));  // none were recorded
  step.particles = hundred_particles(0, kAtFirstCurb, kWithoutCurb);
  EXPECT_THAT(words(), HasSubstr(", but no particle was within 2 m of it."));
  step.particles = hundred_particles(40, kAtFirstCurb, kWithoutCurb);
  EXPECT_THAT(words(), HasSubstr(", and 40 % of the particles were within 2 m of it."));
  for (double& weight : step.particles->weight) weight = 0.9 / 99.0;
  for (std::size_t i = 0; i < 40; ++i)
    step.particles->weight[i] = 1e-4;  // weights count, not heads
  EXPECT_THAT(words(), HasSubstr(", but only less than 1 % of the particles were"));
}

TEST(ExplainMoment, NamesTheClusterAtTheTruth) {
  RunStep step = step_at(kWithoutCurb, kAtFirstCurb, curb_ahead());
  step.particles = hundred_particles(23, kAtFirstCurb, kWithoutCurb);
  step.estimate.modes = {{0.77, {kWithoutCurb, Eigen::Matrix3d::Identity()}},
                         {0.23, {{2.5, 2.5, 0.1}, Eigen::Matrix3d::Identity()}}};
  const auto moment = explain_moment(step, matcher_of(street_with_curbs())).value();
  ASSERT_EQ(moment.modes.size(), 2U);
  EXPECT_DOUBLE_EQ(*moment.modes[0].to_truth_m, 10.0);
  EXPECT_DOUBLE_EQ(*moment.modes[1].to_truth_m, 0.5);
  EXPECT_NEAR(*moment.modes[1].to_truth_deg, 5.73, 0.01);
  EXPECT_LT(*moment.modes[1].mean_cost, *moment.modes[0].mean_cost);
  EXPECT_THAT(in_words(moment), HasSubstr("and a cluster with 23 % of the mass is there."));
}

TEST(ExplainMoment, FindsThatTheMapMisleads) {
  // The curb at the truth is missing from the map.
  const auto moment = explain_moment(step_at(kAtFirstCurb, kWithoutCurb, curb_ahead()),
                                     matcher_of(street_with_curbs()))
                          .value();
  EXPECT_EQ(moment.verdict, MomentVerdict::kMapMisleads);
  EXPECT_EQ(moment.does_truth_score_better(), false);
  EXPECT_EQ(moment.by_class.front().id, kCurb);
  EXPECT_GT(moment.by_class.front().cost_difference, 0.0);
  EXPECT_EQ(moment.by_class.front().at_truth.share(), 0.0);
  EXPECT_THAT(in_words(moment),
              AllOf(HasSubstr("The map itself misleads here, or what was seen does: the estimate, "
                              "10 m and 0.0° off, fits better than the truth (mean cost 0.00 "
                              "against 0."),
                    HasSubstr("; lower is better; a clear difference of 0."),
                    HasSubstr("Curb cells tell most: 100 % agree at the estimate, 0 % at "
                              "the truth.")));
}

TEST(ExplainMoment, FindsThatTwoPlacesLookAlike) {
  RunStep step = step_at(kAtFirstCurb, kAtSecondCurb, curb_ahead());
  step.particles = hundred_particles(30, kAtSecondCurb, kAtFirstCurb);
  const auto moment = explain_moment(step, matcher_of(street_with_curbs())).value();
  EXPECT_EQ(moment.verdict, MomentVerdict::kBothFitAlike);
  EXPECT_EQ(in_words(moment),
            "What is seen here cannot tell the estimate from the truth, 20 m and 0.0° apart: both "
            "fit about as well (mean cost 0.000 and 0.000; lower is better; no difference), and 30 "
            "% of the particles were within 2 m of it.");
}

TEST(ExplainMoment, FindsThatTheEstimateIsRight) {
  RunStep step = step_at({2.3, 2.5, 0.05}, kAtFirstCurb, curb_ahead());
  const auto moment = explain_moment(step, matcher_of(street_with_curbs())).value();
  EXPECT_EQ(moment.verdict, MomentVerdict::kFound);
  EXPECT_THAT(in_words(moment),
              HasSubstr("The estimate is 0.3 m and 2.9° from the truth; the mean cost is 0."));
  step.estimate.moments.mean.yaw_rad = 0.3;  // 17 degrees off are not near
  EXPECT_NE(explain_moment(step, matcher_of(street_with_curbs()))->verdict, MomentVerdict::kFound);
}

TEST(ExplainMoment, SaysThereIsNoEvidenceWhereTheMapKnowsNothing) {
  const auto matcher = matcher_of(drawn_map(0.1, {"RRRR....", "SSSS...."}));
  const auto seen =
      topview_of({{{0, 0}, kRoad}, {{1, 0}, kRoad}, {{3, 0}, kRoad}, {{9, 9}, kCar}}, 0.1);
  const auto few = explain_moment(step_at({0.2, 0.1, 0.0}, Rigid2{0.0, 0.1, 0.0}, seen), matcher);
  EXPECT_EQ(few->verdict, MomentVerdict::kNoEvidence);
  EXPECT_EQ(few->known_cells, 2);
  EXPECT_EQ(in_words(*few), "No evidence: only 2 topview cells lie on known ground.");
  const auto none = explain_moment(step_at({50.0, 0.1, 0.0}, std::nullopt, seen), matcher);
  EXPECT_EQ(in_words(*none), "No evidence: no topview cell lies on known ground.");
  const auto cars = explain_moment(
      step_at({0.2, 0.1, 0.0}, std::nullopt, topview_of({{{0, 0}, kCar}}, 0.1)), matcher);
  EXPECT_FALSE(cars->estimate.mean_cost.has_value());
  EXPECT_EQ(in_words(*cars),
            "No evidence: nothing that was seen is of a class that the map holds.");
  const auto empty =
      explain_moment(step_at({0.2, 0.1, 0.0}, Rigid2{}, topview_of({}, 0.1)), matcher);
  EXPECT_EQ(in_words(*empty), "No evidence: the topview is empty.");
  EXPECT_FALSE(empty->does_truth_score_better().has_value());
}

TEST(ExplainMoment, ManagesWithoutTheTruth) {
  RunStep step = step_at(kAtFirstCurb, std::nullopt, curb_ahead());
  step.estimate.modes = {{0.61, {kAtFirstCurb, Eigen::Matrix3d::Identity()}},
                         {0.39, {kAtSecondCurb, Eigen::Matrix3d::Identity()}}};
  step.particles = hundred_particles(61, kAtFirstCurb, kAtSecondCurb);
  const auto moment = explain_moment(step, matcher_of(street_with_curbs())).value();
  EXPECT_EQ(moment.verdict, MomentVerdict::kNoTruth);
  EXPECT_FALSE(moment.truth || moment.error_m || moment.nees || moment.is_truth_inside_95 ||
               moment.share_near_truth || moment.modes[0].to_truth_m);
  EXPECT_TRUE(moment.by_class.empty());
  EXPECT_EQ(in_words(moment),
            "The truth is not known here. The estimate fits the map at a mean cost of 0.00 (0 fits "
            "everywhere, 1 nowhere), and 100 % of the cells on known ground agree. The particles "
            "form 2 clusters; the heaviest "
            "holds 61 %.");
}

TEST(ExplainMoment, TellsWhetherTheFilterKnewHowWrongItWas) {
  RunStep step = step_at({5.0, 2.5, 0.2}, kAtFirstCurb, curb_ahead());
  step.estimate.moments.covariance = Eigen::Vector3d(1.0, 4.0, 0.01).asDiagonal();
  const auto matcher = matcher_of(street_with_curbs());
  auto moment = explain_moment(step, matcher).value();
  EXPECT_NEAR(*moment.nees, 9.0 + 4.0, 1e-9);  // (3 m / 1 m)^2 + (0.2 rad / 0.1 rad)^2
  EXPECT_EQ(moment.is_truth_inside_95, false);
  EXPECT_THAT(surety_in_words(moment),
              HasSubstr("The NEES of this step, 13.0, is above the 95 % chi-square bounds 0.22 to "
                        "9.35 (3 degrees of freedom); one step is no test of consistency, only "
                        "many are."));
  step.estimate.moments.covariance(0, 0) = 2.0;  // 9 / 2 is inside 5.99, and 4.5 + 4 below 9.35
  moment = explain_moment(step, matcher).value();
  EXPECT_EQ(moment.is_truth_inside_95, true);
  EXPECT_EQ(surety_in_words(moment), "");
  // A heading without spread has no NEES, but the position has its ellipse.
  step.estimate.moments.covariance = Eigen::Vector3d(1.0, 4.0, 0.0).asDiagonal();
  moment = explain_moment(step, matcher).value();
  EXPECT_FALSE(moment.nees);
  EXPECT_THAT(surety_in_words(moment),
              HasSubstr("The truth lies outside the 95 % position ellipse of this step "
                        "(chi-square, 2 degrees of freedom); one step is no test"));
  step.estimate.moments.covariance.setConstant(std::nan(""));
  moment = explain_moment(step, matcher).value();
  EXPECT_FALSE(moment.nees || moment.is_truth_inside_95);
  EXPECT_EQ(surety_in_words(moment), "") << "nobody knows";
}

TEST(ExplainMoment, SaysHowMuchTheCostsDiffer) {
  MomentExplanation moment;
  moment.verdict = MomentVerdict::kFound;
  moment.truth = PoseFit{};
  moment.error_m = 1.24;
  moment.error_deg = 3.0;
  const auto words = [&](double at_estimate, double at_truth) {
    moment.estimate.mean_cost = at_estimate;
    moment.truth->mean_cost = at_truth;
    return in_words(moment);
  };
  EXPECT_EQ(
      words(0.0712, 0.0698),
      "The estimate is 1.2 m and 3.0° from the truth; the mean cost is 0.071 at the estimate, "
      "0.070 at the truth (lower is better; the difference of 0.0014 is too small to tell "
      "them apart).");
  EXPECT_THAT(words(0.0712, 0.0588), HasSubstr("lower is better; a small difference of 0.012)"));
  EXPECT_THAT(words(0.06, 0.31), HasSubstr("lower is better; a clear difference of 0.25)"));
  EXPECT_THAT(words(0.06, 0.06), HasSubstr("lower is better; no difference)"));
  moment.rules.alike_cost = 0.5;
  EXPECT_THAT(words(0.06, 0.31), HasSubstr("the difference of 0.25 is too small"));
}

TEST(ExplainMoment, FitsOdometryToo) {
  RunStep step = step_at(kAtFirstCurb, kAtFirstCurb, curb_ahead());
  EXPECT_FALSE(explain_moment(step, matcher_of(street_with_curbs()))->odometry.has_value());
  step.odometry_in_enu = kWithoutCurb;
  const auto moment = explain_moment(step, matcher_of(street_with_curbs())).value();
  EXPECT_EQ(moment.odometry->pose_in_enu, kWithoutCurb);
  EXPECT_GT(*moment.odometry->mean_cost, *moment.estimate.mean_cost);
}

TEST(ExplainMoment, SharesTheDifferenceOfCostsOutToTheClasses) {
  const auto map = patchwork_map(200, 160, 0.2);
  const Rigid2 truth{20.0, 16.0, 0.7};
  const auto seen = perfect_topview(map, truth, 10.0);
  const auto matcher = matcher_of(map);
  for (const Rigid2& estimate : {Rigid2{21.0, 16.5, 0.8}, Rigid2{12.0, 20.0, -1.0}}) {
    const auto moment = explain_moment(step_at(estimate, truth, seen), matcher).value();
    double sum = 0.0;
    for (const ClassDifference& difference : moment.by_class) sum += difference.cost_difference;
    EXPECT_NEAR(sum, *moment.truth->mean_cost - *moment.estimate.mean_cost, 1e-12);
    for (std::size_t i = 1; i < moment.by_class.size(); ++i) {
      EXPECT_GE(std::abs(moment.by_class[i - 1].cost_difference),
                std::abs(moment.by_class[i].cost_difference));
    }
    EXPECT_EQ(moment.does_truth_score_better(), true);
    EXPECT_EQ(moment.estimate.agreement.of_cell, cell_agreement(seen, map, estimate).of_cell);
  }
}

TEST(ExplainMoment, GoesByItsRules) {
  const RunStep step = step_at(kWithoutCurb, kAtFirstCurb, curb_ahead());
  const auto matcher = matcher_of(street_with_curbs());
  EXPECT_EQ(explain_moment(step, matcher, {.near_m = 11.0})->verdict, MomentVerdict::kFound);
  EXPECT_EQ(explain_moment(step, matcher, {.alike_cost = 1.0})->verdict,
            MomentVerdict::kBothFitAlike);
  EXPECT_EQ(explain_moment(step, matcher, {.least_known_m2 = 13.0})->verdict,
            MomentVerdict::kNoEvidence);  // 12 cells of 1 m^2
}

TEST(ExplainMoment, RefusesStepsThatCannotBeLaidOnTheMap) {
  RunStep step = step_at(kAtFirstCurb, kAtFirstCurb, curb_ahead());
  const auto matcher = matcher_of(street_with_curbs());
  step.topview->metres_per_cell = 0.5;
  EXPECT_EQ(error_text(explain_moment(step, matcher)),
            "step 7: its topview has cells of 0.5 m and map 'drawn' of 1 m");
  step.topview.reset();
  EXPECT_EQ(error_text(explain_moment(step, matcher)), "step 7: its topview was not recorded");
}

}  // namespace moment_explanation_test
}  // namespace nadir
