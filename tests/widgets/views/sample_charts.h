// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "tests/widgets/views/drawn_chart.h"
#include "widgets/canvas/cairo_canvas.h"

namespace nadir {

/// Charts that several tests draw, and the page that they draw them on.
inline constexpr double kPxPerPt = 96.0 / 72.0;
inline constexpr int kPageWidth = 500;
inline constexpr int kPageHeight = 300;
inline constexpr PageRect kChartRoom{10.0, 10.0, 480.0, 280.0};

inline const Theme& light_theme() { return theme(ThemeName::kLight); }

/// An error over time with its band.
inline ChartSpec sample_chart() {
  ChartSpec spec;
  spec.x.title = "time [s]";
  spec.y.title = "east error [m]";
  spec.lines.push_back(line_through(101, 1.0, [](double x) { return std::sin(x / 8.0); }));
  spec.bands.push_back({.name = "band", .colour = kPaleBlue});
  for (const double x : spec.lines[0].x) {
    spec.bands[0].x.push_back(x);
    spec.bands[0].low.push_back(std::sin(x / 8.0) - 0.5);
    spec.bands[0].high.push_back(std::sin(x / 8.0) + 0.5);
  }
  return spec;
}

/// Two series of three groups.
inline ChartSpec sample_bars() {
  ChartSpec spec;
  spec.y.title = "MSE [m²]";
  spec.bars =
      BarsSpec{{"easy", "medium", "hard"},
               {{"odometry", {4.0, 9.0, 14.0}, kOrange}, {"estimate", {0.5, 1.0, 2.0}, kLineBlue}},
               false};
  return spec;
}

inline RecordingCanvas drawn(const XyChart& chart, const PageRect& where = kChartRoom) {
  RecordingCanvas canvas;
  chart.draw(canvas, where, kPageWidth, kPageHeight);
  return canvas;
}

inline RecordingCanvas drawn(const ChartSpec& spec, const PageRect& where = kChartRoom) {
  return drawn(XyChart(spec, light_theme(), kPxPerPt), where);
}

inline Raster<Rgba> pixels_of(const XyChart& chart, const Theme& colours = light_theme()) {
  const auto canvas = CairoCanvas::for_pixels(kPageWidth, kPageHeight, colours.page);
  chart.draw(*canvas, kChartRoom, kPageWidth, kPageHeight);
  return canvas->pixels();
}

inline Raster<Rgba> pixels_of(const ChartSpec& spec) {
  return pixels_of(XyChart(spec, light_theme(), kPxPerPt));
}

/// The lowest and the highest corner of an outline.
inline Eigen::AlignedBox2d box_of(const std::vector<Eigen::Vector2d>& outline) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& point : outline) box.extend(point);
  return box;
}

}  // namespace nadir
