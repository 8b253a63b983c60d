// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <zlib.h>

#include <ctime>
#include <regex>
#include <stdexcept>

#include "tests/support/page_pixels.h"
#include "widgets/canvas/cairo_canvas.h"

namespace nadir {
namespace cairo_pdf_test {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string inflated(const std::string& packed) {
  std::string text(1U << 20U, '\0');
  auto size = static_cast<uLongf>(text.size());
  if (uncompress(reinterpret_cast<Bytef*>(text.data()), &size,
                 reinterpret_cast<const Bytef*>(packed.data()),
                 static_cast<uLong>(packed.size())) != Z_OK) {
    return {};
  }
  text.resize(size);
  return text;
}

/// Everything inside a document's streams that can be unpacked, one after the other.
std::string streams_of(const std::string& pdf) {
  const std::string begin = "stream\n";
  std::string all;
  for (std::size_t at = pdf.find("\n" + begin); at != std::string::npos;) {
    const std::size_t start = at + 1 + begin.size();
    const std::size_t end = pdf.find("endstream", start);
    if (end == std::string::npos) break;
    all += inflated(pdf.substr(start, end - start)) + "\n";
    at = pdf.find("\n" + begin, end);
  }
  return all;
}

std::string drawn(const std::string& line) {
  const auto canvas = CairoCanvas::for_pdf(600, 300, 150.0, "Error over time", "recipe = town");
  canvas->fill(outline_of({10, 10, 50, 20}), {200, 40, 0, 128});
  canvas->stroke(std::vector<Eigen::Vector2d>{{0, 0}, {600, 300}}, {kBlue, 2.0, {3.0, 1.0}});
  canvas->push_clip({0, 0, 300, 300});
  canvas->image({100, 100, 40, 40}, Raster<Rgba>(4, 4, kRed));
  canvas->pop_clip();
  canvas->text({20, 200}, line, {.size_px = 18.0, .colour = kBlack});
  canvas->text({20, 100}, "123.45", {.face = FontFace::kNumbers, .size_px = 18.0});
  return canvas->finish_pdf();
}

TEST(CairoPdf, IsAWholeDocument) {
  const std::string pdf = drawn("Euclidean error");
  EXPECT_THAT(pdf, StartsWith("%PDF-1."));
  EXPECT_THAT(pdf, EndsWith("%%EOF\n"));
  EXPECT_THAT(pdf, HasSubstr("Error over time"));
  EXPECT_THAT(pdf, HasSubstr("recipe = town"));
}

TEST(CairoPdf, HasThePaperSizeThatPixelsAndResolutionGive) {
  // 600 x 300 pixels of 1/150 inch are 4 x 2 inches of 72 points.
  const std::string pdf = drawn("Euclidean error");
  const std::regex box(R"(/MediaBox \[ 0 0 ([0-9.]+) ([0-9.]+) \])");
  std::smatch found;
  ASSERT_TRUE(std::regex_search(pdf, found, box));
  EXPECT_NEAR(std::stod(found[1]), 288.0, 0.01);
  EXPECT_NEAR(std::stod(found[2]), 144.0, 0.01);
}

TEST(CairoPdf, HasTextThatCanBeSearchedAndItsFontsInside) {
  const std::string pdf = drawn("Euclidean error");
  EXPECT_THAT(pdf, HasSubstr("/FontFile"));
  EXPECT_THAT(pdf, HasSubstr("/ToUnicode"));
  const std::string text = streams_of(pdf);
  // Every letter is in the table from glyphs to characters.
  EXPECT_THAT(text, HasSubstr("begincmap"));
  for (const char letter : std::string("Euclidanro12345.")) {
    std::array<char, 8> code{};
    (void)std::snprintf(code.data(), code.size(), "<%04x>", static_cast<unsigned>(letter));
    EXPECT_THAT(text, HasSubstr(code.data())) << letter;
  }
}

TEST(CairoPdf, HasVectorsAndNotAPictureOfThem) {
  const std::string page = streams_of(drawn("Euclidean error"));
  EXPECT_TRUE(std::regex_search(page, std::regex(R"([0-9.]+ [0-9.]+ m\s[0-9.]+ [0-9.]+ l)")));
  EXPECT_THAT(page, HasSubstr(" re"));  // the clip, or the filled rectangle
}

TEST(CairoPdf, IsTheSameFileTwiceAndAsksNoClock) {
  const std::string pdf = drawn("Euclidean error");
  EXPECT_EQ(pdf, drawn("Euclidean error"));
  EXPECT_NE(pdf, drawn("Euclidean terror"));
  const std::regex date(R"(\(D:([0-9]{4})[^)]*\))");
  for (std::sregex_iterator it(pdf.begin(), pdf.end(), date); it != std::sregex_iterator(); ++it) {
    EXPECT_EQ((*it)[1], "2000") << it->str();
  }
  EXPECT_THAT(pdf, Not(HasSubstr("/ModDate")));
}

TEST(CairoPdf, EndsWithoutClipsOpenInThePage) {
  const std::string page = streams_of(drawn("Euclidean error"));
  const auto count = [&page](const char* word) {
    const std::regex whole(std::string("(^|\\s)") + word + "(?=\\s|$)");
    return std::distance(std::sregex_iterator(page.begin(), page.end(), whole),
                         std::sregex_iterator());
  };
  EXPECT_GT(count("q"), 0);
  EXPECT_EQ(count("q"), count("Q"));
}

TEST(CairoPdf, TextThatIsNotUtf8SpoilsNothing) {
  EXPECT_THAT(drawn("M\xfcnchen"), EndsWith("%%EOF\n"));
}

TEST(CairoPdf, AndPixelsAreNotAskedOfEachOther) {
  EXPECT_THROW((void)CairoCanvas::for_pixels(4, 4, kWhite)->finish_pdf(), std::logic_error);
  EXPECT_THROW((void)CairoCanvas::for_pdf(4, 4, 96.0, "", "")->pixels(), std::logic_error);
}

}  // namespace cairo_pdf_test
}  // namespace nadir
