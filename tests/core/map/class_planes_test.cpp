// SPDX-License-Identifier: Apache-2.0
#include "core/map/class_planes.h"

#include <gmock/gmock.h>

#include <bit>

#include "tests/core/map/raster_files.h"

namespace nadir {
namespace class_planes_test {

/// Widths around the size of a word, where off-by-one lives.
constexpr std::array kWidths{1, 63, 64, 65, 127, 128, 200};

bool has_class(const Raster<ClassId>& labels, int column, int row, ClassId id) {
  return labels.contains(column, row) && labels.at(column, row) == id;
}

TEST(ClassPlane, HasTheBitOfEveryCellOfItsClassAndNoOther) {
  for (const int width : kWidths) {
    const Raster<ClassId> labels = patchwork(width, 5);
    const ClassPlane plane = ClassPlane::of(labels, kTerrain);
    for (int row = -2; row < 7; ++row) {
      for (int column = -3; column < width + 70; ++column) {
        ASSERT_EQ(plane.test(column, row), has_class(labels, column, row, kTerrain))
            << width << ": " << column << ", " << row;
      }
    }
  }
}

TEST(ClassPlane, GivesTheSixtyFourCellsFromAnyColumn) {
  for (const int width : kWidths) {
    const Raster<ClassId> labels = patchwork(width, 3);
    const ClassPlane plane = ClassPlane::of(labels, kRoad);
    for (int row = -1; row < 4; ++row) {
      for (int column = -130; column < width + 130; ++column) {
        std::uint64_t expected = 0;
        for (int i = 0; i < 64; ++i) {
          if (has_class(labels, column + i, row, kRoad)) expected |= std::uint64_t{1} << i;
        }
        ASSERT_EQ(plane.word_at(column, row), expected) << width << ": " << column << ", " << row;
      }
    }
  }
}

TEST(ClassPlane, CountsTheCellsOfItsClass) {
  const Raster<ClassId> labels = patchwork(157, 91);
  std::int64_t all = 0;
  for (const ClassId id : {kRoad, kTerrain, kSidewalk, kSky}) {
    const std::int64_t count = ClassPlane::of(labels, id).count();
    EXPECT_EQ(count, std::count(labels.values().begin(), labels.values().end(), id));
    all += count;
  }
  EXPECT_EQ(all, 157 * 91);
}

TEST(ClassPlane, PadsEveryRowWithZeros) {
  const ClassPlane plane = ClassPlane::of(Raster<ClassId>(70, 2, kRoad), kRoad);
  EXPECT_EQ(plane.words_per_row(), 3);
  const auto words = plane.row_words(1);
  EXPECT_EQ(words[0], ~std::uint64_t{0});
  EXPECT_EQ(std::popcount(words[1]), 6);
  EXPECT_EQ(words[2], 0U);
}

TEST(ClassPlane, OfAnEmptyMapIsEmpty) {
  const ClassPlane plane = ClassPlane::of(Raster<ClassId>(), kRoad);
  EXPECT_EQ(plane.count(), 0);
  EXPECT_EQ(plane.word_at(0, 0), 0U);
  EXPECT_FALSE(plane.test(0, 0));
}

}  // namespace class_planes_test
}  // namespace nadir
