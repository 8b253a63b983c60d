// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/map_grid.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "tests/support/recorded_page.h"
#include "widgets/views/map_colours.h"

namespace nadir {
namespace map_grid_test {

using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

constexpr double kPi = std::numbers::pi;
constexpr PageRect kPage{0.0, 0.0, 800.0, 600.0};

MapCamera turned_camera() { return {{120.0, -35.0}, 0.25, 2.2}; }

TEST(GridLines, LieAtRoundCoordinatesAndRunAlongThemWhicheverWayTheMapIsTurned) {
  for (const double up_rad : {kPi / 2.0, 0.4, 2.2, -3.0}) {
    MapCamera camera = turned_camera();
    camera.up_rad = up_rad;
    const auto lines = grid_lines(camera, kPage, 90.0);
    ASSERT_GE(lines.size(), 6U);
    std::vector<double> east, north;
    for (const GridLine& line : lines) {
      (line.is_east ? east : north).push_back(line.value_m);
      for (const Eigen::Vector2d& end : line.ends) {
        const Eigen::Vector2d place = camera.enu_from_page(end, kPage);
        EXPECT_NEAR(line.is_east ? place.x() : place.y(), line.value_m, 1e-6);
        const bool is_on_border = std::abs(end.x()) < 1e-6 || std::abs(end.x() - 800.0) < 1e-6 ||
                                  std::abs(end.y()) < 1e-6 || std::abs(end.y() - 600.0) < 1e-6;
        EXPECT_TRUE(is_on_border) << end.transpose();
      }
    }
    for (const auto* values : {&east, &north}) {
      for (std::size_t i = 1; i < values->size(); ++i) {
        EXPECT_GE(((*values)[i] - (*values)[i - 1]) / camera.metres_per_px, 90.0 - 1e-6);
      }
    }
  }
}

TEST(GridLines, AreNoneWhereNeighboursWouldBeTheSameNumber) {
  EXPECT_THAT(grid_lines({{3e15, 0.0}, 1e-3, kPi / 2.0}, kPage, 90.0), IsEmpty());
  EXPECT_THAT(grid_lines({{std::nan(""), 0.0}, 1.0, kPi / 2.0}, kPage, 90.0), IsEmpty());
}

/// Numbers of a map 200 m across and 150 m high around (5, 5).
std::vector<std::string> numbers_of(double up_rad) {
  const Theme& colours = theme(ThemeName::kLight);
  const MapFrame frame{kPage, {{5.0, 5.0}, 0.25, up_rad}, 1.0};
  RecordedPage page;
  draw_grid_lines(page, frame, grid_look_on_imagery(colours, light_on_imagery(colours), 1.0));
  std::vector<std::string> lines;
  for (const RecordedPage::Text& text : page.texts) lines.push_back(text.line);
  EXPECT_THAT(unreadable_texts(page, kPage.width, kPage.height, 7.0), IsEmpty());
  return lines;
}

TEST(GridLines, HaveTheNumbersOfTheirCoordinates) {
  EXPECT_THAT(numbers_of(kPi / 2.0),
              UnorderedElementsAre("E -50", "E 0", "E 50", "E 100", "N -50", "N 0", "N 50"));
  // East is up: less of it is seen, and more of the north.
  EXPECT_THAT(numbers_of(0.0),
              UnorderedElementsAre("E -50", "E 0", "E 50", "N -50", "N 0", "N 50", "N 100"));
}

TEST(GridLines, OnImageryAreLightInADarkCasing) {
  const Theme& colours = theme(ThemeName::kLight);
  const MapGridLook look = grid_look_on_imagery(colours, light_on_imagery(colours), 0.5);
  EXPECT_EQ(look.line, with_opacity(colours.truth_on_imagery, 0.225));
  EXPECT_EQ(look.casing, with_opacity(colours.casing_on_imagery, 0.175));
}

}  // namespace map_grid_test
}  // namespace nadir
