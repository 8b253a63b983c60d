// SPDX-License-Identifier: Apache-2.0
#include "core/desk/change_log.h"

#include <gmock/gmock.h>

#include "core/desk/label_coverage.h"
#include "core/label/label_raster.h"
#include "tests/core/label/drawn_labels.h"

namespace nadir {
namespace change_log_test {

bool do_hold(const std::vector<PlaneBounds>& parts, const Eigen::Vector2d& place) {
  return std::any_of(parts.begin(), parts.end(), [&](const PlaneBounds& part) {
    return (part.low.array() <= place.array()).all() && (place.array() <= part.high.array()).all();
  });
}

TEST(ChangeLog, TellsNothingOfWhatIsKnown) {
  const ChangeLog log;
  EXPECT_TRUE(log.since(log.revision()).empty());
}

TEST(ChangeLog, TellsApartWhatChangedFarApart) {
  ChangeLog log;
  const std::int64_t before = log.revision();
  const LabelGrid grid = test_grid(1000, 1000);
  log.add(adding({area(kRoad, {box(0, 0, 10, 10)}, 1), area(kRoad, {box(900, 0, 910, 10)}, 2)}),
          grid);
  const LabelChanges changes = log.since(before);
  EXPECT_FALSE(changes.is_everything);
  EXPECT_TRUE(do_hold(changes.parts, {5.0, -5.0}));
  EXPECT_TRUE(do_hold(changes.parts, {905.0, -5.0}));
  EXPECT_FALSE(do_hold(changes.parts, {500.0, -5.0}));
}

TEST(ChangeLog, TellsTheTilesOfPaint) {
  ChangeLog log;
  const LabelDocument document = test_document(1000, 1000, 0.5);
  const std::int64_t before = log.revision();
  log.add(painting(document, {300, 10, 301, 11}, kRoad), document.grid());
  const LabelChanges changes = log.since(before);
  EXPECT_TRUE(do_hold(changes.parts, {150.25, -5.25}));
  EXPECT_FALSE(do_hold(changes.parts, {100.0, -5.0}));
}

TEST(ChangeLog, ManyThingsAtOnceAreOneRectangle) {
  std::vector<LabelObject> objects;
  for (int i = 0; i < 100; ++i) {
    objects.push_back(area(kRoad, {box(i * 10, 0, i * 10 + 5, 5)}, i + 1));
  }
  const auto parts = changed_parts(adding(objects), test_grid(1000, 10));
  ASSERT_EQ(parts.size(), 1U);
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(do_hold(parts, {i * 10 + 2.5, -2.5}));
}

TEST(ChangeLog, IsEverythingForWhoComesTooLateOrFromElsewhere) {
  ChangeLog log;
  const std::int64_t before = log.revision();
  const LabelGrid grid = test_grid(10, 10);
  for (int i = 0; i < 256; ++i) log.add(adding({area(kRoad, {box(0, 0, 1, 1)})}), grid);
  EXPECT_FALSE(log.since(before).is_everything);
  log.add(adding({area(kRoad, {box(0, 0, 1, 1)})}), grid);
  EXPECT_TRUE(log.since(before).is_everything);
  EXPECT_TRUE(log.since(log.revision() + 1).is_everything);
  const std::int64_t later = log.revision();
  log.add_everything();
  EXPECT_TRUE(log.since(later).is_everything);
  EXPECT_TRUE(log.since(log.revision()).empty());
}

TEST(LabelCoverage, CountsInPiecesAndAfterAnEditOnlyWhatItTouched) {
  LabelDocument document = test_document(600, 300, 0.5);
  LabelCoverage coverage(document.grid());
  EXPECT_FALSE(coverage.count(document, 5));  // Of three by two tiles.
  EXPECT_TRUE(coverage.count(document, 1));
  EXPECT_EQ(coverage.cells(kUnclassified), 600 * 300);
  const LabelEdit edit = adding({area(kRoad, {box(10, 10, 30, 20)})});
  document.apply(edit);
  coverage.follow(edit);
  EXPECT_FALSE(coverage.is_complete());
  EXPECT_TRUE(coverage.count(document, 1));  // It lies in one tile.
  EXPECT_EQ(coverage.cells(kRoad), 40 * 20);
  EXPECT_DOUBLE_EQ(coverage.square_metres(kRoad), 200.0);
  EXPECT_EQ(coverage.counted_cells(), 600 * 300);
}

TEST(LabelCoverage, LeavesAGridBeyondMeasureAlone) {
  const LabelGrid grid = test_grid(2'000'000'000, 2'000'000'000);
  LabelCoverage coverage(grid);
  const LabelDocument document(test_plane(), grid);
  coverage.follow(adding({area(kRoad, {box(10, 10, 30, 20)})}));
  EXPECT_FALSE(coverage.count(document, 1));
  EXPECT_EQ(coverage.counted_cells(), 0);
}

}  // namespace change_log_test
}  // namespace nadir
