// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkFloatArray.h>
#include <vtkPlot.h>
#include <vtkTable.h>

#include <functional>

#include "tests/widgets/canvas/device_page.h"
#include "tests/widgets/canvas/xml_reading.h"
#include "widgets/canvas/svg_canvas.h"

namespace nadir {
namespace chart_test {

using testing::Contains;
using testing::HasSubstr;

/// Steps of a line from (0, 0) over (5, 10) to (10, 0), drawn by VTK's own chart.
struct Chart {
  Chart() {
    vtkNew<vtkFloatArray> x;
    x->SetName("time");
    vtkNew<vtkFloatArray> y;
    y->SetName("error");
    for (int i = 0; i <= 10; ++i) {
      x->InsertNextValue(static_cast<float>(i));
      y->InsertNextValue(static_cast<float>(i <= 5 ? 2 * i : 20 - 2 * i));
    }
    table->AddColumn(x);
    table->AddColumn(y);
    vtkPlot* const plot = chart->AddPlot(vtkChart::LINE);
    plot->SetInputData(table, 0, 1);
    plot->SetColor(0, 114, 178, 255);
    plot->SetWidth(4.0F);
    chart->GetAxis(vtkAxis::BOTTOM)->SetTitle("time, s");
    chart->GetAxis(vtkAxis::LEFT)->SetTitle("error, m");
    scene->AddItem(chart);
    scene->SetGeometry(400, 300);
  }

  /// On a device that draws on a page of 400 x 300 pixels.
  void paint(CanvasDevice& device) const {
    const vtkNew<vtkContext2D> painter;
    painter->Begin(&device);
    scene->Paint(painter);
    painter->End();
  }
  [[nodiscard]] Raster<Rgba> pixels() const {
    const auto canvas = CairoCanvas::for_pixels(400, 300, kWhite);
    const vtkNew<CanvasDevice> device;
    device->draw_on(*canvas, 400, 300);
    paint(*device);
    return canvas->pixels();
  }

  vtkNew<vtkTable> table;
  vtkNew<vtkChartXY> chart;
  vtkNew<vtkContextScene> scene;
};

constexpr Rgba kLine{0, 114, 178};

TEST(Chart, DrawnTwiceHasTheSamePixels) {
  const Chart chart;
  const Raster<Rgba> first = chart.pixels();
  EXPECT_THAT(first.values(), Contains(kLine));
  EXPECT_EQ(chart.pixels(), first);
  EXPECT_EQ(Chart().pixels(), first);
}

TEST(Chart, DrawsItsLineInsideItsAxes) {
  const Chart chart;
  const Raster<Rgba> pixels = chart.pixels();
  int left = 400;
  int right = 0;
  int highest = 300;
  int highest_column = 0;
  for (int row = 0; row < 300; ++row) {
    for (int column = 0; column < 400; ++column) {
      if (pixels.at(column, row) != kLine) continue;
      left = std::min(left, column);
      right = std::max(right, column);
      if (row < highest) highest_column = column;
      highest = std::min(highest, row);
    }
  }
  const float* const origin = chart.chart->GetAxis(vtkAxis::BOTTOM)->GetPoint1();
  const float* const end = chart.chart->GetAxis(vtkAxis::BOTTOM)->GetPoint2();
  EXPECT_NEAR(left, origin[0], 4.0);
  EXPECT_NEAR(right, end[0], 4.0);
  EXPECT_NEAR(highest_column, (origin[0] + end[0]) / 2.0, 3.0);  // the peak at 5 s of 10 s
}

TEST(Chart, CutsALineThatLeavesItsAxes) {
  Chart chart;
  vtkAxis* const bottom = chart.chart->GetAxis(vtkAxis::BOTTOM);
  bottom->SetBehavior(vtkAxis::FIXED);
  bottom->SetRange(4.0, 6.0);
  const Raster<Rgba> pixels = chart.pixels();
  const float* const origin = bottom->GetPoint1();
  for (int row = 0; row < 300; ++row) {
    for (int column = 0; column < static_cast<int>(origin[0]) - 2; ++column) {
      ASSERT_NE(pixels.at(column, row), kLine) << column << " " << row;
    }
  }
  EXPECT_THAT(pixels.values(), Contains(kLine));
}

TEST(Chart, KeepsItsWordsAsTextInSvg) {
  const Chart chart;
  const auto draw = [&chart] {
    SvgCanvas canvas(400, 300, 96.0, "chart", "");
    const vtkNew<CanvasDevice> device;
    device->draw_on(canvas, 400, 300);
    chart.paint(*device);
    return canvas.finish();
  };
  const std::string svg = draw();
  EXPECT_EQ(draw(), svg);
  const vtkNew<XmlReading> reading;
  ASSERT_EQ(reading->Parse(svg.c_str(), static_cast<unsigned>(svg.size())), 1);
  std::vector<std::string> words;
  for (const XmlElement& element : reading->named("text")) words.push_back(element.text);
  EXPECT_THAT(words, Contains("time, s"));
  EXPECT_THAT(words, Contains("error, m"));
  EXPECT_THAT(words, Contains("10"));
  EXPECT_THAT(svg, HasSubstr("stroke=\"#0072b2\""));
}

TEST(Chart, HasTheSameLayoutAsPixelsAndAsSvg) {
  const Chart pixels_first;
  (void)pixels_first.pixels();
  const Chart svg_only;
  SvgCanvas canvas(400, 300, 96.0, "chart", "");
  const vtkNew<CanvasDevice> device;
  device->draw_on(canvas, 400, 300);
  svg_only.paint(*device);
  for (const int axis : {vtkAxis::BOTTOM, vtkAxis::LEFT}) {
    for (int i = 0; i < 2; ++i) {
      EXPECT_EQ(pixels_first.chart->GetAxis(axis)->GetPoint1()[i],
                svg_only.chart->GetAxis(axis)->GetPoint1()[i]);
      EXPECT_EQ(pixels_first.chart->GetAxis(axis)->GetPoint2()[i],
                svg_only.chart->GetAxis(axis)->GetPoint2()[i]);
    }
  }
}

}  // namespace chart_test
}  // namespace nadir
