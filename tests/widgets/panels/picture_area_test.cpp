// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/picture_area.h"

#include <gmock/gmock.h>

#include <memory>
#include <vector>

#include "widgets/kit/headless_ui.h"

namespace nadir {
namespace picture_area_test {

using ::testing::ElementsAre;

/// Columns of a picture that the pixels of an area as wide as `side` show, from the left, and rows, from the top.
struct Read {
  std::vector<int> columns, rows;
};

Read read_along_the_diagonal(int pixels, int side) {
  Picture picture;
  picture.pixels = std::make_shared<const Raster<Rgba>>(pixels, pixels, Rgba{1, 2, 3});
  PictureInput input;
  const auto draw = [&](kit::Ui& ui) {
    input = draw_picture(ui, "Picture", picture, {}, {double(side), double(side)});
  };
  kit::HeadlessUi screen(ThemeName::kDark, 1.0, {200.0, 200.0});
  screen.wait(3, draw);
  const kit::Rect area = screen.at("Picture").rect;
  Read read;
  for (int i = 0; i < side; ++i) {
    screen.input().mouse_px = Eigen::Vector2d(area.left + i, area.top + i);
    screen.frame(draw);
    EXPECT_TRUE(input.pixel) << i;
    read.columns.push_back(input.pixel ? input.pixel->x() : -1);
    read.rows.push_back(input.pixel ? input.pixel->y() : -1);
  }
  return read;
}

// Three cells on seven pixels: the middles of the pixels lie at 3 / 14, 9 / 14, 15 / 14 ... of a cell. By their upper left
// corners the first cell would have three pixels and the last one two.
TEST(PictureArea, ReadsWhatLiesAtThePixelsMiddle) {
  const Read read = read_along_the_diagonal(3, 7);
  EXPECT_THAT(read.columns, ElementsAre(0, 0, 1, 1, 1, 2, 2));
  EXPECT_THAT(read.rows, ElementsAre(0, 0, 1, 1, 1, 2, 2))
      << "the same from above as from the left";
}

TEST(PictureArea, ReadsEveryPixelOfAPictureAsLargeAsItsArea) {
  const Read read = read_along_the_diagonal(9, 9);
  EXPECT_THAT(read.columns, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8));
  EXPECT_EQ(read.rows, read.columns);
}

TEST(PictureArea, ReadsCellsThatAreSmallerThanAPixel) {
  const Read read = read_along_the_diagonal(9, 3);
  EXPECT_THAT(read.columns, ElementsAre(1, 4, 7)) << "the middle one of each three";
  EXPECT_EQ(read.rows, read.columns);
}

TEST(PixelOfOtherSize, IsTheOneBelowTheMiddle) {
  const auto column = [](int at, int width, int other_width) {
    return pixel_of_other_size({at, 0}, {width, 1}, {other_width, 1}).x();
  };
  EXPECT_EQ(column(5, 10, 10), 5);
  EXPECT_EQ(column(5, 10, 5), 2);
  EXPECT_EQ(column(0, 10, 30), 1);
  EXPECT_EQ(column(9, 10, 30), 28);
  // Two on three: the middle of the second, 3 / 4 of the way, lies in the third.
  EXPECT_EQ(column(0, 2, 3), 0);
  EXPECT_EQ(column(1, 2, 3), 2);
  EXPECT_EQ(pixel_of_other_size({1, 3}, {4, 8}, {8, 4}), Eigen::Vector2i(3, 1));
}

TEST(MiddleOfPixel, IsRightOfAndBelowTheCornerThatTheMouseIsToldBy) {
  EXPECT_EQ(middle_of_pixel({3.0, 8.0}), Eigen::Vector2d(3.5, 7.5)) << "y counts up";
}

}  // namespace picture_area_test
}  // namespace nadir
