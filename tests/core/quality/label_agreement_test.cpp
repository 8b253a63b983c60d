// SPDX-License-Identifier: Apache-2.0
#include "core/quality/label_agreement.h"

#include <gmock/gmock.h>

#include <set>
#include <tuple>

#include "tests/core/edit/edited_labels.h"

namespace nadir {
namespace label_agreement_test {

using testing::IsEmpty;
using testing::Optional;

LabelDocument random_document(std::uint64_t seed, std::uint32_t steps) {
  LabelDocument document = test_document(60, 50);
  for (std::uint32_t step = 0; step < steps; ++step) {
    document.apply(random_edit(document, seed, step));
  }
  return document;
}

ConfusionMatrix confusion(const LabelDocument& mine, const LabelDocument& theirs) {
  auto matrix = confusion_of(mine, theirs, mine.grid(), mine.grid().whole());
  EXPECT_TRUE(matrix) << error_text(matrix);
  return *matrix;
}

std::vector<DisagreementRegion> regions_of(const LabelDocument& mine,
                                           const LabelDocument& theirs,
                                           double least_m2 = 0.0) {
  auto regions = disagreements(mine, theirs, mine.grid(), mine.grid().whole(), least_m2);
  EXPECT_TRUE(regions) << error_text(regions);
  return *regions;
}

TEST(Agreement, KappaOfTheTextbook) {
  // Two readers of 50 applications: 20 both yes, 15 both no, 5 and 10 where they differ; kappa is 0.4.
  ConfusionMatrix matrix;
  matrix.cells[kRoad][kRoad] = 20;
  matrix.cells[kRoad][kTerrain] = 5;
  matrix.cells[kTerrain][kRoad] = 10;
  matrix.cells[kTerrain][kTerrain] = 15;
  const AgreementSummary summary = summary_of(matrix);
  EXPECT_THAT(summary.agreement, Optional(0.7));
  ASSERT_TRUE(summary.kappa);
  EXPECT_NEAR(*summary.kappa, 0.4, 1e-12);
  // Of two classes each is the other's complement.
  EXPECT_NEAR(*summary.classes[kRoad].kappa, 0.4, 1e-12);
  EXPECT_NEAR(*summary.classes[kTerrain].kappa, 0.4, 1e-12);
  EXPECT_NEAR(*summary.classes[kRoad].iou, 20.0 / 35.0, 1e-12);
  EXPECT_FALSE(summary.classes[kCurb].iou);
  EXPECT_FALSE(summary.classes[kCurb].kappa);
}

TEST(Agreement, KappaOfThreeClassesIsCohensOwn) {
  // Cohen, Weighted kappa, 1968: 200 judgements of two psychologists, whose unweighted kappa is 0.492.
  ConfusionMatrix matrix;
  const std::array<std::array<int, 3>, 3> shares{{{88, 14, 18}, {10, 40, 10}, {2, 6, 12}}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) matrix.cells.at(i).at(j) = shares.at(i).at(j);
  }
  const AgreementSummary summary = summary_of(matrix);
  EXPECT_NEAR(*summary.agreement, 0.70, 1e-12);
  const double expected = 0.6 * 0.5 + 0.3 * 0.3 + 0.1 * 0.2;
  EXPECT_NEAR(*summary.kappa, (0.70 - expected) / (1.0 - expected), 1e-12);
  EXPECT_NEAR(*summary.kappa, 0.492, 5e-4);
}

TEST(Agreement, OfEqualLabelsIsWholeAndOfOneClassHasNoKappa) {
  const LabelDocument document =
      document_of({area(kTerrain, {box(0, 0, 40, 30)}, 1), area(kRoad, {box(0, 10, 40, 20)}, 2)});
  const AgreementSummary same = summary_of(confusion(document, document));
  EXPECT_THAT(same.kappa, Optional(1.0));
  EXPECT_THAT(same.classes[kRoad].iou, Optional(1.0));
  EXPECT_EQ(same.unlabelled_share(), 0.0);
  const LabelDocument plain = document_of({area(kTerrain, {box(0, 0, 40, 30)}, 1)});
  EXPECT_FALSE(summary_of(confusion(plain, plain)).kappa);
  EXPECT_THAT(regions_of(document, document), IsEmpty());
  const AgreementSummary nothing = summary_of(confusion(test_document(), test_document()));
  EXPECT_FALSE(nothing.agreement);
  EXPECT_EQ(nothing.neither, 1200);
  EXPECT_EQ(nothing.unlabelled_share(), 1.0);
}

TEST(Agreement, WhatOnlyOneHasLabelledCountsApart) {
  const LabelDocument mine = document_of({area(kRoad, {box(0, 0, 20, 30)}, 1)});
  const LabelDocument theirs = document_of({area(kRoad, {box(10, 0, 25, 30)}, 1)});
  const AgreementSummary summary = summary_of(confusion(mine, theirs));
  EXPECT_EQ(summary.cells, 300);
  EXPECT_EQ(summary.only_mine, 300);
  EXPECT_EQ(summary.only_theirs, 150);
  EXPECT_EQ(summary.neither, 450);
  EXPECT_THAT(summary.agreement, Optional(1.0));
  EXPECT_EQ(summary.unlabelled_share(), 0.75);
}

TEST(Agreement, OfRandomLabelsIsThatOfTheirCells) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const LabelDocument mine = random_document(seed, 20);
    const LabelDocument theirs = random_document(seed + 100, 20);
    const Raster<ClassId> a = rasterise(mine);
    const Raster<ClassId> b = rasterise(theirs);
    ConfusionMatrix matrix;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const auto index = [](ClassId id) { return id == kUnclassified ? std::size_t{16} : id; };
      ++matrix.cells[index(a.values()[i])][index(b.values()[i])];
    }
    EXPECT_EQ(confusion(mine, theirs), matrix) << seed;
    const Raster<CellAgreement> told =
        cell_agreement(mine, theirs, mine.grid(), mine.grid().whole());
    for (std::size_t i = 0; i < a.size(); ++i) {
      const bool has_mine = a.values()[i] != kUnclassified;
      const bool has_theirs = b.values()[i] != kUnclassified;
      const CellAgreement wanted = !has_mine && !has_theirs         ? CellAgreement::kNeither
                                   : !has_theirs                    ? CellAgreement::kOnlyMine
                                   : !has_mine                      ? CellAgreement::kOnlyTheirs
                                   : a.values()[i] == b.values()[i] ? CellAgreement::kAgree
                                                                    : CellAgreement::kDiffer;
      ASSERT_EQ(told.values()[i], wanted);
    }
  }
}

