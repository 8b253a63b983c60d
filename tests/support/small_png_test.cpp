// SPDX-License-Identifier: Apache-2.0
#include "tests/support/small_png.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <opencv2/imgcodecs.hpp>

#include "tests/support/decoded_picture.h"
#include "widgets/canvas/png_file.h"

namespace nadir {
namespace small_png_test {

/// As another decoder reads it.
Raster<Rgba> read_back(const std::string& file) {
  const std::vector<unsigned char> bytes(file.begin(), file.end());
  return pixels_of_decoded(cv::imdecode(bytes, cv::IMREAD_UNCHANGED));
}

Raster<Rgba> made(int width, int height, const std::function<Rgba(int, int)>& colour) {
  Raster<Rgba> pixels(width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) pixels.at(column, row) = colour(column, row);
  }
  return pixels;
}

std::uint8_t low_byte(int value) { return static_cast<std::uint8_t>(value % 256); }

TEST(SmallPng, KeepsFewColours) {
  const auto pixels = made(61, 40, [](int column, int row) {
    return Rgba{low_byte(column / 5), 200, low_byte(10 * (row / 20))};
  });
  EXPECT_EQ(read_back(small_png(pixels)), pixels);
}

TEST(SmallPng, KeepsAPaletteThatIsFull) {
  const auto pixels = made(16, 16, [](int column, int row) {
    return Rgba{low_byte(16 * row + column), 0, 0};
  });
  EXPECT_EQ(read_back(small_png(pixels)), pixels);
}

TEST(SmallPng, KeepsManyColours) {
  const auto smooth = made(90, 70, [](int column, int row) {
    return Rgba{low_byte(2 * column), low_byte(3 * row), low_byte(column + row)};
  });
  EXPECT_EQ(read_back(small_png(smooth)), smooth);
  const auto wild = made(90, 70, [](int column, int row) {
    return Rgba{low_byte(37 * column * row), low_byte(11 * row * row), low_byte(7 * column)};
  });
  EXPECT_EQ(read_back(small_png(wild)), wild);
}

TEST(SmallPng, KeepsWhatCanBeSeenThrough) {
  const auto pixels = made(20, 20, [](int column, int row) {
    return Rgba{low_byte(column), low_byte(row), 7, low_byte(13 * column)};
  });
  EXPECT_EQ(read_back(small_png(pixels)), pixels);
}

TEST(SmallPng, InFewColoursWhatIsLargeKeepsItsColourAndTheRestIsNear) {
  auto page = made(100, 100, [](int column, int row) {
    return row < 50 ? Rgba{21, 24, 29} : Rgba{low_byte(column), low_byte(2 * row + 5), 77, 200};
  });
  page.at(3, 3) = {20, 24, 29};
  const auto few = in_few_colours(page);
  for (int row = 0; row < 100; ++row) {
    for (int column = 0; column < 100; ++column) {
      const Rgba was = page.at(column, row), is = few.at(column, row);
      if (was == Rgba{21, 24, 29}) {
        ASSERT_EQ(is, was);
      } else {
        ASSERT_LE(std::abs(int{is.red} - int{was.red}), 32);
        ASSERT_LE(std::abs(int{is.green} - int{was.green}), 32);
        ASSERT_LE(std::abs(int{is.blue} - int{was.blue}), 32);
        ASSERT_EQ(is.alpha, was.alpha);
      }
    }
  }
  EXPECT_EQ(in_few_colours(few), few);
}

TEST(SmallPng, IsSmallerThanThePngOfAFigure) {
  const auto page = made(400, 300, [](int column, int row) {
    return (column / 7 + row / 11) % 5 == 0 ? Rgba{20, 30, 40} : Rgba{250, 250, 250};
  });
  const auto smooth = made(400, 300, [](int column, int row) {
    return Rgba{low_byte(column / 2), low_byte(row / 2), low_byte((column * row) / 900)};
  });
  EXPECT_LT(small_png(page).size(), encode_png(page).size() / 2);
  EXPECT_LT(small_png(smooth).size(), encode_png(smooth).size());
}

}  // namespace small_png_test
}  // namespace nadir
