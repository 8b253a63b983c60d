// SPDX-License-Identifier: Apache-2.0
#include "core/label/label_raster.h"

#include <gdal_alg.h>
#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <ogr_geometry.h>

#include <numbers>
#include <set>

#include "core/base/parallel.h"
#include "core/label/cell_fill.h"
#include "tests/core/label/drawn_labels.h"

namespace nadir {
namespace label_raster_test {

using testing::ElementsAre;

/// Rows as text: a letter a class, '.' where there is none.
std::vector<std::string> picture(const Raster<ClassId>& labels) {
  std::vector<std::string> rows;
  for (int row = 0; row < labels.height(); ++row) {
    std::string text;
    for (const ClassId id : labels.row(row)) {
      text += id == kRoad           ? 'R'
              : id == kTerrain      ? 'T'
              : id == kBuilding     ? 'B'
              : id == kCurb         ? 'C'
              : id == kLaneMarking  ? 'L'
              : id == kUnclassified ? '.'
                                    : '?';
    }
    rows.push_back(text);
  }
  return rows;
}

std::vector<std::string> picture(std::vector<LabelObject> objects, int width, int height) {
  return picture(rasterise(document_of(std::move(objects), width, height)));
}

std::int64_t count(const Raster<ClassId>& labels, ClassId id) {
  return std::count(labels.values().begin(), labels.values().end(), id);
}

/// The same by GDAL, in cells of one metre.
Raster<ClassId> by_gdal(const std::vector<Ring>& rings, int width, int height) {
  GDALAllRegister();
  auto* dataset = GetGDALDriverManager()->GetDriverByName("MEM")->Create("", width, height, 1,
                                                                         GDT_Byte, nullptr);
  std::array<double, 6> geotransform{0.0, 1.0, 0.0, 0.0, 0.0, -1.0};
  dataset->SetGeoTransform(geotransform.data());
  OGRPolygon polygon;
  for (const Ring& places : rings) {
    OGRLinearRing made;
    for (const Eigen::Vector2d& point : places) made.addPoint(point.x(), point.y());
    made.closeRings();
    polygon.addRing(&made);
  }
  int band = 1;
  double value = kRoad + 1;
  OGRGeometryH geometry = OGRGeometry::ToHandle(&polygon);
  EXPECT_EQ(GDALRasterizeGeometries(dataset, 1, &band, 1, &geometry, nullptr, nullptr, &value,
                                    nullptr, nullptr, nullptr),
            CE_None);
  Raster<ClassId> labels(width, height);
  EXPECT_EQ(dataset->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, width, height, labels.data(), width,
                                                height, GDT_Byte, 0, 0),
            CE_None);
  GDALClose(dataset);
  for (ClassId& id : labels.values()) id = id == 0 ? ClassId{kUnclassified} : ClassId{kRoad};
  return labels;
}

TEST(LabelRaster, ClaimsTheCellsWhoseCentreIsInside) {
  EXPECT_THAT(picture({area(kRoad, {box(1, 1, 4, 3)})}, 6, 4), ElementsAre("......",  //
                                                                           ".RRR..",  //
                                                                           ".RRR..",  //
                                                                           "......"));
  EXPECT_THAT(picture({area(kRoad, {box(1.4, 0.6, 3.6, 2.4)})}, 6, 4), ElementsAre("......",  //
                                                                                   ".RRR..",  //
                                                                                   "......",  //
                                                                                   "......"));
}

TEST(LabelRaster, LeavesHolesAndCountsOddAndEven) {
  EXPECT_THAT(picture({area(kRoad, {box(0, 0, 5, 5), box(1, 1, 4, 4), box(2, 2, 3, 3)})}, 5, 5),
              ElementsAre("RRRRR",  //
                          "R...R",  //
                          "R.R.R",  //
                          "R...R",  //
                          "RRRRR"));
}

TEST(LabelRaster, EqualsGdalOnRandomPolygons) {
  for (std::uint32_t step = 0; step < 400; ++step) {
    std::vector<Ring> rings;
    std::uint32_t draw = 0;
    const auto random = [&](double low, double high) {
      return low + (high - low) * uniforms({11, 0, step, 0, draw++})[0];
    };
    for (int r = 0; r < 1 + static_cast<int>(step % 3); ++r) {
      Ring places;
      for (int i = 0; i < 3 + static_cast<int>(step % 9); ++i) {
        places.emplace_back(random(-8.0, 45.0), random(-36.0, 8.0));
      }
      rings.push_back(places);
    }
    ASSERT_EQ(picture(rasterise(document_of({area(kRoad, rings)}, 37, 28))),
              picture(by_gdal(rings, 37, 28)))
        << "step " << step;
  }
}

TEST(LabelRaster, NeighboursShareTheirBorderWithoutGapOrOverlap) {
  // A fan around a place in the middle, each piece with two borders of its neighbours; half of them run through centres.
  for (const Eigen::Vector2d& middle : {Eigen::Vector2d(20.5, 15.5), Eigen::Vector2d(20.2, 14.9)}) {
    std::vector<Raster<ClassId>> pieces;
    constexpr int kPieces = 16;
    for (int i = 0; i < kPieces; ++i) {
      const auto corner = [&](int k) {
        const double turn = 2.0 * std::numbers::pi * (k % kPieces) / kPieces;
        return std::pair(middle.x() + 100.0 * std::cos(turn), middle.y() + 100.0 * std::sin(turn));
      };
      std::vector<std::pair<double, double>> places{
          {middle.x(), middle.y()}, corner(i), corner(i + 1)};
      if (i % 2 == 1) std::reverse(places.begin(), places.end());
      pieces.push_back(rasterise(document_of({area(kRoad, {ring(places)})})));
    }
    for (int row = 0; row < 30; ++row) {
      for (int column = 0; column < 40; ++column) {
        int claims = 0;
        for (const auto& piece : pieces) claims += piece.at(column, row) == kRoad ? 1 : 0;
        ASSERT_EQ(claims, 1) << column << ", " << row;
      }
    }
  }
}

TEST(LabelRaster, AThreeCellStripKeepsItsAreaAndCentreAtAnyAngle) {
  // Slopes of small whole numbers (45 degrees; 31, nearly 3 to 5) are left out: there the centres lie in rows along the
  // strip, and no rule that asks for centres can be right; GDAL's errs as much.
  for (const double angle_deg : {0.0, 7.0, 13.0, 22.0, 29.0, 38.0, 52.0, 64.0, 77.0, 90.0}) {
    const double angle = angle_deg * std::numbers::pi / 180.0;
    const Eigen::Vector2d middle(400.5, -400.5);
    const Eigen::Vector2d half = 330.0 * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    const auto labels =
        rasterise(document_of({line(kLaneMarking, {middle - half, middle + half}, 3.0)}, 800, 800));
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double cells = 0.0;
    for (int row = 0; row < 800; ++row) {
      for (int column = 0; column < 800; ++column) {
        if (labels.at(column, row) != kLaneMarking) continue;
        sum += Eigen::Vector2d(column + 0.5, -(row + 0.5)) - middle;
        cells += 1.0;
      }
    }
    EXPECT_NEAR(cells / (660.0 * 3.0), 1.0, 0.005) << angle_deg;
    const Eigen::Vector2d across(-std::sin(angle), std::cos(angle));
    EXPECT_LT(std::abs((sum / cells).dot(across)), 0.02) << angle_deg;
  }
}

TEST(LabelRaster, CutsLinesOffSquareAndRoundsTheirJoins) {
  EXPECT_THAT(picture({line(kRoad, ring({{2, 2.5}, {7, 2.5}, {7, 6}}), 3.0)}, 10, 7),
              ElementsAre("..........",  //
                          "..RRRRRR..",  //
                          "..RRRRRRR.",  //
                          "..RRRRRRR.",  //
                          "......RRR.",  //
                          "......RRR.",  //
                          ".........."));
}

/// Whether all cells of a class hang together by sides or corners.
bool hangs_together(const Raster<ClassId>& labels, ClassId id) {
  std::vector<std::pair<int, int>> waiting;
  std::set<std::pair<int, int>> seen;
  for (int row = 0; row < labels.height() && waiting.empty(); ++row) {
    for (int column = 0; column < labels.width() && waiting.empty(); ++column) {
      if (labels.at(column, row) == id) waiting.emplace_back(column, row);
    }
  }
  while (!waiting.empty()) {
    const auto [column, row] = waiting.back();
    waiting.pop_back();
    if (!labels.contains(column, row) || labels.at(column, row) != id ||
        !seen.insert({column, row}).second)
      continue;
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) waiting.emplace_back(column + dx, row + dy);
    }
  }
  return !seen.empty() && static_cast<std::int64_t>(seen.size()) == count(labels, id);
}

