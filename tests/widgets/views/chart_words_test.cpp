// SPDX-License-Identifier: Apache-2.0
// What a chart writes, at every size from nothing to a poster.
#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "tests/widgets/views/sample_charts.h"
#include "widgets/canvas/svg_canvas.h"

namespace nadir {
namespace chart_words_test {

using testing::Contains;
using testing::Ge;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

RecordingCanvas drawn_at(const ChartSpec& spec, const PageRect& where, double px_per_pt) {
  RecordingCanvas canvas;
  XyChart(spec, light_theme(), px_per_pt).draw(canvas, where, 2000, 2000);
  return canvas;
}

std::vector<std::string> lines_of(const RecordingCanvas& canvas) {
  std::vector<std::string> lines;
  for (const auto& text : canvas.texts) lines.push_back(text.line);
  return lines;
}

void expect_texts_inside_and_apart(const RecordingCanvas& canvas, const PageRect& where) {
  const auto& texts = canvas.texts;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const Eigen::AlignedBox2d box = texts[i].box();
    EXPECT_GE(box.min().x(), where.left - 0.6) << texts[i].line;
    EXPECT_GE(box.min().y(), where.bottom - 0.6) << texts[i].line;
    EXPECT_LE(box.max().x(), where.right() + 0.6) << texts[i].line;
    EXPECT_LE(box.max().y(), where.top() + 0.6) << texts[i].line;
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_TRUE(box.intersection(texts[j].box()).isEmpty())
          << texts[i].line << " over " << texts[j].line;
    }
  }
}

/// Of every kind: short and long numbers, powers of ten, long names, an axis of shares.
std::vector<ChartSpec> many_charts() {
  ChartSpec wide = sample_chart();
  for (double& y : wide.lines[0].y) y *= 3e7;
  ChartSpec tiny = sample_chart();
  tiny.bands.clear();
  for (double& x : tiny.lines[0].x) x *= 1e-9;
  for (double& y : tiny.lines[0].y) y *= 1e-9;
  ChartSpec logarithmic = sample_bars();
  logarithmic.bars->is_logarithmic = true;
  logarithmic.bars->groups[1] = "a long name of a trial";
  logarithmic.bars->series[0].heights[2] = 3e-7;
  ChartSpec crowded;
  crowded.y.title = "orientation MSE [rad²]";
  crowded.bars = BarsSpec{{}, {{"estimate", {}, kLineBlue}}, false};
  for (int i = 0; i < 40; ++i) {
    crowded.bars->groups.push_back("trial-number-" + std::to_string(i));
    crowded.bars->series[0].heights.push_back(1.0 + i);
  }
  ChartSpec share = sample_chart();
  share.x = {"probability of the ellipse", -0.02, 1.02};
  share.y = {"share of truth inside", -0.02, 1.02};
  return {sample_chart(), wide, tiny, sample_bars(), logarithmic, crowded, share};
}

TEST(XyChart, WritesNumbersAndTitlesInTheirFaces) {
  int titles = 0;
  for (const auto& text : drawn(sample_chart()).texts) {
    const bool is_title = text.line.find('[') != std::string::npos;
    EXPECT_EQ(text.style.face, is_title ? FontFace::kText : FontFace::kNumbers) << text.line;
    EXPECT_EQ(text.style.size_px, is_title ? 12.0 : 11.0) << text.line;
    EXPECT_FALSE(text.style.is_bold);
    titles += is_title ? 1 : 0;
  }
  EXPECT_EQ(titles, 2);
}

TEST(ChartWords, StayInTheirRoomAndApartAtEverySizeOfAPage) {
  const std::vector<ChartSpec> charts = many_charts();
  for (std::size_t i = 0; i < charts.size(); ++i) {
    for (double width = 200.0; width <= 1600.0; width += 140.0) {
      for (const double shape : {0.12, 0.3, 0.6, 1.0}) {
        const PageRect where{5.0, 7.0, width, shape * width};
        SCOPED_TRACE(testing::Message()
                     << "chart " << i << " of " << width << " x " << where.height);
        const RecordingCanvas canvas = drawn_at(charts[i], where, kPxPerPt);
        expect_texts_inside_and_apart(canvas, where);
        if (where.height > 60.0) {
          EXPECT_THAT(canvas.texts, SizeIs(Ge(3U)));
        }
      }
    }
  }
}

