// SPDX-License-Identifier: Apache-2.0
#include "core/mcl/cost_kernel.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/random.h"
#include "tests/support/drawn_map.h"

namespace nadir {
namespace cost_kernel_test {

OverheadMap blank_map(int width, int height) {
  OverheadMap map = drawn_map(0.5, {"R"});
  map.labels = Raster<ClassId>(width, height, kRoad);
  map.top_left_in_enu_m = {0.0, 0.5 * height};
  return map;
}

/// Costs that differ from cell to cell, 200 off the map.
CostRaster numbered_raster(int width, int height) {
  CostRaster raster{width, height, {}};
  raster.values.assign(static_cast<std::size_t>((width + 2) * (height + 2)) + 3, 200);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      raster.values[static_cast<std::size_t>((row + 1) * raster.stride() + column + 1)] =
          static_cast<std::uint8_t>((31 * row + 7 * column) % 199);
    }
  }
  return raster;
}

HalfCell half_cell(int forward, int left) {
  return {static_cast<std::int16_t>(2 * forward + 1), static_cast<std::int16_t>(2 * left + 1)};
}

std::vector<HalfCell> fan(int count) {
  std::vector<HalfCell> cells;
  for (int i = 0; i < count; ++i) cells.push_back(half_cell(i / 9, i % 9 - 4));
  return cells;
}

/// The cost under one cell centre, in floating point and without any trick.
std::uint32_t cost_by_geometry(const CostRaster& raster,
                               const OverheadMap& map,
                               const Rigid2& pose,
                               const HalfCell& cell) {
  const Eigen::Vector2d in_body_m =
      0.5 * map.metres_per_cell * Eigen::Vector2d(cell.forward, cell.left);
  const Eigen::Vector2d in_overhead = map.overhead_from_enu(pose * in_body_m);
  const int column = static_cast<int>(std::floor(in_overhead.x()));
  const int row = static_cast<int>(std::floor(in_overhead.y()));
  if (!map.labels.contains(column, row)) return 200;
  return raster.values[static_cast<std::size_t>((row + 1) * raster.stride() + column + 1)];
}

Rigid2 random_pose(std::uint32_t i, double extent_m) {
  const auto [u, v] = uniforms({.seed = 3, .particle = i});
  const double turn = uniforms({.seed = 4, .particle = i})[0];
  return {extent_m * (1.4 * u - 0.2), extent_m * (1.4 * v - 0.2), wrap_rad(6.28 * turn)};
}

TEST(CostKernel, ReadsTheCellAheadOfABodyThatLooksEast) {
  const OverheadMap map = blank_map(10, 8);
  const CostRaster raster = numbered_raster(10, 8);
  // The body stands on the corner between columns 3 and 4 and rows 2 and 3; ahead and left of it is
  // column 4, row 2.
  const Rigid2 pose{2.0, 0.5 * 8 - 1.5, 0.0};
  const auto cells = std::vector{half_cell(0, 0)};
  EXPECT_EQ(sum_costs(raster, cells, fixed_pose(pose, map), InstructionSet::kPortable),
            (31U * 2U + 7U * 4U) % 199U);
}

TEST(CostKernel, AgreesWithPlainGeometryButForCentresOnABorder) {
  const OverheadMap map = blank_map(60, 40);
  const CostRaster raster = numbered_raster(60, 40);
  const auto cells = fan(200);
  int same = 0;
  int all = 0;
  for (std::uint32_t i = 0; i < 300; ++i) {
    const Rigid2 pose = random_pose(i, 30.0);
    const FixedPose fixed = fixed_pose(pose, map);
    for (const HalfCell& cell : cells) {
      const auto sum = sum_costs(raster, std::span(&cell, 1), fixed, InstructionSet::kPortable);
      same += sum == cost_by_geometry(raster, map, pose, cell) ? 1 : 0;
      ++all;
    }
  }
  EXPECT_GT(same,
            all - all / 500);  // fixed point moves a centre by less than a thousandth of a cell
}

TEST(CostKernel, GivesTheSameIntegerWithEveryInstructionSet) {
  const OverheadMap map = blank_map(60, 40);
  const CostRaster raster = numbered_raster(60, 40);
  int sets = 0;
  for (const auto set : {InstructionSet::kAvx2, InstructionSet::kAvx512}) {
    if (!is_available(set)) continue;
    ++sets;
    for (int count : {0, 1, 7, 8, 9, 15, 16, 17, 31, 200}) {
      const auto cells = fan(count);
      for (std::uint32_t i = 0; i < 100; ++i) {
        const FixedPose pose = fixed_pose(random_pose(i, 30.0), map);
        ASSERT_EQ(sum_costs(raster, cells, pose, set),
                  sum_costs(raster, cells, pose, InstructionSet::kPortable))
            << count << " cells, pose " << i;
      }
    }
  }
  if (sets == 0) GTEST_SKIP() << "this machine has the portable instruction set only";
}

TEST(CostKernel, CostsTheBorderEverywhereOffTheMap) {
  const OverheadMap map = blank_map(10, 8);
  const CostRaster raster = numbered_raster(10, 8);
  const auto cells = fan(18);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Rigid2& pose : {Rigid2{-1e9, 3.0, 0.3}, Rigid2{1e12, -1e12, 2.0},
                             Rigid2{nan, nan, 0.0}, Rigid2{90.0, 2.0, 0.0}}) {
    EXPECT_EQ(sum_costs(raster, cells, fixed_pose(pose, map), best_instruction_set()), 18U * 200U);
  }
}

