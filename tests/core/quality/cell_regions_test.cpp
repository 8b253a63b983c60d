// SPDX-License-Identifier: Apache-2.0
#include "core/quality/cell_regions.h"

#include <gmock/gmock.h>

#include <array>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

#include "core/base/random.h"
#include "core/base/raster.h"

namespace nadir {
namespace cell_regions_test {

using Cells = Raster<std::uint8_t>;

bool odd_join_corners(CellValue value) { return value % 2 == 1; }

/// What a region is to a test: value, cells, bounds, its sides by value.
using Told =
    std::tuple<int, std::int64_t, std::array<std::int64_t, 4>, std::map<int, std::int64_t>>;

std::array<std::int64_t, 4> numbers(const CellRect& cells) {
  return {cells.left, cells.top, cells.right, cells.bottom};
}

std::vector<RegionOfCells> regions_of(const Cells& cells, const CellRect& asked_for = {}) {
  RegionFinder finder({0, 0, cells.width(), cells.height()}, asked_for, odd_join_corners);
  for (int row = 0; row < cells.height(); ++row) finder.add_row(cells.row(row));
  return finder.finish();
}

/// By going from cell to cell, one region after the other.
std::multiset<Told> flooded(const Cells& cells) {
  std::multiset<Told> regions;
  Raster<int> is_seen(cells.width(), cells.height(), 0);
  for (int y = 0; y < cells.height(); ++y) {
    for (int x = 0; x < cells.width(); ++x) {
      if (is_seen.at(x, y) != 0) continue;
      const int value = cells.at(x, y);
      CellRect bounds;
      std::map<int, std::int64_t> sides;
      std::vector<std::pair<int, int>> waiting{{x, y}};
      is_seen.at(x, y) = 1;
      std::int64_t count = 0;
      while (!waiting.empty()) {
        const auto [column, row] = waiting.back();
        waiting.pop_back();
        ++count;
        bounds = bounds.joined({column, row, column + 1, row + 1});
        for (int down = -1; down <= 1; ++down) {
          for (int across = -1; across <= 1; ++across) {
            if (across == 0 && down == 0) continue;
            const bool is_side = across == 0 || down == 0;
            const bool is_there = cells.contains(column + across, row + down);
            const int other = is_there ? cells.at(column + across, row + down) : kBesideWindow;
            if (is_side && other != value) ++sides[other];
            if (other != value || (!is_side && value % 2 == 0)) continue;
            int& seen = is_seen.at(column + across, row + down);
            if (seen == 0) waiting.emplace_back(column + across, row + down);
            seen = 1;
          }
        }
      }
      regions.insert({value, count, numbers(bounds), sides});
    }
  }
  return regions;
}

std::multiset<Told> told(const std::vector<RegionOfCells>& regions) {
  std::multiset<Told> all;
  for (const RegionOfCells& region : regions) {
    std::map<int, std::int64_t> sides;
    for (const auto& [other, count] : region.sides) sides[other] = count;
    all.insert({region.value, region.cells, numbers(region.bounds), sides});
  }
  return all;
}

Cells random_cells(int width, int height, int values, std::uint32_t number) {
  Cells cells(width, height);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double drawn = uniforms({7, 0, number, static_cast<std::uint32_t>(i), 0})[0];
    cells.values()[i] = static_cast<std::uint8_t>(drawn * values);
  }
  return cells;
}

TEST(RegionFinder, FindsTheRegionsThatGoingFromCellToCellFinds) {
  for (std::uint32_t number = 0; number < 60; ++number) {
    const Cells cells = random_cells(1 + static_cast<int>(number) % 17,
                                     1 + static_cast<int>(number) % 13, 2 + number % 3, number);
    EXPECT_EQ(told(regions_of(cells)), flooded(cells)) << number;
  }
}

TEST(RegionFinder, JoinsArmsThatMeetBelow) {
  const Cells cells(5, 3,
                    {1, 0, 1, 0, 1,  //
                     1, 0, 1, 0, 1,  //
                     1, 1, 1, 1, 1});
  const auto regions = regions_of(cells);
  ASSERT_EQ(regions.size(), 3U);
  EXPECT_EQ(regions[0].value, 1);
  EXPECT_EQ(regions[0].cells, 11);
  EXPECT_EQ(regions[0].row, 2) << "its longest row is the lowest";
  EXPECT_EQ(regions[0].column, 2);
  EXPECT_EQ(regions[0].sides_with(0), 10);
  EXPECT_EQ(regions[0].sides_with(kBesideWindow), 14);
  EXPECT_EQ(regions[0].all_sides(), 24);
}

TEST(RegionFinder, PlaceLiesOnTheRegion) {
  for (std::uint32_t number = 0; number < 20; ++number) {
    const Cells cells = random_cells(23, 19, 3, 1000 + number);
    for (const RegionOfCells& region : regions_of(cells)) {
      EXPECT_EQ(cells.at(static_cast<int>(region.column), static_cast<int>(region.row)),
                region.value);
    }
  }
}

TEST(RegionFinder, TellsWhichHaveACellInThePartAskedFor) {
  const Cells cells(4, 2,
                    {0, 0, 2, 2,  //
                     0, 0, 2, 4});
  std::map<int, bool> is_touched;
  for (const RegionOfCells& region : regions_of(cells, {2, 1, 3, 2})) {
    is_touched[region.value] = region.is_touched;
  }
  EXPECT_EQ(is_touched, (std::map<int, bool>{{0, false}, {2, true}, {4, false}}));
}

TEST(RegionFinder, WidthOfAStraightStripIsItsOwnAlongRowsAndNearItAslant) {
  Cells cells(200, 200, 0);
  for (int x = 0; x < 200; ++x) {
    for (int y = 50; y < 54; ++y) cells.at(x, y) = 1;
  }
  EXPECT_NEAR(regions_of(cells)[1].mean_width(), 4.0, 0.1);
  Cells aslant(200, 200, 0);
  for (int x = 0; x < 200; ++x) {
    for (int y = 0; y < 200; ++y) {
      if (std::abs(x - y) * std::numbers::sqrt2 / 2.0 <= 3.0) aslant.at(x, y) = 1;
    }
  }
  EXPECT_NEAR(regions_of(aslant)[0].mean_width(), 6.0, 0.9);
}

TEST(RowsOfRegion, AreTheCellsOfTheRegion) {
  for (std::uint32_t number = 0; number < 30; ++number) {
    const Cells cells = random_cells(15, 11, 2, 2000 + number);
    const CellRect window{-3, 40, 12, 51};
    for (const RegionOfCells& region : regions_of(cells)) {
      std::int64_t count = 0;
      CellRect bounds;
      for (const CellRect& row : rows_of_region(cells.values(), window, region.column - 3,
                                                region.row + 40, odd_join_corners(region.value))) {
        count += row.width() * row.height();
        bounds = bounds.joined(row);
      }
      EXPECT_EQ(count, region.cells);
      EXPECT_EQ(bounds, (CellRect{region.bounds.left - 3, region.bounds.top + 40,
                                  region.bounds.right - 3, region.bounds.bottom + 40}));
    }
  }
}

}  // namespace cell_regions_test
}  // namespace nadir
