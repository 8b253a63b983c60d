// SPDX-License-Identifier: Apache-2.0
#include "core/sim/relief.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/drawn_map.h"

namespace nadir {
namespace relief_test {

using testing::AllOf;
using testing::Each;
using testing::Ge;
using testing::Le;

TEST(ChessboardDistance, AgreesWithASearchOverAllCells) {
  Raster<std::uint8_t> cells(23, 17);
  for (const int i : {5, 77, 78, 200, 311}) cells.values()[static_cast<std::size_t>(i)] = 1;
  const auto distance = chessboard_distance(cells);
  for (int row = 0; row < cells.height(); ++row) {
    for (int column = 0; column < cells.width(); ++column) {
      int nearest = 255;
      for (int y = 0; y < cells.height(); ++y) {
        for (int x = 0; x < cells.width(); ++x) {
          if (cells.at(x, y) == 0) continue;
          nearest = std::min(nearest, std::max(std::abs(x - column), std::abs(y - row)));
        }
      }
      EXPECT_EQ(distance.at(column, row), nearest) << column << ", " << row;
    }
  }
}

TEST(ChessboardDistance, IsTheLargestNumberWhereThereIsNothingOrItIsFar) {
  EXPECT_THAT(chessboard_distance(Raster<std::uint8_t>(4, 3)).values(), Each(255));
  Raster<std::uint8_t> long_row(400, 1);
  long_row.at(0, 0) = 1;
  EXPECT_EQ(chessboard_distance(long_row).at(254, 0), 254);
  EXPECT_EQ(chessboard_distance(long_row).at(399, 0), 255);
}

TEST(Relief, RaisesWhatLiesBehindCurbsByTheCurbAndLeavesTheRoadDown) {
  const OverheadMap map = drawn_map(0.5, {"TVS", "CCC", "RLR", "..."});
  const Relief relief = raise_relief(map, 0.12, 1);
  for (int column = 0; column < 3; ++column) {
    EXPECT_FLOAT_EQ(relief.height_m.at(column, 0), 0.12F);
    EXPECT_FLOAT_EQ(relief.height_m.at(column, 1), 0.12F);
    EXPECT_EQ(relief.height_m.at(column, 2), 0.0F);
    EXPECT_EQ(relief.height_m.at(column, 3), 0.0F);
  }
  EXPECT_FLOAT_EQ(relief.low_m, 0.12F);
  EXPECT_THAT(relief.cells_to_tall.values(), Each(255)) << "curb-high ground is not tall";
}

TEST(Relief, IsFlatOnAMapWithoutCurbs) {
  const Relief relief = raise_relief(drawn_map(0.5, {"TVS", "RLR"}), 0.12, 1);
  EXPECT_THAT(relief.height_m.values(), Each(0.0F));
  EXPECT_EQ(relief.low_m, 0.0F);
}

TEST(Relief, GivesEachBuildingOneHeightThatTheSeedDecides) {
  const OverheadMap map = drawn_map(0.5, {"BBB..B", "B.B.B.", "BBB...", "......", "FF.BBB"});
  const Relief relief = raise_relief(map, 0.12, 7);
  const float ring = relief.height_m.at(0, 0);
  const float diagonal = relief.height_m.at(5, 0);
  const float bar = relief.height_m.at(3, 4);
  for (const float height_m : {ring, diagonal, bar})
    EXPECT_THAT(height_m, AllOf(Ge(3.0F), Le(8.0F)));
  EXPECT_EQ(relief.height_m.at(2, 2), ring);
  EXPECT_EQ(relief.height_m.at(1, 1), 0.0F) << "the unclassified inside is not solid";
  EXPECT_EQ(relief.height_m.at(4, 1), diagonal) << "cells that touch at a corner are one building";
  EXPECT_EQ(relief.height_m.at(5, 4), bar);
  EXPECT_NE(ring, bar);
  EXPECT_EQ(relief.tallest_m, std::max({ring, diagonal, bar}));
  EXPECT_FLOAT_EQ(relief.height_m.at(0, 4), 1.1F);
  EXPECT_EQ(raise_relief(map, 0.12, 7).height_m, relief.height_m);
  EXPECT_NE(raise_relief(map, 0.12, 8).height_m, relief.height_m);
}

}  // namespace relief_test
}  // namespace nadir
