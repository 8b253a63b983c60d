// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/space_lines.h"

#include <cmath>

#include "tests/widgets/views/space_page.h"
#include "widgets/views/space_picture.h"

namespace nadir {
namespace space_lines_test {

const Eigen::Vector3d kBreak = Eigen::Vector3d::Constant(std::nan(""));

double length_of(const SpacePath& path) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) length += (path[i] - path[i - 1]).norm();
  return length;
}

TEST(Dashes, AreOfTheirLengthAlsoAroundCorners) {
  const SpacePath path = {{0, 0, 0}, {1.5, 0, 0}, {1.5, 4, 0}, {9, 4, 0}};
  const auto dashes = dashes_of(path, 1.0, 0.5);
  ASSERT_EQ(dashes.size(), 9U);  // 13 m in steps of 1.5 m, and a piece
  for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(length_of(dashes[i]), 1.0, 1e-9) << i;
  EXPECT_EQ(dashes[0].front(), path.front());
  EXPECT_EQ(dashes[1].size(), 2U);
  EXPECT_TRUE(dashes[1].front().isApprox(Eigen::Vector3d(1.5, 0, 0), 1e-9));
}

TEST(Dashes, BeginAgainAfterABreakAndAreNoneOfNothing) {
  const auto dashes = dashes_of({{0, 0, 0}, {0.5, 0, 0}, kBreak, {5, 0, 0}, {5.5, 0, 0}}, 1.0, 0.5);
  ASSERT_EQ(dashes.size(), 2U);
  EXPECT_EQ(dashes[1].front(), Eigen::Vector3d(5, 0, 0));
  EXPECT_TRUE(dashes_of({}, 1.0, 1.0).empty());
  EXPECT_TRUE(dashes_of({{1, 1, 1}}, 1.0, 1.0).empty());
  EXPECT_TRUE(dashes_of({{1, 1, 1}, {1, 1, 1}}, 1.0, 1.0).empty());
  EXPECT_TRUE(dashes_of({{0, 0, 0}, {1e30, 0, 0}}, 1.0, 1.0).empty());  // not for ever
  EXPECT_THROW((void)dashes_of({}, 0.0, 1.0), std::logic_error);
}

TEST(Dashes, DoNotJoinWhatLiesOnBothSidesOfAStretchThatIsLeftOut) {
  const auto dashes = dashes_of({{0, 0, 0}, {0.5, 0, 0}, {1e30, 0, 0}, {1e30, 5, 0}}, 1.0, 0.5);
  ASSERT_GE(dashes.size(), 2U);
  EXPECT_EQ(dashes[0].back(), Eigen::Vector3d(0.5, 0, 0));
  EXPECT_EQ(dashes[1].front(), Eigen::Vector3d(1e30, 0, 0));
  for (const SpacePath& dash : dashes) EXPECT_LE(length_of(dash), 1.0 + 1e-9);
}

class Lines : public SpacePage {};

TEST_F(Lines, PassThroughTheirPointsAndBreakWhereOneIsNotFinite) {
  SpaceScene scene({3.0, -2.0});
  SpaceLines lines(scene, SpaceLayer::kSolid, kRed, 2.0);
  const std::vector<SpacePath> paths = {{{-2, 3, 0}, {-2, 1, 0}, kBreak, {-2, -1, 0}, {-2, -3, 0}}};
  lines.show(paths);
  const Raster<Rgba> drawn = draw(scene, {{0, 0, 0}, 20.0, 0.0, 0.6, 0.6});
  const PinholeOracle oracle({{0, 0, 0}, 20.0, 0.0, 0.6, 0.6}, kPage);
  const auto colour_at = [&](double y) {
    const auto at = oracle.page_from_enu({-2.0, y, 0.0});
    return pixel_at(drawn, at->x(), at->y());
  };
  EXPECT_EQ(colour_at(2.0), kRed);
  EXPECT_EQ(colour_at(-2.5), kRed);
  EXPECT_EQ(colour_at(0.0), kNothing);
}

