// SPDX-License-Identifier: Apache-2.0
#include "core/desk/label_tool.h"

#include <gmock/gmock.h>

#include "tests/support/error_text.h"

namespace nadir {
namespace label_tool_test {

using testing::HasSubstr;

TEST(LabelTool, ComesBackFromItsText) {
  LabelTool tool;
  tool.kind = ToolKind::kStreet;
  use_class(tool, kLaneMarking);
  tool.recode_from = {kUnclassified};
  tool.brush_unit = BrushUnit::kCells;
  tool.brush_radius_cells = 12.5;
  tool.street_profile = {"two lanes, \"old\""};
  tool.snaps = false;
  tool.paints_over = true;
  LabelTool read;
  for (const OptionText& option : option_texts(tool)) {
    const auto set = set_option(read, option.name, option.value);
    EXPECT_TRUE(set) << error_text(set);
  }
  EXPECT_EQ(read, tool);
}

TEST(LabelTool, RefusesWhatNobodyCanDrawWith) {
  LabelTool tool;
  EXPECT_THAT(error_text(set_option(tool, "class", "sky")), HasSubstr("no map holds sky"));
  EXPECT_THAT(error_text(set_option(tool, "class", "car")), HasSubstr("no map holds car"));
  EXPECT_THAT(error_text(set_option(tool, "class", "lava")), HasSubstr("lava is no class"));
  EXPECT_THAT(error_text(set_option(tool, "line-width", "0")), HasSubstr("--line-width"));
  EXPECT_THAT(error_text(set_option(tool, "tool", "hammer")), HasSubstr("hammer"));
  EXPECT_THAT(error_text(set_option(tool, "street-profile", "a\nb")), HasSubstr("one line"));
  EXPECT_EQ(tool, LabelTool());
}

TEST(LabelTool, TogglesBetweenTheLastTwoClasses) {
  LabelTool tool;
  use_class(tool, kBuilding);
  use_class(tool, kCurb);
  use_class(tool, kCurb);  // Again is nothing new.
  toggle_class(tool);
  EXPECT_EQ(tool.class_id.id, kBuilding);
  toggle_class(tool);
  EXPECT_EQ(tool.class_id.id, kCurb);
}

TEST(LabelTool, PaintsInTheLevelOfTheClassUnlessOverEverything) {
  LabelTool tool;
  tool.kind = ToolKind::kBrush;
  use_class(tool, kTerrain);
  EXPECT_EQ(paint_value(tool), kTerrain);
  tool.paints_over = true;
  EXPECT_EQ(paint_value(tool), kTerrain + kPaintOver);
  use_class(tool, kUnclassified);
  EXPECT_EQ(paint_value(tool), kUnclassified);
  tool.kind = ToolKind::kEraser;
  EXPECT_EQ(paint_value(tool), kNoPaint);
}

TEST(LabelTool, MeasuresItsBrushInMetresOrCells) {
  LabelTool tool;
  tool.brush_radius_m = 2.0;
  tool.brush_radius_cells = 30.0;
  EXPECT_EQ(brush_radius_m(tool, 0.1), 2.0);
  tool.brush_unit = BrushUnit::kCells;
  EXPECT_DOUBLE_EQ(brush_radius_m(tool, 0.1), 3.0);
}

TEST(LabelTool, TakesNoMorePlacesThanItNeedsWhereTheNumberIsGiven) {
  for (std::size_t i = 0; i < EnumNames<ToolKind>::kNames.size(); ++i) {
    const auto kind = static_cast<ToolKind>(i);
    const std::size_t most = most_points(kind);
    EXPECT_TRUE(most == 0 || most == least_points(kind)) << enum_name(kind);
    EXPECT_TRUE(!draws_ring(kind) || least_points(kind) == 3U) << enum_name(kind);
  }
}

}  // namespace label_tool_test
}  // namespace nadir
