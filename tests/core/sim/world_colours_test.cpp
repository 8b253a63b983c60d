// SPDX-License-Identifier: Apache-2.0
#include "core/sim/world_colours.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/parallel.h"
#include "tests/core/sim/street_map.h"

namespace nadir {
namespace world_colours_test {

CameraModel camera(int width = 320, int height = 240) {
  return CameraModel::from_horizontal_view(width, height, 59.95 * std::numbers::pi / 180.0);
}

/// A picture in which a colour tells the place: red grows eastwards, green southwards.
ColourRaster telling_picture(const OverheadMap& map) {
  ColourRaster picture(map.labels.width(), map.labels.height());
  for (int row = 0; row < picture.height(); ++row) {
    for (int column = 0; column < picture.width(); ++column) {
      picture.at(column, row) = {static_cast<std::uint8_t>(250 * column / picture.width()),
                                 static_cast<std::uint8_t>(250 * row / picture.height()), 60};
    }
  }
  return picture;
}

WorldOptions bare() {
  return {.tree_share = 0.0,
          .pole_share = 0.0,
          .parked_car_share = 0.0,
          .moving_car_share = 0.0,
          .pedestrian_share = 0.0};
}

SurfaceView view_of(const World& world, const CameraModel& model, const Rigid3& pose) {
  return render_surfaces(world, model, pose, 1.5, kFarthestLabelM);
}

TEST(WorldColours, GroundHasTheColourOfThePictureWhereItIsHit) {
  // From depth and camera alone: neither mirrored, nor shifted, nor upside down.
  const OverheadMap map = street_map();
  const World world = raise_world(map, bare(), 4);
  const ColourRaster picture = telling_picture(map);
  const WorldColours colours(world, &picture, 1);
  const CameraModel model = camera();
  int ground = 0;
  for (const Rigid3& pose :
       {camera_over(20.0, 28.0, 10.0), camera_over(41.0, 12.0, 80.0, -9.0, 5.0),
        camera_over(70.0, 33.0, 200.0)}) {
    const SurfaceView view = view_of(world, model, pose);
    const ColourRaster image = colours.paint(view, model, pose);
    for (int row = 0; row < model.height; row += 3) {
      for (int column = 0; column < model.width; column += 3) {
        const double depth_m = static_cast<double>(view.frame.depth_m.at(column, row));
        if (depth_m <= 0.0 || depth_m > 9.0 || view.frame.labels.at(column, row) != kRoad) continue;
        const Eigen::Vector3d point = pose * (depth_m * model.ray({column + 0.5, row + 0.5}));
        const Eigen::Vector2d share =
            map.overhead_from_enu(point.head<2>())
                .cwiseQuotient(Eigen::Vector2d(map.labels.width(), map.labels.height()));
        ++ground;
        // Haze is 1 % at 9 m.
        EXPECT_NEAR(image.at(column, row).red, 250.0 * share.x(), 4.0) << column << ' ' << row;
        EXPECT_NEAR(image.at(column, row).green, 250.0 * share.y(), 4.0) << column << ' ' << row;
      }
    }
  }
  EXPECT_GT(ground, 5'000);
}

TEST(WorldColours, SkyIsAboveAndGetsBluerUpwards) {
  const World world = raise_world(street_map(), bare(), 4);
  const CameraModel model = camera();
  const Rigid3 pose = camera_over(2.0, 30.0, 180.0);  // Out over the border: nothing stands there.
  const SurfaceView view = view_of(world, model, pose);
  const ColourRaster image = WorldColours(world, nullptr, 1).paint(view, model, pose);
  int before = 256;
  for (const int row : {118, 90, 60, 30, 0}) {
    ASSERT_EQ(view.frame.labels.at(160, row), kSky);
    const Colour sky = image.at(160, row);
    EXPECT_LT(sky.red, before) << row;
    EXPECT_GT(sky.blue, sky.red) << row;
    before = sky.red;
  }
  EXPECT_NE(view.frame.labels.at(160, 239), kSky);
}

TEST(WorldColours, WithoutAPictureGroundHasTheColourOfItsClass) {
  const World world = raise_world(street_map(), bare(), 4);
  const CameraModel model = camera();
  const Rigid3 pose = camera_over(20.0, 28.0, 0.0);
  const SurfaceView view = view_of(world, model, pose);
  const ColourRaster image = WorldColours(world, nullptr, 1).paint(view, model, pose);
  ASSERT_EQ(view.frame.labels.at(200, 239), kRoad);
  const Colour road = class_info(kRoad).colour;
  EXPECT_NEAR(image.at(200, 239).red, road.red, 3);
  EXPECT_NEAR(image.at(200, 239).green, road.green, 3);
  EXPECT_NEAR(image.at(200, 239).blue, road.blue, 3);
}

TEST(WorldColours, HazeTakesOverWithDistance) {
  const OverheadMap map = street_map();
  const World world = raise_world(map, bare(), 4);
  const ColourRaster black(map.labels.width(), map.labels.height());
  const CameraModel model = camera();
  const Rigid3 pose = camera_over(2.0, 28.0, 0.0);
  const SurfaceView view = view_of(world, model, pose);
  const ColourRaster image = WorldColours(world, &black, 1).paint(view, model, pose);
  int before = -1;
  for (const int row : {239, 180, 150, 135, 130}) {
    ASSERT_EQ(view.frame.labels.at(160, row), kRoad) << row;
    EXPECT_GT(image.at(160, row).red, before) << row;
    before = image.at(160, row).red;
  }
  EXPECT_LT(image.at(160, 239).red, 3);
}

TEST(WorldColours, FarGroundIsAveragedAndDoesNotSparkle) {
  // Chequers of one cell: near by black and white, far away grey.
  const OverheadMap map = street_map(0.1);
  ColourRaster chequers(map.labels.width(), map.labels.height());
  for (int row = 0; row < chequers.height(); ++row) {
    for (int column = 0; column < chequers.width(); ++column) {
      if ((row + column) % 2 == 0) chequers.at(column, row) = {240, 240, 240};
    }
  }
  const World world = raise_world(map, bare(), 4);
  const CameraModel model = camera(640, 480);
  const Rigid3 pose = camera_over(2.0, 28.0, 0.0);
  const SurfaceView view = view_of(world, model, pose);
  const ColourRaster image = WorldColours(world, &chequers, 1).paint(view, model, pose);
  const auto contrast = [&](int first_row, int rows) {
    int least = 255;
    int most = 0;
    for (int row = first_row; row < first_row + rows; ++row) {
      for (int column = 300; column < 340; ++column) {
        least = std::min<int>(least, image.at(column, row).red);
        most = std::max<int>(most, image.at(column, row).red);
      }
    }
    return most - least;
  };
  EXPECT_GT(contrast(450, 25), 150);  // 5 m away; in a single row chequers may blend
  EXPECT_LT(contrast(265, 1), 12);    // 40 m away
}

TEST(WorldColours, WallsTowardsTheSunAreBrighterThanThoseAwayFromIt) {
  // One thick wall, seen from the south, where the sun is, and from the north.
  const std::vector<std::string> rows = {"RRRRRRRRRRRR", "RRRRRRRRRRRR", "RRRRRRRRRRRR",
                                         "RRRRRRRRRRRR", "RBBBBBBBBBBR", "RBBBBBBBBBBR",
                                         "RBBBBBBBBBBR", "RRRRRRRRRRRR", "RRRRRRRRRRRR",
                                         "RRRRRRRRRRRR", "RRRRRRRRRRRR", "RRRRRRRRRRRR"};
  const World world = raise_world(drawn_map(1.0, rows), bare(), 1);
  const CameraModel model = camera(64, 48);
  const WorldColours colours(world, nullptr, 1);
  const auto brightness = [&](const Rigid3& pose) {
    const SurfaceView view = view_of(world, model, pose);
    EXPECT_EQ(view.frame.labels.at(32, 20), kBuilding);
    const Colour wall = colours.paint(view, model, pose).at(32, 20);
    return wall.red + wall.green + wall.blue;
  };
  EXPECT_GT(brightness(camera_over(6.0, 1.0, 90.0)),
            1.3 * brightness(camera_over(6.0, 11.0, -90.0)));
}

TEST(WorldColours, ColoursEveryThingThatTheLabelsShow) {
  const World world = raise_world(street_map(), {}, 4);
  const CameraModel model = camera();
  const Rigid3 pose = camera_over(12.0, 28.0, 3.0);
  const SurfaceView view = view_of(world, model, pose);
  std::size_t solid_pixels = 0;
  for (int row = 0; row < model.height; ++row) {
    for (int column = 0; column < model.width; ++column) {
      const std::int32_t solid = view.solid.at(column, row);
      if (solid == SurfaceView::kNoSolid) continue;
      ++solid_pixels;
      ASSERT_LT(static_cast<std::size_t>(solid), view.solids.size());
      EXPECT_EQ(view.solids[static_cast<std::size_t>(solid)].label,
                view.frame.labels.at(column, row));
    }
  }
  EXPECT_GT(solid_pixels, 500U);
}

TEST(WorldColours, AreTheSameBitsOnAnyNumberOfThreads) {
  const OverheadMap map = street_map();
  const World world = raise_world(map, {}, 4);
  const ColourRaster picture = telling_picture(map);
  const WorldColours colours(world, &picture, 1);
  const CameraModel model = camera();
  const Rigid3 pose = camera_over(41.0, 12.0, 80.0, -9.0, -2.0);
  const auto painted = [&](int threads) {
    const ThreadLimit limit(threads);
    return colours.paint(view_of(world, model, pose), model, pose);
  };
  EXPECT_EQ(painted(1), painted(2));
}

TEST(WorldColours, TakeACameraOutsideTheMap) {
  const OverheadMap map = street_map();
  const World world = raise_world(map, {}, 4);
  const ColourRaster picture = telling_picture(map);
  const CameraModel model = camera(64, 48);
  const Rigid3 pose = camera_over(-30.0, -20.0, 200.0);
  const SurfaceView view = view_of(world, model, pose);
  const ColourRaster image = WorldColours(world, &picture, 1).paint(view, model, pose);
  EXPECT_EQ(view.frame.labels.at(32, 47), kUnclassified);
  EXPECT_NE(image.at(32, 47), Colour{});
  EXPECT_THROW(WorldColours(world, &image, 1), std::logic_error) << "a picture of another size";
}

}  // namespace world_colours_test
}  // namespace nadir
