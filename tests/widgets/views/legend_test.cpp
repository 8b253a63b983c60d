// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/legend.h"

#include <gmock/gmock.h>

#include "tests/widgets/views/drawn_chart.h"

namespace nadir {
namespace legend_test {

using testing::IsEmpty;
using testing::SizeIs;

constexpr PageRect kStrip{10.0, 10.0, 300.0, 40.0};

RecordingCanvas drawn(const LegendEntry& entry, ThemeName name = ThemeName::kLight) {
  RecordingCanvas canvas;
  draw_legend(canvas, kStrip, std::vector<LegendEntry>{entry}, theme(name), 2.0);
  return canvas;
}

Eigen::AlignedBox2d box_around(const std::vector<Eigen::Vector2d>& points) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& point : points) box.extend(point);
  return box;
}

TEST(LegibleEntry, OutlinesABarThatIsAboutThePagesColour) {
  const LegendEntry building{"building", class_colour(kBuilding), LegendEntry::Kind::kBar};
  const LegendEntry outlined = legible_entry(building, theme(ThemeName::kDark));
  EXPECT_EQ(outlined.kind, LegendEntry::Kind::kOutlinedBar);
  EXPECT_EQ(outlined.colour, building.colour) << "as on the map";
  EXPECT_EQ(outlined.casing, theme(ThemeName::kDark).muted);
  EXPECT_EQ(legible_entry(building, theme(ThemeName::kLight)), building);
  const LegendEntry line{"truth", theme(ThemeName::kDark).page};
  EXPECT_EQ(legible_entry(line, theme(ThemeName::kDark)), line) << "it has a casing";
}

TEST(Legend, ShowsEllipsesAsTwoOutlinesOneInsideTheOther) {
  const Rgba blue{80, 170, 230};
  const RecordingCanvas canvas = drawn({"ellipses", blue, LegendEntry::Kind::kRings});
  ASSERT_THAT(canvas.strokes, SizeIs(2));
  const Eigen::AlignedBox2d outer = box_around(canvas.strokes[0].points);
  const Eigen::AlignedBox2d inner = box_around(canvas.strokes[1].points);
  EXPECT_TRUE(outer.contains(inner));
  EXPECT_GT(outer.sizes().x(), outer.sizes().y());
  EXPECT_EQ(canvas.strokes[1].style.colour, blue);
  ASSERT_THAT(canvas.fills, SizeIs(1));  // as faint as on the map, unlike a band
  EXPECT_LT(canvas.fills[0].colour.alpha, 60);
  EXPECT_LT(outer.max().x(), canvas.texts.at(0).point.x());
}

TEST(Legend, ShowsPaleAreasWithAnOutline) {
  const Theme& light = theme(ThemeName::kLight);
  const RecordingCanvas canvas =
      drawn({"unclassified", light.page, LegendEntry::Kind::kOutlinedBar, light.muted});
  EXPECT_THAT(canvas.fills_in(light.page), SizeIs(1));
  ASSERT_THAT(canvas.strokes_in(light.muted), SizeIs(1));
  EXPECT_EQ(box_around(canvas.strokes[0].points).sizes(),
            box_around(canvas.fills[0].outline).sizes());
}

TEST(Legend, DrawsNothingBelowItsStrip) {
  const std::vector<LegendEntry> many(
      40, {"a name of some length", {0, 0, 0}, LegendEntry::Kind::kRings});
  RecordingCanvas canvas;
  draw_legend(canvas, kStrip, many, theme(ThemeName::kDark), 2.0);
  for (const auto& stroke : canvas.strokes) {
    EXPECT_GE(box_around(stroke.points).min().y(), kStrip.bottom);
  }
  EXPECT_LT(canvas.texts.size(), many.size());
  canvas = {};
  draw_legend(canvas, kStrip, {}, theme(ThemeName::kDark), 2.0);
  EXPECT_THAT(canvas.texts, IsEmpty());
}

TEST(Legend, IsDrawnByItsLayoutAsItWouldLayItselfOut) {
  std::vector<LegendEntry> entries;
  for (int i = 0; i < 6; ++i) {
    entries.push_back({"name " + std::to_string(i * i * i), {1, 2, 3}, LegendEntry::Kind::kBar});
  }
  const PageRect where{10.0, 10.0, 300.0, 200.0};
  const LegendLayout layout = legend_layout(where.width, entries, 2.0);
  ASSERT_THAT(layout.places, SizeIs(6));
  EXPECT_EQ(layout.places[0], Eigen::Vector2d::Zero());
  for (std::size_t i = 1; i < layout.places.size(); ++i) {
    const Eigen::Vector2d step = layout.places[i] - layout.places[i - 1];
    EXPECT_TRUE(step.y() == 0.0 ? step.x() > 0.0 : layout.places[i].x() == 0.0) << i;
    EXPECT_GE(step.y(), 0.0);
  }
  EXPECT_GT(layout.height_px, layout.places.back().y());
  RecordingCanvas once, again;
  EXPECT_EQ(draw_legend(once, where, entries, theme(ThemeName::kDark), 2.0), layout.height_px);
  draw_legend(again, where, entries, layout, theme(ThemeName::kDark), 2.0);
  ASSERT_EQ(once.texts.size(), again.texts.size());
  for (std::size_t i = 0; i < once.texts.size(); ++i) {
    EXPECT_EQ(once.texts[i].point, again.texts[i].point);
  }
  EXPECT_EQ(legend_layout(300.0, {}, 2.0).height_px, 0.0);
}

TEST(Legend, ShowsAParticleAsADotWithItsHeadingAndCasing) {
  const Rgba teal{30, 155, 138};
  const Rgba dark{0, 0, 0};
  const RecordingCanvas canvas = drawn({"particles", teal, LegendEntry::Kind::kParticle, dark});
  ASSERT_THAT(canvas.fills_in(teal), SizeIs(1));
  ASSERT_THAT(canvas.fills_in(dark), SizeIs(1));
  const Eigen::AlignedBox2d dot = box_around(canvas.fills_in(teal)[0].outline);
  EXPECT_TRUE(box_around(canvas.fills_in(dark)[0].outline).contains(dot));
  ASSERT_THAT(canvas.strokes_in(teal), SizeIs(1));
  EXPECT_GT(box_around(canvas.strokes_in(teal)[0].points).max().x(), dot.max().x());
  EXPECT_THAT(canvas.strokes_in(dark), SizeIs(1));
}

TEST(Legend, ShowsWeightsFromDarkToLight) {
  const RecordingCanvas canvas = drawn({"particles", {}, LegendEntry::Kind::kParticles});
  ASSERT_THAT(canvas.fills, SizeIs(3));
  for (std::size_t i = 1; i < 3; ++i) {
    EXPECT_LT(box_around(canvas.fills[i - 1].outline).max().x(),
              box_around(canvas.fills[i].outline).min().x());
    EXPECT_LT(int{canvas.fills[i - 1].colour.green}, int{canvas.fills[i].colour.green});
  }
}

TEST(Legend, ShowsAScaleFromDarkToLight) {
  const RecordingCanvas canvas = drawn({"cost 0.9 to 0.1", {}, LegendEntry::Kind::kRamp});
  ASSERT_GE(canvas.fills.size(), 6U);
  EXPECT_LT(int{canvas.fills.front().colour.green}, 60);
  EXPECT_GT(int{canvas.fills.back().colour.green}, 190);
  EXPECT_LT(box_around(canvas.fills.back().outline).max().x(), canvas.texts.at(0).point.x());
}

}  // namespace legend_test
}  // namespace nadir
