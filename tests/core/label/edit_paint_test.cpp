// SPDX-License-Identifier: Apache-2.0
#include "core/label/edit_paint.h"

#include <gmock/gmock.h>

#include "core/label/label_raster.h"
#include "tests/core/label/drawn_labels.h"
#include "tests/support/error_text.h"

namespace nadir {
namespace edit_paint_test {

using testing::HasSubstr;

double distance(const Eigen::Vector2d& point, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const double length = (b - a).squaredNorm();
  const double t = length > 0.0 ? std::clamp((point - a).dot(b - a) / length, 0.0, 1.0) : 0.0;
  return (a + t * (b - a) - point).norm();
}

LabelDocument after(LabelDocument document, const LabelEdit& edit) {
  const auto fits = document.check(edit);
  if (!fits) throw std::logic_error(error_text(fits));
  document.apply(edit);
  return document;
}

TEST(PaintStroke, TakesTheCellsWhoseCentreIsWithinItsRadius) {
  const LabelDocument document = test_document(600, 400);
  const Ring path = ring({{30.3, 40.1}, {290.7, 61.4}, {250.2, 300.9}, {251.0, 301.5}});
  const LabelDocument painted = after(document, paint_stroke(document, path, 7.37, kRoad, "Paint"));
  for (int row = 0; row < 400; ++row) {
    for (int column = 0; column < 600; ++column) {
      const Eigen::Vector2d centre(column + 0.5, -(row + 0.5));
      double least = 1e9;
      for (std::size_t i = 1; i < path.size(); ++i)
        least = std::min(least, distance(centre, path[i - 1], path[i]));
      if (std::abs(least - 7.37) < 1e-9) continue;
      ASSERT_EQ(painted.paint_at(column, row), least < 7.37 ? PaintValue{kRoad} : kNoPaint)
          << column << ", " << row;
    }
  }
}

TEST(PaintStroke, OfOneClickIsADiscAndNeverNothing) {
  const LabelDocument document = test_document();
  const LabelDocument disc =
      after(document, paint_stroke(document, ring({{10.5, 10.5}}), 2.0, kRoad, "Paint"));
  EXPECT_EQ(disc.paint_at(10, 9), kRoad);
  EXPECT_EQ(disc.paint_at(9, 11), kRoad);
  EXPECT_EQ(disc.paint_at(12, 12), kNoPaint);
  const LabelDocument dot =
      after(document, paint_stroke(document, ring({{3.1, 4.1}}), 0.01, kRoad, "Paint"));
  EXPECT_EQ(dot.paint_at(3, 4), kRoad);
}

TEST(PaintStroke, StaysWithinTheGrid) {
  const LabelDocument document = test_document();
  const LabelEdit edit =
      paint_stroke(document, ring({{-500.0, 5.0}, {500.0, 5.0}}), 100.0, kTerrain, "Paint");
  const LabelDocument painted = after(document, edit);
  EXPECT_EQ(edit.tiles.size(), 1U);
  EXPECT_EQ(painted.paint_at(0, 0), kTerrain);
  EXPECT_EQ(painted.paint_at(-1, 0), kNoPaint);
  EXPECT_EQ(painted.paint_at(40, 0), kNoPaint);
}

TEST(PaintStroke, ErasesToNothingAndChangesNothingTwice) {
  const LabelDocument document = test_document(600, 400);
  const Ring path = ring({{30, 40}, {290, 61}});
  const LabelDocument painted = after(document, paint_stroke(document, path, 5.0, kRoad, "Paint"));
  EXPECT_TRUE(paint_stroke(painted, path, 5.0, kRoad, "Again").empty());
  const LabelDocument erased = after(painted, paint_stroke(painted, path, 6.0, kNoPaint, "Erase"));
  EXPECT_TRUE(erased.paint().empty());
}

TEST(LabelPaint, ABrushOfTwoThousandCellsIsOneStep) {
  const LabelDocument document = test_document(5000, 5000);
  const LabelEdit edit =
      paint_stroke(document, ring({{2400, 2400}, {2600, 2600}}), 1000.0, kVegetation, "Paint");
  EXPECT_EQ(edit.title, "Paint");
  EXPECT_GT(edit.tiles.size(), 64U);
  EXPECT_TRUE(document.check(edit));
}

TEST(PaintRings, EqualsTheAreaThatIsDrawnSo) {
  const LabelDocument document = test_document(300, 280);
  const std::vector<Ring> rings{ring({{3.2, 4.1}, {290.4, 30.3}, {120.7, 270.9}}),
                                box(60, 50, 150, 120)};
  const LabelDocument painted = after(document, paint_rings(document, rings, kRoad, "Fill"));
  EXPECT_EQ(rasterise(painted), rasterise(document_of({area(kRoad, rings)}, 300, 280)));
}

TEST(FloodFill, StopsAtBordersOfOtherClassesAndAtCorners) {
  // A box of curb whose inside hangs together with the outside by a corner only.
  LabelDocument document =
      document_of({area(kCurb, {box(2, 2, 9, 9), box(3, 3, 8, 8)}, 1)}, 12, 12);
  document.apply(painting(document, {2, 2, 3, 3}, kUnclassified));
  const auto inside = flood_fill(document, {5.0, -5.0}, kRoad, "Fill");
  ASSERT_TRUE(inside) << error_text(inside);
  const auto labels = rasterise(after(document, *inside));
  EXPECT_EQ(std::count(labels.values().begin(), labels.values().end(), kRoad), 25);
  const auto outside = flood_fill(document, {0.5, -0.5}, kTerrain + kPaintOver, "Fill");
  ASSERT_TRUE(outside);
  const auto around = rasterise(after(document, *outside));
  EXPECT_EQ(std::count(around.values().begin(), around.values().end(), kTerrain), 144 - 49 + 1);
}

TEST(FloodFill, GoesThroughManyTilesAsABruteForceDoes) {
  LabelDocument document = test_document(700, 600);
  for (std::uint32_t step = 0; step < 30; ++step) {
    const auto [x, y] = uniforms({61, 0, step, 0, 0});
    const auto [z, w] = uniforms({61, 0, step, 0, 1});
    document.apply({"",
                    {added(line(kCurb, ring({{700 * x, 600 * y}, {700 * z, 600 * w}}), 3.0,
                                document.next_id()))},
                    {},
                    {}});
  }
  const auto labels = rasterise(document);
  std::vector<std::pair<int, int>> waiting{{350, 300}};
  Raster<std::uint8_t> reached(700, 600, 0);
  const ClassId wanted = labels.at(350, 300);
  while (!waiting.empty()) {
    const auto [column, row] = waiting.back();
    waiting.pop_back();
    if (!labels.contains(column, row) || reached.at(column, row) != 0 ||
        labels.at(column, row) != wanted)
      continue;
    reached.at(column, row) = 1;
    for (const auto& [dx, dy] :
         {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
      waiting.emplace_back(column + dx, row + dy);
    }
  }
  const auto edit = flood_fill(document, {350.5, -300.5}, kTerrain + kPaintOver, "Fill");
  ASSERT_TRUE(edit) << error_text(edit);
  const LabelDocument filled = after(document, *edit);
  for (int row = 0; row < 600; ++row) {
    for (int column = 0; column < 700; ++column) {
      ASSERT_EQ(filled.paint_at(column, row) != kNoPaint, reached.at(column, row) == 1)
          << column << ", " << row;
    }
  }
}

TEST(FloodFill, RefusesWhatIsOutsideOrHasNoBorder) {
  EXPECT_THAT(error_text(flood_fill(test_document(), {-1.0, -1.0}, kRoad, "Fill")),
              HasSubstr("outside"));
  EXPECT_THAT(error_text(flood_fill(test_document(5000, 5000), {9.0, -9.0}, kRoad, "Fill")),
              HasSubstr("more than 16000000"));
}

}  // namespace edit_paint_test
}  // namespace nadir
