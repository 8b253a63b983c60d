// SPDX-License-Identifier: Apache-2.0
#include "core/flight/frame_image.h"

#include <gmock/gmock.h>

#include <limits>
#include <opencv2/imgcodecs.hpp>

#include "core/base/random.h"
#include "tests/core/flight/flight_fixtures.h"

namespace nadir {
namespace frame_image_test {

using test::bytes_of;
using test::kHeight;
using test::kWidth;
using test::message_of;
using test::small_frame;
using testing::HasSubstr;

constexpr ImageSize kSize{kWidth, kHeight};

std::vector<std::uint8_t> png_of(const cv::Mat& image, const std::vector<int>& options = {}) {
  std::vector<std::uint8_t> bytes;
  cv::imencode(".png", image, bytes, options);
  return bytes;
}

TEST(LabelImage, ComesBackAsEncoded) {
  const Raster<ClassId> labels = small_frame(0.0).labels;
  const auto png = encode_label_png(labels);
  ASSERT_TRUE(png) << message_of(png);
  const auto again = decode_label_image(*png, "a.png", kSize);
  ASSERT_TRUE(again) << message_of(again);
  EXPECT_EQ(*again, labels);
}

TEST(DepthImage, ComesBackToTheMillimetre) {
  Raster<float> depth_m(40, 30);
  for (std::uint32_t i = 0; i < depth_m.size(); ++i) {
    depth_m.values()[i] =
        65.5F * static_cast<float>(random_words({3, 0, i, 0, 0})[0]) / 4294967296.0F;
  }
  const auto png = encode_depth_png(depth_m);
  ASSERT_TRUE(png) << message_of(png);
  const auto again = decode_depth_image(*png, "d.png", {40, 30}, 1000.0);
  ASSERT_TRUE(again) << message_of(again);
  for (std::size_t i = 0; i < depth_m.size(); ++i) {
    EXPECT_NEAR(again->values()[i], depth_m.values()[i], 0.00051F);
  }
}

TEST(DepthImage, EverythingThatIsNoDepthBecomesNone) {
  const float infinity = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Raster<float> depth_m(4, 3,
                              {0.0F, -1.0F, nan, infinity, -infinity, 65.535F, 65.536F, 1e30F,
                               0.0004F, 0.001F, 20.0F, 1.5F});
  const auto again = decode_depth_image(*encode_depth_png(depth_m), "d.png", {4, 3}, 1000.0);
  ASSERT_TRUE(again) << message_of(again);
  EXPECT_THAT(again->values(),
              testing::ElementsAre(0, 0, 0, 0, 0, 65.535F, 0, 0, 0, 0.001F, 20.0F, 1.5F));
}

TEST(DepthImage, UnitsAreThoseOfTheFlight) {
  const cv::Mat image(1, 2, CV_16UC1, cv::Scalar(5000));
  const auto depth_m = decode_depth_image(png_of(image), "d.png", {2, 1}, 5000.0);
  ASSERT_TRUE(depth_m) << message_of(depth_m);
  EXPECT_THAT(depth_m->values(), testing::Each(1.0F));
}

TEST(LabelImage, CutOffAnywhereIsOneSentenceAndNeverALabel) {
  const auto png = encode_label_png(small_frame(0.0).labels);
  for (std::size_t length = 0; length < png->size(); ++length) {
    const auto labels = decode_label_image(std::span(png->data(), length), "labels/7.png", kSize);
    ASSERT_FALSE(labels) << length;
    EXPECT_THAT(labels.error().message, HasSubstr("labels/7.png: is "));
    if (length >= 4) {
      EXPECT_EQ(labels.error().code, ErrorCode::kMalformed);
      EXPECT_EQ(labels.error().message,
                fmt::format("labels/7.png: is cut off after {} bytes", length));
    }
  }
  EXPECT_EQ(message_of(decode_label_image({}, "a.png", kSize)), "a.png: is empty");
}

TEST(LabelImage, ASingleFlippedBitIsFound) {
  const auto png = encode_label_png(small_frame(0.0).labels);
  for (std::size_t at = 0; at < png->size(); ++at) {
    std::vector<std::uint8_t> damaged = *png;
    damaged[at] ^= 0x10U;
    EXPECT_FALSE(decode_label_image(damaged, "a.png", kSize)) << "byte " << at;
  }
}

TEST(LabelImage, BytesAfterTheEndDoNotMatter) {
  auto png = *encode_label_png(small_frame(0.0).labels);
  png.insert(png.end(), 100, 0xAB);
  EXPECT_TRUE(decode_label_image(png, "a.png", kSize));
}

TEST(LabelImage, OfAnotherSizeSaysBothSizes) {
  const auto png = encode_label_png(small_frame(0.0).labels);
  EXPECT_EQ(message_of(decode_label_image(*png, "a.png", {640, 480})),
            "a.png: is 4 x 3 pixels, but the camera has 640 x 480");
}

TEST(LabelImage, ThatIsAnotherKindOfImageSaysWhich) {
  const auto fault = [](const cv::Mat& image, const std::vector<int>& options = {}) {
    return message_of(decode_label_image(png_of(image, options), "a.png", kSize));
  };
  const cv::Scalar one = cv::Scalar::all(1);
  EXPECT_EQ(fault(cv::Mat(3, 4, CV_8UC3, one)), "a.png: is in colour, but it must be grey");
  EXPECT_EQ(fault(cv::Mat(3, 4, CV_8UC4, one)), "a.png: is in colour, but it must be grey");
  EXPECT_EQ(fault(cv::Mat(3, 4, CV_16UC1, one)),
            "a.png: has 16 bits a pixel, but labels must have 8");
  EXPECT_EQ(fault(cv::Mat(3, 4, CV_8UC1, one), {cv::IMWRITE_PNG_BILEVEL, 1}),
            "a.png: has 1 bits a pixel, not 8 or 16");
  EXPECT_EQ(
      message_of(decode_depth_image(png_of(cv::Mat(3, 4, CV_8UC1, one)), "d.png", kSize, 1000.0)),
      "d.png: has 8 bits a pixel, but depth must have 16");
  std::vector<std::uint8_t> jpeg;
  cv::imencode(".jpg", cv::Mat(3, 4, CV_8UC1, one), jpeg);
  const auto lossy = decode_label_image(jpeg, "a.jpg", kSize);
  ASSERT_FALSE(lossy);
  EXPECT_EQ(lossy.error().code, ErrorCode::kUnsupported);
  EXPECT_EQ(lossy.error().message, "a.jpg: is neither a PNG nor a PGM image");
}

TEST(LabelImage, AnIdThatIsNoClassIsNamedWithItsPlace) {
  for (const int id : {16, 17, 200, 254}) {
    Raster<ClassId> labels = small_frame(0.0).labels;
    labels.at(2, 1) = static_cast<ClassId>(id);
    EXPECT_EQ(message_of(decode_label_image(*encode_label_png(labels), "a.png", kSize)),
              fmt::format(
                  "a.png: has id {} at column 2, row 1, which is no class (0 to 15, or 255)", id));
  }
}

TEST(LabelImage, APgmIsNotStretchedToItsLargestValue) {
  const std::string pgm = std::string("P5\n# made by hand\n2 2\n15\n") + "\x03\x0f" + "\x01\x02";
  const auto labels = decode_label_image(bytes_of(pgm), "a.pgm", {2, 2});
  ASSERT_TRUE(labels) << message_of(labels);
  EXPECT_THAT(labels->values(), testing::ElementsAre(3, 15, 1, 2));
}

TEST(DepthImage, APgmHasItsHighByteFirst) {
  const std::string pgm = std::string("P5 2 1 65535\n") + "\x01\x02" + "\xff\xff";
  const auto depth_m = decode_depth_image(bytes_of(pgm), "d.pgm", {2, 1}, 1000.0);
  ASSERT_TRUE(depth_m) << message_of(depth_m);
  EXPECT_THAT(depth_m->values(), testing::ElementsAre(0.258F, 65.535F));
}

TEST(LabelImage, ABadPgmHeaderIsNamed) {
  const auto fault = [](const std::string& text) {
    return message_of(decode_label_image(bytes_of(text), "a.pgm", {2, 2}));
  };
  EXPECT_EQ(fault("P5"), "a.pgm: has no valid width in its PGM header");
  EXPECT_EQ(fault("P5 0 2 255\n"), "a.pgm: has no valid width in its PGM header");
  EXPECT_EQ(fault("P5 2 99999999999999999999 255\n"),
            "a.pgm: has no valid height in its PGM header");
  EXPECT_EQ(fault("P5 2 2 65536\n"), "a.pgm: has no valid largest value in its PGM header");
  EXPECT_EQ(fault("P5 2 2 255\nabc"), "a.pgm: is cut off after 14 bytes");
  EXPECT_EQ(fault("P5 2 2 255"), "a.pgm: is cut off after 10 bytes");
}

TEST(EncodeImage, EmptyRastersAreABugOfTheCaller) {
  EXPECT_THROW((void)encode_label_png({}), std::logic_error);
  EXPECT_THROW((void)encode_depth_png({}), std::logic_error);
}

}  // namespace frame_image_test
}  // namespace nadir
