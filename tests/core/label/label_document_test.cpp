// SPDX-License-Identifier: Apache-2.0
#include "core/label/label_document.h"

#include <gmock/gmock.h>

#include "tests/core/label/drawn_labels.h"
#include "tests/support/error_text.h"

namespace nadir {
namespace label_document_test {

using testing::HasSubstr;

LabelEdit replacing(const LabelDocument& document, const LabelObject& object) {
  return {"Change",
          {{document.object(object.id), std::make_shared<const LabelObject>(object)}},
          {},
          {}};
}

TEST(LabelDocument, HoldsWhatAnEditAdds) {
  const LabelDocument document = document_of({area(kRoad, {box(0, 0, 5, 5)}, 3)});
  ASSERT_NE(document.object(3), nullptr);
  EXPECT_EQ(document.object(3)->class_id, kRoad);
  EXPECT_EQ(document.object(4), nullptr);
  EXPECT_EQ(document.next_id(), 4);
}

TEST(LabelDocument, GivesNoNumberTwice) {
  LabelDocument document = document_of({area(kRoad, {box(0, 0, 5, 5)}, 8)});
  document.apply({"Delete", {{document.object(8), nullptr}}, {}, {}});
  EXPECT_EQ(document.next_id(), 9);
}

TEST(LabelDocument, ComesBackByTheReversedEdits) {
  LabelDocument document = test_document();
  const LabelDocument empty = document;
  std::vector<LabelEdit> edits;
  for (std::uint32_t step = 0; step < 200; ++step) {
    edits.push_back(random_edit(document, 1, step));
    ASSERT_TRUE(document.check(edits.back())) << step << error_text(document.check(edits.back()));
    document.apply(edits.back());
  }
  EXPECT_FALSE(document == empty);
  while (!edits.empty()) {
    const LabelEdit back = reversed(edits.back());
    ASSERT_TRUE(document.check(back));
    document.apply(back);
    edits.pop_back();
  }
  EXPECT_TRUE(document == empty);
}

TEST(LabelDocument, RefusesAnEditOfAnotherState) {
  LabelDocument document = document_of({area(kRoad, {box(0, 0, 5, 5)})});
  LabelObject wider = *document.object(1);
  wider.rings.front()[1].x() = 9.0;
  const LabelEdit edit = replacing(document, wider);
  LabelObject other = wider;
  other.note = "meanwhile";
  document.apply(replacing(document, other));
  EXPECT_EQ(error_text(document.check(edit)), "Change: object 1 has changed since");
  EXPECT_THAT(error_text(document.check(adding({wider}))), HasSubstr("has changed since"));
}

TEST(LabelDocument, RefusesEditsThatMakeNoSense) {
  const LabelDocument document = document_of({area(kRoad, {box(0, 0, 5, 5)})});
  EXPECT_FALSE(document.check({"Nothing", {{nullptr, nullptr}}, {}, {}}));
  EXPECT_FALSE(document.check(
      adding({area(kRoad, {box(0, 0, 1, 1)}, 2), area(kRoad, {box(0, 0, 1, 1)}, 2)})));
  EXPECT_THAT(
      error_text(document.check(adding({area(kRoad, {ring({{0, 0}, {1, 1}})}, 2)}, "Draw road"))),
      HasSubstr("Draw road: area 2: a ring has 2"));
  auto renumbered = std::make_shared<LabelObject>(*document.object(1));
  renumbered->id = 2;
  EXPECT_FALSE(document.check({"Renumber", {{document.object(1), renumbered}}, {}, {}}));
  auto tile = std::make_shared<PaintTile>();
  EXPECT_FALSE(document.check({"Blank", {}, {{{0, 0}, {nullptr, tile}}}, {}}));
  tile->at(3, 3) = 99;
  EXPECT_FALSE(document.check({"No class", {}, {{{0, 0}, {nullptr, tile}}}, {}}));
  tile->at(3, 3) = kRoad;
  EXPECT_TRUE(document.check({"Road", {}, {{{0, 0}, {nullptr, tile}}}, {}}));
  EXPECT_FALSE(document.check({"Far", {}, {{{kMostPaintAddress + 1, 0}, {nullptr, tile}}}, {}}));
}

TEST(LabelDocument, KnowsItsPaintOnAllSidesOfItsCorner) {
  LabelDocument document = test_document();
  document.apply(painting(document, {-300, -2, 3, 1}, kRoad));
  EXPECT_EQ(document.paint().size(), 6U);
  EXPECT_EQ(document.paint_at(-300, -2), kRoad);
  EXPECT_EQ(document.paint_at(-256, -1), kRoad);
  EXPECT_EQ(document.paint_at(2, 0), kRoad);
  EXPECT_EQ(document.paint_at(-301, -2), kNoPaint);
  EXPECT_EQ(document.paint_at(3, 0), kNoPaint);
  EXPECT_EQ(document.paint_at(0, 1), kNoPaint);
  EXPECT_EQ(document.paint_at(std::int64_t{1} << 50U, 0), kNoPaint);
}

TEST(LabelDocument, PutsNewObjectsAboveThoseOfTheirLevelOnly) {
  LabelDocument document = document_of({area(kRoad, {box(0, 0, 5, 5)}, 1)});
  EXPECT_EQ(document.next_order(kRoad), document.object(1)->order + kOrderStep);
  EXPECT_EQ(level_of_order(document.next_order(kRoad)), drawing_level(kRoad));
  EXPECT_EQ(level_of_order(document.next_order(kTerrain)), drawing_level(kTerrain));
  LabelObject top = *document.object(1);
  top.order = (drawing_level(kRoad) + 1) * kOrdersPerLevel - 1;
  document.apply(replacing(document, top));
  EXPECT_EQ(document.next_order(kRoad), top.order);
}

TEST(LabelDocument, SharesWhatItHoldsWithItsCopies) {
  LabelDocument document = document_of({area(kRoad, {box(0, 0, 5, 5)})});
  const LabelDocument copy = document;
  EXPECT_EQ(copy.object(1), document.object(1));
  document.apply({"Delete", {{document.object(1), nullptr}}, {}, {}});
  EXPECT_NE(copy.object(1), nullptr);
}

TEST(LabelDifference, LeadsFromOneDocumentToTheOther) {
  LabelDocument from = test_document();
  for (std::uint32_t step = 0; step < 60; ++step) from.apply(random_edit(from, 2, step));
  LabelDocument to = from;
  for (std::uint32_t step = 60; step < 120; ++step) to.apply(random_edit(to, 2, step));
  const LabelEdit edit = difference(from, to, "Compare");
  EXPECT_EQ(edit.title, "Compare");
  ASSERT_TRUE(from.check(edit));
  from.apply(edit);
  EXPECT_TRUE(from == to);
  EXPECT_TRUE(difference(from, to, {}).empty());
}

}  // namespace label_document_test
}  // namespace nadir
