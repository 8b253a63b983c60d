// SPDX-License-Identifier: Apache-2.0
#include "widgets/canvas/page_lines.h"

#include <gmock/gmock.h>

#include <limits>

#include "core/base/random.h"

namespace nadir {
namespace page_lines_test {

using Points = std::vector<Eigen::Vector2d>;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

const Eigen::AlignedBox2d kBox(Eigen::Vector2d(0, 0), Eigen::Vector2d(10, 10));

/// Points in and around the box.
Points scattered(std::uint32_t which, int count) {
  Points points;
  for (int i = 0; i < count; ++i) {
    const auto [x, y] = uniforms({.seed = 5, .step = which, .particle = static_cast<unsigned>(i)});
    points.emplace_back(30.0 * x - 10.0, 30.0 * y - 10.0);
  }
  return points;
}

/// Even-odd, by a ray to the right.
bool is_inside(const Points& outline, const Eigen::Vector2d& point) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d& a = outline[i];
    const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    const double x = a.x() + (point.y() - a.y()) * (b.x() - a.x()) / (b.y() - a.y());
    if (x > point.x()) inside = !inside;
  }
  return inside;
}

TEST(LineInside, LeavesALineInTheBoxAsItIs) {
  const Points line = {{1, 1}, {2, 5}, {2, 5}, {9, 9}};
  const auto pieces = line_inside(line, kBox);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].points, line);
  EXPECT_EQ(pieces[0].begin, 0.0);
}

TEST(LineInside, CutsWhereALineEntersAndLeaves) {
  const auto pieces = line_inside(Points{{-10, 5}, {5, 5}, {5, 25}, {8, 25}, {8, -5}}, kBox);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_THAT(pieces[0].points,
              ElementsAre(Eigen::Vector2d(0, 5), Eigen::Vector2d(5, 5), Eigen::Vector2d(5, 10)));
  EXPECT_DOUBLE_EQ(pieces[0].begin, 10.0);
  EXPECT_THAT(pieces[1].points, ElementsAre(Eigen::Vector2d(8, 10), Eigen::Vector2d(8, 0)));
  EXPECT_DOUBLE_EQ(pieces[1].begin, 15.0 + 20.0 + 3.0 + 15.0);
}

TEST(LineInside, HasNothingOfLinesThatPassBy) {
  EXPECT_THAT(line_inside(Points{{-5, 0}, {0, 20}, {20, 20}}, kBox), IsEmpty());
  EXPECT_THAT(line_inside(Points{{12, 0}, {12, 10}}, kBox), IsEmpty());
  EXPECT_THAT(line_inside(Points{{5, 5}}, kBox), IsEmpty());
  EXPECT_THAT(line_inside(Points{}, kBox), IsEmpty());
}

TEST(LineInside, StopsBeforeAPointThatIsNotFiniteAndBeginsAnew) {
  const auto pieces = line_inside(
      Points{{1, 1}, {2, 2}, {kNone, 3}, {4, 4}, {5, 5}, {6, kInfinite}, {7, 7}, {8, 8}}, kBox);
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_THAT(pieces[1].points, ElementsAre(Eigen::Vector2d(4, 4), Eigen::Vector2d(5, 5)));
  for (const LinePiece& piece : pieces) EXPECT_EQ(piece.begin, 0.0);
}

TEST(LineInside, KeepsTheLengthThatLiesInTheBox) {
  for (std::uint32_t which = 0; which < 200; ++which) {
    const Points line = scattered(which, 12);
    double expected = 0.0;
    constexpr int kSteps = 2000;
    for (std::size_t i = 1; i < line.size(); ++i) {
      int inside = 0;
      for (int step = 0; step < kSteps; ++step) {
        const Eigen::Vector2d at = line[i - 1] + (step + 0.5) / kSteps * (line[i] - line[i - 1]);
        inside += kBox.contains(at) ? 1 : 0;
      }
      expected += (line[i] - line[i - 1]).norm() * inside / kSteps;
    }
    double length = 0.0;
    for (const LinePiece& piece : line_inside(line, kBox)) {
      ASSERT_GE(piece.points.size(), 2U);
      for (std::size_t i = 0; i < piece.points.size(); ++i) {
        EXPECT_LT(kBox.exteriorDistance(piece.points[i]), 1e-9);
        if (i > 0) length += (piece.points[i] - piece.points[i - 1]).norm();
      }
    }
    EXPECT_NEAR(length, expected, 0.3) << which;
  }
}

TEST(AreaInside, LeavesAnAreaInTheBoxAsItIs) {
  const Points area = {{1, 1}, {9, 1}, {5, 9}};
  EXPECT_EQ(area_inside(area, kBox), area);
}

TEST(AreaInside, CoversTheSamePointsOfTheBoxAlsoOfOutlinesThatCrossThemselves) {
  for (std::uint32_t which = 0; which < 100; ++which) {
    const Points area = scattered(which, 3 + static_cast<int>(which % 9));
    const Points cut = area_inside(area, kBox);
    for (const Eigen::Vector2d& point : cut) EXPECT_LT(kBox.exteriorDistance(point), 1e-9);
    for (int y = 0; y < 20; ++y) {
      for (int x = 0; x < 20; ++x) {
        const Eigen::Vector2d point(0.5 * x + 0.2501, 0.5 * y + 0.2499);
        EXPECT_EQ(is_inside(cut, point), is_inside(area, point)) << which << " " << x << " " << y;
      }
    }
  }
}

TEST(AreaInside, IsEmptyForAnAreaElsewhereOrWithoutThreePoints) {
  EXPECT_THAT(area_inside(Points{{20, 0}, {30, 0}, {30, 10}}, kBox), IsEmpty());
  EXPECT_THAT(area_inside(Points{{1, 1}, {2, 2}}, kBox), IsEmpty());
  EXPECT_THAT(area_inside(Points{{1, 1}, {2, 2}, {kNone, 0}}, kBox), IsEmpty());
}

TEST(AreaInside, IsTheBoxForAnAreaAroundIt) {
  const Points cut = area_inside(Points{{-1e12, -1e12}, {1e12, -1e12}, {0, 1e13}}, kBox);
  for (const double x : {0.1, 5.0, 9.9}) {
    for (const double y : {0.1, 5.0, 9.9}) EXPECT_TRUE(is_inside(cut, {x, y}));
  }
}

}  // namespace page_lines_test
}  // namespace nadir