TEST(ChartWords, StayInTheirRoomAndApartInPanelsOfSmallPages) {
  const std::vector<ChartSpec> charts = many_charts();
  for (std::size_t i = 0; i < charts.size(); ++i) {
    for (double width = 1.0; width < 200.0; width += 13.0) {
      for (double height = 1.0; height < 200.0; height += 17.0) {
        const PageRect where{5.0, 7.0, width, height};
        SCOPED_TRACE(testing::Message() << "chart " << i << " of " << width << " x " << height);
        expect_texts_inside_and_apart(drawn_at(charts[i], where, kPxPerPt), where);
      }
    }
  }
}

TEST(ChartWords, GiveWayInTurnTitlesFirstThenNumbers) {
  const auto texts = [](double width, double height) {
    return lines_of(drawn_at(sample_chart(), {0.0, 0.0, width, height}, kPxPerPt));
  };
  EXPECT_THAT(texts(300, 200), Contains("east error [m]"));
  EXPECT_THAT(texts(300, 200), Contains("time [s]"));
  const auto narrow = texts(64, 200);
  EXPECT_THAT(narrow, testing::Not(Contains(HasSubstr("[m]"))));
  EXPECT_THAT(narrow, SizeIs(Ge(3U)));
  EXPECT_THAT(texts(300, 40), testing::Not(Contains("time [s]")));
  EXPECT_THAT(texts(33, 33), SizeIs(testing::Le(2U)));
}

TEST(ChartWords, HaveTheSameSizesWhateverTheRoom) {
  std::set<double> sizes;
  for (const ChartSpec& spec : many_charts()) {
    for (const double side : {40.0, 90.0, 150.0, 400.0, 1200.0}) {
      for (const auto& text : drawn_at(spec, {0.0, 0.0, side, 0.5 * side}, kPxPerPt).texts) {
        sizes.insert(text.style.size_px);
      }
    }
  }
  EXPECT_THAT(sizes, testing::ElementsAre(11.0, 12.0));  // 8 and 9 points
}

TEST(SmallChart, IsAFrameAndNothingElse) {
  ChartSpec spec = sample_chart();
  spec.marked_x = 5.0;
  for (const auto& [width, height] : {std::pair(31.0, 300.0), {300.0, 31.0}, {10.0, 10.0}}) {
    const PageRect where{4.0, 6.0, width, height};
    const RecordingCanvas canvas = drawn(spec, where);
    EXPECT_THAT(canvas.texts, IsEmpty());
    EXPECT_THAT(canvas.fills, IsEmpty());
    ASSERT_THAT(canvas.strokes, SizeIs(1));
    const Eigen::AlignedBox2d frame = box_of(canvas.strokes[0].points);
    EXPECT_NEAR(frame.min().x(), where.left, 1.0);
    EXPECT_NEAR(frame.min().y(), where.bottom, 1.0);
    EXPECT_NEAR(frame.max().x(), where.right(), 1.0);
    EXPECT_NEAR(frame.max().y(), where.top(), 1.0);
    EXPECT_EQ(canvas.strokes[0].style.colour, light_theme().line);
  }
}

TEST(SmallChart, OfNoSizeDrawsNothingAndNeedsNothing) {
  for (const auto& [width, height] :
       {std::pair(0.0, 100.0), {100.0, 0.0}, {-5.0, 100.0}, {0.5, 0.5}}) {
    const PageRect where{4.0, 6.0, width, height};
    XyChart chart(sample_chart(), light_theme(), kPxPerPt);
    const RecordingCanvas canvas = drawn(chart, where);
    EXPECT_THAT(canvas.strokes, IsEmpty());
    EXPECT_THAT(canvas.texts, IsEmpty());
    EXPECT_EQ(chart.needed_left_margin_px(where), 0.0);
    chart.mark_x(3.0);
    EXPECT_THAT(drawn(chart), testing::Field(&RecordingCanvas::strokes, SizeIs(Ge(4U))));
  }
}

