// SPDX-License-Identifier: Apache-2.0
#include "core/geo/world_file.h"

#include <gmock/gmock.h>

#include "tests/support/error_text.h"

namespace nadir {
namespace world_file_test {

using testing::HasSubstr;
using testing::StartsWith;

TEST(WorldFile, NamesTheCentreOfTheFirstPixel) {
  const auto read = parse_world_file("0.5\n0\n0\n-0.5\n1000.25\n1999.75\n", "town.pgw");
  ASSERT_TRUE(read) << error_text(read);
  EXPECT_EQ(read->offset, Eigen::Vector2d(1000.0, 2000.0));
  EXPECT_EQ(*read * Eigen::Vector2d(0.5, 0.5), Eigen::Vector2d(1000.25, 1999.75));
  EXPECT_TRUE(read->is_north_up());
}

TEST(WorldFile, HasItsNumbersInTheOrderADBECF) {
  const auto read = parse_world_file("1\n2\n3\n4\n5\n6\n", "town.wld");
  ASSERT_TRUE(read) << error_text(read);
  EXPECT_EQ(*read * Eigen::Vector2d(1.5, 0.5), Eigen::Vector2d(6.0, 8.0));   // a column on: A and D
  EXPECT_EQ(*read * Eigen::Vector2d(0.5, 1.5), Eigen::Vector2d(8.0, 10.0));  // a row on: B and E
}

TEST(WorldFile, ComesBackForARotatedImage) {
  Affine2 affine;
  affine.linear << 0.19, 0.07, 0.11, -0.23;
  affine.offset = {691'234.5, 5'334'321.25};
  const auto read = parse_world_file(world_file_text(affine), "town.jgw");
  ASSERT_TRUE(read) << error_text(read);
  EXPECT_EQ(read->linear, affine.linear);
  EXPECT_LT((read->offset - affine.offset).norm(), 2e-9);
}

TEST(WorldFile, IsRefusedWhereItIsNone) {
  const auto refusal = [](const std::string& text) {
    return error_text(parse_world_file(text, "town.tfw"));
  };
  EXPECT_THAT(refusal(""), HasSubstr("town.tfw: holds 0 of the six numbers"));
  EXPECT_THAT(refusal("1\n0\n0\n-1\n5\n"), HasSubstr("holds 5 of the six"));
  EXPECT_THAT(refusal("1\n0\n0\n-1\n5\n6\n7\n"), HasSubstr("more than the six"));
  EXPECT_THAT(refusal("1\n0\n0\n-1\n5\nsix\n"), StartsWith("town.tfw: line 6"));
  EXPECT_THAT(refusal("1\n0\n0\nnan\n5\n6\n"), StartsWith("town.tfw: line 4"));
  EXPECT_THAT(refusal("0\n0\n0\n0\n5\n6\n"), StartsWith("town.tfw: "));
}

}  // namespace world_file_test
}  // namespace nadir
