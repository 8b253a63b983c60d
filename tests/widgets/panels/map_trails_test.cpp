// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/map_trails.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/random.h"
#include "tests/core/session/made_run.h"

namespace nadir {
namespace map_trails_test {

using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr PageRect kPage{0.0, 0.0, 800.0, 600.0};
const MapCamera kCamera{
    {0.0, 0.0}, 1.0, std::numbers::pi / 2.0};  // a metre a pixel, (0, 0) in the middle

double distance_to_segment(const Eigen::Vector2d& point,
                           const Eigen::Vector2d& a,
                           const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((point - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (point - a - t * along).norm();
}

double distance_to(const Eigen::Vector2d& point, const std::vector<ScreenPath>& paths) {
  double least = 1e9;
  for (const ScreenPath& path : paths) {
    for (std::size_t i = 1; i < path.size(); ++i) {
      least = std::min(least, distance_to_segment(point, path[i - 1], path[i]));
    }
  }
  return least;
}

TEST(ScreenPaths, AStraightWayIsItsTwoEnds) {
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i <= 1000; ++i) points.emplace_back(0.3 * i - 150.0, 0.1 * i - 50.0);
  const auto paths = screen_paths(points, kCamera, kPage);
  ASSERT_THAT(paths, SizeIs(1));
  ASSERT_THAT(paths[0], SizeIs(2));
  EXPECT_LT((paths[0][0] - kCamera.page_from_enu(points.front(), kPage)).norm(), 1e-9);
  EXPECT_LT((paths[0][1] - kCamera.page_from_enu(points.back(), kPage)).norm(), 1e-9);
}

TEST(ScreenPaths, PassEveryPointWithinAThirdOfAPixelAndKeepFew) {
  for (const double up_rad : {std::numbers::pi / 2.0, 0.7, -2.5}) {
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i < 4541; ++i) {
      const double turn = 2.0 * std::numbers::pi * i / 900.0;
      const auto [jitter_x, jitter_y] =
          standard_normals({.seed = 5, .particle = static_cast<std::uint32_t>(i)});
      points.emplace_back(150.0 * std::sin(turn) + 0.02 * i + 0.05 * jitter_x,
                          120.0 * std::sin(2.3 * turn) + 0.05 * jitter_y);
    }
    const MapCamera camera{{0.0, 0.0}, 0.8, up_rad};
    const auto paths = screen_paths(points, camera, kPage);
    std::size_t kept = 0;
    for (const ScreenPath& path : paths) kept += path.size();
    EXPECT_LT(kept, 1500U);
    for (const Eigen::Vector2d& point : points) {
      EXPECT_LT(distance_to(camera.page_from_enu(point, kPage), paths), 0.34 + 0.34);
    }
  }
}

TEST(ScreenPaths, KeepTheFarEndOfAWayThereAndBack) {
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i <= 100; ++i) points.emplace_back(i, 0.0);
  for (int i = 100; i >= 0; --i) points.emplace_back(i, 0.0);
  const auto paths = screen_paths(points, kCamera, kPage);
  EXPECT_LT(distance_to({500.0, 300.0}, paths), 0.5);
}

TEST(ScreenPaths, BreakAtPointsThatAreNotKnown) {
  const double nan = std::nan("");
  const std::vector<Eigen::Vector2d> points = {{0, 0}, {10, 0}, {nan, nan}, {20, 0}, {20, 10}};
  EXPECT_THAT(screen_paths(points, kCamera, kPage), SizeIs(2));
  const std::vector<Eigen::Vector2d> lonely = {{nan, nan}, {5, 5}, {nan, nan}};
  EXPECT_THAT(screen_paths(lonely, kCamera, kPage), IsEmpty());
}

TEST(ScreenPaths, LeaveOutWhatCannotBeSeenButNotWhatCrossesThePage) {
  const std::vector<Eigen::Vector2d> beside = {{1000, 0}, {1000, 200}, {1200, 300}};
  EXPECT_THAT(screen_paths(beside, kCamera, kPage), IsEmpty());
  const std::vector<Eigen::Vector2d> across = {{-5000, 0}, {5000, 0}};
  EXPECT_LT(distance_to({400.0, 300.0}, screen_paths(across, kCamera, kPage)), 1e-6);
  const std::vector<Eigen::Vector2d> around = {{-1000, 0}, {-1000, 1000}, {0, 1000}, {0, 0}};
  const auto paths = screen_paths(around, kCamera, kPage);
  ASSERT_THAT(paths, SizeIs(1));  // only the last leg is seen
  EXPECT_LT(distance_to({400.0, 400.0}, paths), 1e-6);
  EXPECT_GT(distance_to({-600.0, 500.0}, paths), 100.0);
}

TEST(ScreenPaths, OfAVehicleThatStandsStillAreNothing) {
  const std::vector<Eigen::Vector2d> points(50, Eigen::Vector2d(3.0, 4.0));
  EXPECT_THAT(screen_paths(points, kCamera, kPage), IsEmpty());
}

TEST(RunPaths, HaveOnePointAStepAndNoneWhereAPoseIsNotKnown) {
  const auto document = made_document(5, [](RunStep& step) {
    if (step.step == 2) step.truth_in_enu.reset();
  });
  const RunPaths paths = RunPaths::of(document);
  ASSERT_THAT(paths.estimate, SizeIs(5));
  EXPECT_EQ(paths.estimate[3], Eigen::Vector2d(1.5, 0.1));
  EXPECT_EQ(paths.truth[3], Eigen::Vector2d(1.5, 0.0));
  EXPECT_FALSE(paths.truth[2].allFinite());
  EXPECT_FALSE(paths.odometry[0].allFinite());
}

TEST(RunPaths, AreMadeOnceADocumentAndDroppedWithIt) {
  RunPathsCache cache;
  const auto first = made_document(5);
  const auto second = made_document(6);
  const RunPaths* const made = &cache.of(first);
  EXPECT_EQ(&cache.of(first), made);
  EXPECT_EQ(cache.of(second).estimate.size(), 6U);
  const std::vector<std::shared_ptr<const RunDocument>> kept = {second};
  cache.keep_only(kept);
  EXPECT_EQ(cache.size(), 1U);
}

}  // namespace map_trails_test
}  // namespace nadir
