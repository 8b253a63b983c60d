// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/raster_pictures.h"

#include <gmock/gmock.h>

#include "tests/support/page_pixels.h"
#include "widgets/views/theme.h"

namespace nadir {
namespace raster_pictures_test {

TEST(ClassPicture, HasEachClassInItsColourInItsPlace) {
  Raster<ClassId> labels(16, 17);
  for (int id = 0; id < 16 * 17; ++id) {
    labels.values()[static_cast<std::size_t>(id)] = static_cast<ClassId>(id % 256);
  }
  const Raster<Rgba> picture = class_picture(labels);
  ASSERT_EQ(picture.width(), 16);
  ASSERT_EQ(picture.height(), 17);
  for (int row = 0; row < 17; ++row) {
    for (int column = 0; column < 16; ++column) {
      EXPECT_EQ(picture.at(column, row), class_colour(labels.at(column, row)));
    }
  }
  EXPECT_EQ(picture.at(15, 15), kNothing);  // 255
}

TEST(ColourPicture, IsOpaqueAndHasTheSameColours) {
  ColourRaster colours(2, 1);
  colours.at(0, 0) = {1, 2, 3};
  colours.at(1, 0) = {250, 128, 0};
  const Raster<Rgba> picture = colour_picture(colours);
  EXPECT_EQ(picture.at(0, 0), (Rgba{1, 2, 3, 255}));
  EXPECT_EQ(picture.at(1, 0), (Rgba{250, 128, 0, 255}));
}

TEST(ColourPicture, OfAnImageIsAsClearAsThat) {
  const Raster<Rgba> picture = colour_picture(ImageRaster(1, 1, ImagePixel{1, 2, 3, 4}));
  EXPECT_EQ(picture.at(0, 0), (Rgba{1, 2, 3, 4}));
}

}  // namespace raster_pictures_test
}  // namespace nadir
