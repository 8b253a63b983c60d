// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/chart_panel.h"

#include <gmock/gmock.h>
#include <vtkChartXY.h>
#include <vtkPlot.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "tests/widgets/views/drawn_chart.h"
#include "widgets/figures/page_layout.h"

namespace nadir {
namespace chart_panel_test {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

PageFormat page(int width, int height) {
  PageFormat format;
  format.width = width;
  format.height = height;
  format.dpi = 96.0;
  return format;
}

CaptionedChart captioned(const std::string& caption, double scale) {
  ChartSpec spec;
  spec.x.title = "time [s]";
  spec.y.title = "orientation error [deg]";
  spec.lines.push_back(line_through(50, 1.0, [scale](double x) { return scale * x; }));
  return {caption, spec};
}

std::vector<CaptionedChart> four_charts() {
  return {captioned("(a) east", 1.0), captioned("(b) north", 1e5), captioned("(c) yaw", 1e-3),
          captioned("(d) distance", 20.0)};
}

std::vector<std::string> texts_of(const RecordingCanvas& canvas) {
  std::vector<std::string> lines;
  for (const auto& text : canvas.texts) lines.push_back(text.line);
  return lines;
}

void expect_apart(const RecordingCanvas& canvas) {
  for (std::size_t i = 0; i < canvas.texts.size(); ++i) {
    const Eigen::AlignedBox2d box = canvas.texts[i].box();
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_TRUE(box.intersection(canvas.texts[j].box()).isEmpty())
          << canvas.texts[i].line << " over " << canvas.texts[j].line;
    }
  }
}

TEST(ChartGrid, DrawsCaptionsAndChartsOfAllPanels) {
  const PageFormat format = page(900, 600);
  ChartGrid grid(four_charts(), 2);
  RecordingCanvas canvas;
  grid.draw(canvas, format, page_inside(format));
  for (const char* caption : {"(a) east", "(b) north", "(c) yaw", "(d) distance"}) {
    EXPECT_THAT(texts_of(canvas), Contains(caption));
  }
  EXPECT_THAT(canvas.strokes_in(kLineBlue), SizeIs(4));
}

TEST(ChartGrid, KeepsItsTextsApartOnPagesOfAllSizes) {
  for (const int width : {200, 260, 320, 420, 600, 900, 1600}) {
    for (const double aspect : {0.6, 1.0, 2.2, 5.0}) {
      const PageFormat format = page(width, static_cast<int>(width / aspect));
      SCOPED_TRACE(testing::Message() << width << " x " << format.height);
      for (const std::size_t columns_wanted : {1U, 2U, 4U}) {
        RecordingCanvas canvas;
        draw_charts(canvas, format, page_inside(format), four_charts(), columns_wanted);
        expect_apart(canvas);
        EXPECT_THAT(canvas.strokes, Not(IsEmpty()));
      }
    }
  }
}

TEST(ChartGrid, WritesAllTitlesInOneSize) {
  for (const int width : {260, 420, 1600}) {
    const PageFormat format = page(width, width * 3 / 4);
    RecordingCanvas canvas;
    std::vector<CaptionedChart> charts = four_charts();
    for (CaptionedChart& chart : charts) chart.caption.clear();
    charts[1].chart.y.title = "NEES";
    draw_charts(canvas, format, page_inside(format), charts, 2);
    for (const auto& text : canvas.texts) {
      const bool is_title = std::any_of(text.line.begin(), text.line.end(), [](char letter) {
        return std::isalpha(static_cast<unsigned char>(letter)) != 0;
      });
      EXPECT_EQ(text.style.size_px, is_title ? 12.0 : 11.0) << text.line;
    }
  }
}

TEST(ChartGrid, TakesFewerColumnsOnANarrowPage) {
  const auto columns_on = [](int width, int height) {
    const PageFormat format = page(width, height);
    ChartGrid grid(four_charts(), 2);
    RecordingCanvas canvas;
    grid.draw(canvas, format, page_inside(format));
    std::set<int> lefts;
    for (const auto& line : canvas.strokes_in(kLineBlue)) {
      lefts.insert(static_cast<int>(line.points.front().x()));
    }
    return lefts.size();
  };
  EXPECT_EQ(columns_on(900, 600), 2U);
  EXPECT_EQ(columns_on(220, 900), 1U);
  EXPECT_EQ(columns_on(300, 120), 2U);  // below each other they would be strips
}

TEST(ChartGrid, LeavesOutTheLastRowsOfAVeryLowPage) {
  const auto shown_on = [](int height) {
    const PageFormat format = page(400, height);
    ChartGrid grid(four_charts(), 1);
    RecordingCanvas canvas;
    grid.draw(canvas, format, page_inside(format));
    return grid.charts().size();
  };
  EXPECT_EQ(shown_on(600), 4U);
  EXPECT_EQ(shown_on(120), 2U);
  EXPECT_EQ(shown_on(20), 1U);
}

TEST(ChartGrid, BeginsChartsAboveEachOtherAtOnePlace) {
  const PageFormat format = page(900, 900);
  ChartGrid grid(four_charts(), 1);
  RecordingCanvas canvas;
  grid.draw(canvas, format, page_inside(format));
  const auto lines = canvas.strokes_in(kLineBlue);
  ASSERT_THAT(lines, SizeIs(4));
  for (const auto& line : lines) {
    EXPECT_NEAR(line.points.front().x(), lines[0].points.front().x(), 0.01);
  }
}

// What a film needs: nothing is made anew from one frame to the next.
TEST(ChartGrid, IsKeptBetweenFrames) {
  const PageFormat format = page(900, 600);
  ChartGrid grid(four_charts(), 2);
  const auto draw = [&] {
    RecordingCanvas canvas;
    grid.draw(canvas, format, page_inside(format));
    return canvas;
  };
  const RecordingCanvas unmarked = draw();
  std::vector<vtkPlot*> plots;
  std::vector<vtkMTimeType> changed;
  for (XyChart& chart : grid.charts()) {
    plots.push_back(chart.chart().GetPlot(0));
    changed.push_back(plots.back()->GetMTime());
  }
  for (const double moment : {3.0, 4.0, 48.0}) {
    grid.mark_x(moment);
    const RecordingCanvas frame = draw();
    EXPECT_THAT(frame.strokes_in(format.colours().text), SizeIs(4));
    EXPECT_EQ(frame.strokes_in(kLineBlue)[2].points, unmarked.strokes_in(kLineBlue)[2].points);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(grid.charts()[i].chart().GetPlot(0), plots[i]);
      EXPECT_EQ(plots[i]->GetMTime(), changed[i]);
    }
  }
  grid.mark_x(std::nullopt);
  EXPECT_THAT(draw().strokes_in(format.colours().text), IsEmpty());
}

