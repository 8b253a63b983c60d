// SPDX-License-Identifier: Apache-2.0
#include "core/geo/control_points.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "core/base/random.h"
#include "tests/support/error_text.h"

namespace nadir {
namespace control_points_test {

using ::testing::HasSubstr;
using Points = std::vector<ControlPoint>;

/// A turned image of half a metre a pixel, far from the plane's origin.
Affine2 similar_truth() {
  Affine2 truth;
  const double turn_rad = 0.3, scale_m = 0.5;
  truth.linear << scale_m * std::cos(turn_rad), scale_m * std::sin(turn_rad),
      scale_m * std::sin(turn_rad), -scale_m * std::cos(turn_rad);
  truth.offset = {120'300.0, -84'200.0};
  return truth;
}

/// One with pixels that are wider than high, sheared.
Affine2 sheared_truth() {
  Affine2 truth;
  truth.linear << 0.61, 0.07, -0.02, -0.48;
  truth.offset = {-310.0, 95.5};
  return truth;
}

/// Points all over an image, with errors of a click.
Points clicked(const Affine2& truth, int count, double sigma_m = 0.0) {
  Points points;
  for (int i = 0; i < count; ++i) {
    const auto number = static_cast<std::uint32_t>(i);
    const auto [column, row] = uniforms({1, 5, 0, number, 0});
    const Eigen::Vector2d at(1000.0 * column, 800.0 * row);
    const auto [east, north] = standard_normals({1, 6, 0, number, 0});
    points.push_back({at, truth * at + sigma_m * Eigen::Vector2d(east, north), ""});
  }
  return points;
}

double squared_error(const Affine2& fit, const Points& points) {
  double sum = 0.0;
  for (const ControlPoint& point : points) {
    sum += (fit * point.in_pixels - point.in_enu_m).squaredNorm();
  }
  return sum;
}

TEST(ControlPoints, FindWhereTheImageLies) {
  for (const int count : {2, 3, 20}) {
    const auto fit = fit_control_points(clicked(similar_truth(), count), ControlModel::kSimilarity);
    ASSERT_TRUE(fit) << error_text(fit);
    EXPECT_TRUE(fit->enu_from_pixels.linear.isApprox(similar_truth().linear, 1e-9));
    EXPECT_NEAR((fit->enu_from_pixels.offset - similar_truth().offset).norm(), 0.0, 1e-6);
    EXPECT_NEAR(fit->rms_m, 0.0, 1e-8);
  }
  for (const int count : {3, 20}) {
    const auto fit = fit_control_points(clicked(sheared_truth(), count), ControlModel::kAffine);
    ASSERT_TRUE(fit) << error_text(fit);
    EXPECT_TRUE(fit->enu_from_pixels.linear.isApprox(sheared_truth().linear, 1e-9));
    EXPECT_NEAR((fit->enu_from_pixels.offset - sheared_truth().offset).norm(), 0.0, 1e-7);
  }
}

TEST(ControlPoints, NoOtherImageOfItsKindFitsBetter) {
  const Points points = clicked(similar_truth(), 12, 0.8);
  for (const ControlModel model : {ControlModel::kSimilarity, ControlModel::kAffine}) {
    const auto fit = fit_control_points(points, model);
    ASSERT_TRUE(fit) << error_text(fit);
    const double best = squared_error(fit->enu_from_pixels, points);
    for (const double step : {1e-6, -1e-6}) {
      Affine2 turned = fit->enu_from_pixels, larger = turned, shifted = turned;
      turned.linear = Eigen::Rotation2Dd(step) * turned.linear;
      turned.offset = fit->enu_from_pixels * Eigen::Vector2d(500.0, 400.0) -
                      turned.linear * Eigen::Vector2d(500.0, 400.0);
      larger.linear *= 1.0 + step;
      shifted.offset.x() += 1000.0 * step;
      EXPECT_GE(squared_error(larger, points), best);
      EXPECT_GE(squared_error(shifted, points), best);
      if (model == ControlModel::kAffine) {
        Affine2 sheared = fit->enu_from_pixels;
        sheared.linear(0, 1) += step;
        EXPECT_GE(squared_error(sheared, points), best);
      }
    }
  }
}

TEST(ControlPoints, TellTheirResidualsOnTheGroundAndInTheImage) {
  Points points = clicked(similar_truth(), 8);
  const Eigen::Vector2d wrong_m(3.0, -4.0);
  points[2].in_enu_m += wrong_m;
  const auto fit = fit_control_points(points, ControlModel::kSimilarity);
  ASSERT_TRUE(fit) << error_text(fit);
  double sum_m2 = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ControlResidual& residual = fit->residuals[i];
    EXPECT_NEAR(
        (fit->enu_from_pixels * points[i].in_pixels - residual.in_m - points[i].in_enu_m).norm(),
        0.0, 1e-6);
    // Half a metre a pixel: the same error is twice as many pixels, up to the change of scale by the wrong point.
    EXPECT_NEAR(residual.in_pixels.norm() / (residual.in_m.norm() / 0.5), 1.0, 0.02);
    sum_m2 += residual.in_m.squaredNorm();
  }
  EXPECT_NEAR(fit->rms_m, std::sqrt(sum_m2 / 8.0), 1e-9);
  // The others agree on where it is, so that leaving it out tells all of its error, which it hides in the fit itself.
  EXPECT_NEAR(fit->residuals[2].left_out_m.value(), 5.0, 1e-6);
  EXPECT_LT(fit->residuals[2].in_m.norm(), 4.9);
}

TEST(ControlPoints, SayThatTheLeastNumberOfThemProvesNothing) {
  for (const ControlModel model : {ControlModel::kSimilarity, ControlModel::kAffine}) {
    const int least = least_control_points(model);
    const auto fit = fit_control_points(clicked(similar_truth(), least, 5.0), model);
    ASSERT_TRUE(fit) << error_text(fit);
    EXPECT_NEAR(fit->rms_m, 0.0, 1e-6) << "whatever was clicked";
    EXPECT_FALSE(fit->left_out_rms_m);
    const auto one_more = fit_control_points(clicked(similar_truth(), least + 1, 5.0), model);
    ASSERT_TRUE(one_more) << error_text(one_more);
    EXPECT_GT(one_more->left_out_rms_m.value(), one_more->rms_m);
  }
}

TEST(ControlPoints, LeftOutErrorIsTheOneOfAFitWithoutThePoint) {
  const Points points = clicked(sheared_truth(), 6, 0.5);
  const auto fit = fit_control_points(points, ControlModel::kAffine);
  ASSERT_TRUE(fit) << error_text(fit);
  for (std::size_t i = 0; i < points.size(); ++i) {
    Points others = points;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    const auto without = fit_control_points(others, ControlModel::kAffine);
    ASSERT_TRUE(without);
    EXPECT_NEAR(fit->residuals[i].left_out_m.value(),
                (without->enu_from_pixels * points[i].in_pixels - points[i].in_enu_m).norm(), 1e-9);
  }
}

TEST(ControlPoints, OfAnAffineFitHaveNoLeftOutErrorWhereTheOthersLieOnALine) {
  Points points;
  for (const auto& [column, row] :
       {std::pair(0.5, 0.5), {100.5, 0.5}, {300.5, 0.5}, {50.5, 90.5}}) {
    const Eigen::Vector2d at(column, row);
    points.push_back({at, sheared_truth() * at, ""});
  }
  const auto fit = fit_control_points(points, ControlModel::kAffine);
  ASSERT_TRUE(fit) << error_text(fit);
  EXPECT_TRUE(fit->residuals[0].left_out_m);
  EXPECT_FALSE(fit->residuals[3].left_out_m);
}

TEST(ControlPoints, ThatDetermineNoImageAreRefusedInOneSentence) {
  const auto refused = [](const Points& points, ControlModel model) {
    return error_text(fit_control_points(points, model));
  };
  const Points one = clicked(similar_truth(), 1), two = clicked(similar_truth(), 2);
  EXPECT_EQ(refused(one, ControlModel::kSimilarity),
            "control points: a similarity needs 2 of them, there is 1");
  EXPECT_EQ(refused(two, ControlModel::kAffine),
            "control points: an affine fit needs 3 of them, there are 2");
  EXPECT_EQ(refused({one[0], one[0], one[0]}, ControlModel::kSimilarity),
            "control points: all of them lie at one place");
  Points line;
  for (const double at : {10.0, 500.0, 900.0}) {
    line.push_back({{at, 2.0 * at}, similar_truth() * Eigen::Vector2d(at, 2.0 * at), ""});
  }
  EXPECT_TRUE(fit_control_points(line, ControlModel::kSimilarity));
  EXPECT_THAT(refused(line, ControlModel::kAffine), HasSubstr("they lie on a line"));
  line[1].in_pixels.x() += 0.5;  // clicks along a road, half a pixel off
  line[2].in_pixels.y() -= 0.5;
  EXPECT_THAT(refused(line, ControlModel::kAffine), HasSubstr("they lie on a line"));
  Points on_one_spot = clicked(similar_truth(), 4);
  for (ControlPoint& point : on_one_spot) point.in_enu_m = {1.0, 2.0};
  EXPECT_THAT(refused(on_one_spot, ControlModel::kSimilarity), HasSubstr("at one place"));
  EXPECT_THAT(refused(on_one_spot, ControlModel::kAffine), HasSubstr("on a line"));
  Points unknown = clicked(similar_truth(), 3);
  unknown[1].in_enu_m.y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refused(unknown, ControlModel::kSimilarity),
            "control point 2: has a coordinate that is no number");
  unknown[1].name = "church";
  EXPECT_THAT(refused(unknown, ControlModel::kAffine), HasSubstr("control point 'church'"));
}

