// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/chart_layout.h"

#include <gmock/gmock.h>

#include <cmath>

namespace nadir {
namespace chart_layout_test {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kPxPerPt = 96.0 / 72.0;

ChartSpec error_spec() {
  ChartSpec spec;
  spec.x.title = "time [s]";
  spec.y.title = "position error [m]";
  spec.lines.push_back({.x = {0.0, 150.0}, .y = {0.0, 4.2}});
  return spec;
}

ChartSpec bars_spec(std::vector<std::string> groups) {
  ChartSpec spec;
  spec.y.title = "MSE [m²]";
  spec.bars = BarsSpec{std::move(groups), {{"estimate", {1.0, 2.0, 3.0}, {}}}, false};
  return spec;
}

ChartLayout laid_out(const ChartSpec& spec, const PageRect& where, double px_per_pt = kPxPerPt) {
  return lay_out(spec, ChartType(theme(ThemeName::kLight), px_per_pt, spec.bars.has_value()),
                 where);
}

TEST(ChartLayout, LeavesThePlotInsideOfTheChart) {
  for (const double width : {250.0, 500.0, 1600.0}) {
    for (const double height : {150.0, 300.0, 900.0}) {
      const PageRect where{11.3, 7.7, width, height};
      const PageRect plot = laid_out(error_spec(), where).plot;
      EXPECT_GT(plot.left, where.left + 20.0);
      EXPECT_GT(plot.bottom, where.bottom + 20.0);
      EXPECT_LT(plot.right(), where.right());
      EXPECT_LT(plot.top(), where.top());
      EXPECT_GT(plot.width, 0.6 * width);
      EXPECT_GT(plot.height, 0.5 * height);
    }
  }
}

TEST(ChartLayout, HasCornersOnWholePixels) {
  const PageRect plot = laid_out(error_spec(), {10.4, 20.6, 333.3, 222.2}).plot;
  for (const double side : {plot.left, plot.bottom, plot.width, plot.height}) {
    EXPECT_EQ(side, std::round(side));
  }
}

TEST(ChartLayout, HasMoreTicksWhereThereIsMoreRoom) {
  const ChartLayout narrow = laid_out(error_spec(), {0.0, 0.0, 250.0, 100.0});
  const ChartLayout wide = laid_out(error_spec(), {0.0, 0.0, 1600.0, 600.0});
  EXPECT_LT(narrow.x_ticks.at.size(), wide.x_ticks.at.size());
  EXPECT_LT(narrow.y_ticks.at.size(), wide.y_ticks.at.size());
  EXPECT_GE(narrow.x_ticks.at.size(), 3U);
  EXPECT_LE(wide.x_ticks.at.size(), 8U);
}

TEST(ChartLayout, LabelsDoNotTouchAtAnySize) {
  const ChartType type(theme(ThemeName::kLight), kPxPerPt, false);
  for (const double scale : {1e-7, 0.01, 1.0, 1e3, 1e8}) {
    for (double width = 120.0; width < 900.0; width += 37.0) {
      ChartSpec spec = error_spec();
      for (double& x : spec.lines[0].x) x *= scale;
      for (double& y : spec.lines[0].y) y *= scale;
      const ChartLayout layout = laid_out(spec, {0.0, 0.0, width, width / 2.0});
      double last_end = -1e9;
      for (std::size_t i = 0; i < layout.x_ticks.at.size(); ++i) {
        const double half = measure_text(layout.x_ticks.labels[i], type.x_label).width / 2.0;
        const double centre =
            (layout.x_ticks.at[i] - layout.x.low) / layout.x.span() * layout.plot.width;
        EXPECT_GT(centre - half, last_end) << width << " " << scale;
        last_end = centre + half;
      }
    }
  }
}

TEST(ChartLayout, OfAStripKeepsTwoNumbersForAScale) {
  ChartSpec spec = error_spec();
  spec.lines[0].y = {-2.2, 2.2};
  EXPECT_GE(laid_out(spec, {0.0, 0.0, 800.0, 80.0}).y_ticks.at.size(), 2U);
}

TEST(ChartLayout, NeedsMoreRoomOnTheLeftForLongerLabels) {
  ChartSpec wide = error_spec();
  wide.lines[0].y = {0.0, 42'000.0};
  const PageRect where{0.0, 0.0, 500.0, 300.0};
  EXPECT_GT(laid_out(wide, where).plot.left, laid_out(error_spec(), where).plot.left + 10.0);
}

TEST(ChartLayout, HasTheLeftMarginThatIsAskedFor) {
  ChartSpec spec = error_spec();
  spec.left_margin_px = 123.0;
  EXPECT_EQ(laid_out(spec, {10.0, 0.0, 500.0, 300.0}).plot.left, 133.0);
}

TEST(ChartLayout, WithoutTitlesHasMoreRoom) {
  ChartSpec bare = error_spec();
  bare.x.title.clear();
  bare.y.title.clear();
  const PageRect where{0.0, 0.0, 500.0, 300.0};
  const ChartLayout layout = laid_out(bare, where);
  EXPECT_TRUE(layout.x_title.empty());
  EXPECT_LT(layout.plot.left, laid_out(error_spec(), where).plot.left);
  EXPECT_LT(layout.plot.bottom, laid_out(error_spec(), where).plot.bottom);
}

TEST(ChartLayout, BreaksTitlesThatAreTooLongForTheirAxis) {
  EXPECT_THAT(laid_out(error_spec(), {0.0, 0.0, 500.0, 300.0}).y_title,
              ElementsAre("position error [m]"));
  const ChartLayout low = laid_out(error_spec(), {0.0, 0.0, 500.0, 130.0});
  EXPECT_GT(low.y_title.size(), 1U);
  for (const std::string& line : low.y_title) {
    EXPECT_LE(measure_text(line, low.y_title_style).width, low.plot.height) << line;
  }
}

TEST(ChartLayout, LeavesOutATitleWithoutUnitThatIsLongerThanItsAxisInsteadOfShrinkingIt) {
  ChartSpec spec = error_spec();
  spec.y.title = "Mahalanobis-distance";
  const ChartLayout layout = laid_out(spec, {0.0, 0.0, 500.0, 130.0});
  EXPECT_THAT(layout.y_title, IsEmpty());
  EXPECT_THAT(layout.x_title, ElementsAre("time [s]"));
  EXPECT_THAT(laid_out(spec, {0.0, 0.0, 500.0, 300.0}).y_title, ElementsAre(spec.y.title));
}

TEST(ChartLayout, NamesGroupsBelowTheirBars) {
  const ChartLayout layout = laid_out(bars_spec({"easy", "medium", "hard"}), {0, 0, 500, 300});
  EXPECT_THAT(layout.x_ticks.at, ElementsAre(0.0, 1.0, 2.0));
  EXPECT_THAT(layout.x_ticks.labels, ElementsAre("easy", "medium", "hard"));
  EXPECT_EQ(layout.x_label_style.face, FontFace::kText);
}

TEST(ChartLayout, BreaksNamesOfGroupsAtSpaces) {
  const ChartLayout layout =
      laid_out(bars_spec({"proving ground in the morning", "b", "c"}), {0, 0, 400, 300});
  EXPECT_THAT(layout.x_ticks.labels[0], HasSubstr("\n"));
  const ChartLayout single = laid_out(bars_spec({"a", "b", "c"}), {0, 0, 400, 300});
  EXPECT_GT(layout.plot.bottom, single.plot.bottom);
}

TEST(ChartLayout, CutsNamesOfGroupsThatAreTooLong) {
  const ChartLayout cut =
      laid_out(bars_spec({"überaus-langer-name-eines-versuchs", "b", "c"}), {0, 0, 200, 200});
  EXPECT_THAT(cut.x_ticks.labels[0], EndsWith("…"));
  EXPECT_LE(measure_text(cut.x_ticks.labels[0], cut.x_label_style).width, cut.plot.width / 3.0);
}

TEST(ChartLayout, OfALogarithmicAxisBeginsAtZero) {
  ChartSpec spec = bars_spec({"a", "b", "c"});
  spec.bars->is_logarithmic = true;
  spec.bars->series[0].heights = {0.02, 3.0, 40.0};
  const ChartLayout layout = laid_out(spec, {0, 0, 500, 300});
  EXPECT_EQ(layout.y.low, 0.0);
  EXPECT_DOUBLE_EQ(layout.scale.log10_at_low, -2.0);
  EXPECT_THAT(layout.y_ticks.labels, ElementsAre("0.01", "0.1", "1", "10", "100"));
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(layout.y_ticks.at[i], static_cast<double>(i), 1e-9);
  }
}

TEST(ChartLayout, IsOnlyAFrameWhereThereIsRoomForNothingElse) {
  for (const auto& [width, height] :
       {std::pair(-3.0, 50.0), {0.0, 10.0}, {1.0, 1.0}, {31.0, 400.0}, {400.0, 31.0}}) {
    const ChartLayout layout = laid_out(error_spec(), {0.0, 0.0, width, height});
    EXPECT_TRUE(layout.is_only_frame) << width << " x " << height;
    EXPECT_GT(layout.plot.width, 0.0);
    EXPECT_GT(layout.plot.height, 0.0);
    EXPECT_THAT(layout.x_ticks.at, IsEmpty());
    EXPECT_THAT(layout.y_title, IsEmpty());
  }
  EXPECT_FALSE(laid_out(error_spec(), {0.0, 0.0, 33.0, 33.0}).is_only_frame);
}

TEST(ChartLayout, GivesThePlotAboutHalfOfTheChartAtLeast) {
  for (double width = 33.0; width < 700.0; width *= 1.2) {
    for (double height = 33.0; height < 700.0; height *= 1.2) {
      const PageRect plot = laid_out(error_spec(), {3.5, 4.5, width, height}).plot;
      EXPECT_GE(plot.width, 0.5 * width - 2.0) << width << " x " << height;
      EXPECT_GE(plot.height, 0.45 * height - 2.0) << width << " x " << height;
      EXPECT_LE(plot.right(), 3.5 + width);
      EXPECT_LE(plot.top(), 4.5 + height);
    }
  }
}

TEST(ChartType, HasTheSizesOfPaper) {
  const ChartType type(theme(ThemeName::kLight), 300.0 / 72.0, false);
  EXPECT_EQ(type.x_label.size_px, 33.0);  // 8 points
  EXPECT_EQ(type.title.size_px, 38.0);    // 9 points
  EXPECT_EQ(type.x_label.face, FontFace::kNumbers);
  EXPECT_EQ(type.title.face, FontFace::kText);
  EXPECT_FALSE(type.title.is_bold);
}

}  // namespace chart_layout_test
}  // namespace nadir
