// SPDX-License-Identifier: Apache-2.0
#include "core/sim/camera_renderer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/parallel.h"
#include "tests/core/sim/solid_oracle.h"
#include "tests/core/sim/street_map.h"

namespace nadir {
namespace camera_renderer_test {

constexpr double kViewRad = 59.95 * std::numbers::pi / 180.0;

CameraModel camera(int width, int height) {
  return CameraModel::from_horizontal_view(width, height, kViewRad);
}

WorldOptions bare() {
  return {.tree_share = 0.0,
          .pole_share = 0.0,
          .parked_car_share = 0.0,
          .moving_car_share = 0.0,
          .pedestrian_share = 0.0};
}

TEST(CameraRenderer, LaysBackProjectedGroundOnTheCellsThatItShows) {
  // THE test of all frames at once: camera, body, enu and overhead must agree on where every pixel
  // lies.
  const OverheadMap map = street_map();
  const World world = raise_world(map, bare(), 4);
  const CameraModel full = camera(320, 240);
  for (const Rigid3& pose :
       {camera_over(20.0, 28.0, 10.0), camera_over(41.0, 12.0, 100.0, -8.0, 5.0)}) {
    const SemanticFrame frame = render(world, full, pose, 0.0, 20.0);
    int ground = 0;
    int exact = 0;
    int near = 0;
    for (int row = 0; row < full.height; ++row) {
      for (int column = 0; column < full.width; ++column) {
        const double depth_m = static_cast<double>(frame.depth_m.at(column, row));
        if (depth_m <= 0.0) continue;
        const Eigen::Vector3d point = pose * (depth_m * full.ray({column + 0.5, row + 0.5}));
        const ClassId label = frame.labels.at(column, row);
        ++ground;
        if (map.class_at(point.head<2>()) == label) {
          ++exact;
          ++near;
          continue;
        }
        for (int i = 0; i < 9; ++i) {
          const Eigen::Vector2d beside =
              point.head<2>() + map.metres_per_cell * Eigen::Vector2d(i % 3 - 1, i / 3 - 1);
          if (map.class_at(beside) != label) continue;
          ++near;
          break;
        }
      }
    }
    EXPECT_GT(ground, full.width * full.height / 4);
    EXPECT_GE(near, 0.99 * ground);
    EXPECT_GE(exact, 0.99 * ground) << "walls lie a little inside their cells, so they count too";
  }
}

TEST(CameraRenderer, SeesLevelGroundAtTheDepthThatGeometryTells) {
  const OverheadMap map = drawn_map(10.0, {"RRRRRRRR", "RRRRRRRT"});
  const World world = raise_world(map, bare(), 1);
  const CameraModel full = camera(640, 480);
  const SemanticFrame frame = render(world, full, camera_over(5.0, 10.0, 0.0), 0.0, 20.0);
  for (const int row : {300, 350, 479}) {
    const double depth_m = 2.0 * full.focal_y_px / (row + 0.5 - full.centre_y_px);
    EXPECT_NEAR(frame.depth_m.at(320, row), depth_m, 1e-4);
    EXPECT_EQ(frame.labels.at(320, row), kRoad);
  }
  EXPECT_EQ(frame.labels.at(320, 100), kSky);
  EXPECT_EQ(frame.depth_m.at(320, 100), 0.0F);
}

TEST(CameraRenderer, GivesLabelsBeyondTheDepthRangeButNoDepth) {
  const World world = raise_world(drawn_map(10.0, {"RRRRRRRR", "RRRRRRRT"}), bare(), 1);
  const CameraModel full = camera(640, 480);
  const SemanticFrame frame = render(world, full, camera_over(5.0, 10.0, 0.0), 0.0, 12.0);
  const auto row_at = [&](double depth_m) {
    return static_cast<int>(full.centre_y_px + 2.0 * full.focal_y_px / depth_m);
  };
  EXPECT_GT(frame.depth_m.at(320, row_at(11.5)), 0.0F);
  EXPECT_EQ(frame.depth_m.at(320, row_at(13.0)), 0.0F);
  EXPECT_EQ(frame.labels.at(320, row_at(40.0)), kRoad);
  EXPECT_EQ(frame.labels.at(320, row_at(63.0)), kSky) << "nothing shows beyond 60 m";
}

TEST(CameraRenderer, SeesUnclassifiedGroundOutsideTheMap) {
  const World world = raise_world(drawn_map(1.0, {"RRRR", "RRRT"}), bare(), 1);
  const SemanticFrame frame = render(world, camera(64, 48), camera_over(2.0, 1.0, 0.0), 0.0, 20.0);
  EXPECT_EQ(frame.labels.at(32, 47), kUnclassified);
  EXPECT_GT(frame.depth_m.at(32, 47), 0.0F);
  const SemanticFrame from_outside =
      render(world, camera(64, 48), camera_over(-4.0, 1.0, 0.0), 0.0, 20.0);
  EXPECT_EQ(from_outside.labels.at(32, 40), kRoad) << "and the map from outside";
}

TEST(CameraRenderer, StopsAtWallsAndSeesOverFences) {
  // A camera at the left edge looks east over a fence at 3 m and at a wall from 12 m on.
  const OverheadMap map =
      drawn_map(1.0, {"RRRFRRRRRRRRBBRR", "RRRFRRRRRRRRBBRR", "RRRFRRRRRRRRBBRT"});
  const World world = raise_world(map, bare(), 1);
  const CameraModel full = camera(640, 480);
  const SemanticFrame frame = render(world, full, camera_over(0.0, 1.5, 0.0), 0.0, 20.0);
  EXPECT_EQ(frame.labels.at(320, 239), kBuilding);
  EXPECT_NEAR(frame.depth_m.at(320, 239), 12.05, 1e-3) << "a twentieth of a cell inside its cell";
  const int top_of_fence = static_cast<int>(full.centre_y_px + full.focal_y_px * 0.9 / 3.05);
  EXPECT_EQ(frame.labels.at(320, top_of_fence + 5), kFence);
  EXPECT_NEAR(frame.depth_m.at(320, top_of_fence + 5), 3.05, 1e-3);
  // Seen at a grazing angle the flat top of the cell follows: 1 m deep, 1.1 m high.
  EXPECT_EQ(frame.labels.at(320, top_of_fence - 5), kFence);
  // 0.9 m below the camera at 4 m the sight reaches the ground 8.9 m away: road shows between there
  // and the wall.
  const int row_at_10_m = static_cast<int>(full.centre_y_px + full.focal_y_px * 2.0 / 10.0);
  EXPECT_EQ(frame.labels.at(320, row_at_10_m), kRoad);
  EXPECT_NEAR(frame.depth_m.at(320, row_at_10_m), 10.0, 0.1);
}

TEST(CameraRenderer, LooksOutOfAColumnThatItIsIn) {
  const OverheadMap map = drawn_map(1.0, {"BBBRRRRR", "BBBRRRRB"});
  const World world = raise_world(map, bare(), 1);
  const SemanticFrame frame = render(world, camera(64, 48), camera_over(1.0, 0.7, 0.0), 0.0, 20.0);
  EXPECT_EQ(frame.labels.at(32, 20), kBuilding);
  EXPECT_NEAR(frame.depth_m.at(32, 20), 6.05, 0.01) << "the building across the road";
}

TEST(CameraRenderer, LetsNearThingsHideFarOnes) {
  World world = raise_world(drawn_map(10.0, {"RRRRRRRR", "RRRRRRRT"}), bare(), 1);
  const Solid car{
      .label = kCar, .centre_in_enu_m = {15.0, 10.0, 0.8}, .half_size_m = {2.0, 0.9, 0.7}};
  const Solid person{.shape = Solid::Shape::kCapsule,
                     .label = kPedestrian,
                     .centre_in_enu_m = {11.0, 10.0, 0.9},
                     .half_size_m = {0.25, 0.25, 0.9}};
  world.standing = {person, car};
  const CameraModel full = camera(640, 480);
  const Rigid3 pose = camera_over(5.0, 10.0, 0.0);
  const auto pixel = [&](const Eigen::Vector3d& point) {
    const Eigen::Vector2d image = full.project(pose.inverse() * point);
    return std::pair(static_cast<int>(image.x()), static_cast<int>(image.y()));
  };
  const auto nearest_first = render(world, full, pose, 0.0, 20.0);
  world.standing = {car, person};
  const auto farthest_first = render(world, full, pose, 0.0, 20.0);
  EXPECT_EQ(nearest_first.labels, farthest_first.labels);
  const auto [person_column, person_row] = pixel({11.0, 10.0, 1.0});
  EXPECT_EQ(nearest_first.labels.at(person_column, person_row), kPedestrian);
  EXPECT_NEAR(nearest_first.depth_m.at(person_column, person_row), 5.75, 0.01);
  const auto [car_column, car_row] = pixel({13.0, 10.6, 1.0});
  EXPECT_EQ(nearest_first.labels.at(car_column, car_row), kCar);
  EXPECT_NEAR(nearest_first.depth_m.at(car_column, car_row), 8.0, 0.01);
}

TEST(CameraRenderer, ShowsMovingThingsWhereTheyAreAtThatTime) {
  World world = raise_world(drawn_map(10.0, {"RRRRRRRR", "RRRRRRRT"}), bare(), 1);
  world.moving = {{.parts = {{.label = kCar,
                              .centre_in_enu_m = {0.0, 0.0, 0.8},
                              .half_size_m = {2.0, 0.9, 0.7}}},
                   .from_in_enu_m = {15.0, 10.0},
                   .to_in_enu_m = {45.0, 10.0},
                   .speed_mps = 5.0}};
  const CameraModel full = camera(640, 480);
  const Rigid3 pose = camera_over(5.0, 10.0, 0.0);
  const auto depth_of_car = [&](double time_s) {
    const auto frame = render(world, full, pose, time_s, 50.0);
    for (int row = 240; row < 480; ++row) {
      if (frame.labels.at(320, row) == kCar)
        return static_cast<double>(frame.depth_m.at(320, std::min(row + 2, 479)));
    }
    return 0.0;
  };
  const double first_m = depth_of_car(0.0);
  EXPECT_GT(first_m, 7.5);
  EXPECT_NEAR(depth_of_car(1.0) - first_m, 5.0, 1.5);
}

TEST(CameraRenderer, GivesTheSameBitsOnOneThreadAndOnTwo) {
  const World world = raise_world(street_map(), {}, 4);
  const Rigid3 pose = camera_over(20.0, 28.0, 10.0, 4.0, 3.0);
  const auto on_threads = [&](int threads) {
    const ThreadLimit limit(threads);
    return render(world, camera(320, 240), pose, 2.0, 20.0);
  };
  const SemanticFrame one = on_threads(1);
  const SemanticFrame two = on_threads(2);
  EXPECT_EQ(one.labels, two.labels);
  EXPECT_EQ(one.depth_m, two.depth_m);
}

}  // namespace camera_renderer_test
}  // namespace nadir
