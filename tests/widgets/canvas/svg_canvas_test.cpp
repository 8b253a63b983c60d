// SPDX-License-Identifier: Apache-2.0
#include "widgets/canvas/svg_canvas.h"

#include <gmock/gmock.h>
#include <vtkNew.h>

#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <set>
#include <stdexcept>

#include "tests/support/page_pixels.h"
#include "tests/widgets/canvas/xml_reading.h"

namespace nadir {
namespace svg_canvas_test {

using testing::HasSubstr;
using testing::StartsWith;

/// Every character that XML treats in its own way, and letters from outside ASCII.
constexpr const char* kAwkward = "a < b & \"c\" > 'd' &amp; ]]> \xc3\xbc \xe2\x88\x9e";

class SvgPage : public testing::Test {
 protected:
  /// Ends the page and reads it.
  const XmlReading& read() {
    text = canvas.finish();
    const int answer = reading->Parse(text.c_str(), static_cast<unsigned>(text.size()));
    EXPECT_TRUE(answer == 1 && reading->is_well_formed) << text;
    return *reading;
  }
  /// The only element of that name.
  XmlElement only(const std::string& name) {
    const auto found = read().named(name);
    EXPECT_EQ(found.size(), 1U) << text;
    return found.empty() ? XmlElement{} : found.front();
  }

