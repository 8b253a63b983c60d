// SPDX-License-Identifier: Apache-2.0
#include "core/assist/pixel_mask.h"

#include <gmock/gmock.h>

#include "core/edit/polygon_algebra.h"
#include "core/label/label_raster.h"
#include "tests/core/assist/drawn_windows.h"
#include "tests/core/label/drawn_labels.h"

namespace nadir {
namespace pixel_mask_test {

using testing::HasSubstr;

CellMask cells(const AssistWindow& window, const PixelMask& mask, const LabelGrid& grid) {
  auto found = cells_of(window, mask, grid);
  if (!found) throw std::runtime_error(error_text(found));
  return std::move(*found);
}

/// A grid that holds the window of turned_place() and more, its cells so large.
LabelGrid grid_around(const AssistWindow& window, double metres_per_cell) {
  const Eigen::Vector2d middle =
      window.enu_from_pixels() * Eigen::Vector2d(window.width() / 2.0, window.height() / 2.0);
  const int side = static_cast<int>(120.0 / metres_per_cell);
  return {metres_per_cell, middle + Eigen::Vector2d(-60.0, 60.0), side, side};
}

/// Some piece with a hole, an island in it, and pieces that touch at corners.
PixelMask islands() {
  return mask_drawn({"..........",  //
                     ".#######..",  //
                     ".#.....#..",  //
                     ".#.##..##.",  //
                     ".#.##..#..",  //
                     ".#.....#..",  //
                     ".#######..",  //
                     "........#.",  //
                     "........#."});
}

TEST(FilledHoles, AreThoseThatAreSmallAndClosed) {
  const PixelMask mask = mask_drawn({"#####..",  //
                                     "#.#.#..",  //
                                     "#####..",  //
                                     "#...###",  //
                                     "#...#.#",  //
                                     "####.##"});
  EXPECT_EQ(filled_holes(mask, 0, PixelNeighbours::kEight), mask);
  EXPECT_EQ(filled_holes(mask, 1, PixelNeighbours::kEight), mask_drawn({"#####..",  //
                                                                        "#####..",  //
                                                                        "#####..",  //
                                                                        "#...###",  //
                                                                        "#...###",  //
                                                                        "####.##"}));
  EXPECT_EQ(filled_holes(mask, 6, PixelNeighbours::kEight), mask_drawn({"#####..",  //
                                                                        "#####..",  //
                                                                        "#####..",  //
                                                                        "#######",  //
                                                                        "#######",  //
                                                                        "####.##"}));
  // Through a corner the hole on the right reaches the border, where sides alone make the mask.
  EXPECT_EQ(filled_holes(mask, 1, PixelNeighbours::kFour).at(5, 4), 0);
  EXPECT_EQ(filled_holes(mask, 1, PixelNeighbours::kFour).at(1, 1), 1);
}

TEST(BordersInEnu, SurroundThePixelsOfTheMask) {
  const AssistWindow window = window_of(ImageRaster(10, 9, kGrass), turned_place());
  const auto borders = borders_in_enu(window, islands());
  ASSERT_TRUE(borders);
  EXPECT_EQ(borders->size(), 4U);  // The ring and its hole, the island in it, the line below.
  double area = 0.0;
  for (const Ring& border : *borders) {
    Region region;
    region.parts.push_back({border});
    area += area_m2(region);
  }
  // The hole counts twice here: once around, once alone; 5 x 4 pixels.
  EXPECT_NEAR(area, 0.375 * (count_of(islands()) + 2 * 20), 1e-9);
}

TEST(CellsOf, AreThoseWhoseCentreLiesInThePixels) {
  const AssistWindow window = window_of(ImageRaster(10, 9, kGrass), turned_place());
  for (const double metres_per_cell : {0.07, 0.4, 1.1}) {
    const LabelGrid grid = grid_around(window, metres_per_cell);
    const CellMask found = cells(window, islands(), grid);
    ASSERT_FALSE(found.cells.empty());
    for (std::int64_t row = 0; row < grid.height; ++row) {
      for (std::int64_t column = 0; column < grid.width; ++column) {
        const Eigen::Vector2d centre = grid.enu_from_cells(
            {static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5});
        const auto pixel = window.pixel_at(centre);
        const int expected = pixel ? islands().at(pixel->column, pixel->row) : 0;
        const CellRect& at = found.cells;
        const bool is_held =
            column >= at.left && column < at.right && row >= at.top && row < at.bottom;
        const int is = is_held ? found.values.at(static_cast<int>(column - at.left),
                                                 static_cast<int>(row - at.top))
                               : 0;
        ASSERT_EQ(is, expected) << column << ", " << row << " of " << metres_per_cell;
      }
    }
  }
}

TEST(CellsOf, OfAWindowOnTheGridAreItsPixels) {
  const AssistWindow window = window_of(ImageRaster(10, 9, kGrass), plain_place());
  const CellMask found = cells(window, islands(), test_grid(40, 30));
  EXPECT_EQ(found.cells, (CellRect{1, 1, 10, 10}));
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 8; ++column) {
      EXPECT_EQ(found.values.at(column, row), islands().at(column + 1, row + 1));
    }
  }
}