TEST(SmallChart, ShowsItsDataAsSoonAsItIsMoreThanAFrame) {
  for (const double side : {33.0, 40.0, 60.0}) {
    const PageRect where{4.0, 6.0, side, side};
    const RecordingCanvas canvas = drawn(sample_chart(), where);
    ASSERT_THAT(canvas.strokes_in(kLineBlue), SizeIs(1)) << side;
    const XyChart chart(sample_chart(), light_theme(), kPxPerPt);
    EXPECT_GE(chart.plot_area(where).width, 0.5 * side);
    EXPECT_GE(chart.plot_area(where).height, 0.45 * side);
  }
}

// JetBrains Mono, the face of numbers, has no U+207B.
TEST(ChartWords, WritePowersBelowOneInAFaceThatHasTheirMinus) {
  ChartSpec spec = sample_bars();
  spec.bars->is_logarithmic = true;
  spec.bars->series[0].heights = {3e-7, 2e-6, 5e-5};
  spec.bars->series[1].heights = {1e-6, 2e-7, 4e-6};
  int powers = 0;
  for (const auto& text : drawn(spec).texts) {
    if (text.line.find("10⁻") == std::string::npos) continue;
    ++powers;
    EXPECT_EQ(text.style.face, FontFace::kText) << text.line;
  }
  EXPECT_GE(powers, 2);
  SvgCanvas svg(kPageWidth, kPageHeight, 96.0, "chart", "");
  XyChart(spec, light_theme(), kPxPerPt).draw(svg, kChartRoom, kPageWidth, kPageHeight);
  EXPECT_THAT(svg.finish(), HasSubstr("10⁻⁷"));
}

TEST(XyChart, AlignsStackedChartsByACommonMargin) {
  ChartSpec upper = sample_chart();
  ChartSpec lower = sample_chart();
  for (double& y : lower.lines[0].y) y *= 1000.0;
  const auto margin = [](const ChartSpec& spec) {
    return XyChart(spec, light_theme(), kPxPerPt).needed_left_margin_px(kChartRoom);
  };
  EXPECT_LT(margin(upper), margin(lower));
  const double common = margin(lower);
  upper.left_margin_px = common;
  lower.left_margin_px = common;
  EXPECT_EQ(margin(upper), margin(sample_chart()));  // what it would need itself
  const auto plot = [](const ChartSpec& spec) {
    return XyChart(spec, light_theme(), kPxPerPt).plot_area(kChartRoom);
  };
  EXPECT_EQ(plot(upper).left, plot(lower).left);
  EXPECT_EQ(plot(upper).left, kChartRoom.left + common + 0.5);
  EXPECT_EQ(plot(upper).width, plot(lower).width);
}

TEST(ChartWords, LeaveOutWhatACommonMarginHasNoRoomFor) {
  ChartSpec spec = sample_chart();
  for (const double margin : {3.0, 20.0, 45.0}) {
    spec.left_margin_px = margin;
    const PageRect where{5.0, 7.0, 300.0, 200.0};
    const RecordingCanvas canvas = drawn(spec, where);
    expect_texts_inside_and_apart(canvas, where);
    EXPECT_NEAR(XyChart(spec, light_theme(), kPxPerPt).plot_area(where).left, 5.0 + margin, 1.0);
  }
}

TEST(ChartWords, DoNotFollowAMarginThatLeavesNoPlot) {
  ChartSpec spec = sample_chart();
  spec.left_margin_px = 290.0;
  const PageRect where{5.0, 7.0, 300.0, 200.0};
  EXPECT_GE(XyChart(spec, light_theme(), kPxPerPt).plot_area(where).width, 150.0);
  expect_texts_inside_and_apart(drawn(spec, where), where);
}

}  // namespace chart_words_test
}  // namespace nadir
