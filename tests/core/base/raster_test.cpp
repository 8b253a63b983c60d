// SPDX-License-Identifier: Apache-2.0
#include "core/base/raster.h"

#include <gmock/gmock.h>

#include <stdexcept>

namespace nadir {
namespace raster_test {

using testing::ElementsAre;

TEST(Raster, IsFilledRowByRow) {
  const Raster<int> raster(3, 2, std::vector<int>{1, 2, 3, 4, 5, 6});
  EXPECT_EQ(raster.at(2, 0), 3);
  EXPECT_EQ(raster.at(0, 1), 4);
  EXPECT_THAT(raster.row(1), ElementsAre(4, 5, 6));
}

TEST(Raster, StartsWithOneValueEverywhere) {
  const Raster<float> raster(4, 5, 2.5F);
  EXPECT_EQ(raster.size(), 20U);
  EXPECT_THAT(raster.values(), testing::Each(2.5F));
}

TEST(Raster, RowsAreWindowsOnItsValues) {
  Raster<int> raster(2, 2);
  raster.row(1)[0] = 7;
  raster.at(1, 0) = 8;
  EXPECT_THAT(raster.values(), ElementsAre(0, 8, 7, 0));
}

TEST(Raster, ContainsItsCellsAndNoOthers) {
  const Raster<int> raster(3, 2);
  EXPECT_TRUE(raster.contains(0, 0));
  EXPECT_TRUE(raster.contains(2, 1));
  EXPECT_FALSE(raster.contains(3, 0));
  EXPECT_FALSE(raster.contains(0, 2));
  EXPECT_FALSE(raster.contains(-1, 0));
  EXPECT_FALSE(raster.contains(0, -1));
}

TEST(Raster, IsEmptyByDefaultAndWithoutWidth) {
  EXPECT_TRUE(Raster<int>().empty());
  EXPECT_TRUE(Raster<int>(0, 5).empty());
  EXPECT_FALSE(Raster<int>(0, 5).contains(0, 0));
}

TEST(Raster, AWrongNumberOfValuesIsABugOfTheCaller) {
  EXPECT_THROW(Raster<int>(2, 2, std::vector<int>{1, 2, 3}), std::logic_error);
  EXPECT_THROW(Raster<int>(-1, 2), std::logic_error);
}

TEST(Raster, EqualsAnotherOfTheSameShapeAndValues) {
  EXPECT_EQ(Raster<int>(2, 3, 1), Raster<int>(2, 3, 1));
  EXPECT_FALSE(Raster<int>(2, 3, 1) == Raster<int>(3, 2, 1));
  EXPECT_FALSE(Raster<int>(2, 3, 1) == Raster<int>(2, 3, 2));
}

}  // namespace raster_test
}  // namespace nadir
