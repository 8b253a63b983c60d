// SPDX-License-Identifier: Apache-2.0
#include "core/desk/coming_stroke.h"

#include "tests/core/desk/desk_at_work.h"

namespace nadir {
namespace coming_stroke_test {

class StrokeAtWork : public DeskAtWork {
 protected:
  /// What a view that follows the changes alone shows: cells outside of them must be what they were.
  void follow() {
    const LabelChanges changes = stroke.follow(desk);
    const Raster<ClassId> now_seen = rasterise(*stroke.document());
    if (changes.is_everything || seen.empty()) {
      seen = now_seen;
      return;
    }
    for (const PlaneBounds& part : changes.parts) {
      const LabelGrid& grid = now().grid();
      const CellRect cells = grid.cells_of(part, 1).cut_to(grid.whole());
      for (auto row = static_cast<int>(cells.top); row < cells.bottom; ++row) {
        for (auto column = static_cast<int>(cells.left); column < cells.right; ++column) {
          seen.at(column, row) = now_seen.at(column, row);
        }
      }
    }
    ASSERT_EQ(seen, now_seen);
  }

  ComingStroke stroke;
  Raster<ClassId> seen;
};

TEST_F(StrokeAtWork, IsTheDocumentWhereNobodyPaints) {
  EXPECT_TRUE(stroke.follow(desk).is_everything);
  EXPECT_EQ(*stroke.document(), now());
  EXPECT_TRUE(stroke.follow(desk).empty());
  drawn_box(10, 10, 20, 20);
  const LabelChanges changes = stroke.follow(desk);
  EXPECT_FALSE(changes.is_everything);
  EXPECT_EQ(changes.parts.size(), 1U);
  EXPECT_EQ(*stroke.document(), now());
}

TEST_F(StrokeAtWork, ShowsPlaceByPlaceWhatFinishingMakes) {
  drawn_box(10, 10, 60, 60, kTerrain);
  for (const ToolKind kind : {ToolKind::kBrush, ToolKind::kEraser}) {
    take_up(kind, kVegetation);
    LabelTool tool = desk.tool();
    tool.brush_radius_m = 4.0;
    ASSERT_THAT(desk.set_tool(tool), Succeeds());
    for (int i = 0; i < 12; ++i) {
      ASSERT_THAT(points({{20.0 + 3.1 * i, 30.0 + 11.0 * std::sin(i)}}), Succeeds());
      follow();
    }
    const Raster<ClassId> coming = rasterise(*stroke.document());
    EXPECT_NE(coming, rasterise(now())) << "nothing is finished yet";
    ASSERT_THAT(desk.finish(), Succeeds());
    EXPECT_EQ(rasterise(now()), coming);
    follow();
    EXPECT_EQ(*stroke.document(), now());
  }
}

TEST_F(StrokeAtWork, LeavesNothingBehindWhenItIsCancelled) {
  follow();
  take_up(ToolKind::kBrush);
  ASSERT_THAT(points({{30, 30}, {50, 40}}), Succeeds());
  follow();
  EXPECT_NE(*stroke.document(), now());
  EXPECT_TRUE(desk.cancel());
  follow();
  EXPECT_EQ(*stroke.document(), now());
  EXPECT_EQ(seen, rasterise(now()));
}

TEST_F(StrokeAtWork, IsPaintedAnewWithAnotherBrush) {
  follow();
  take_up(ToolKind::kBrush);
  ASSERT_THAT(points({{30, 30}, {50, 40}}), Succeeds());
  follow();
  LabelTool tool = desk.tool();
  tool.brush_radius_m = 0.6;
  ASSERT_THAT(desk.set_tool(tool), Succeeds());
  follow();
  ASSERT_THAT(desk.finish(), Succeeds());
  EXPECT_EQ(seen, rasterise(now()));
}

}  // namespace coming_stroke_test
}  // namespace nadir