  SvgCanvas canvas{600, 300, 300.0, "Error", "recipe"};
  std::string text;
  vtkNew<XmlReading> reading;
};

TEST_F(SvgPage, IsAsLargeAsPixelsAndResolutionSay) {
  // 600 x 300 pixels of 1/300 inch are 2 x 1 inches of 96 units of CSS.
  const XmlElement root = only("svg");
  EXPECT_EQ(root["width"], "192");
  EXPECT_EQ(root["height"], "96");
  EXPECT_EQ(root["viewBox"], "0 0 600 300");
  EXPECT_EQ(root["xmlns"], "http://www.w3.org/2000/svg");
  EXPECT_THAT(text, StartsWith("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"));
}

TEST(SvgCanvas, KeepsTitleAndMetadataWhateverTheyHold) {
  SvgCanvas canvas(10, 10, 96.0, kAwkward, std::string("key = \"value\"\n\tb = 2 ") + kAwkward);
  const std::string svg = canvas.finish();
  const vtkNew<XmlReading> reading;
  ASSERT_EQ(reading->Parse(svg.c_str(), static_cast<unsigned>(svg.size())), 1) << svg;
  EXPECT_EQ(reading->named("title").at(0).text, kAwkward);
  EXPECT_EQ(reading->named("metadata").at(0).text,
            std::string("key = \"value\"\n\tb = 2 ") + kAwkward);
}

TEST(SvgCanvas, HasNoMetadataWhereThereAreNone) {
  SvgCanvas canvas(10, 10, 96.0, "t", "");
  EXPECT_THAT(canvas.finish(), testing::Not(HasSubstr("metadata")));
}

TEST(SvgCanvas, GivesItsMetadataBack) {
  for (const std::string metadata :
       {"", "seed = 1\n", kAwkward, "&lt; &amp;amp; &quot;", "</metadata>"}) {
    EXPECT_EQ(svg_metadata(SvgCanvas(10, 10, 96.0, kAwkward, metadata).finish()), metadata);
  }
  EXPECT_EQ(svg_metadata(SvgCanvas(10, 10, 96.0, "<metadata>no</metadata>", "").finish()), "");
  EXPECT_EQ(svg_metadata("<svg><metadata>cut"), "");
}

TEST_F(SvgPage, WritesTextAsText) {
  canvas.text({20, 50}, kAwkward, {.size_px = 12.5, .colour = {1, 2, 255}});
  const XmlElement element = only("text");
  EXPECT_EQ(element.text, kAwkward);
  EXPECT_EQ(element["x"], "20");
  EXPECT_EQ(element["y"], "250");
  EXPECT_EQ(element["font-size"], "12.5");
  EXPECT_EQ(element["fill"], "#0102ff");
  EXPECT_EQ(element["fill-opacity"], "(none)");
  EXPECT_EQ(element["text-anchor"], "(none)");
  EXPECT_EQ(element["font-weight"], "(none)");
  EXPECT_EQ(element["transform"], "(none)");
  EXPECT_THAT(element["font-family"], StartsWith("Inter,"));
}

TEST_F(SvgPage, LeavesOutControlCharacters) {
  std::string line = "a";
  for (char control = 1; control < 0x20; ++control) line += control;
  line += std::string("\0", 1) + "b\x7f";
  canvas.text({20, 50}, line, {});
  EXPECT_EQ(only("text").text, "a\t\nb\x7f");
}

TEST_F(SvgPage, StaysWellFormedWhenATextIsNotUtf8) {
  canvas.text({20, 50}, "M\xfcnchen \xff\xfe \xe2\x88", {});
  EXPECT_THAT(only("text").text, testing::AllOf(StartsWith("M"), HasSubstr("nchen")));
}

TEST_F(SvgPage, AlignsTurnsAndStretchesTextToItsMeasure) {
  const TextStyle style{.face = FontFace::kNumbers,
                        .is_bold = true,
                        .size_px = 20.0,
                        .align = TextAlign::kRight,
                        .rotation_deg = 90.0};
  canvas.text({100, 50}, "12.50", style);
  const XmlElement element = only("text");
  EXPECT_EQ(element["text-anchor"], "end");
  EXPECT_EQ(element["font-weight"], "bold");
  EXPECT_EQ(element["transform"], "rotate(-90 100 250)");  // SVG turns clockwise
  EXPECT_THAT(element["font-family"], HasSubstr("monospace"));
  EXPECT_NEAR(std::stod(element["textLength"]), measure_text("12.50", style).width, 0.006);
}

TEST_F(SvgPage, CentresText) {
  canvas.text({100, 50}, "x", {.align = TextAlign::kCentre});
  EXPECT_EQ(only("text")["text-anchor"], "middle");
}

TEST_F(SvgPage, WritesAreasAndLinesWithYDown) {
  canvas.fill(outline_of({10, 20, 30.25, 40}), {255, 0, 16, 51});
  canvas.stroke(std::vector<Eigen::Vector2d>{{0, 0}, {600, 300}, {1.004, 299.996}},
                {{0, 128, 0}, 2.5, {4.0, 2.5}});
  const auto& svg = read();
  const XmlElement area = svg.named("polygon").at(0);
  EXPECT_EQ(area["points"], "10,280 40.25,280 40.25,240 10,240");
  EXPECT_EQ(area["fill"], "#ff0010");
  EXPECT_EQ(area["fill-opacity"], "0.2");
  EXPECT_EQ(area["fill-rule"], "evenodd");
  const XmlElement line = svg.named("polyline").at(0);
  EXPECT_EQ(line["points"], "0,300 600,0 1,0");
  EXPECT_EQ(line["stroke"], "#008000");
  EXPECT_EQ(line["stroke-width"], "2.5");
  EXPECT_EQ(line["stroke-dasharray"], "4 2.5");
  EXPECT_EQ(line["stroke-linejoin"], "round");
  EXPECT_EQ(line["fill"], "none");
}

TEST_F(SvgPage, HasAGroupForEachClipAndEndsItThere) {
  canvas.push_clip({10, 20, 100, 50});
  canvas.fill(outline_of({0, 0, 1, 1}), kRed);
  canvas.push_clip({20, 30, 10, 10});
  canvas.fill(outline_of({0, 0, 2, 2}), kRed);
  canvas.pop_clip();
  canvas.fill(outline_of({0, 0, 3, 3}), kRed);
  canvas.pop_clip();
  canvas.push_clip({0, 0, 5, 5});
  canvas.pop_clip();
  canvas.fill(outline_of({0, 0, 4, 4}), kRed);
  const auto& svg = read();
  std::vector<int> depths;
  for (const XmlElement& area : svg.named("polygon")) depths.push_back(area.depth);
  EXPECT_THAT(depths, testing::ElementsAre(2, 3, 2, 1));
  std::set<std::string> clips;
  for (const XmlElement& clip : svg.named("clipPath")) clips.insert("url(#" + clip["id"] + ")");
  EXPECT_EQ(clips.size(), 3U);
  std::set<std::string> used;
  for (const XmlElement& group : svg.named("g")) used.insert(group["clip-path"]);
  EXPECT_EQ(used, clips);
  const XmlElement box = svg.named("rect").at(0);
  EXPECT_EQ(box.parent, "clipPath");
  EXPECT_EQ(box["x"] + " " + box["y"] + " " + box["width"] + " " + box["height"], "10 230 100 50");
}

TEST_F(SvgPage, RefusesClipsThatDoNotMatch) {
  EXPECT_THROW(canvas.pop_clip(), std::logic_error);
  canvas.push_clip({0, 0, 1, 1});
  EXPECT_THROW((void)canvas.finish(), std::logic_error);
}

std::vector<unsigned char> from_base64(const std::string& text) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<unsigned char> bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char letter : text) {
    const std::size_t value = letters.find(letter);
    if (value == std::string::npos) break;
    bits = (bits << 6U) | static_cast<std::uint32_t>(value);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<unsigned char>(bits >> static_cast<unsigned>(count)));
  }
  return bytes;
}