TEST(LabelRaster, ThinLinesKeepACellEverywhereAlongTheirCentre) {
  for (std::uint32_t step = 0; step < 200; ++step) {
    Ring places;
    for (std::uint32_t i = 0; i < 6; ++i) {
      const auto [x, y] = uniforms({5, 0, step, 0, i});
      places.emplace_back(2.0 + 36.0 * x, -2.0 - 26.0 * y);
    }
    const auto labels = rasterise(document_of({line(kCurb, places, 0.05 + 0.3 * (step % 3))}));
    ASSERT_TRUE(hangs_together(labels, kCurb)) << step;
    for (std::size_t i = 1; i < places.size(); ++i) {
      for (double t = 0.0; t <= 1.0;
           t += 0.01) {  // A labelled cell is never farther off than its neighbour.
        const Eigen::Vector2d point = places[i - 1] + t * (places[i] - places[i - 1]);
        bool is_near = false;
        for (int dx = -1; dx <= 1; ++dx) {
          for (int dy = -1; dy <= 1; ++dy) {
            const int column = static_cast<int>(std::floor(point.x())) + dx;
            const int row = static_cast<int>(std::floor(-point.y())) + dy;
            is_near = is_near || (labels.contains(column, row) && labels.at(column, row) == kCurb);
          }
        }
        ASSERT_TRUE(is_near) << step;
      }
    }
  }
}

