// SPDX-License-Identifier: Apache-2.0
// Tools that look at the image, alone and in the hand of a desk.
#include "core/desk/image_tool.h"

#include "core/map/overhead_image.h"
#include "tests/core/assist/drawn_windows.h"
#include "tests/core/desk/desk_at_work.h"
#include "tests/core/map/image_files.h"

namespace nadir {
namespace image_tool_test {

using testing::HasSubstr;

/// Over an image of two roofs: a metre a pixel, pixel by cell as the document's grid.
class DeskOverAnImage : public DeskAtWork {
 protected:
  static bool is_large(const Eigen::Vector2d& at) { return disc(40.3, 45.2, 21.4)(at); }
  static bool is_small(const Eigen::Vector2d& at) { return disc(92.6, 40.7, 11.3)(at); }

  void pick(ToolKind kind, FoundAs found_as = FoundAs::kPaint) {
    take_up(kind, kBuilding);
    LabelTool tool = desk.tool();
    tool.found_as = found_as;
    tool.assist.radius_m = 200.0;
    ASSERT_EQ(error_text(desk.set_tool(tool)), "(no error)");
    ASSERT_EQ(error_text(desk.look_at_image(image.tiles, {60.0, -45.0})), "(no error)");
  }
  [[nodiscard]] Result<void> told(const std::vector<std::pair<double, double>>& places,
                                  bool takes_away = false) {
    return desk.tell_image({ring(places), takes_away});
  }
  /// Share of cells that are buildings just where they should be, of those that are or should.
  [[nodiscard]] double agreement(const Inside& inside) const {
    PixelMask drawn(120, 90);
    const Raster<ClassId> labels = rasterise(now());
    for (std::size_t i = 0; i < labels.size(); ++i)
      drawn.values()[i] = labels.values()[i] == kBuilding;
    return overlap(drawn, pixels_inside(120, 90, inside));
  }
  [[nodiscard]] std::int64_t steps() const { return desk.sheet().step(); }

  OpenedImage image = opened();

 private:
  OpenedImage opened() {
    const auto inside = [](const Eigen::Vector2d& at) { return is_large(at) || is_small(at); };
    write_image({.pixels = noisy(drawn_picture(120, 90, inside), 4.0)}, scratch.path() / "a.tif");
    auto result = open_overhead_image(scratch.path() / "a.tif");
    if (!result) throw std::runtime_error(error_text(result));
    return std::move(*result);
  }
};

TEST_F(DeskOverAnImage, PaintsWhatTheWandHasFoundInOneStep) {
  pick(ToolKind::kWand);
  ASSERT_EQ(error_text(told({{40.0, 45.0}})), "(no error)");
  ASSERT_EQ(error_text(desk.add_point({92.0, -40.0}, 0.1)), "(no error)");
  EXPECT_EQ(steps(), 0);
  ASSERT_EQ(error_text(desk.finish()), "(no error)");
  EXPECT_EQ(steps(), 1);
  EXPECT_EQ(desk.undo_title(), "Paint building");
  EXPECT_GT(agreement([](const Eigen::Vector2d& at) { return is_large(at) || is_small(at); }),
            0.99);
  EXPECT_FALSE(desk.image_tool().is_told());
  ASSERT_TRUE(desk.undo());
  EXPECT_TRUE(now().paint().empty());
}

TEST_F(DeskOverAnImage, ShowsWhatIsComingAndTakesStrokesBack) {
  pick(ToolKind::kWand);
  ASSERT_TRUE(told({{40.0, 45.0}}));
  const std::vector<LabelObject> one = desk.coming({0.0, 0.0}, 0.1);
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].class_id, kBuilding);
  ASSERT_TRUE(told({{92.0, 40.0}}));
  EXPECT_NE(desk.coming({0.0, 0.0}, 0.1)[0].rings, one[0].rings);
  EXPECT_EQ(desk.undo_title(), "Last stroke");
  ASSERT_TRUE(desk.undo());
  EXPECT_EQ(desk.coming({0.0, 0.0}, 0.1)[0].rings, one[0].rings);
  ASSERT_TRUE(desk.undo());
  EXPECT_TRUE(desk.coming({0.0, 0.0}, 0.1).empty());
  EXPECT_EQ(desk.undo_title(), std::nullopt);
}

TEST_F(DeskOverAnImage, FindsAgainWhenTheToleranceChanges) {
  pick(ToolKind::kWand);
  ASSERT_TRUE(told({{40.0, 45.0}}));
  const auto before = desk.image_tool().borders();
  LabelTool tool = desk.tool();
  tool.wand.tolerance = 150.0;
  ASSERT_TRUE(desk.set_tool(tool));
  EXPECT_EQ(desk.image_tool().borders().size(), 1U);  // Everything.
  EXPECT_NE(desk.image_tool().borders(), before);
  tool.kind = ToolKind::kSuperpixels;
  ASSERT_TRUE(desk.set_tool(tool));
  EXPECT_FALSE(desk.image_tool().is_told());
}

TEST_F(DeskOverAnImage, DrawsAreasOfSuperpixelsThatWereDraggedOver) {
  pick(ToolKind::kSuperpixels, FoundAs::kAreas);
  LabelTool tool = desk.tool();
  tool.superpixels.side_px = 8.0;
  ASSERT_TRUE(desk.set_tool(tool));
  ASSERT_TRUE(told({{23.0, 35.0}, {58.0, 35.0}, {58.0, 42.0}, {23.0, 42.0}}));
  ASSERT_TRUE(told({{23.0, 49.0}, {58.0, 49.0}, {50.0, 56.0}, {28.0, 56.0}, {40.0, 62.0}}));
  ASSERT_TRUE(told({{92.0, 40.0}}));
  ASSERT_TRUE(told({{92.0, 40.0}}, true));
  ASSERT_EQ(error_text(desk.finish()), "(no error)");
  EXPECT_EQ(object_count(), 1U);
  EXPECT_EQ(desk.selection().ids().size(), 1U);
  EXPECT_GT(agreement(is_large), 0.8);
  EXPECT_EQ(class_at(92.0, 40.0), kUnclassified);
}

