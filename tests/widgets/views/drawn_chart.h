// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <Eigen/Geometry>
#include <numbers>
#include <string>
#include <vector>

#include "widgets/views/xy_chart.h"

namespace nadir {

/// Keeps what was drawn as data.
class RecordingCanvas : public Canvas {
 public:
  struct Stroke {
    std::vector<Eigen::Vector2d> points;
    StrokeStyle style;
    std::vector<PageRect> clips;
  };
  struct Fill {
    std::vector<Eigen::Vector2d> outline;
    Rgba colour;
    std::vector<PageRect> clips;
  };
  struct Text {
    Eigen::Vector2d point;
    std::string line;
    TextStyle style;
    /// What the letters cover on the page.
    [[nodiscard]] Eigen::AlignedBox2d box() const {
      const TextExtent extent = measure_text(line, style);
      double left = 0.0;
      if (style.align == TextAlign::kCentre) left = -extent.width / 2.0;
      if (style.align == TextAlign::kRight) left = -extent.width;
      Eigen::AlignedBox2d covered;
      const Eigen::Rotation2Dd turned(style.rotation_deg * std::numbers::pi / 180.0);
      for (const double x : {left, left + extent.width}) {
        for (const double y : {-extent.descent, extent.cap_height}) {
          covered.extend(point + turned * Eigen::Vector2d(x, y));
        }
      }
      return covered;
    }
  };

  void stroke(std::span<const Eigen::Vector2d> points, const StrokeStyle& style) override {
    strokes.push_back({{points.begin(), points.end()}, style, clips_});
  }
  void fill(std::span<const Eigen::Vector2d> outline, Rgba colour) override {
    fills.push_back({{outline.begin(), outline.end()}, colour, clips_});
  }
  void text(const Eigen::Vector2d& point,
            const std::string& line,
            const TextStyle& style) override {
    texts.push_back({point, line, style});
  }
  void image(const PageRect& /*where*/, const Raster<Rgba>& /*pixels*/) override {}
  void push_clip(const PageRect& inside) override { clips_.push_back(inside); }
  void pop_clip() override { clips_.pop_back(); }

  /// Those of one colour, in the order of drawing.
  [[nodiscard]] std::vector<Stroke> strokes_in(Rgba colour) const {
    std::vector<Stroke> chosen;
    for (const Stroke& stroke : strokes) {
      if (stroke.style.colour == colour) chosen.push_back(stroke);
    }
    return chosen;
  }
  [[nodiscard]] std::vector<Fill> fills_in(Rgba colour) const {
    std::vector<Fill> chosen;
    for (const Fill& fill : fills) {
      if (fill.colour == colour) chosen.push_back(fill);
    }
    return chosen;
  }

  std::vector<Stroke> strokes;
  std::vector<Fill> fills;
  std::vector<Text> texts;

 private:
  std::vector<PageRect> clips_;
};

/// Hears whatever VTK says while it lives.
class VtkWords {
 public:
  VtkWords() {
    vtkOutputWindow::SetInstance(ear_);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  }
  ~VtkWords() {
    vtkOutputWindow::SetInstance(nullptr);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_INFO);
  }
  VtkWords(const VtkWords&) = delete;
  VtkWords& operator=(const VtkWords&) = delete;
  [[nodiscard]] const std::string& said() const { return ear_->said; }

 private:
  class Ear : public vtkOutputWindow {
   public:
    static Ear* New() { VTK_STANDARD_NEW_BODY(Ear); }
    void DisplayText(const char* text) override { said += text; }
    std::string said;
  };
  vtkNew<Ear> ear_;
};

inline constexpr Rgba kLineBlue{0, 114, 178, 255};
inline constexpr Rgba kOrange{230, 159, 0, 255};
inline constexpr Rgba kPaleBlue{0, 114, 178, 50};

/// One line of n points, `step` apart in x.
template <typename Function>
LineSpec line_through(std::size_t n, double step, Function y) {
  LineSpec line{.name = "line", .colour = kLineBlue};
  for (std::size_t i = 0; i < n; ++i) {
    line.x.push_back(step * static_cast<double>(i));
    line.y.push_back(y(line.x.back()));
  }
  return line;
}

}  // namespace nadir
