// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>

#include "core/quality/label_checks.h"
#include "tests/core/edit/edited_labels.h"

namespace nadir {
namespace label_fixes_test {

using testing::HasSubstr;
using testing::IsEmpty;

LabelObject ground(ObjectId id = 100) { return area(kTerrain, {box(0, 0, 40, 30)}, id); }

std::vector<Finding> findings_of(const LabelDocument& document,
                                 FindingKind kind,
                                 const CheckSettings& settings) {
  auto findings = check_labels(document, document.grid(), settings);
  EXPECT_TRUE(findings) << error_text(findings);
  if (!findings) return {};
  std::erase_if(*findings, [kind](const Finding& finding) { return finding.kind != kind; });
  return *findings;
}

/// The document after the one finding of a kind was mended, which must be gone then.
LabelDocument mended(const LabelDocument& document,
                     FindingKind kind,
                     const CheckSettings& settings = {}) {
  const auto findings = findings_of(document, kind, settings);
  EXPECT_EQ(findings.size(), 1U);
  if (findings.empty()) return document;
  const auto edit = fix(document, document.grid(), findings[0], settings);
  EXPECT_TRUE(edit && !edit->empty()) << error_text(edit);
  LabelDocument after = edited(document, edit);
  EXPECT_THAT(findings_of(after, kind, settings), IsEmpty());
  const auto again = fix(after, after.grid(), findings[0], settings);
  EXPECT_TRUE(!again || kind == FindingKind::kOverlap || kind == FindingKind::kSelfCrossing ||
              kind == FindingKind::kOpenOutline);
  return after;
}

/// Cells whose class is not the same.
int changed_count(const LabelDocument& before, const LabelDocument& after) {
  const Raster<ClassId> was = rasterise(before);
  const Raster<ClassId> is = rasterise(after);
  int count = 0;
  for (std::size_t i = 0; i < was.size(); ++i) count += was.values()[i] != is.values()[i] ? 1 : 0;
  return count;
}

TEST(FixFinding, AnIslandTakesTheClassAroundItAlsoFromALowerLevel) {
  const LabelDocument document = document_of(
      {ground(),
       area(kRoad, {ring({{10, 10}, {12, 10}, {12, 12}, {11, 12}, {11, 11}, {10, 11}})}, 2)});
  const LabelDocument after = mended(document, FindingKind::kIsland, {.island_m2 = 5.0});
  EXPECT_EQ(changed_count(document, after), 3);
  EXPECT_EQ(rasterise(after).at(11, 11), kTerrain);
}

TEST(FixFinding, AGapBetweenAreasThatCanShareABorderIsClosedByOneAndElseByPaint) {
  const LabelDocument apart =
      document_of({area(kRoad, {box(0, 0, 40, 10)}, 1), area(kSidewalk, {box(0, 11, 40, 30)}, 2)});
  const CheckSettings settings{.gap_width_m = 1.2};
  const LabelDocument joined = mended(apart, FindingKind::kGap, settings);
  EXPECT_THAT(joined.paint(), IsEmpty());
  EXPECT_EQ(shared_places(joined), 2U);
  EXPECT_EQ(changed_count(apart, joined), 40);
  LabelDocument painted = apart;
  painted.apply(painting(painted, {0, 0, 40, 10}, kRoad));
  painted.apply({"Remove", {{painted.object(1), nullptr}}, {}, {}});
  const LabelDocument filled = mended(painted, FindingKind::kGap, settings);
  EXPECT_EQ(changed_count(painted, filled), 40);
}

TEST(FixFinding, AGapGoesToTheNeighbourWithTheLongestBorder) {
  LabelDocument document = document_of({area(kSidewalk, {box(0, 11, 40, 30)}, 2)});
  document.apply(painting(document, {0, 0, 30, 10}, kRoad));
  document.apply(painting(document, {30, 0, 40, 10}, kVegetation));
  const LabelDocument after = mended(document, FindingKind::kGap, {.gap_width_m = 1.0});
  const Raster<ClassId> cells = rasterise(after);
  for (int x = 0; x < 40; ++x) EXPECT_EQ(cells.at(x, 10), kSidewalk);
}

TEST(FixFinding, OfAnOverlapTheLowerAreaIsClippedAndNoCellChanges) {
  const LabelDocument document =
      document_of({area(kRoad, {box(2, 2, 12, 12)}, 1), area(kRoad, {box(9, 8, 22, 12)}, 2)});
  const LabelDocument after = mended(document, FindingKind::kOverlap);
  EXPECT_EQ(changed_count(document, after), 0);
  const Raster<int> claimed = cells_claimed(after);
  EXPECT_LE(*std::max_element(claimed.values().begin(), claimed.values().end()), 1);
}

TEST(FixFinding, AnOutlineIsNotClipped) {
  const LabelDocument document = document_of({outline(kBuilding, {box(2, 2, 12, 12)}, 1, 1),
                                              outline(kBuilding, {box(9, 8, 22, 12)}, 1, 2)});
  const auto findings = findings_of(document, FindingKind::kOverlap, {});
  ASSERT_EQ(findings.size(), 1U);
  const auto edit = fix(document, document.grid(), findings[0]);
  ASSERT_FALSE(edit);
  EXPECT_THAT(error_text(edit), HasSubstr("walls"));
}

TEST(FixFinding, AnOpenOutlineIsClosedAndEndsThatNearlyMeetAreJoined) {
  const LabelDocument open =
      document_of({line(kFence, ring({{2, 2}, {12, 2}, {12, 12}, {2.3, 2.4}}), 0.2, 1)});
  const LabelDocument closed = mended(open, FindingKind::kOpenOutline);
  EXPECT_EQ(object_in(closed, 1).rings.front().back(), Eigen::Vector2d(2, -2));
  EXPECT_EQ(object_in(closed, 1).rings.front().size(), 5U);
  const LabelDocument apart = document_of({line(kCurb, ring({{20, 2}, {25, 2}}), 0.2, 2),
                                           line(kCurb, ring({{25.3, 2.1}, {30, 8}}), 0.2, 3)});
  const LabelDocument joined = mended(apart, FindingKind::kOpenOutline);
  EXPECT_EQ(shared_places(joined), 1U);
}

TEST(FixFinding, WhatIsNothingGoesAndOfTwoTheLowerOne) {
  const LabelDocument nothing =
      document_of({ground(), area(kSidewalk, {ring({{20, 2}, {30, 2}, {25, 2}})}, 2)});
  EXPECT_EQ(mended(nothing, FindingKind::kDegenerate).object(2), nullptr);
  const LabelDocument twice =
      document_of({area(kRoad, {box(2, 2, 12, 12)}, 1), area(kRoad, {box(2, 2, 12, 12)}, 2)});
  const LabelDocument once = mended(twice, FindingKind::kDuplicate);
  EXPECT_EQ(once.object(1), nullptr);
  EXPECT_EQ(changed_count(twice, once), 0);
}

TEST(FixFinding, WhatCrossesItselfBecomesTheAreasThatItSurrounds) {
  const LabelDocument document =
      document_of({area(kRoad, {ring({{2, 2}, {12, 12}, {12, 2}, {2, 12}})}, 1)});
  const LabelDocument after = mended(document, FindingKind::kSelfCrossing);
  EXPECT_EQ(after.objects().size(), 2U);
  EXPECT_EQ(changed_count(document, after), 0);
}

TEST(FixFinding, SaysWhyWhereThereIsNoOneWay) {
  const LabelDocument document = document_of(
      {area(kTerrain, {box(0, 0, 40, 30), box(5, 5, 12, 9)}, 1),
       area(kRoad, {box(-340, 10, -330, 20)}, 2), line(kCurb, ring({{20, 10}, {35, 10}}), 1.0, 3)});
  const auto findings = check_labels(document, document.grid());
  ASSERT_TRUE(findings);
  ASSERT_EQ(findings->size(), 3U);
  for (const Finding& finding : *findings) {
    EXPECT_FALSE(finding.why_not_fix.empty());
    const auto edit = fix(document, document.grid(), finding);
    ASSERT_FALSE(edit);
    EXPECT_EQ(edit.error().code, ErrorCode::kInvalidOptions);
    EXPECT_EQ(edit.error().message, finding.sentence + ": " + finding.why_not_fix);
  }
}

TEST(FixFinding, RefusesAFindingThatIsGone) {
  const LabelDocument document = document_of({ground(), area(kRoad, {box(10, 10, 12, 11)}, 2)});
  const CheckSettings settings{.island_m2 = 5.0};
  const auto findings = findings_of(document, FindingKind::kIsland, settings);
  ASSERT_EQ(findings.size(), 1U);
  const auto edit = fix(document_of({ground()}), document.grid(), findings[0], settings);
  ASSERT_FALSE(edit);
  EXPECT_EQ(edit.error().message, "road island of 2 m2 in terrain: the labels have changed since");
  const auto grown = fix(document_of({ground(), area(kRoad, {box(10, 10, 14, 11)}, 2)}),
                         document.grid(), findings[0], settings);
  EXPECT_FALSE(grown);
}

TEST(FixFinding, MendingRandomIslandsAndGapsChangesTheirCellsOnly) {
  const CheckSettings settings{.island_m2 = 6.0, .gap_width_m = 2.0};
  int mended_count = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    LabelDocument document = test_document(60, 50);
    for (std::uint32_t step = 0; step < 30; ++step) {
      document.apply(random_edit(document, seed, step));
    }
    for (const FindingKind kind : {FindingKind::kIsland, FindingKind::kGap}) {
      for (const Finding& finding : findings_of(document, kind, settings)) {
        if (!finding.why_not_fix.empty()) continue;
        const auto edit = fix(document, document.grid(), finding, settings);
        ASSERT_TRUE(edit) << error_text(edit);
        const CellRect cells = changed_cells(*edit, document.grid(), document.grid());
        const LabelDocument after = edited(document, edit);
        const int changed = changed_count(document, after);
        ++mended_count;
        if (kind == FindingKind::kIsland) {
          EXPECT_EQ(changed, finding.size) << finding.sentence;
        }
        EXPECT_GT(changed, 0);
        EXPECT_FALSE(cells.empty());
      }
    }
  }
  EXPECT_GT(mended_count, 10);
}

}  // namespace label_fixes_test
}  // namespace nadir