TEST(Disagreements, CoverEachCellThatDiffersOnce) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const LabelDocument mine = random_document(seed, 20);
    const LabelDocument theirs = random_document(seed + 100, 20);
    const ConfusionMatrix matrix = confusion(mine, theirs);
    ConfusionMatrix told;
    const auto regions = regions_of(mine, theirs);
    for (const DisagreementRegion& region : regions) {
      const auto index = [](ClassId id) { return std::min<std::size_t>(id, kClassCount); };
      told.cells[index(region.mine)][index(region.theirs)] += region.cells;
      EXPECT_NE(region.mine, region.theirs);
    }
    for (std::size_t i = 0; i < ConfusionMatrix::kSide; ++i) {
      told.cells.at(i).at(i) = matrix.cells.at(i).at(i);
    }
    EXPECT_EQ(told, matrix);
    for (std::size_t i = 1; i < regions.size(); ++i) {
      EXPECT_GE(regions[i - 1].cells, regions[i].cells);
    }
  }
}

TEST(Disagreements, SmallOnesAreLeftOut) {
  const LabelDocument mine = document_of({area(kRoad, {box(0, 0, 40, 30)}, 1)});
  const LabelDocument theirs =
      document_of({area(kRoad, {box(0, 0, 40, 30)}, 1), area(kCurb, {box(2, 2, 3, 3)}, 2),
                   area(kCurb, {box(10, 10, 14, 15)}, 3)});
  const auto regions = regions_of(mine, theirs, 2.0);
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(regions[0].size_m2, 20.0);
  EXPECT_EQ(regions[0].mine, kRoad);
  EXPECT_EQ(regions[0].theirs, kCurb);
  EXPECT_EQ(regions[0].bounds.low, Eigen::Vector2d(10, -15));
}

