// SPDX-License-Identifier: Apache-2.0
#include "core/geo/similarity2.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <limits>
#include <vector>

#include "core/base/random.h"
#include "tests/support/error_text.h"

namespace nadir {
namespace similarity2_test {

using testing::HasSubstr;
using Points = std::vector<Eigen::Vector2d>;

/// An S-shaped walk of 200 points.
Points drawn_points() {
  Points points;
  for (int i = 0; i < 200; ++i) {
    const double t = 0.05 * i;
    points.emplace_back(10.0 * t, 30.0 * std::sin(t));
  }
  return points;
}

template <typename Motion>
Points moved(const Motion& motion, const Points& points, double noise_m = 0.0) {
  Points result;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const auto [a, b] = standard_normals({3, 99, 0, i, 0});
    result.push_back(motion * points[i] + noise_m * Eigen::Vector2d(a, b));
  }
  return result;
}

template <typename Motion>
double squared_error(const Motion& motion, const Points& from, const Points& to) {
  double sum = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) sum += (motion * from[i] - to[i]).squaredNorm();
  return sum;
}

TEST(AlignRigid2, FindsTheMotionThatMovedThePoints) {
  const Rigid2 truth{458'000.0, -5'429'000.0, 2.5};
  const Points points = drawn_points();
  const auto found = align_rigid2(points, moved(truth, points));
  ASSERT_TRUE(found) << error_text(found);
  EXPECT_NEAR(found->x_m, truth.x_m, 1e-6);
  EXPECT_NEAR(found->y_m, truth.y_m, 1e-6);
  EXPECT_NEAR(found->yaw_rad, truth.yaw_rad, 1e-9);
}

TEST(AlignSimilarity2, FindsTheScaleToo) {
  const Similarity2 truth{17.5, {3.0, 4.0, -3.0}};
  const Points points = drawn_points();
  const auto found = align_similarity2(points, moved(truth, points));
  ASSERT_TRUE(found) << error_text(found);
  EXPECT_NEAR(found->scale, truth.scale, 1e-12);
  EXPECT_NEAR(found->rigid.yaw_rad, truth.rigid.yaw_rad, 1e-12);
  EXPECT_NEAR(found->rigid.x_m, truth.rigid.x_m, 1e-9);
}

TEST(AlignSimilarity2, AgreesWithEigensUmeyamaOnNoisyPoints) {
  const Points from = drawn_points();
  const Points to = moved(Similarity2{2.0, {1.0, 2.0, 0.7}}, from, 3.0);
  // Matrices of fixed size make g++ 12 warn inside Eigen, wrongly.
  Eigen::MatrixXd from_columns(2, static_cast<Eigen::Index>(from.size()));
  Eigen::MatrixXd to_columns(2, static_cast<Eigen::Index>(to.size()));
  for (std::size_t i = 0; i < from.size(); ++i) {
    from_columns.col(static_cast<Eigen::Index>(i)) = from[i];
    to_columns.col(static_cast<Eigen::Index>(i)) = to[i];
  }
  const Eigen::Vector2d probe(12.0, -34.0);
  const auto similarity = align_similarity2(from, to);
  const auto rigid = align_rigid2(from, to);
  ASSERT_TRUE(similarity && rigid);
  const Eigen::Matrix3d with_scale = Eigen::umeyama(from_columns, to_columns, true);
  const Eigen::Matrix3d without_scale = Eigen::umeyama(from_columns, to_columns, false);
  EXPECT_TRUE((*similarity * probe).isApprox((with_scale * probe.homogeneous()).head<2>(), 1e-10));
  EXPECT_TRUE((*rigid * probe).isApprox((without_scale * probe.homogeneous()).head<2>(), 1e-10));
}

TEST(AlignRigid2, NoMotionNearbyHasASmallerError) {
  const Points from = drawn_points();
  const Points to = moved(Rigid2{1.0, 2.0, 0.7}, from, 3.0);
  const auto best = align_rigid2(from, to);
  ASSERT_TRUE(best);
  const double least = squared_error(*best, from, to);
  for (const double step : {-1e-3, 1e-3}) {
    EXPECT_GT(squared_error(Rigid2{best->x_m + step, best->y_m, best->yaw_rad}, from, to), least);
    EXPECT_GT(squared_error(Rigid2{best->x_m, best->y_m + step, best->yaw_rad}, from, to), least);
    EXPECT_GT(squared_error(Rigid2{best->x_m, best->y_m, best->yaw_rad + step}, from, to), least);
  }
}

TEST(AlignRigid2, NeverMirrors) {
  const Points from = {{0, 0}, {4, 0}, {4, 1}, {0, 5}};
  Points mirrored;
  for (const auto& point : from) mirrored.emplace_back(-point.x(), point.y());
  const auto found = align_rigid2(from, mirrored);
  ASSERT_TRUE(found);
  EXPECT_GT(squared_error(*found, from, mirrored), 1.0);
}

TEST(AlignRigid2, TwoPointsAreEnough) {
  const auto found = align_rigid2(Points{{0, 0}, {1, 0}}, Points{{5, 5}, {5, 6}});
  ASSERT_TRUE(found) << error_text(found);
  EXPECT_NEAR(found->yaw_rad, std::numbers::pi / 2.0, 1e-15);
}

TEST(AlignRigid2, RefusesPointsThatDetermineNothing) {
  EXPECT_THAT(error_text(align_rigid2(Points{}, Points{})), HasSubstr("there are 0"));
  EXPECT_THAT(error_text(align_rigid2(Points{{1, 1}}, Points{{2, 2}})), HasSubstr("there are 1"));
  const Points one_place(7, Eigen::Vector2d(458'074.6042933, 5'429'380.172093));
  const Points walk = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}, {6, 0}};
  EXPECT_THAT(error_text(align_rigid2(one_place, walk)), HasSubstr("do not determine a rotation"));
  EXPECT_THAT(error_text(align_similarity2(walk, one_place)), HasSubstr("do not determine"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(align_rigid2(Points{{0, 0}, {nan, 0}}, Points{{0, 0}, {1, 1}}));
}

TEST(AlignRigid2, ListsOfDifferentLengthAreABugOfTheCaller) {
  EXPECT_THROW((void)align_rigid2(Points{{0, 0}, {1, 0}}, Points{{0, 0}}), std::logic_error);
}

TEST(Similarity2, TheInverseUndoesTheMotion) {
  const Similarity2 motion{3.0, {1.0, -2.0, 1.2}};
  const Eigen::Vector2d point(7.0, 8.0);
  EXPECT_TRUE((motion.inverse() * (motion * point)).isApprox(point, 1e-14));
}

TEST(Similarity2, MovesAPoseWithItsHeading) {
  const Rigid2 pose = Similarity2{2.0, {1.0, 0.0, std::numbers::pi / 2.0}} * Rigid2{3.0, 0.0, 3.0};
  EXPECT_NEAR(pose.x_m, 1.0, 1e-14);
  EXPECT_NEAR(pose.y_m, 6.0, 1e-14);
  EXPECT_NEAR(pose.yaw_rad, 3.0 + std::numbers::pi / 2.0 - 2.0 * std::numbers::pi, 1e-14);
}

}  // namespace similarity2_test
}  // namespace nadir