TEST(LabelRaster, AThinStraightLineIsOneCellWide) {
  EXPECT_THAT(picture({line(kCurb, ring({{0, 1}, {6, 1}}), 0.1)}, 6, 3),
              ElementsAre("CCCCCC", "......", "......"));
  const auto labels = rasterise(document_of({line(kCurb, ring({{0, 3}, {40, 20.3}}), 0.2)}));
  for (int column = 1; column < 39; ++column) {
    int cells = 0;
    for (int row = 0; row < 30; ++row) cells += labels.at(column, row) == kCurb ? 1 : 0;
    EXPECT_EQ(cells, 1) << column;
  }
}

TEST(LabelRaster, OutlinesLeaveTheirInsideUnclassified) {
  EXPECT_THAT(
      picture({area(kTerrain, {box(0, 0, 9, 7)}, 1), outline(kBuilding, {box(1, 1, 8, 6)}, 1.2, 2)},
              9, 7),
      ElementsAre("TTTTTTTTT",  //
                  "TBBBBBBBT",  //
                  "TB.....BT",  //
                  "TB.....BT",  //
                  "TB.....BT",  //
                  "TBBBBBBBT",  //
                  "TTTTTTTTT"));
}

TEST(LabelRaster, OutlinesKeepACellHoweverThinTheyAre) {
  EXPECT_THAT(picture({outline(kBuilding, {box(1, 1, 6, 5)}, 0.1)}, 7, 6),
              ElementsAre(".......",  //
                          ".BBBBB.",  //
                          ".B...B.",  //
                          ".B...B.",  //
                          ".BBBBB.",  //
                          "......."));
  // A wall of a fifth of a cell between centres.
  EXPECT_THAT(picture({outline(kBuilding, {box(1, 1.6, 6, 1.8)}, 0.1)}, 7, 3),
              ElementsAre(".......", ".BBBBBB", "......."));
}

TEST(LabelRaster, DrawsByOrderThenByNumber) {
  LabelObject below = area(kRoad, {box(0, 0, 3, 1)}, 5);
  LabelObject above = area(kTerrain, {box(1, 0, 4, 1)}, 6);
  EXPECT_THAT(picture({below, above}, 4, 1), ElementsAre("RRRT"));  // Roads lie on terrain.
  above.order = below.order;
  EXPECT_THAT(picture({below, above}, 4, 1), ElementsAre("RTTT"));
  above.order = below.order + 1;
  EXPECT_THAT(picture({below, above}, 4, 1), ElementsAre("RTTT"));
}

TEST(LabelRaster, PaintLiesInTheLevelOfItsClass) {
  LabelDocument document = document_of({area(kTerrain, {box(0, 0, 6, 3)}, 1),
                                        line(kLaneMarking, ring({{0, 1.5}, {6, 1.5}}), 1.0, 2)},
                                       6, 3);
  document.apply(painting(document, {1, 0, 3, 3}, kRoad));
  document.apply(painting(document, {3, 0, 4, 3}, kRoad + kPaintOver));
  document.apply(painting(document, {4, 0, 5, 3}, kUnclassified));
  EXPECT_THAT(picture(rasterise(document)), ElementsAre("TRRR.T",  //
                                                        "LLLR.L",  //
                                                        "TRRR.T"));
}

TEST(LabelRaster, AnyWindowEqualsTheSamePartOfTheWhole) {
  LabelDocument document = test_document(90, 70);
  for (std::uint32_t step = 0; step < 120; ++step) document.apply(random_edit(document, 21, step));
  for (const double metres_per_cell : {1.0, 0.37, 2.9}) {
    const LabelGrid grid{metres_per_cell,
                         {-3.3, 4.1},
                         static_cast<int>(90 / metres_per_cell),
                         static_cast<int>(75 / metres_per_cell)};
    const auto whole = rasterise(document, grid, grid.whole());
    for (std::uint32_t i = 0; i < 60; ++i) {
      const auto [x, y] = uniforms({22, 0, i, 0, 0});
      const auto [w, h] = uniforms({22, 0, i, 0, 1});
      const auto left = static_cast<std::int64_t>(x * grid.width);
      const auto top = static_cast<std::int64_t>(y * grid.height);
      const CellRect window = CellRect{left, top, left + 1 + static_cast<std::int64_t>(w * 40),
                                       top + 1 + static_cast<std::int64_t>(h * 40)}
                                  .cut_to(grid.whole());
      const auto part = rasterise(document, grid, window);
      for (std::int64_t row = window.top; row < window.bottom; ++row) {
        for (std::int64_t column = window.left; column < window.right; ++column) {
          ASSERT_EQ(
              part.at(static_cast<int>(column - window.left), static_cast<int>(row - window.top)),
              whole.at(static_cast<int>(column), static_cast<int>(row)))
              << metres_per_cell << " window " << i << " at " << column << ", " << row;
        }
      }
    }
  }
}

