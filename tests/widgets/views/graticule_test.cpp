// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/graticule.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "tests/widgets/views/drawn_chart.h"

namespace nadir {
namespace graticule_test {

constexpr PageRect kMap{60, 40, 400, 300};

const Theme& light() { return theme(ThemeName::kLight); }
ProjectPlane plane() { return ProjectPlane::create({33.45, -83.9}).value(); }

MapFrame frame_of(const Eigen::Vector2d& centre,
                  double metres_per_px,
                  const PageRect& where = kMap,
                  double px_per_pt = 1.5) {
  return {where, {centre, metres_per_px}, px_per_pt};
}

RecordingCanvas drawn_with_names(const MapFrame& frame, Graticule kind) {
  RecordingCanvas canvas;
  draw_graticule(canvas, frame, kind, plane(), light());
  return canvas;
}

bool is_name(const RecordingCanvas::Text& text) { return text.style.align == TextAlign::kLeft; }

/// Ticks and numbers alone.
RecordingCanvas drawn(const MapFrame& frame, Graticule kind) {
  RecordingCanvas canvas = drawn_with_names(frame, kind);
  std::erase_if(canvas.texts, is_name);
  return canvas;
}

/// Names touch neither numbers nor map, and keep inside the margin.
void expect_names_apart(const MapFrame& frame, Graticule kind) {
  const RecordingCanvas canvas = drawn_with_names(frame, kind);
  const Eigen::Vector2d room = graticule_margin_px(kind, frame.px_per_pt);
  const PageRect& map = frame.where;
  for (const auto& name : canvas.texts) {
    if (!is_name(name)) continue;
    const Eigen::AlignedBox2d box = name.box();
    EXPECT_GE(box.min().x(), map.left - room.x() - 1e-6) << name.line;
    EXPECT_LE(box.max().x(), map.left) << name.line;
    EXPECT_GE(box.min().y(), map.bottom - room.y() - 1e-6) << name.line;
    EXPECT_LE(box.max().y(), map.top()) << name.line;
    for (const auto& other : canvas.texts) {
      if (&other == &name) continue;
      Eigen::AlignedBox2d digits = other.box();
      if (!is_name(other)) digits.min().y() += measure_text("0", other.style).descent;
      EXPECT_TRUE(box.intersection(digits).isEmpty()) << name.line << " and " << other.line;
    }
  }
}

/// A number with a true minus and maybe a degree sign.
double number_in(std::string label) {
  const std::string minus = "−";
  if (label.rfind(minus, 0) == 0) label.replace(0, minus.size(), "-");
  return std::stod(label);
}

/// Numbers below the map or beside it.
std::vector<RecordingCanvas::Text> along(const RecordingCanvas& canvas, TextAlign align) {
  std::vector<RecordingCanvas::Text> found;
  for (const auto& text : canvas.texts) {
    if (text.style.align == align) found.push_back(text);
  }
  return found;
}

void expect_labels_apart(const RecordingCanvas& canvas, const MapFrame& frame, Graticule kind) {
  const Eigen::Vector2d room = graticule_margin_px(kind, frame.px_per_pt);
  const PageRect& map = frame.where;
  for (std::size_t i = 0; i < canvas.texts.size(); ++i) {
    const Eigen::AlignedBox2d box = canvas.texts[i].box();
    const bool is_below = canvas.texts[i].style.align == TextAlign::kCentre;
    // Digits have no descent, which box() allows for.
    const double descent = measure_text("0", canvas.texts[i].style).descent;
    const Eigen::AlignedBox2d digits(box.min() + Eigen::Vector2d(0.0, descent), box.max());
    EXPECT_GE(digits.min().x(), is_below ? map.left - 1e-6 : map.left - room.x());
    EXPECT_LE(digits.max().x(), is_below ? map.right() + 1e-6 : map.left);
    EXPECT_GE(digits.min().y(), is_below ? map.bottom - room.y() : map.bottom - 1e-6);
    EXPECT_LE(digits.max().y(), is_below ? map.bottom : map.top() + 1e-6);
    for (std::size_t j = 0; j < i; ++j) {
      const Eigen::AlignedBox2d other = canvas.texts[j].box();
      const Eigen::AlignedBox2d other_digits(other.min() + Eigen::Vector2d(0.0, descent),
                                             other.max());
      EXPECT_TRUE(digits.intersection(other_digits).isEmpty())
          << canvas.texts[i].line << " and " << canvas.texts[j].line;
    }
  }
}

TEST(Graticule, HasNumbersWhereTheirCoordinatesAre) {
  const MapFrame frame = frame_of({120.0, -35.0}, 0.25);  // 100 m x 75 m
  const RecordingCanvas canvas = drawn(frame, Graticule::kMetres);
  const auto below = along(canvas, TextAlign::kCentre);
  const auto beside = along(canvas, TextAlign::kRight);
  ASSERT_GE(below.size(), 3U);
  ASSERT_GE(beside.size(), 3U);
  const double cap_height = measure_text("0", below[0].style).cap_height;
  for (const auto& text : below) {
    const double at = frame.page({number_in(text.line), 0.0}).x();
    const double half = measure_text(text.line, text.style).width / 2.0;
    EXPECT_NEAR(text.point.x(), std::clamp(at, kMap.left + half, kMap.right() - half), 1e-6);
  }
  for (const auto& text : beside) {
    const double at = frame.page({0.0, number_in(text.line)}).y();
    EXPECT_NEAR(text.point.y() + cap_height / 2.0, at, cap_height / 2.0 + 1e-6);
  }
  // A tick for each number.
  EXPECT_EQ(canvas.strokes.size(), canvas.texts.size());
}

TEST(Graticule, HasTicksWhereMeridiansAndParallelsMeetTheBorder) {
  for (const double metres_per_px : {0.05, 0.5, 20.0}) {
    const MapFrame frame = frame_of({900.0, -400.0}, metres_per_px);
    const RecordingCanvas canvas = drawn(frame, Graticule::kDegrees);
    ASSERT_EQ(canvas.strokes.size(), canvas.texts.size());
    ASSERT_GE(canvas.texts.size(), 4U);
    for (std::size_t i = 0; i < canvas.texts.size(); ++i) {
      const Eigen::Vector2d tick = canvas.strokes[i].points[0];
      const Geodetic place =
          plane().geodetic_from_enu(frame.camera.enu_from_page(tick, frame.where));
      const bool is_below = canvas.texts[i].style.align == TextAlign::kCentre;
      const double metre_deg = 1.0 / 111'000.0;
      EXPECT_NEAR(is_below ? place.longitude_deg : place.latitude_deg,
                  number_in(canvas.texts[i].line), 0.01 * metres_per_px * metre_deg);
      EXPECT_THAT(canvas.texts[i].line, testing::HasSubstr("°"));
    }
  }
}

TEST(Graticule, HasNumbersThatDifferAtEveryScale) {
  for (const Graticule kind : {Graticule::kMetres, Graticule::kDegrees}) {
    for (double metres_per_px = 1e-5; metres_per_px < 2e4; metres_per_px *= 1.7) {
      for (const Eigen::Vector2d& centre :
           {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(-4321.5, 98'765.25)}) {
        const MapFrame frame = frame_of(centre, metres_per_px);
        const RecordingCanvas canvas = drawn(frame, kind);
        for (const TextAlign align : {TextAlign::kCentre, TextAlign::kRight}) {
          std::set<std::string> seen;
          for (const auto& text : along(canvas, align)) {
            EXPECT_TRUE(seen.insert(text.line).second) << text.line << " at " << metres_per_px;
          }
          EXPECT_LE(seen.size(), 12U);
        }
        expect_labels_apart(canvas, frame, kind);
        expect_names_apart(frame, kind);
      }
    }
  }
}

TEST(Graticule, HasLabelsThatTouchNothingOnPagesOfAnySize) {
  for (const Graticule kind : {Graticule::kMetres, Graticule::kDegrees}) {
    for (const double width : {2.0, 20.0, 45.0, 90.0, 200.0, 1500.0}) {
      for (const double height : {2.0, 12.0, 40.0, 150.0, 900.0}) {
        for (const double px_per_pt : {1.33, 2.8, 6.0}) {
          const MapFrame frame =
              frame_of({-123.4, 7000.0}, 90.0 / width, {100.0, 80.0, width, height}, px_per_pt);
          SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height));
          expect_labels_apart(drawn(frame, kind), frame, kind);
          expect_names_apart(frame, kind);
        }
      }
    }
  }
}

TEST(Graticule, NamesEachCoordinateOnceWithItsUnit) {
  const auto names = [](Graticule kind) {
    std::vector<std::string> found;
    for (const auto& text : drawn_with_names(frame_of({120.0, -35.0}, 0.25), kind).texts) {
      if (is_name(text)) found.push_back(text.line);
    }
    return found;
  };
  EXPECT_THAT(names(Graticule::kMetres), testing::ElementsAre("east [m]", "north [m]"));
  EXPECT_THAT(names(Graticule::kDegrees), testing::Contains("longitude"));
}

TEST(Graticule, LeavesNamesOutBesideNumbersThatTakeTheRoom) {
  const MapFrame far = frame_of({0.0, -987'650.0}, 0.25);
  for (const auto& text : drawn_with_names(far, Graticule::kMetres).texts) {
    EXPECT_NE(text.line, "north [m]");
  }
}

TEST(Graticule, EndsForEveryCamera) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  for (const double centre : {0.0, 1.0, 1e9, -1e17, 1e300, kLargest, kNaN}) {
    for (const double metres_per_px : {1e-300, 1e-18, 1e-12, 1e-3, 1.0, 1e9, 1e200, 1e306, kNaN}) {
      for (const Graticule kind : {Graticule::kMetres, Graticule::kDegrees}) {
        const MapFrame frame = frame_of({centre, -centre}, metres_per_px);
        RecordingCanvas canvas;
        draw_graticule(canvas, frame, kind, plane(), light());
        draw_graticule_lines(canvas, frame, kind, plane(), light());
        EXPECT_LT(canvas.texts.size(), 30U) << centre << " " << metres_per_px;
      }
    }
  }
}

TEST(Graticule, HasNeitherTicksNorLinesWhereTheMapIsTurnedOrNoneAreWanted) {
  MapFrame turned = frame_of({0.0, 0.0}, 0.5);
  turned.camera.up_rad = 0.3;
  RecordingCanvas canvas;
  for (const Graticule kind : {Graticule::kMetres, Graticule::kDegrees}) {
    draw_graticule(canvas, turned, kind, plane(), light());
    draw_graticule_lines(canvas, turned, kind, plane(), light());
  }
  draw_graticule(canvas, frame_of({0.0, 0.0}, 0.5), Graticule::kNone, plane(), light());
  draw_graticule_lines(canvas, frame_of({0.0, 0.0}, 0.5), Graticule::kNone, plane(), light());
  EXPECT_TRUE(canvas.strokes.empty());
  EXPECT_TRUE(canvas.texts.empty());
  EXPECT_EQ(graticule_margin_px(Graticule::kNone, 2.0), Eigen::Vector2d(0.0, 0.0));
}

TEST(GraticuleLines, BeginAtTheTicksAndCrossTheMap) {
  for (const Graticule kind : {Graticule::kMetres, Graticule::kDegrees}) {
    // So large that meridians lean and parallels bend.
    const MapFrame frame = frame_of({40'000.0, 60'000.0}, 200.0);
    const RecordingCanvas ticks = drawn(frame, kind);
    RecordingCanvas lines;
    draw_graticule_lines(lines, frame, kind, plane(), light());
    ASSERT_EQ(lines.strokes.size(), 2 * ticks.strokes.size());  // each with its casing
    for (std::size_t i = 0; i < ticks.strokes.size(); ++i) {
      const auto& line = lines.strokes[2 * i + 1];
      EXPECT_LT((line.points.front() - ticks.strokes[i].points[0]).norm(), 0.01);
      EXPECT_THAT(line.clips, testing::ElementsAre(kMap));
      const bool is_meridian = ticks.texts[i].style.align == TextAlign::kCentre;
      const double value = number_in(ticks.texts[i].line);
      for (const Eigen::Vector2d& point : line.points) {
        const Eigen::Vector2d in_enu = frame.camera.enu_from_page(point, frame.where);
        if (kind == Graticule::kMetres) {
          EXPECT_NEAR(is_meridian ? in_enu.x() : in_enu.y(), value, 1e-6);
        } else {
          const Geodetic place = plane().geodetic_from_enu(in_enu);
          EXPECT_NEAR(is_meridian ? place.longitude_deg : place.latitude_deg, value, 1e-9);
        }
      }
      EXPECT_NEAR(is_meridian ? line.points.back().y() : line.points.back().x(),
                  is_meridian ? kMap.top() : kMap.right(), 1e-6);
    }
  }
}

TEST(GraticuleLines, AreThinOnPaperWhateverTheSizeOfThePage) {
  for (const double px_per_pt : {1.33, 3.0}) {
    RecordingCanvas lines;
    draw_graticule_lines(lines, frame_of({0, 0}, 0.5, kMap, px_per_pt), Graticule::kMetres, plane(),
                         light());
    ASSERT_FALSE(lines.strokes.empty());
    for (const auto& stroke : lines.strokes) EXPECT_LE(stroke.style.width_px, 1.0 * px_per_pt);
  }
}

}  // namespace graticule_test
}  // namespace nadir