TEST(TakeTheirs, TakesOverReplacesOrRemovesAnObjectThatIsTheWholeRegion) {
  const LabelObject ground = area(kTerrain, {box(0, 0, 40, 30)}, 1);
  const LabelObject road = area(kRoad, {box(5, 5, 15, 15)}, 2);
  const auto taken = [](const LabelDocument& mine, const LabelDocument& theirs) {
    const auto regions = regions_of(mine, theirs);
    EXPECT_EQ(regions.size(), 1U);
    return edited(mine, take_theirs(mine, theirs, mine.grid(), regions.at(0)));
  };
  const LabelDocument without = document_of({ground});
  const LabelDocument with = document_of({ground, road});
  EXPECT_TRUE(taken(without, with) == with);
  EXPECT_TRUE(taken(with, without) == without);
  const LabelDocument wider = document_of({ground, area(kRoad, {box(5, 5, 25, 15)}, 2)});
  EXPECT_TRUE(taken(with, wider) == wider);
  // An object of theirs whose number is something else in mine.
  const LabelDocument other = document_of(
      {ground, area(kSidewalk, {box(30, 20, 35, 25)}, 2), area(kRoad, {box(5, 5, 15, 15)}, 3)});
  const LabelDocument mine = document_of({ground, area(kSidewalk, {box(30, 20, 35, 25)}, 3)});
  const LabelDocument after = taken(mine, other);
  EXPECT_EQ(after.objects().size(), 3U);
  EXPECT_TRUE(rasterise(after) == rasterise(other));
}

TEST(TakeTheirs, PaintsAPartAndErasesPaintThatTheyHaveNot) {
  const LabelObject ground = area(kTerrain, {box(0, 0, 40, 30)}, 1);
  const LabelDocument mine = document_of({ground});
  LabelDocument theirs = mine;
  theirs.apply(painting(theirs, {3, 4, 9, 8}, kVegetation));
  const auto regions = regions_of(mine, theirs);
  ASSERT_EQ(regions.size(), 1U);
  const LabelDocument after = edited(mine, take_theirs(mine, theirs, mine.grid(), regions[0]));
  EXPECT_TRUE(rasterise(after) == rasterise(theirs));
  EXPECT_EQ(after.paint_at(3, 4), kVegetation) << "in its level, not over everything";
  const LabelDocument back =
      edited(after, take_theirs(after, mine, mine.grid(), regions_of(after, mine).at(0)));
  EXPECT_TRUE(back == mine);
}

TEST(TakeTheirs, OfEveryRegionMakesMineTheirs) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    LabelDocument mine = random_document(seed, 15);
    const LabelDocument theirs = random_document(seed + 50, 15);
    const auto differing = [&] {
      std::int64_t cells = 0;
      for (const DisagreementRegion& region : regions_of(mine, theirs)) cells += region.cells;
      return cells;
    };
    for (std::int64_t left = differing(); left > 0;) {
      const auto edit = take_theirs(mine, theirs, mine.grid(), regions_of(mine, theirs).at(0));
      ASSERT_TRUE(edit) << error_text(edit);
      mine = edited(mine, edit);
      ASSERT_LT(differing(), left);
      left = differing();
    }
    EXPECT_TRUE(rasterise(mine) == rasterise(theirs)) << seed;
  }
}

TEST(TakeTheirs, RefusesARegionThatIsGone) {
  const LabelDocument mine = document_of({area(kTerrain, {box(0, 0, 40, 30)}, 1)});
  const LabelDocument theirs =
      document_of({area(kTerrain, {box(0, 0, 40, 30)}, 1), area(kRoad, {box(2, 2, 9, 9)}, 2)});
  const auto region = regions_of(mine, theirs).at(0);
  const auto edit = take_theirs(theirs, theirs, mine.grid(), region);
  ASSERT_FALSE(edit);
  EXPECT_EQ(edit.error().message, "the labels have changed since they were compared");
}

TEST(Agreement, StopsWhenTold) {
  std::stop_source stop;
  stop.request_stop();
  const LabelDocument document = test_document();
  const auto matrix = confusion_of(document, document, document.grid(), document.grid().whole(),
                                   {stop.get_token(), {}});
  ASSERT_FALSE(matrix);
  EXPECT_EQ(matrix.error().code, ErrorCode::kCancelled);
  EXPECT_FALSE(disagreements(document, document, document.grid(), document.grid().whole(), 0.0,
                             {stop.get_token(), {}}));
}

}  // namespace label_agreement_test
}  // namespace nadir
