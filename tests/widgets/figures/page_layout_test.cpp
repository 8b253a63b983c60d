// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/page_layout.h"

#include <gmock/gmock.h>

#include "widgets/figures/figures.h"

namespace nadir {
namespace {

TEST(PageLayout, CutsColumnsFromTheLeftAndRowsFromTheTop) {
  const PageRect whole{10.0, 20.0, 100.0, 60.0};
  const auto side_by_side = columns(whole, {1.0, 3.0}, 20.0);
  EXPECT_EQ(side_by_side[0], (PageRect{10.0, 20.0, 20.0, 60.0}));
  EXPECT_EQ(side_by_side[1], (PageRect{50.0, 20.0, 60.0, 60.0}));
  const auto stacked = rows(whole, {1.0, 1.0}, 10.0);
  EXPECT_EQ(stacked[0], (PageRect{10.0, 55.0, 100.0, 25.0}));
  EXPECT_EQ(stacked[1], (PageRect{10.0, 20.0, 100.0, 25.0}));
}

TEST(PageLayout, TakesStripsAndNeverLeavesLessThanNothing) {
  PageRect rest{0.0, 0.0, 50.0, 30.0};
  EXPECT_EQ(take_top(rest, 10.0, 2.0), (PageRect{0.0, 20.0, 50.0, 10.0}));
  EXPECT_EQ(take_bottom(rest, 5.0, 1.0), (PageRect{0.0, 0.0, 50.0, 5.0}));
  EXPECT_EQ(rest, (PageRect{0.0, 6.0, 50.0, 12.0}));
  EXPECT_GE(take_top(rest, 100.0).height, 0.0);
  EXPECT_EQ(rest.height, 0.0);
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

TEST(PageFormat, KeepsTextReadableOnSmallPagesAndInProportionOnLargeOnes) {
  FigureOptions options;
  options.width = 600;
  EXPECT_DOUBLE_EQ(page_format(options, 1.5).dpi, 96.0);
  EXPECT_EQ(page_format(options, 1.5).height, 400);
  options.width = 1500;
  EXPECT_DOUBLE_EQ(page_format(options, 1.5).dpi, 200.0);
  options.dpi = 300.0;
  options.height = 77;
  EXPECT_DOUBLE_EQ(page_format(options, 1.5).dpi, 300.0);
  EXPECT_EQ(page_format(options, 1.5).height, 77);
}

}  // namespace
}  // namespace nadir
