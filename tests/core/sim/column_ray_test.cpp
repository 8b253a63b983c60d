// SPDX-License-Identifier: Apache-2.0
#include "core/sim/column_ray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "tests/support/drawn_map.h"

namespace nadir {
namespace column_ray_test {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr std::uint32_t kTestStream = 1001;

World bare_world(const OverheadMap& map) {
  return raise_world(map,
                     {.tree_share = 0.0,
                      .pole_share = 0.0,
                      .parked_car_share = 0.0,
                      .moving_car_share = 0.0,
                      .pedestrian_share = 0.0},
                     1);
}

/// A map of random cells, most of them road, some buildings, fences, curbs and sidewalks.
World random_world(std::uint64_t seed, const std::string& letters) {
  std::vector<std::string> rows(18, std::string(24, 'R'));
  for (std::uint32_t row = 0; row < 18; ++row) {
    for (std::uint32_t column = 0; column < 24; ++column) {
      const double draw = uniforms({seed, kTestStream, row, column, 0})[0];
      rows[row][column] =
          letters[static_cast<std::size_t>(draw * static_cast<double>(letters.size()))];
    }
  }
  return bare_world(drawn_map(0.5, rows));
}

/// The first hit by trying every column of the world, each as an upright box from z = 0.
ColumnHit try_every_column(const World& world, const ColumnRay& ray, double t_end) {
  ColumnHit nearest{kNever, kSky};
  if (ray.z_rate_m < 0.0) {
    const double t = -ray.z_m / ray.z_rate_m;
    const Eigen::Vector2d place = ray.start + t * ray.rate;
    const int column = static_cast<int>(std::floor(place.x()));
    const int row = static_cast<int>(std::floor(place.y()));
    nearest = {t, world.map.labels.contains(column, row) ? world.map.labels.at(column, row)
                                                         : ClassId{kUnclassified}};
  }
  for (int row = 0; row < world.map.labels.height(); ++row) {
    for (int column = 0; column < world.map.labels.width(); ++column) {
      const double height_m = static_cast<double>(world.relief.height_m.at(column, row));
      if (height_m == 0.0) continue;
      double begin = 0.0;
      double end = kNever;
      const auto meet = [&](double position, double rate, double low, double high) {
        if (rate == 0.0) {
          if (position < low || position >= high) end = -kNever;
          return;
        }
        begin = std::max(begin, std::min((low - position) / rate, (high - position) / rate));
        end = std::min(end, std::max((low - position) / rate, (high - position) / rate));
      };
      meet(ray.start.x(), ray.rate.x(), column, column + 1.0);
      meet(ray.start.y(), ray.rate.y(), row, row + 1.0);
      meet(ray.z_m, ray.z_rate_m, -1.0, height_m);
      if (begin < end && begin > 0.0 && begin < nearest.t) {
        nearest = {begin, world.map.labels.at(column, row)};
      }
    }
  }
  return nearest.t <= t_end ? nearest : ColumnHit{kNever, kSky};
}

/// A ray from above a free cell, in any direction; some run exactly along the axes.
ColumnRay random_ray(std::uint64_t seed, std::uint32_t number, const World& world) {
  const auto [x, y] = uniforms({seed, kTestStream, 100, number, 0});
  const auto [turn, climb] = uniforms({seed, kTestStream, 101, number, 0});
  ColumnRay ray;
  ray.start = {x * 24.0, y * 18.0};
  const int column = static_cast<int>(ray.start.x());
  const int row = static_cast<int>(ray.start.y());
  ray.z_m = 0.3 + static_cast<double>(world.relief.height_m.at(column, row));
  const double yaw_rad = 6.283185307179586 * turn;
  ray.rate = {2.0 * std::cos(yaw_rad), 2.0 * std::sin(yaw_rad)};
  if (number % 8 == 0) ray.rate = {number % 16 == 0 ? 2.0 : -2.0, 0.0};
  if (number % 8 == 4) ray.rate = {0.0, number % 16 == 4 ? 2.0 : -2.0};
  ray.z_rate_m = climb - 0.6;
  return ray;
}

class RandomWorlds : public testing::TestWithParam<std::string> {};

TEST_P(RandomWorlds, AreHitWhereTryingEveryColumnSays) {
  constexpr double kInset = 0.05 / 2.0;  // of a cell, for rays of two cells a metre
  int hits = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const World world = random_world(seed, GetParam());
    for (std::uint32_t number = 0; number < 400; ++number) {
      const ColumnRay ray = random_ray(seed, number, world);
      const ColumnHit found = trace_columns(world, ray, 60.0);
      const ColumnHit expected = try_every_column(world, ray, 60.0);
      ASSERT_EQ(found.label, expected.label) << "seed " << seed << ", ray " << number;
      if (expected.t == kNever) {
        EXPECT_EQ(found.t, kNever);
        continue;
      }
      ++hits;
      EXPECT_GE(found.t, expected.t - 1e-9);
      EXPECT_LE(found.t, expected.t + kInset + 1e-9);
      const Eigen::Vector2d place = ray.start + found.t * ray.rate;
      const int column = static_cast<int>(std::floor(place.x()));
      const int row = static_cast<int>(std::floor(place.y()));
      if (world.map.labels.contains(column, row)) {
        EXPECT_EQ(world.map.labels.at(column, row), found.label) << "the hit lies in its own cell";
      }
    }
  }
  EXPECT_GT(hits, 4000);
}

INSTANTIATE_TEST_SUITE_P(TraceColumns,
                         RandomWorlds,
                         testing::Values("RRRRRRRRRRRRRB",          // scattered walls, no curbs
                                         "RRRRRRRRRRRRRRRRRRRFFB",  // things to look over
                                         "RRRRCST",                 // low relief alone
                                         "RRRRRRRRCSTFB.L"));       // everything

TEST(TraceColumns, FindsNothingAboveTheHorizonOfABareWorld) {
  const World world = bare_world(drawn_map(1.0, {"RRR", "RRT"}));
  const ColumnRay up{.start = {1.0, 1.0}, .rate = {1.0, 0.0}, .z_m = 2.0, .z_rate_m = 0.1};
  EXPECT_EQ(trace_columns(world, up, 60.0).label, kSky);
  const ColumnRay level{.start = {1.0, 1.0}, .rate = {1.0, 0.0}, .z_m = 2.0, .z_rate_m = 0.0};
  EXPECT_EQ(trace_columns(world, level, 60.0).label, kSky);
}

TEST(TraceColumns, LooksStraightDownWithoutMovingSideways) {
  const World world = bare_world(drawn_map(1.0, {"RCT", "RRB"}));
  const auto below = [&](double column, double row) {
    return trace_columns(
        world, {.start = {column, row}, .rate = {0.0, 0.0}, .z_m = 10.0, .z_rate_m = -1.0}, 60.0);
  };
  EXPECT_EQ(below(0.5, 0.5).label, kRoad);
  EXPECT_NEAR(below(0.5, 0.5).t, 10.0, 1e-9);
  EXPECT_EQ(below(1.5, 0.5).label, kCurb);
  EXPECT_NEAR(below(1.5, 0.5).t, 9.88, 1e-6);
  EXPECT_EQ(below(2.5, 1.5).label, kBuilding);
  EXPECT_NEAR(below(2.5, 1.5).t, 10.0 - static_cast<double>(world.relief.height_m.at(2, 1)), 1e-6);
  EXPECT_EQ(below(-2.0, 0.5).label, kUnclassified);
}

TEST(TraceColumns, SeesTheSideOfACurbFromTheRoadAndNotFromBehind) {
  // Road, then everything from column 2 on is up by 0.12 m.
  const World world = bare_world(drawn_map(1.0, {"RRCS", "RRCS"}));
  const ColumnRay towards{.start = {0.5, 0.5}, .rate = {1.0, 0.0}, .z_m = 0.2, .z_rate_m = -0.1};
  const ColumnHit side = trace_columns(world, towards, 60.0);
  EXPECT_EQ(side.label, kCurb);
  EXPECT_NEAR(side.t, 1.55, 1e-9) << "at z = 0.05, a twentieth of a cell inside";
  const ColumnRay away{.start = {2.5, 0.5}, .rate = {-1.0, 0.0}, .z_m = 0.2, .z_rate_m = -0.1};
  const ColumnHit road = trace_columns(world, away, 60.0);
  EXPECT_EQ(road.label, kRoad);
  EXPECT_NEAR(road.t, 2.0, 1e-9) << "over the edge and down to z = 0";
}

}  // namespace column_ray_test
}  // namespace nadir