TEST(CellsOf, AreCutToTheGridAndMayBeNone) {
  const AssistWindow window = window_of(ImageRaster(10, 9, kGrass), plain_place());
  EXPECT_EQ(cells(window, islands(), test_grid(4, 3)).cells, (CellRect{1, 1, 4, 3}));
  EXPECT_TRUE(cells(window, PixelMask(10, 9), test_grid(40, 30)).cells.empty());
  EXPECT_TRUE(cells(window, islands(), {1.0, {500.0, 0.0}, 40, 30}).cells.empty());
  EXPECT_THAT(error_text(cells_of(window, islands(), {1e-4, {0.0, 0.0}, 200'000, 200'000})),
              HasSubstr("more than 16000000 cells"));
}

TEST(PaintCells, PaintsThemAndNothingElse) {
  LabelDocument document = document_of({area(kBuilding, {box(0.0, 0.0, 5.0, 30.0)})});
  const AssistWindow window = window_of(ImageRaster(10, 9, kGrass), plain_place());
  const CellMask found = cells(window, islands(), document.grid());
  const auto labels_with = [&](PaintValue value) {
    LabelDocument painted = document;
    painted.apply(paint_cells(document, found, value, "Wand"));
    return rasterise(painted);
  };
  const Raster<ClassId> before = rasterise(document);
  const Raster<ClassId> below = labels_with(kRoad);
  const Raster<ClassId> over = labels_with(kRoad + kPaintOver);
  for (int row = 0; row < before.height(); ++row) {
    for (int column = 0; column < before.width(); ++column) {
      const bool is_found = column < 10 && row < 9 && islands().at(column, row) != 0;
      const ClassId was = before.at(column, row);
      EXPECT_EQ(over.at(column, row), is_found ? ClassId{kRoad} : was);
      // A road lies below buildings.
      const bool is_free = was == kUnclassified;
      EXPECT_EQ(below.at(column, row), is_found && is_free ? ClassId{kRoad} : was);
    }
  }
  const LabelEdit edit = paint_cells(document, found, kRoad, "Wand");
  EXPECT_EQ(edit.title, "Wand");
  document.apply(edit);
  EXPECT_TRUE(paint_cells(document, found, kRoad, "Wand").empty());
  document.apply(paint_cells(document, found, kNoPaint, "Erase"));
  EXPECT_TRUE(document.paint().empty());
  EXPECT_TRUE(paint_cells(document, {}, kRoad, "Wand").empty());
}

TEST(DrawCells, GivesAreasThatHaveTheSameCells) {
  LabelDocument document = test_document();
  const AssistWindow window = window_of(ImageRaster(10, 9, kGrass), plain_place());
  const CellMask found = cells(window, islands(), document.grid());
  const auto edit = draw_cells(document, found, kVegetation, {}, "Wand");
  ASSERT_TRUE(edit);
  EXPECT_EQ(edit->objects.size(), 3U);
  EXPECT_EQ(error_text(document.check(*edit)), "(no error)");
  document.apply(*edit);
  LabelDocument painted = test_document();
  painted.apply(paint_cells(painted, found, kVegetation, "Wand"));
  EXPECT_EQ(rasterise(document), rasterise(painted));
}

TEST(DrawCells, LeavesOutSmallPiecesAndHoles) {
  const LabelDocument document = test_document();
  const AssistWindow window = window_of(ImageRaster(10, 9, kGrass), plain_place());
  const CellMask found = cells(window, islands(), document.grid());
  const auto drawn = [&](double least_m2) {
    const auto edit = draw_cells(document, found, kRoad, {.least_area_m2 = least_m2}, "Wand");
    std::size_t rings = 0;
    for (const ObjectChange& change : edit->objects) rings += change.after->rings.size();
    return std::pair(edit->objects.size(), rings);
  };
  EXPECT_EQ(drawn(2.0), std::pair(std::size_t{3}, std::size_t{4}));
  EXPECT_EQ(drawn(3.0), std::pair(std::size_t{2}, std::size_t{3}));    // Without the line below.
  EXPECT_EQ(drawn(5.0), std::pair(std::size_t{1}, std::size_t{2}));    // Without the island.
  EXPECT_EQ(drawn(20.5), std::pair(std::size_t{1}, std::size_t{1}));   // The hole is filled.
  EXPECT_EQ(drawn(100.0), std::pair(std::size_t{0}, std::size_t{0}));  // Nothing is left.
}

TEST(DrawCells, SimplifiesWithinTheTolerance) {
  const LabelDocument document{test_plane(), {0.1, {0.0, 0.0}, 400, 300}};
  const Inside inside = disc(100.0, 80.0, 60.0);
  Affine2 place = plain_place();
  place.linear *= 0.1;
  const AssistWindow window = window_of(ImageRaster(200, 160, kGrass), place);
  const CellMask found = cells(window, pixels_inside(200, 160, inside), document.grid());
  const auto edit = draw_cells(document, found, kRoad, {.simplify_m = 0.12}, "Wand");
  ASSERT_TRUE(edit);
  ASSERT_EQ(edit->objects.size(), 1U);
  const Ring& ring = edit->objects[0].after->rings[0];
  EXPECT_LT(ring.size(), 100U);  // Of several hundred corners of cells.
  for (const Eigen::Vector2d& corner : ring) {
    EXPECT_NEAR((corner - Eigen::Vector2d(10.0, -8.0)).norm(), 6.0, 0.2);
    EXPECT_EQ(on_lattice(corner), corner);
  }
  EXPECT_THAT(error_text(draw_cells(document, found, kSky, {}, "Wand")),
              HasSubstr("no overhead can hold its class 9"));
  EXPECT_THAT(error_text(draw_cells(document, found, kRoad, {.simplify_m = -1.0}, "Wand")),
              HasSubstr("--simplify-found"));
}

}  // namespace pixel_mask_test
}  // namespace nadir
