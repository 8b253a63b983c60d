// SPDX-License-Identifier: Apache-2.0
#include "core/mcl/cost_rows.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "core/base/random.h"

namespace nadir::detail {
namespace cost_rows_test {

/// Costs that differ from cell to cell, also on the border.
CostRaster numbered_costs(int width, int height) {
  CostRaster raster{width, height, {}};
  raster.values.resize(static_cast<std::size_t>((width + 2) * (height + 2)) + 3);
  for (std::size_t i = 0; i < raster.values.size(); ++i) {
    raster.values[i] = static_cast<std::uint8_t>(
        random_words({.seed = 5, .particle = static_cast<std::uint32_t>(i)})[0]);
  }
  return raster;
}

/// As sum_costs() reads it.
std::uint8_t cost_at(const CostRaster& raster, int column, int row) {
  const int inside_column = std::clamp(column, 0, raster.width + 1);
  const int inside_row = std::clamp(row, 0, raster.height + 1);
  return raster.values[static_cast<std::size_t>(inside_row * raster.stride() + inside_column)];
}

TEST(CostWindow, HoldsTheRasterAndItsNearestCellBeyond) {
  const CostRaster raster = numbered_costs(20, 15);
  for (const int step : {1, 2, 3, 7}) {
    const CostWindow window(raster, {-6, -4}, 40, 30, step);
    for (int row = -4; row < 26; ++row) {
      for (int column = -6; column < 34; ++column) {
        ASSERT_EQ(window.data()[window.index_of({column, row})], cost_at(raster, column, row))
            << column << ' ' << row << ' ' << step;
      }
    }
  }
}

TEST(CostWindow, LaysPosesAStepApartSideBySide) {
  const CostRaster raster = numbered_costs(60, 50);
  for (const int step : {1, 2, 5}) {
    const CostWindow window(raster, {3, 2}, 50, 40, step);
    const std::size_t index = window.index_of({7, 6});
    for (int k = 0; 7 + k * step < 53; ++k) {
      EXPECT_EQ(window.data()[index + static_cast<std::size_t>(k)],
                cost_at(raster, 7 + k * step, 6));
    }
    for (int k = 0; 6 + k * step < 42; ++k) {
      EXPECT_EQ(window.data()[index + static_cast<std::size_t>(k) * window.index_of_step()],
                cost_at(raster, 7, 6 + k * step));
    }
  }
}

TEST(CostWindow, TakesTheBytesThatItSays) {
  EXPECT_GE(CostWindow::bytes(101, 50, 4), 101 * 50);
  EXPECT_LE(CostWindow::bytes(101, 50, 4), (101 + 4) * 50);
}

std::vector<std::uint8_t> random_bytes(std::size_t count) {
  std::vector<std::uint8_t> bytes(count);
  for (std::size_t i = 0; i < count; ++i) {
    bytes[i] = static_cast<std::uint8_t>(
        random_words({.seed = 6, .particle = static_cast<std::uint32_t>(i)})[0]);
  }
  return bytes;
}

TEST(SumRows, AddsWhatIsAtEachIndexWithEveryInstructionSet) {
  const auto values = random_bytes(4'000);
  for (const std::size_t count : {0U, 1U, 7U, 255U, 256U, 257U, 1'000U}) {
    std::vector<std::uint32_t> index;
    for (std::size_t i = 0; i < count; ++i) {
      index.push_back(static_cast<std::uint32_t>(i * 37 % (values.size() - kRowLanes)));
    }
    std::vector<std::uint32_t> expected(kRowLanes, 0U);
    for (const std::uint32_t i : index) {
      for (std::size_t k = 0; k < kRowLanes; ++k) expected[k] += values[i + k];
    }
    for (const auto set :
         {InstructionSet::kPortable, InstructionSet::kAvx2, InstructionSet::kAvx512}) {
      if (!is_available(set)) continue;
      std::vector<std::uint32_t> sums(kRowLanes, 77U);  // what was there does not count
      sum_rows(values.data(), index, sums.data(), set);
      EXPECT_EQ(sums, expected) << count << " cells, set " << static_cast<int>(set);
    }
  }
}

TEST(SumRows, DoesNotOverflowWhereEveryCellCostsAll) {
  const std::vector<std::uint8_t> values(kRowLanes + 1, 255);
  const std::vector<std::uint32_t> index(10'000, 1U);
  for (const auto set :
       {InstructionSet::kPortable, InstructionSet::kAvx2, InstructionSet::kAvx512}) {
    if (!is_available(set)) continue;
    std::vector<std::uint32_t> sums(kRowLanes);
    sum_rows(values.data(), index, sums.data(), set);
    EXPECT_THAT(sums, testing::Each(2'550'000U));
  }
}

}  // namespace cost_rows_test
}  // namespace nadir::detail