TEST(ChartGrid, MarksAlsoWhatIsDrawnOnAnotherPageLater) {
  ChartGrid grid(four_charts(), 2);
  grid.mark_x(7.0);
  for (const PageFormat& format : {page(900, 600), page(700, 500)}) {
    RecordingCanvas canvas;
    grid.draw(canvas, format, page_inside(format));
    EXPECT_THAT(canvas.strokes_in(format.colours().text), SizeIs(4));
  }
}

TEST(ChartGrid, TakesTheColoursOfThePage) {
  ChartGrid grid(four_charts(), 2);
  PageFormat format = page(900, 600);
  for (const ThemeName name : {ThemeName::kLight, ThemeName::kDark}) {
    format.theme = name;
    RecordingCanvas canvas;
    grid.draw(canvas, format, page_inside(format));
    EXPECT_THAT(canvas.strokes_in(theme(name).line), Not(IsEmpty()));
  }
}

TEST(ChartGrid, ListsEachNameOnce) {
  const ChartGrid grid(four_charts(), 2);
  EXPECT_THAT(grid.legend(), ElementsAre(LegendEntry{"line", kLineBlue, LegendEntry::Kind::kLine}));
}

TEST(ChartGrid, DrawsNothingOfNoCharts) {
  const PageFormat format = page(300, 200);
  RecordingCanvas canvas;
  draw_charts(canvas, format, page_inside(format), {}, 2);
  EXPECT_THAT(canvas.strokes, IsEmpty());
}

}  // namespace chart_panel_test
}  // namespace nadir
