// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/map_camera.h"

#include <gmock/gmock.h>

#include <numbers>
#include <stdexcept>

namespace nadir {
namespace map_camera_test {

constexpr double kPi = std::numbers::pi;
constexpr PageRect kPage{100, 50, 400, 200};

void expect_point(const Eigen::Vector2d& point, const Eigen::Vector2d& expected) {
  EXPECT_LT((point - expected).norm(), 1e-9)
      << point.transpose() << ", not " << expected.transpose();
}

TEST(MapCamera, PutsItsCentreInTheMiddleAndNorthUp) {
  const MapCamera camera{{1000, 2000}, 0.5};
  expect_point(camera.page_from_enu({1000, 2000}, kPage), {300, 150});
  expect_point(camera.page_from_enu({1010, 2000}, kPage), {320, 150});  // east is right
  expect_point(camera.page_from_enu({1000, 2010}, kPage), {300, 170});  // north is up
}

TEST(MapCamera, TurnsWhatItNamesUpwards) {
  // East is up, so north is left.
  const MapCamera east_up{{1000, 2000}, 0.5, 0.0};
  expect_point(east_up.page_from_enu({1010, 2000}, kPage), {300, 170});
  expect_point(east_up.page_from_enu({1000, 2010}, kPage), {280, 150});
  const MapCamera south_up{{1000, 2000}, 0.5, -kPi / 2.0};
  expect_point(south_up.page_from_enu({1010, 2000}, kPage), {280, 150});
  const double up_rad = 2.2;
  const MapCamera camera{{1000, 2000}, 0.5, up_rad};
  expect_point(
      camera.page_from_enu({1000 + 5 * std::cos(up_rad), 2000 + 5 * std::sin(up_rad)}, kPage),
      {300, 160});
}

TEST(MapCamera, GoesThereAndBack) {
  for (const double up_rad : {-3.0, -1.0, 0.0, 0.7, kPi / 2.0, 3.1}) {
    const MapCamera camera{{-70, 31}, 0.37, up_rad};
    for (const Eigen::Vector2d& point :
         {Eigen::Vector2d(0, 0), Eigen::Vector2d(123, -45), Eigen::Vector2d(1e5, 1e5)}) {
      EXPECT_LT((camera.enu_from_page(camera.page_from_enu(point, kPage), kPage) - point).norm(),
                1e-8);
    }
  }
}

TEST(MapCamera, FitsTheLongerSide) {
  const MapCamera wide = MapCamera::fit({0, 0}, {800, 100}, kPage);
  EXPECT_DOUBLE_EQ(wide.metres_per_px, 2.0);
  expect_point(wide.page_from_enu({0, 50}, kPage), {100, 150});
  expect_point(wide.page_from_enu({800, 50}, kPage), {500, 150});
  const MapCamera high = MapCamera::fit({0, 0}, {100, 800}, kPage);
  EXPECT_DOUBLE_EQ(high.metres_per_px, 4.0);
  expect_point(high.page_from_enu({50, 800}, kPage), {300, 250});
}

TEST(MapCamera, LeavesAMarginAround) {
  const MapCamera camera = MapCamera::fit({0, 0}, {800, 100}, kPage, 0.25);
  EXPECT_DOUBLE_EQ(camera.metres_per_px, 3.0);  // a quarter of 800 m on either side
  expect_point(camera.page_from_enu({-200, 50}, kPage), {100, 150});
}

TEST(MapCamera, ShowsASinglePointAsAMetre) {
  const MapCamera camera = MapCamera::fit({7, 7}, {7, 7}, kPage);
  EXPECT_DOUBLE_EQ(camera.metres_per_px, 1.0 / 200.0);
  expect_point(camera.page_from_enu({7, 7}, kPage), kPage.centre());
}

TEST(MapCamera, IsTurnedUnlessNorthIsUpHoweverOftenItWentRound) {
  for (const double turns : {-3.0, -1.0, 0.0, 1.0, 7.0}) {
    for (const double off_rad : {-1e-11, 0.0, 1e-11}) {
      EXPECT_FALSE(MapCamera{.up_rad = kPi / 2.0 + 2.0 * kPi * turns + off_rad}.is_turned())
          << turns;
    }
    EXPECT_TRUE(MapCamera{.up_rad = kPi / 2.0 + 2.0 * kPi * turns + 1e-6}.is_turned()) << turns;
  }
  EXPECT_TRUE(MapCamera{.up_rad = -kPi / 2.0}.is_turned()) << "south is up";
}

TEST(MapCamera, CannotFillNothing) {
  EXPECT_THROW((void)MapCamera::fit({0, 0}, {1, 1}, {0, 0, 0, 10}), std::logic_error);
  EXPECT_THROW((void)MapCamera::fit({0, 0}, {1, 1}, {0, 0, 10, 0}), std::logic_error);
}

}  // namespace map_camera_test
}  // namespace nadir