TEST(LabelRaster, IsTheSameOnOneThreadAndOnFour) {
  LabelDocument document = test_document(300, 300);
  for (std::uint32_t step = 0; step < 200; ++step) document.apply(random_edit(document, 23, step));
  const auto on_threads = [&](int threads) {
    const ThreadLimit limit(threads);
    return rasterise(document);
  };
  EXPECT_EQ(on_threads(1), on_threads(4));
}

TEST(LabelRaster, HoldsNoClassThatNobodyDrewAtAnyResolution) {
  LabelDocument document = test_document(200, 200);
  std::set<ClassId> drawn_classes{kUnclassified};
  for (std::uint32_t step = 0; step < 150; ++step) document.apply(random_edit(document, 24, step));
  for (const auto& [id, placed] : document.objects()) drawn_classes.insert(placed.object->class_id);
  for (const auto& [address, tile] : document.paint()) {
    for (const PaintValue value : tile->values) {
      if (value != kNoPaint) drawn_classes.insert(painted_class(value));
    }
  }
  for (const double metres_per_cell : {0.5, 1.0, 2.0, 4.0, 8.0, 16.0}) {
    const LabelGrid grid{metres_per_cell,
                         {0.0, 0.0},
                         static_cast<int>(200 / metres_per_cell),
                         static_cast<int>(200 / metres_per_cell)};
    const auto labels = rasterise(document, grid, grid.whole());
    for (const ClassId id : labels.values()) ASSERT_EQ(drawn_classes.count(id), 1U);
  }
}

TEST(LabelRaster, AnAreaFarOutsideOrHugeCostsNothingAndIsRight) {
  EXPECT_EQ(count(rasterise(document_of({area(kRoad, {box(5e5, 5e5, 6e5, 6e5)})})), kRoad), 0);
  EXPECT_EQ(count(rasterise(document_of({area(kRoad, {box(-9e5, -9e5, 9e5, 9e5)})})), kRoad),
            40 * 30);
  EXPECT_EQ(
      count(rasterise(document_of({line(kRoad, ring({{-9e5, 15.0}, {9e5, 15.0}}), 10.0)})), kRoad),
      40 * 10);
}

TEST(ChangedCells, HoldAllThatAnEditChanges) {
  LabelDocument document = test_document(60, 50);
  const LabelGrid fine{0.4, {-5.0, 6.0}, 180, 150};
  for (const LabelGrid& grid : {document.grid(), fine}) {
    auto before = rasterise(document, grid, grid.whole());
    for (std::uint32_t step = 0; step < 150; ++step) {
      const LabelEdit edit = random_edit(document, 25, step);
      document.apply(edit);
      const CellRect changed = changed_cells(edit, document.grid(), grid);
      const auto after = rasterise(document, grid, grid.whole());
      for (int row = 0; row < grid.height; ++row) {
        for (int column = 0; column < grid.width; ++column) {
          const bool is_inside = column >= changed.left && column < changed.right &&
                                 row >= changed.top && row < changed.bottom;
          ASSERT_TRUE(is_inside || before.at(column, row) == after.at(column, row)) << step;
        }
      }
      before = after;
    }
  }
}

TEST(ChangedCells, AreNoneWhereNothingIsDrawn) {
  const LabelDocument document = test_document();
  const LabelEdit edit{
      "Name", {}, {}, {{"name", {nullptr, std::make_shared<const std::string>("a")}}}};
  EXPECT_TRUE(changed_cells(edit, document.grid(), document.grid()).empty());
}

TEST(MeanWidth, IsThatOfALongThinRing) {
  EXPECT_NEAR(mean_width(std::vector<Ring>{box(0, 0, 1000, 2)}), 2.0, 0.01);
  EXPECT_NEAR(mean_width(std::vector<Ring>{box(1e6, 1e6, 1e6 + 1000, 1e6 + 2)}), 2.0, 0.01);
  EXPECT_EQ(mean_width(std::vector<Ring>{}), 0.0);
}

}  // namespace label_raster_test
}  // namespace nadir