// Sizes that leave every rest when bytes are packed by three.
TEST_F(SvgPage, CarriesAnImageInside) {
  for (int width = 1; width < 7; ++width) {
    SvgCanvas page(100, 50, 96.0, "t", "");
    Raster<Rgba> image(width, 2);
    for (int i = 0; i < 2 * width; ++i) {
      image.values()[static_cast<std::size_t>(i)] = {static_cast<std::uint8_t>(40 * i), 7, 9};
    }
    page.image({10, 20, 30, 15}, image);
    const std::string svg = page.finish();
    const vtkNew<XmlReading> read_page;
    ASSERT_EQ(read_page->Parse(svg.c_str(), static_cast<unsigned>(svg.size())), 1) << svg;
    const XmlElement element = read_page->named("image").at(0);
    EXPECT_EQ(element["x"] + " " + element["y"] + " " + element["width"] + " " + element["height"],
              "10 15 30 15");
    EXPECT_EQ(element["preserveAspectRatio"], "none");
    EXPECT_THAT(element["style"], HasSubstr("pixelated"));
    const std::string prefix = "data:image/png;base64,";
    const std::string link = element["xlink:href"];
    ASSERT_THAT(link, StartsWith(prefix));
    EXPECT_EQ((link.size() - prefix.size()) % 4, 0U);
    const cv::Mat decoded =
        cv::imdecode(from_base64(link.substr(prefix.size())), cv::IMREAD_UNCHANGED);
    ASSERT_EQ(decoded.cols, width);
    ASSERT_EQ(decoded.rows, 2);
    for (int row = 0; row < 2; ++row) {
      for (int column = 0; column < width; ++column) {
        const auto& pixel = decoded.at<cv::Vec3b>(row, column);
        EXPECT_EQ((Rgba{pixel[2], pixel[1], pixel[0]}), image.at(column, row));
      }
    }
  }
}

TEST_F(SvgPage, LetsAReducedImageBeSmooth) {
  canvas.image({0, 0, 4, 4}, Raster<Rgba>(8, 8, kRed));
  EXPECT_EQ(only("image")["style"], "(none)");
}

TEST_F(SvgPage, CutsLinesThatReachFarAndKeepsTheirDashes) {
  canvas.stroke(std::vector<Eigen::Vector2d>{{-1e9, 100}, {1e9, 100}}, {kRed, 2.0, {4.0, 1.0}});
  const XmlElement line = only("polyline");
  EXPECT_EQ(line["points"], "-10000,200 10600,200");
  EXPECT_EQ(line["stroke-dashoffset"], "999990000");
}

TEST_F(SvgPage, HasNoNumberThatIsNone) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  canvas.stroke(std::vector<Eigen::Vector2d>{{0, 0}, {1, 1}, {kNone, 2}, {3, 3}, {4, 4}}, {kRed});
  canvas.fill(std::vector<Eigen::Vector2d>{{0, 0}, {1, kNone}, {9, 0}, {9, 9}}, kRed);
  const auto& svg = read();
  ASSERT_EQ(svg.named("polyline").size(), 2U);
  EXPECT_EQ(svg.named("polyline")[0]["points"], "0,300 1,299");
  EXPECT_EQ(svg.named("polyline")[1]["points"], "3,297 4,296");
  EXPECT_EQ(svg.named("polygon").at(0)["points"], "0,300 9,300 9,291");
}

TEST_F(SvgPage, IsTheSameFileTwice) {
  const auto draw = [](SvgCanvas& page) {
    page.push_clip({1, 2, 3, 4});
    page.text({1, 2}, "x", {});
    page.image({0, 0, 4, 4}, Raster<Rgba>(8, 8, Rgba{1, 2, 3, 4}));
    page.pop_clip();
    return page.finish();
  };
  SvgCanvas again{600, 300, 300.0, "Error", "recipe"};
  EXPECT_EQ(draw(canvas), draw(again));
}

TEST_F(SvgPage, WritesNothingForTooFewPointsAnEmptyTextOrAnEmptyImage) {
  canvas.stroke(std::vector<Eigen::Vector2d>{{5, 5}}, {kRed});
  canvas.fill(std::vector<Eigen::Vector2d>{{5, 5}, {6, 6}}, kRed);
  canvas.text({1, 1}, "", {});
  canvas.image({0, 0, 4, 4}, {});
  EXPECT_EQ(read().elements.size(), 3U);  // svg, title, metadata
}

}  // namespace svg_canvas_test
}  // namespace nadir
