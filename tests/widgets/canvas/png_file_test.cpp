// SPDX-License-Identifier: Apache-2.0
#include "widgets/canvas/png_file.h"

#include <gmock/gmock.h>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

#include "tests/support/error_text.h"
#include "tests/support/page_pixels.h"
#include "tests/support/scratch_folder.h"
#include "tests/widgets/canvas/png_chunks.h"

namespace nadir {
namespace png_file_test {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;
using Texts = std::map<std::string, std::string>;

Raster<Rgba> picture(std::uint8_t alpha = 255) {
  Raster<Rgba> pixels(7, 5);
  for (int i = 0; i < 35; ++i) {
    const auto value = static_cast<std::uint8_t>(7 * i);
    pixels.values()[static_cast<std::size_t>(i)] = {value, static_cast<std::uint8_t>(255 - value),
                                                    static_cast<std::uint8_t>(i)};
  }
  pixels.at(3, 2).alpha = alpha;
  return pixels;
}

cv::Mat decoded(const std::string& png) {
  return cv::imdecode(std::vector<unsigned char>(png.begin(), png.end()), cv::IMREAD_UNCHANGED);
}

const Texts kTexts = {{"Recipe", "[layers]\npicture = \"a\\\"b\"\n"},
                      {"Empty", ""},
                      {"Software", "Nadir 0.1"},
                      {"Title",
                       "Flug \xc3\xbc"
                       "ber M\xc3\xbcnchen \xe2\x88\x9e \xf0\x9f\x9a\x81"}};

TEST(EncodePng, KeepsOpaquePixelsInThreeChannels) {
  const Raster<Rgba> pixels = picture();
  const cv::Mat image = decoded(encode_png(pixels));
  ASSERT_EQ(image.type(), CV_8UC3);
  ASSERT_EQ(image.size(), cv::Size(7, 5));
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 7; ++column) {
      const auto& pixel = image.at<cv::Vec3b>(row, column);
      EXPECT_EQ((Rgba{pixel[2], pixel[1], pixel[0]}), pixels.at(column, row));
    }
  }
}

TEST(EncodePng, KeepsTransparencyInFour) {
  const Raster<Rgba> pixels = picture(130);
  const cv::Mat image = decoded(encode_png(pixels));
  ASSERT_EQ(image.type(), CV_8UC4);
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 7; ++column) {
      const auto& pixel = image.at<cv::Vec4b>(row, column);
      EXPECT_EQ((Rgba{pixel[2], pixel[1], pixel[0], pixel[3]}), pixels.at(column, row));
    }
  }
}

TEST(EncodePng, GivesTheSameBytesTwice) {
  EXPECT_EQ(encode_png(picture(), {300.0, kTexts}), encode_png(picture(), {300.0, kTexts}));
}

TEST(EncodePng, MakesChunksInTheOrderThatPngAsksFor) {
  const auto chunks = png_chunks(encode_png(picture(), {300.0, kTexts}));
  for (const PngChunk& chunk : chunks) EXPECT_TRUE(chunk.is_whole) << chunk.type;
  ASSERT_GE(chunks.size(), 4U);
  EXPECT_EQ(chunks.front().type, "IHDR");
  EXPECT_EQ(chunks[1].type, "pHYs");  // must come before the pixels
  EXPECT_EQ(chunks.back().type, "IEND");
}

TEST(EncodePng, SaysTheResolutionInPixelsPerMetre) {
  const auto chunks = png_chunks(encode_png(picture(), {.dpi = 300.0, .texts = {}}));
  // 300 / 0.0254 = 11811.02
  EXPECT_EQ(chunks.at(1).data, png_bytes(11811) + png_bytes(11811) + '\x01');
  for (const PngChunk& chunk : png_chunks(encode_png(picture()))) EXPECT_NE(chunk.type, "pHYs");
}

TEST(EncodePng, LeavesThePixelsReadableWhateverTheTexts) {
  EXPECT_EQ(
      cv::norm(decoded(encode_png(picture(), {96.0, kTexts})), decoded(encode_png(picture()))),
      0.0);
}

TEST(EncodePng, RefusesKeywordsThatPngDoesNotKnow) {
  EXPECT_THROW((void)encode_png(picture(), {0.0, {{"", "x"}}}), std::logic_error);
  EXPECT_THROW((void)encode_png(picture(), {0.0, {{std::string(80, 'k'), "x"}}}), std::logic_error);
  const Texts longest = {{std::string(79, 'k'), "x"}};
  EXPECT_EQ(parse_png_texts(encode_png(picture(), {0.0, longest}), "p").value(), longest);
}

TEST(PngTexts, ComeBackAsTheyWereWritten) {
  const auto texts = parse_png_texts(encode_png(picture(), {300.0, kTexts}), "p.png");
  ASSERT_TRUE(texts) << error_text(texts);
  EXPECT_EQ(*texts, kTexts);
}