TEST_F(DeskOverAnImage, CutsOutWhatIsInTheRectangle) {
  pick(ToolKind::kGrabCut);
  ASSERT_EQ(error_text(told({{12.0, 15.0}, {110.0, 75.0}})), "(no error)");
  ASSERT_EQ(error_text(told({{86.0, 36.0}, {98.0, 44.0}}, true)), "(no error)");
  ASSERT_EQ(error_text(told({{30.0, 45.0}, {50.0, 45.0}})), "(no error)");
  ASSERT_EQ(error_text(desk.finish()), "(no error)");
  EXPECT_EQ(class_at(40.0, 45.0), kBuilding);
  EXPECT_EQ(class_at(92.0, 40.0), kUnclassified);
  EXPECT_EQ(class_at(5.0, 5.0), kUnclassified);
}

TEST_F(DeskOverAnImage, DrawsAnAreaWhoseBorderFollowsTheEdge) {
  pick(ToolKind::kScissors);
  const auto rim = [](double turn_deg) {
    const double turn = turn_deg * std::acos(-1.0) / 180.0;
    return Eigen::Vector2d(40.3 + 22.5 * std::cos(turn), -45.2 + 22.5 * std::sin(turn));
  };
  for (const double turn_deg : {0.0, 95.0, 185.0, 270.0}) {
    ASSERT_EQ(error_text(desk.look_at_image(image.tiles, rim(turn_deg))), "(no error)");
    ASSERT_EQ(error_text(desk.add_point(rim(turn_deg), 0.5)), "(no error)");
  }
  EXPECT_GT(desk.points().size(), 12U);
  // What finishing now would draw is shown with the way under the hand.
  ASSERT_TRUE(desk.look_at_image(image.tiles, rim(300.0)));
  const auto coming = desk.coming(rim(300.0), 0.1);
  ASSERT_EQ(coming.size(), 1U);
  EXPECT_GT(coming[0].rings[0].size(), desk.points().size() + 1);
  ASSERT_EQ(error_text(desk.add_point(desk.points().all().front().in_enu_m, 0.5)), "(no error)");
  EXPECT_EQ(object_count(), 1U);
  EXPECT_EQ(steps(), 1);
  EXPECT_GT(agreement(is_large), 0.97);
}

TEST_F(DeskOverAnImage, ForgetsWhatItWasToldWhenCancelled) {
  pick(ToolKind::kWand);
  ASSERT_TRUE(told({{40.0, 45.0}}));
  EXPECT_TRUE(desk.cancel());
  EXPECT_FALSE(desk.image_tool().is_told());
  EXPECT_EQ(desk.tool().kind, ToolKind::kWand);
  EXPECT_TRUE(desk.cancel());
  EXPECT_EQ(desk.tool().kind, ToolKind::kSelect);
  EXPECT_EQ(steps(), 0);
}

TEST_F(DeskOverAnImage, RefusesWhatCannotBe) {
  take_up(ToolKind::kWand);
  EXPECT_EQ(error_text(told({{40.0, 45.0}})), "there is no image to look at");
  EXPECT_EQ(error_text(desk.finish()), "nothing was found yet");
  EXPECT_EQ(error_text(desk.look_at_image(image.tiles, {500.0, 0.0})),
            "the place is outside of the image");
  ASSERT_TRUE(desk.look_at_image(image.tiles, {60.0, -45.0}));
  EXPECT_EQ(error_text(told({{300.0, 300.0}})), "the place is outside of what is looked at");
  EXPECT_EQ(error_text(told({})), "a stroke needs a place");
  EXPECT_FALSE(desk.image_tool().is_told());
  take_up(ToolKind::kBrush);
  EXPECT_THAT(error_text(told({{40.0, 45.0}})), HasSubstr("brush takes no strokes"));
  take_up(ToolKind::kScissors);
  desk.look_away();
  EXPECT_EQ(error_text(desk.add_point({40.0, -45.0}, 0.1)), "there is no image to look at");
}

TEST_F(DeskOverAnImage, LooksAnewOnlyWhereTheHandLeavesTheMiddle) {
  ImageTool tool;
  const AssistWindowOptions near{.radius_m = 20.0, .most_pixels = 512};
  ASSERT_TRUE(tool.look(image.tiles, {50.0, -45.0}, near));
  const Affine2 first = tool.window()->enu_from_pixels();
  ASSERT_TRUE(tool.look(image.tiles, {58.0, -40.0}, near));
  EXPECT_EQ(tool.window()->enu_from_pixels().offset, first.offset);
  // While it was told something it stays.
  LabelTool wand;
  wand.kind = ToolKind::kWand;
  ASSERT_TRUE(tool.tell(wand, {ring({{50.0, 45.0}}), false}));
  ASSERT_TRUE(tool.look(image.tiles, {90.0, -45.0}, near));
  EXPECT_EQ(tool.window()->enu_from_pixels().offset, first.offset);
  tool.take_back(wand);
  ASSERT_TRUE(tool.look(image.tiles, {90.0, -45.0}, near));
  EXPECT_NE(tool.window()->enu_from_pixels().offset, first.offset);
}

}  // namespace image_tool_test
}  // namespace nadir