TEST_F(Lines, OnTheGroundLieOverItWheneverItCame) {
  SpaceScene scene({0.0, 0.0});
  SpaceLines lines(scene, SpaceLayer::kOnGround, kRed, 3.0);
  const std::vector<SpacePath> across = {{{0, -9, 0}, {0, 9, 0}}};
  lines.show(across);
  SpacePicture ground(scene, SpaceLayer::kGround);
  ground.show(Raster<Rgba>(4, 4, kWhite), false);
  ground.place({-50, 50, 0}, {100, 0, 0}, {0, -100, 0});
  const SpaceCamera camera{{0, 0, 0}, 20.0, 0.0, 0.6, 0.6};
  const Raster<Rgba> drawn = draw(scene, camera);
  EXPECT_EQ(drawn.at(kPageWidth / 2, kPageHeight / 2), kRed);
  EXPECT_EQ(drawn.at(kPageWidth / 2, kPageHeight / 2 + 8), kWhite);
  // What stands on the ground hides them, however low.
  SpacePicture wall(scene, SpaceLayer::kSolid);
  wall.show(Raster<Rgba>(2, 2, kBlue), false);
  wall.place({-1, 1, 1}, {0, -2, 0}, {0, 0, -2});
  EXPECT_EQ(draw(scene, camera).at(kPageWidth / 2, kPageHeight / 2), kBlue);
}

TEST_F(Lines, AndPicturesAreUprightAndNotMirroredAndMayBeCut) {
  SpaceScene scene({0.0, 0.0});
  SpacePicture wall(scene, SpaceLayer::kSolid);
  Raster<Rgba> picture(32, 24, kBlue);
  for (int row = 0; row < 12; ++row) {
    for (int column = 0; column < 16; ++column) picture.at(column, row) = kRed;  // upper left
  }
  wall.show(picture, false);
  // Across a view to the east: its left is north.
  wall.place({0, 2, 2}, {0, -4, 0}, {0, 0, -4});
  const SpaceCamera camera{{0, 0, 0}, 12.0, 0.0, 0.0, 0.6};
  const Raster<Rgba> drawn = draw(scene, camera);
  const auto red = centre_of(drawn, kRed);
  ASSERT_TRUE(red);
  EXPECT_LT(red->x(), kPage.centre().x() - 5.0);
  EXPECT_GT(red->y(), kPage.centre().y() + 5.0);
  EXPECT_NEAR(count_of(drawn, kBlue), 3 * count_of(drawn, kRed), 0.05 * count_of(drawn, kBlue));
  // The right half of it is blue only, and the left half half of it.
  wall.place({0, 2, 2}, {0, -4, 0}, {0, 0, -4},
             {Eigen::Vector2d(0.5, 0.0), Eigen::Vector2d(1.0, 1.0)});
  EXPECT_EQ(count_of(draw(scene, camera), kRed), 0);
  wall.place({0, 2, 2}, {0, -4, 0}, {0, 0, -4},
             {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(1.0, 0.5)});
  const Raster<Rgba> upper = draw(scene, camera);
  EXPECT_EQ(count_of(upper, kRed), count_of(upper, kBlue));
  wall.set_visible(false);
  EXPECT_EQ(count_of(draw(scene, camera), kBlue), 0);
}

TEST_F(Lines, ArePointsOfAnInchWide) {
  SpaceScene scene({0.0, 0.0});
  SpaceLines lines(scene, SpaceLayer::kSolid, kRed, 2.0);
  const std::vector<SpacePath> across = {{{0, -90, 0}, {0, 90, 0}}};
  lines.show(across);
  const SpaceCamera camera{{0, 0, 0}, 20.0, 0.0, 0.6, 0.6};
  EXPECT_EQ(count_of(draw(scene, camera), kRed), 2 * kPageWidth);
  lines.set_px_per_pt(3.0);  // as a page of three times the resolution says
  scene.look(camera, 3.0);
  lines.show({});
  EXPECT_EQ(count_of(draw(scene, camera), kRed), 0);
}

}  // namespace space_lines_test
}  // namespace nadir