TEST(PngTexts, ComeBackWhenTheyAreLong) {
  std::string recipe;
  for (int i = 0; i < 40'000; ++i) recipe += std::to_string(i) + "\n";
  EXPECT_EQ(parse_png_texts(encode_png(picture(), {0.0, {{"Recipe", recipe}}}), "p")->at("Recipe"),
            recipe);
}

TEST(PngTexts, AreReadFromAFile) {
  const ScratchFolder folder;
  const auto path = folder.file("figure.png", encode_png(picture(), {0.0, kTexts}));
  EXPECT_EQ(read_png_texts(path).value(), kTexts);
}

TEST(PngTexts, AreReadBehindThePixelsToo) {
  const std::string file = before_png_end(
      encode_png(picture()), png_chunk("iTXt", std::string("Recipe\0\0\0\0\0", 11) + "late"));
  EXPECT_EQ(parse_png_texts(file, "p").value(), (Texts{{"Recipe", "late"}}));
}

TEST(PngTexts, AreNoneInAPngOfAnotherProgram) {
  std::vector<unsigned char> file;
  cv::imencode(".png", cv::Mat(4, 4, CV_8UC1, cv::Scalar(9)), file);
  const auto texts = parse_png_texts(std::string(file.begin(), file.end()), "p");
  ASSERT_TRUE(texts) << error_text(texts);
  EXPECT_THAT(*texts, IsEmpty());
}

TEST(PngTexts, OfOtherKindsArePassedOver) {
  std::string file = encode_png(picture(), {0.0, {{"Recipe", "ours"}}});
  const std::string compressed = std::string("A\0\1\0\0\0", 6) + "x\x9c\x03\x00\x00\x00\x00\x01";
  const std::string in_english = std::string("B\0\0\0en\0Title\0", 13) + "text";
  file = before_png_end(file, png_chunk("iTXt", compressed) + png_chunk("iTXt", in_english) +
                                  png_chunk("tEXt", std::string("C\0text", 6)) +
                                  png_chunk("iTXt", "no end of a keyword") + png_chunk("iTXt", ""));
  EXPECT_EQ(parse_png_texts(file, "p").value(), (Texts{{"Recipe", "ours"}}));
}

TEST(PngTexts, CutShortAnywhereAreAnErrorThatNamesTheFile) {
  const std::string file = encode_png(picture(), {300.0, kTexts});
  for (std::size_t size = 0; size < file.size(); ++size) {
    const std::string cut = file.substr(0, size);  // its own memory, so that a sanitizer watches
    const auto texts = parse_png_texts(cut, "cut.png");
    ASSERT_FALSE(texts) << size;
    EXPECT_EQ(error_code(texts), ErrorCode::kMalformed);
    EXPECT_EQ(error_text(texts),
              size < 8 ? "cut.png: is not a PNG image" : "cut.png: is cut short");
  }
}

TEST(PngTexts, DamagedInAnyByteAreAnError) {
  const std::string file = encode_png(picture(), {0.0, {{"Recipe", "seed = 1"}}});
  const PngChunk chunk = png_chunks(file).at(1);
  ASSERT_EQ(chunk.type, "iTXt");
  // From its first letter through its checksum; another type or length is another chunk.
  for (std::size_t i = 8; i < 12 + chunk.data.size(); ++i) {
    std::string damaged = file;
    damaged[chunk.begin_at + i] = static_cast<char>(damaged[chunk.begin_at + i] ^ 0x10);
    const auto texts = parse_png_texts(damaged, "old.png");
    ASSERT_FALSE(texts) << i;
    EXPECT_EQ(error_code(texts), ErrorCode::kMalformed);
    EXPECT_EQ(error_text(texts), "old.png: a text in it is damaged");
  }
}

TEST(PngTexts, WithALengthBeyondTheFileAreCutShort) {
  std::string file = encode_png(picture());
  for (const std::uint32_t length : {0xFFFFFFFFU, 0x80000000U, 0x7FFFFFFFU, 0x00100000U}) {
    file.replace(8, 4, png_bytes(length));
    EXPECT_EQ(error_text(parse_png_texts(file, "p")), "p: is cut short") << length;
  }
}

TEST(PngTexts, AreNotSoughtInOtherFiles) {
  for (const std::string& text : {std::string(), std::string("\xff\xd8\xff\xe0JFIF"),
                                  std::string("<svg/>"), std::string("\x89PNG\n\n\x1a\n....")}) {
    EXPECT_EQ(error_text(parse_png_texts(text, "x.jpg")), "x.jpg: is not a PNG image");
  }
}

TEST(PngTexts, OfAFileThatIsNotThereAreAnError) {
  const ScratchFolder folder;
  const auto texts = read_png_texts(folder.path() / "none.png");
  ASSERT_FALSE(texts);
  EXPECT_EQ(error_code(texts), ErrorCode::kNotFound);
  EXPECT_THAT(error_text(texts), StartsWith((folder.path() / "none.png").string() + ": "));
}

TEST(PngTexts, OfAFolderAreAnError) {
  const ScratchFolder folder;
  EXPECT_THAT(error_text(read_png_texts(folder.path())), StartsWith(folder.path().string() + ": "));
}

}  // namespace png_file_test
}  // namespace nadir
