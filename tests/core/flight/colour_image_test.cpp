// SPDX-License-Identifier: Apache-2.0
#include "core/flight/colour_image.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <opencv2/imgcodecs.hpp>

#include "tests/core/flight/flight_fixtures.h"

namespace nadir {
namespace colour_image_test {

using test::message_of;
using testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

/// Red grows to the right, green downwards; the upper left corner is blue.
ColourRaster slopes(int width, int height) {
  ColourRaster image(width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      image.at(column, row) = {static_cast<std::uint8_t>(255 * column / width),
                               static_cast<std::uint8_t>(255 * row / height),
                               static_cast<std::uint8_t>(column + row < width / 2 ? 200 : 0)};
    }
  }
  return image;
}

Bytes png_of(const cv::Mat& image) {
  Bytes bytes;
  cv::imencode(".png", image, bytes);
  return bytes;
}

TEST(ColourImage, ComesBackUprightInItsOwnColours) {
  const ColourRaster image = slopes(64, 48);
  const auto jpeg = encode_colour_jpeg(image);
  ASSERT_TRUE(jpeg) << message_of(jpeg);
  EXPECT_TRUE(is_jpeg(*jpeg));
  const auto again = decode_colour_image(*jpeg, "a.jpg");
  ASSERT_TRUE(again) << message_of(again);
  ASSERT_EQ(again->width(), 64);
  ASSERT_EQ(again->height(), 48);
  for (const auto& [column, row] : {std::pair{4, 4}, {58, 6}, {8, 44}, {60, 44}}) {
    const Colour expected = image.at(column, row);
    const Colour found = again->at(column, row);
    EXPECT_NEAR(found.red, expected.red, 12) << column << ' ' << row;
    EXPECT_NEAR(found.green, expected.green, 12) << column << ' ' << row;
    EXPECT_NEAR(found.blue, expected.blue, 12) << column << ' ' << row;
  }
}

TEST(ColourImage, TheSamePictureHasTheSameBytes) {
  EXPECT_EQ(encode_colour_jpeg(slopes(40, 30)).value(), encode_colour_jpeg(slopes(40, 30)).value());
  EXPECT_THROW((void)encode_colour_jpeg(ColourRaster()), std::logic_error);
}

TEST(ColourImage, TakesPngInColourInGreyAndWithSixteenBits) {
  const auto coloured = decode_colour_image(png_of(cv::Mat(3, 4, CV_8UC3, {10, 20, 30})), "a.png");
  ASSERT_TRUE(coloured) << message_of(coloured);
  EXPECT_EQ(coloured->at(3, 2), (Colour{30, 20, 10}));  // OpenCV has blue first.
  const auto grey = decode_colour_image(png_of(cv::Mat(3, 4, CV_8UC1, {77})), "a.png");
  ASSERT_TRUE(grey) << message_of(grey);
  EXPECT_EQ(grey->at(0, 0), (Colour{77, 77, 77}));
  const auto deep = decode_colour_image(png_of(cv::Mat(3, 4, CV_16UC1, {256.0 * 90.0})), "a.png");
  ASSERT_TRUE(deep) << message_of(deep);
  EXPECT_NEAR(deep->at(0, 0).red, 90, 1);
}

TEST(ColourImage, IsRefusedWhereverItIsCutOff) {
  // A library would fill up with grey what is missing.
  const Bytes jpeg = encode_colour_jpeg(slopes(64, 48)).value();
  for (std::size_t size = 3; size + 1 < jpeg.size(); size += 7) {
    const auto cut = decode_colour_image(std::span(jpeg).first(size), "cut.jpg");
    ASSERT_FALSE(cut) << size;
    EXPECT_EQ(cut.error().code, ErrorCode::kMalformed) << size;
    EXPECT_THAT(cut.error().message, HasSubstr("cut.jpg: is cut off after ")) << size;
  }
  const Bytes png = png_of(cv::Mat(30, 40, CV_8UC3, {1, 2, 3}));
  EXPECT_EQ(message_of(decode_colour_image(std::span(png).first(50), "cut.png")),
            "cut.png: is cut off after 50 bytes");
}

TEST(ColourImage, RefusesWhatIsNoPictureAndWhatIsTooLarge) {
  EXPECT_EQ(message_of(decode_colour_image({}, "x")), "x: is empty");
  const auto text = decode_colour_image(test::bytes_of("GIF89a, and more"), "x.gif");
  ASSERT_FALSE(text);
  EXPECT_EQ(text.error().code, ErrorCode::kUnsupported);
  EXPECT_EQ(text.error().message, "x.gif: is neither a JPEG nor a PNG image");

  Bytes huge = encode_colour_jpeg(slopes(64, 48)).value();
  const Bytes frame_header{0xFF, 0xC0};
  const auto at = std::search(huge.begin(), huge.end(), frame_header.begin(), frame_header.end());
  ASSERT_NE(at, huge.end());
  *(at + 7) = 0xFF;  // The high byte of the width.
  EXPECT_EQ(message_of(decode_colour_image(huge, "x.jpg")), "x.jpg: cannot be 65344 x 48 pixels");

  Bytes damaged = encode_colour_jpeg(slopes(64, 48)).value();
  damaged[2] = 0xFF;
  damaged[20] = 0x00;  // The first segment ends here, and another must begin.
  EXPECT_THAT(message_of(decode_colour_image(damaged, "x.jpg")), HasSubstr("damaged JPEG"));
}

TEST(ColourImage, IsReadFromAFileByName) {
  const test::TemporaryFolder folder;
  const auto file =
      folder.write("rgb/1.jpg", test::text_of(encode_colour_jpeg(slopes(16, 8)).value()));
  const auto image = read_colour_image(file);
  ASSERT_TRUE(image) << message_of(image);
  EXPECT_EQ(image->height(), 8);
  const auto missing = read_colour_image(folder.path() / "no.jpg");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::kNotFound);
}

}  // namespace colour_image_test
}  // namespace nadir