/// Cells on every side of the body, most of them behind it, some as far as a topview may reach.
std::vector<HalfCell> cells_all_around() {
  std::vector<HalfCell> cells;
  for (int i = 0; i < 500; ++i) {
    const double angle = 0.7 * i;
    const double reach = i % 5 == 0 ? kMaxReachCells - 2.0 : 0.3 * i;
    const double behind = i % 4 == 0 ? 1.0 : -1.0;
    cells.push_back(half_cell(static_cast<int>(behind * std::abs(std::cos(angle)) * reach),
                              static_cast<int>(std::sin(angle) * reach)));
  }
  return cells;
}

/// On the map, over its corners, far off it, turned more than once, and no pose at all.
std::vector<Rigid2> extreme_poses() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<Rigid2> poses;
  for (const double x_m : {15.0, 0.0, -1e6, 1e6, 1e300}) {
    for (const double y_m : {10.0, 20.0, -1e6, 1e6}) {
      for (const double yaw_rad : {0.0, 3.5, -4.0, 7.0, 1e4, -1e9}) {
        poses.push_back({x_m, y_m, yaw_rad});
      }
    }
  }
  poses.insert(poses.end(), {{nan, 10.0, 0.0},
                             {15.0, nan, 0.0},
                             {15.0, 10.0, nan},
                             {infinity, -infinity, 1.0},
                             {15.0, 10.0, infinity}});
  return poses;
}

TEST(CostKernel, AgreesWithPlainGeometryForCellsBehindTheBody) {
  const OverheadMap map = blank_map(60, 40);
  const CostRaster raster = numbered_raster(60, 40);
  int same = 0;
  int on_map = 0;
  int all = 0;
  for (std::uint32_t i = 0; i < 100; ++i) {
    const Rigid2 pose = random_pose(i, 30.0);
    for (const HalfCell& cell : cells_all_around()) {
      if (cell.forward >= 0) continue;
      const auto expected = cost_by_geometry(raster, map, pose, cell);
      const auto sum =
          sum_costs(raster, std::span(&cell, 1), fixed_pose(pose, map), InstructionSet::kPortable);
      same += sum == expected ? 1 : 0;
      on_map += expected != 200 ? 1 : 0;
      ++all;
    }
  }
  EXPECT_GT(on_map, 1000);
  EXPECT_GT(same, all - all / 200);  // centres on a border may fall on either side
}

TEST(CostKernel, GivesTheSameIntegerAtExtremePosesWithEveryInstructionSet) {
  const OverheadMap map = blank_map(60, 40);
  const CostRaster raster = numbered_raster(60, 40);
  const auto cells = cells_all_around();
  for (const Rigid2& pose : extreme_poses()) {
    const FixedPose fixed = fixed_pose(pose, map);
    const auto portable = sum_costs(raster, cells, fixed, InstructionSet::kPortable);
    EXPECT_LE(portable, 200U * cells.size());
    for (const auto set : {InstructionSet::kAvx2, InstructionSet::kAvx512}) {
      if (!is_available(set)) continue;
      EXPECT_EQ(sum_costs(raster, cells, fixed, set), portable)
          << pose.x_m << ' ' << pose.y_m << ' ' << pose.yaw_rad;
    }
  }
}

TEST(CostKernel, SendsPosesThatAreNoneOffTheMap) {
  const OverheadMap map = blank_map(60, 40);
  const CostRaster raster = numbered_raster(60, 40);
  const auto cells = fan(18);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Rigid2& pose :
       {Rigid2{nan, 10.0, 0.0}, Rigid2{15.0, nan, 0.0}, Rigid2{15.0, 10.0, nan},
        Rigid2{15.0, 10.0, infinity}, Rigid2{-infinity, 10.0, 0.0}}) {
    EXPECT_EQ(sum_costs(raster, cells, fixed_pose(pose, map), InstructionSet::kPortable),
              18U * 200U);
  }
}

TEST(CostKernel, DoesNotMindHowOftenABodyHasTurned) {
  const OverheadMap map = blank_map(60, 40);
  const CostRaster raster = numbered_raster(60, 40);
  const auto cells = fan(100);
  for (std::uint32_t i = 0; i < 50; ++i) {
    Rigid2 pose = random_pose(i, 30.0);
    const auto once = sum_costs(raster, cells, fixed_pose(pose, map), InstructionSet::kPortable);
    for (const double turns : {1.0, -1.0, 3.0}) {
      Rigid2 turned = pose;
      turned.yaw_rad += turns * 2.0 * std::numbers::pi;
      EXPECT_EQ(sum_costs(raster, cells, fixed_pose(turned, map), InstructionSet::kPortable), once);
    }
  }
}

TEST(CostKernel, LooksTheSameFromAnyPlaceOutOfReach) {
  // Far bodies are moved nearer; that must not bring any cell back on the map.
  const OverheadMap map = blank_map(60, 40);
  const CostRaster raster = numbered_raster(60, 40);
  const auto cells = cells_all_around();
  const double reach_m = 0.5 * kMaxReachCells;
  for (const double away_m : {reach_m + 1.0, 10.0 * reach_m, 1e6, 1e15}) {
    for (const double yaw_rad : {0.0, 1.0, 3.1, -2.2}) {
      for (const Rigid2& pose :
           {Rigid2{-away_m, 10.0, yaw_rad}, Rigid2{30.0 + away_m, 10.0, yaw_rad},
            Rigid2{15.0, -away_m, yaw_rad}, Rigid2{15.0, 20.0 + away_m, yaw_rad}}) {
        EXPECT_EQ(sum_costs(raster, cells, fixed_pose(pose, map), InstructionSet::kPortable),
                  200U * cells.size());
      }
    }
  }
}

TEST(CostKernel, HasAPortableWayAlways) {
  EXPECT_TRUE(is_available(InstructionSet::kPortable));
  EXPECT_TRUE(is_available(best_instruction_set()));
}

}  // namespace cost_kernel_test
}  // namespace nadir