TEST(ControlPoints, OfAMirroredImageAreRefusedRatherThanTurnedUpsideDown) {
  Points points = clicked(similar_truth(), 5);
  for (ControlPoint& point : points) point.in_pixels.y() = 800.0 - point.in_pixels.y();
  EXPECT_THAT(error_text(fit_control_points(points, ControlModel::kAffine)),
              HasSubstr("rows counted from below?"));
  // A similarity cannot be mirrored: it fits badly, and says by how much.
  const auto fit = fit_control_points(points, ControlModel::kSimilarity);
  if (fit) {
    EXPECT_GT(fit->rms_m, 20.0);
  }
}

TEST(KnownDistance, GivesTheScale) {
  const auto fit = scale_by_distance({100.5, 200.5}, {400.5, 600.5}, 75.0, {10.0, 20.0});
  ASSERT_TRUE(fit) << error_text(fit);
  EXPECT_DOUBLE_EQ(fit->pixel_size().x(), 0.15);
  EXPECT_TRUE(fit->is_north_up());
  EXPECT_EQ(Eigen::Vector2d(*fit * Eigen::Vector2d::Zero()), Eigen::Vector2d(10.0, 20.0));
}

TEST(KnownDistance, ThatIsNoneIsRefused) {
  EXPECT_THAT(error_text(scale_by_distance({5.0, 5.0}, {5.5, 5.0}, 3.0, {0.0, 0.0})),
              HasSubstr("less than a pixel apart"));
  for (const double distance_m : {0.0, -1.0, std::numeric_limits<double>::infinity(),
                                  std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THAT(error_text(scale_by_distance({5.0, 5.0}, {50.0, 5.0}, distance_m, {0.0, 0.0})),
                HasSubstr("is no distance"));
  }
}

}  // namespace control_points_test
}  // namespace nadir
