// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/page_layout.h"

#include <gmock/gmock.h>

#include "tests/support/recorded_page.h"
#include "widgets/figures/figures.h"

namespace nadir {
namespace page_layout_test {

TEST(PageLayout, CutsColumnsFromTheLeftAndRowsFromTheTop) {
  const PageRect whole{10.0, 20.0, 100.0, 60.0};
  const auto side_by_side = columns(whole, {1.0, 3.0}, 20.0);
  EXPECT_EQ(side_by_side[0], (PageRect{10.0, 20.0, 20.0, 60.0}));
  EXPECT_EQ(side_by_side[1], (PageRect{50.0, 20.0, 60.0, 60.0}));
  const auto stacked = rows(whole, {1.0, 1.0}, 10.0);
  EXPECT_EQ(stacked[0], (PageRect{10.0, 55.0, 100.0, 25.0}));
  EXPECT_EQ(stacked[1], (PageRect{10.0, 20.0, 100.0, 25.0}));
}

TEST(PageLayout, TakesStripsAndNeverMoreThanIsLeft) {
  PageRect rest{0.0, 0.0, 50.0, 30.0};
  EXPECT_EQ(take_top(rest, 10.0, 2.0), (PageRect{0.0, 20.0, 50.0, 10.0}));
  EXPECT_EQ(take_bottom(rest, 5.0, 1.0), (PageRect{0.0, 0.0, 50.0, 5.0}));
  EXPECT_EQ(rest, (PageRect{0.0, 6.0, 50.0, 12.0}));
  PageRect other = rest;
  EXPECT_EQ(take_top(rest, 100.0), (PageRect{0.0, 6.0, 50.0, 12.0}));
  EXPECT_EQ(rest, (PageRect{0.0, 6.0, 50.0, 0.0}));
  EXPECT_EQ(take_bottom(other, 10.0, 5.0), (PageRect{0.0, 6.0, 50.0, 10.0}));
  EXPECT_EQ(other, (PageRect{0.0, 18.0, 50.0, 0.0}));
}

TEST(PageLayout, LeavesOutTheLastPanelsUntilTheOthersHaveRoom) {
  const PageRect whole{0.0, 0.0, 100.0, 60.0};
  const LeastRoom least{30.0, 25.0};
  EXPECT_EQ(fitting_columns(whole, {1.0, 1.0}, 20.0, least), columns(whole, {1.0, 1.0}, 20.0));
  const auto two_of_four = fitting_columns(whole, {1.0, 1.0, 1.0, 1.0}, 10.0, least);
  ASSERT_EQ(two_of_four.size(), 4U);
  EXPECT_EQ(two_of_four[1], (PageRect{55.0, 0.0, 45.0, 60.0}));
  EXPECT_EQ(two_of_four[2].width, 0.0);
  EXPECT_EQ(two_of_four[3].height, 0.0);
  const auto one_row = fitting_rows(whole, {2.0, 1.0}, 0.0, least);
  EXPECT_EQ(one_row[0], whole);
  EXPECT_EQ(one_row[1].height, 0.0);
  for (const PageRect& panel : fitting_rows({0.0, 0.0, 10.0, 60.0}, {1.0, 1.0}, 0.0, least)) {
    EXPECT_EQ(panel.width, 0.0);
  }
}

TEST(PageLayout, FitsAPictureIntoTheMiddle) {
  EXPECT_EQ(fitted(20.0, 10.0, {0.0, 0.0, 100.0, 100.0}), (PageRect{0.0, 25.0, 100.0, 50.0}));
  EXPECT_EQ(fitted(10.0, 20.0, {0.0, 0.0, 100.0, 100.0}), (PageRect{25.0, 0.0, 50.0, 100.0}));
}

TEST(PageLayout, RectanglesThatOnlyTouchDoNotOverlap) {
  EXPECT_FALSE(overlap({0.0, 0.0, 10.0, 10.0}, {10.0, 0.0, 10.0, 10.0}));
  EXPECT_TRUE(overlap({0.0, 0.0, 10.0, 10.0}, {9.0, 9.0, 10.0, 10.0}));
}

TEST(PageLayout, BreaksTextToTheWidthAtSpaces) {
  TextStyle style;
  style.size_px = 10.0;
  const std::string text = "one two three four five six seven";
  const auto lines = broken_to(text, style, 60.0);
  ASSERT_GT(lines.size(), 2U);
  std::string joined;
  for (const std::string& line : lines) {
    EXPECT_LE(measure_text(line, style).width, 60.0);
    joined += (joined.empty() ? "" : " ") + line;
  }
  EXPECT_EQ(joined, text);
  EXPECT_EQ(broken_to("incomprehensibilities", style, 20.0).size(), 1U);
}

TEST(PageLayout, DropsSeparatorsWhereALineBreaks) {
  TextStyle style;
  style.size_px = 10.0;
  const std::string text = "one two · three four | five · six";
  const double width = measure_text("one two ·", style).width;
  for (const double room : {20.0, width - 1.0, width + 1.0, 70.0, 100.0, 1000.0}) {
    std::string words;
    for (const std::string& line : broken_to(text, style, room)) {
      EXPECT_FALSE(line.starts_with("·") || line.starts_with("|")) << line;
      EXPECT_FALSE(line.ends_with("·") || line.ends_with("|")) << line;
      words += line + " ";
    }
    for (const char* word : {"one", "two", "three", "four", "five", "six"}) {
      EXPECT_THAT(words, testing::HasSubstr(word));
    }
  }
  EXPECT_THAT(broken_to(text, style, 1000.0), testing::ElementsAre(text));
}

TEST(PageLayout, ShortensWordsWithAnEllipsisAtWholeLetters) {
  TextStyle style;
  style.size_px = 10.0;
  EXPECT_EQ(shortened_to("short", style, 100.0), "short");
  const std::string text = "\u00e4\u00f6\u00fc\u00df\u00e4\u00f6\u00fc\u00df";
  for (double width = 60.0; width > 0.0; width -= 1.0) {
    const std::string cut = shortened_to(text, style, width);
    EXPECT_LE(measure_text(cut, style).width, width);
    if (!cut.empty() && cut != text) {
      EXPECT_TRUE(cut.ends_with("\u2026"));
      EXPECT_EQ((cut.size() - 3) % 2, 0U);
    }
  }
  EXPECT_EQ(shortened_to("anything", style, 1.0), "");
}

TEST(PageWords, GiveWayOnALowPage) {
  PageFormat format;
  format.width = 300;
  format.height = 100;
  format.dpi = 72.0;
  RecordedPage canvas;
  PageRect rest = page_inside(format);
  const std::string long_text(400, 'a');
  std::string many;
  for (int i = 0; i < 60; ++i) many += "word ";
  draw_foot(canvas, format, rest, many);
  ASSERT_EQ(canvas.texts.size(), 1U);  // of many lines
  EXPECT_TRUE(canvas.texts[0].line.ends_with("\u2026"));
  EXPECT_GT(rest.height, 60.0);
  const std::vector<LegendEntry> tall(9, {"an entry of some length", {}, LegendEntry::Kind::kBar});
  const PageRect before = rest;
  draw_page_legend(canvas, format, rest, tall);
  EXPECT_EQ(rest, before);
  const std::vector<LegendEntry> wide = {{long_text, {}, LegendEntry::Kind::kBar}};
  draw_page_legend(canvas, format, rest, wide);
  EXPECT_LT(rest.height, before.height);
  PageRect low{10.0, 10.0, 100.0, 30.0};
  draw_caption(canvas, format, low, "(a) never seen");
  EXPECT_EQ(low.height, 30.0);
  EXPECT_FALSE(canvas.has_text("never seen"));
  draw_message(canvas, format, {100.0, 40.0, 60.0, 21.0}, many + long_text);
  EXPECT_THAT(unreadable_texts(canvas, format.width, format.height, 7.0), testing::IsEmpty());
}

TEST(PageFormat, IsHigherWhereItIsNarrow) {
  FigureOptions options;
  const PageShape shape{2.0, 0.5};
  options.size.width = 1600;
  EXPECT_EQ(page_format(options, shape).height, 800);
  options.size.width = 320;  // 240 points
  EXPECT_EQ(page_format(options, shape).height, 640);
  options.size.width = 200;
  EXPECT_EQ(page_format(options, shape).height, 400);
  // 320 points, half way from 240 to 400: a shape of 1.25.
  options.size.width = 400;
  options.dpi = 90.0;
  EXPECT_EQ(page_format(options, shape).height, 320);
}

TEST(PageFormat, KeepsTextReadableOnSmallPagesAndInProportionOnLargeOnes) {
  FigureOptions options;
  options.size.width = 600;
  EXPECT_DOUBLE_EQ(page_format(options, 1.5).dpi, 96.0);
  EXPECT_EQ(page_format(options, 1.5).height, 400);
  options.size.width = 1500;
  EXPECT_DOUBLE_EQ(page_format(options, 1.5).dpi, 200.0);
  options.dpi = 300.0;
  options.size.height = 77;
  EXPECT_DOUBLE_EQ(page_format(options, 1.5).dpi, 300.0);
  EXPECT_EQ(page_format(options, 1.5).height, 77);
}

}  // namespace page_layout_test
}  // namespace nadir
