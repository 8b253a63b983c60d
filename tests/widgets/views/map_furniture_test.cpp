// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/map_furniture.h"

#include <gmock/gmock.h>

#include <limits>
#include <numbers>

#include "tests/widgets/views/drawn_chart.h"

namespace nadir {
namespace map_furniture_test {

constexpr PageRect kMap{60, 40, 400, 300};

const Theme& light() { return theme(ThemeName::kLight); }

Eigen::AlignedBox2d box_around(const std::vector<Eigen::Vector2d>& outline) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& point : outline) box.extend(point);
  return box;
}

TEST(RoundLength, IsTheLargestOfOneTwoFiveThatFits) {
  EXPECT_DOUBLE_EQ(round_length(1.0), 1.0);
  EXPECT_DOUBLE_EQ(round_length(1.99), 1.0);
  EXPECT_DOUBLE_EQ(round_length(2.0), 2.0);
  EXPECT_DOUBLE_EQ(round_length(49.9), 20.0);
  EXPECT_DOUBLE_EQ(round_length(0.00071), 0.0005);
  EXPECT_DOUBLE_EQ(round_length(1000.0), 1000.0);
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW((void)round_length(bad), std::logic_error);
  }
}

TEST(ScaleBar, IsAsLongAsItSays) {
  const std::vector<std::pair<double, std::string>> cases = {
      {0.001, "10 cm"}, {0.25, "20 m"}, {10.0, "1 km"}, {37.0, "2 km"}};
  for (const auto& [metres_per_px, words] : cases) {
    RecordingCanvas canvas;
    draw_scale_bar(canvas, {kMap, {{0, 0}, metres_per_px}, 1.5}, light());
    ASSERT_EQ(canvas.texts.size(), 1U);
    EXPECT_EQ(canvas.texts[0].line, words);
    const auto bars = canvas.fills_in(light().text);
    ASSERT_EQ(bars.size(), 1U);
    const double number = std::stod(words);
    const double unit = words.ends_with("km") ? 1000.0 : words.ends_with("cm") ? 0.01 : 1.0;
    EXPECT_NEAR(box_around(bars[0].outline).sizes().x() * metres_per_px, number * unit, 1e-9);
    // On its plate, which lies inside of the map.
    const Eigen::AlignedBox2d plate = box_around(canvas.fills[0].outline);
    EXPECT_TRUE(plate.contains(box_around(bars[0].outline)));
    EXPECT_TRUE(plate.contains(canvas.texts[0].box()));
    EXPECT_GT(plate.min().x(), kMap.left);
    EXPECT_GT(plate.min().y(), kMap.bottom);
  }
}

TEST(NorthArrow, PointsNorthHoweverTheMapIsTurned) {
  for (const double up_rad : {std::numbers::pi / 2.0, 0.0, -2.0, 1.0}) {
    const MapFrame frame{kMap, {{100, 200}, 0.5, up_rad}, 2.0};
    RecordingCanvas canvas;
    draw_north_arrow(canvas, frame, light());
    const auto arrows = canvas.fills_in(light().text);
    ASSERT_EQ(arrows.size(), 1U);
    const Eigen::Vector2d along = arrows[0].outline[0] - arrows[0].outline[2];
    const Eigen::Vector2d north = frame.page({100, 201}) - frame.page({100, 200});
    EXPECT_GT(along.normalized().dot(north.normalized()), 1.0 - 1e-9);
    const Eigen::AlignedBox2d plate = box_around(canvas.fills[0].outline);
    EXPECT_LT(plate.max().x(), kMap.right());
    EXPECT_LT(plate.max().y(), kMap.top());
  }
}

}  // namespace map_furniture_test
}  // namespace nadir
