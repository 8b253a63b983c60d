// SPDX-License-Identifier: Apache-2.0
#include "core/label/paint_objects.h"

#include <gmock/gmock.h>

#include "core/label/label_raster.h"
#include "tests/core/label/drawn_labels.h"
#include "tests/support/error_text.h"

namespace nadir {
namespace paint_objects_test {

using testing::HasSubstr;

LabelDocument after(LabelDocument document, const Result<LabelEdit>& edit) {
  if (!edit) throw std::logic_error(error_text(edit));
  const auto fits = document.check(*edit);
  if (!fits) throw std::logic_error(error_text(fits));
  document.apply(*edit);
  return document;
}

LabelDocument painted(const std::vector<std::string>& rows) {
  LabelDocument document = test_document(40, 30);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (std::size_t column = 0; column < rows[row].size(); ++column) {
      if (rows[row][column] == '.') continue;
      const auto x = static_cast<std::int64_t>(column);
      const auto y = static_cast<std::int64_t>(row);
      document.apply(
          painting(document, {x, y, x + 1, y + 1}, rows[row][column] == 'R' ? kRoad : kBuilding));
    }
  }
  return document;
}

TEST(PaintObjects, AFourBySixObjectComesBackExactly) {
  LabelDocument document = test_document();
  document.apply(painting(document, {7, 9, 11, 15}, kBuilding));
  const LabelDocument objects = after(document, paint_to_objects(document));
  ASSERT_EQ(objects.objects().size(), 1U);
  EXPECT_TRUE(objects.paint().empty());
  EXPECT_EQ(objects.objects().begin()->second.object->rings.front().size(), 4U);
  EXPECT_EQ(rasterise(objects), rasterise(document));
  const LabelDocument back = after(objects, objects_to_paint(objects, std::array{ObjectId{1}}));
  EXPECT_TRUE(back.objects().empty());
  EXPECT_EQ(rasterise(back), rasterise(document));
  EXPECT_EQ(*back.tile({0, 0}), *document.tile({0, 0}));
}

TEST(PaintObjects, AOneCellHoleSurvives) {
  const LabelDocument document = painted({"RRRRR", "RR.RR", "RRRRR"});
  const LabelDocument objects = after(document, paint_to_objects(document));
  ASSERT_EQ(objects.objects().size(), 1U);
  EXPECT_EQ(objects.objects().begin()->second.object->rings.size(), 2U);
  EXPECT_EQ(rasterise(objects), rasterise(document));
}

TEST(PaintObjects, CellsThatTouchByACornerAreTwo) {
  const LabelDocument document = painted({"R.R", ".R.", "RRR", "R.R", ".R."});
  const LabelDocument objects = after(document, paint_to_objects(document));
  EXPECT_EQ(rasterise(objects), rasterise(document));
  EXPECT_EQ(objects.objects().size(), 4U);
}

TEST(PaintObjects, TurnsAnyPaintIntoObjectsWithoutLoss) {
  LabelDocument document = test_document(600, 500);
  for (std::uint32_t step = 0; step < 250; ++step) document.apply(random_edit(document, 71, step));
  document.apply(painting(document, {100, 100, 420, 330}, kRoad));
  ASSERT_FALSE(document.paint().empty());
  const LabelDocument objects = after(document, paint_to_objects(document));
  EXPECT_TRUE(objects.paint().empty());
  EXPECT_EQ(rasterise(objects), rasterise(document));
}

TEST(PaintObjects, TurnsAnyObjectsIntoPaintWithoutLoss) {
  for (std::uint64_t seed = 81; seed < 86; ++seed) {
    LabelDocument document = test_document(120, 90);
    for (std::uint32_t step = 0; step < 120; ++step)
      document.apply(random_edit(document, seed, step));
    std::vector<ObjectId> some;
    for (const auto& [id, placed] : document.objects()) {
      if (id % 2 == 0) some.push_back(id);
    }
    const LabelDocument paint = after(document, objects_to_paint(document, some));
    EXPECT_EQ(paint.objects().size(), document.objects().size() - some.size());
    EXPECT_EQ(rasterise(paint), rasterise(document)) << seed;
  }
}

TEST(PaintObjects, PaintOfARoadStaysBelowItsMarkings) {
  LabelDocument document = document_of({area(kRoad, {box(0, 0, 20, 8)}, 1)});
  document = after(document, objects_to_paint(document, std::array{ObjectId{1}}));
  document.apply(adding({line(kLaneMarking, ring({{0, 4}, {20, 4}}), 1.0, 2)}));
  const auto labels = rasterise(document);
  EXPECT_EQ(std::count(labels.values().begin(), labels.values().end(), kLaneMarking), 20);
}

TEST(PaintObjects, NamesAnObjectThatIsNotThere) {
  EXPECT_THAT(error_text(objects_to_paint(test_document(), std::array{ObjectId{5}})),
              HasSubstr("no object 5"));
}

TEST(Polygonise, PutsEveryCellIntoOneRegion) {
  Raster<std::uint8_t> values(50, 40);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values.values()[i] = static_cast<std::uint8_t>(
        random_words({91, 0, static_cast<std::uint32_t>(i), 0, 0})[0] % 3);
  }
  const auto regions = polygonise(values, 2);
  ASSERT_TRUE(regions) << error_text(regions);
  Raster<int> claims(50, 40, 0);
  for (const CellRegion& region : *regions) {
    LabelObject object = area(kRoad, region.rings_in_cells);
    for (Ring& places : object.rings) {
      for (Eigen::Vector2d& point : places) point.y() = -point.y();
    }
    const auto cells = rasterise(document_of({object}, 50, 40));
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (cells.values()[i] != kRoad) continue;
      ASSERT_EQ(values.values()[i], region.value);
      ++claims.values()[i];
    }
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    ASSERT_EQ(claims.values()[i], values.values()[i] == 2 ? 0 : 1);
  }
}

TEST(Polygonise, OfNothingIsNothing) {
  EXPECT_TRUE(polygonise(Raster<std::uint8_t>(), 0)->empty());
  EXPECT_TRUE(polygonise(Raster<std::uint8_t>(4, 4, 7), 7)->empty());
}

}  // namespace paint_objects_test
}  // namespace nadir
