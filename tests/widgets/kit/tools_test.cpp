// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "widgets/kit/headless_ui.h"

namespace nadir::kit {
namespace tools_test {

/// Six tools in two groups, in a region as high as they take.
struct ToolPlate {
  std::vector<Tool> tools;
  double height = 1000.0;
  double taken = 0.0;
  std::vector<std::size_t> clicked;

  ToolPlate() {
    for (const char* const name : {"Pan", "Measure", "Pick", "Zoom in", "Zoom out", "Fit"}) {
      Tool tool;
      tool.name = name;
      tool.icon = Icon::kMove;
      tool.hint = {std::string("What it does: ") + name, "M"};
      tools.push_back(tool);
    }
    tools[0].is_on = true;
    tools[3].begins_group = true;
  }
  void operator()(Ui& ui) {
    taken = ui.tool_column_height(tools, height);
    RegionStyle style;
    style.padding = 0.0;
    const auto region = ui.region("Tools", {100.0, 50.0, ui.px(28.0), taken}, style);
    if (const auto index = ui.tool_column(tools, height)) clicked.push_back(*index);
  }
};

auto drawing(ToolPlate& plate) {
  return [&plate](Ui& ui) { plate(ui); };
}

TEST(ToolColumns, ShowAllWhereThereIsRoom) {
  HeadlessUi screen;
  ToolPlate plate;
  screen.wait(2, drawing(plate));
  EXPECT_FALSE(screen.has("Tools/More"));
  for (const Tool& tool : plate.tools) EXPECT_TRUE(screen.at("Tools/" + tool.name).is_visible);
  EXPECT_EQ(screen.at("Tools/Fit").rect.bottom(), 50.0 + plate.taken) << "as high as it said";
  EXPECT_TRUE(screen.at("Tools/Pan").is_selected);
  screen.click("Tools/Fit", drawing(plate));
  screen.click("Tools/Pan", drawing(plate));
  EXPECT_THAT(plate.clicked, testing::ElementsAre(5U, 0U));
}

TEST(ToolColumns, HoldWhatDoesNotFitInAMenu) {
  HeadlessUi screen;
  ToolPlate plate;
  plate.height = 130.0;
  screen.wait(2, drawing(plate));
  EXPECT_TRUE(screen.has("Tools/Measure"));
  EXPECT_FALSE(screen.has("Tools/Zoom out"));
  EXPECT_EQ(screen.at("Tools/More").kind, ControlKind::kMenu);
  screen.click("Tools/More/Zoom out", drawing(plate));
  EXPECT_THAT(plate.clicked, testing::ElementsAre(4U));
  screen.wait(2, drawing(plate));
  EXPECT_FALSE(screen.has("Tools/More/Zoom out")) << "closed by the choice";
}

TEST(ToolColumns, SayInTheMenuWhatTheirIconsSay) {
  HeadlessUi screen;
  ToolPlate plate;
  plate.height = 60.0;
  plate.tools[4].is_on = true;
  screen.click("Tools/More", drawing(plate));
  screen.wait(2, drawing(plate));
  EXPECT_TRUE(screen.at("Tools/More/Zoom out").is_selected);
  EXPECT_EQ(screen.at("Tools/More/Zoom out").value, "M");
  EXPECT_EQ(screen.at("Tools/More/Fit").tooltip, "What it does: Fit");
}

TEST(ToolColumns, NeverTakeMoreThanTheyMayAndLoseNoTool) {
  for (const double scale : {1.0, 1.5, 2.0}) {
    for (double height = 28.0; height < 240.0; height += 7.0) {
      HeadlessUi screen(ThemeName::kDark, scale);
      ToolPlate plate;
      plate.height = height * scale;
      screen.wait(2, drawing(plate));
      EXPECT_LE(plate.taken, plate.height + 0.5);
      std::size_t shown = 0;
      double bottom = 50.0;
      for (const Tool& tool : plate.tools) {
        const Control* const control = screen.find("Tools/" + tool.name);
        if (control == nullptr) continue;
        ++shown;
        EXPECT_GE(control->rect.top, bottom);
        bottom = control->rect.bottom();
      }
      if (const Control* const more = screen.find("Tools/More")) {
        EXPECT_GE(more->rect.top, bottom);
        bottom = more->rect.bottom();
        screen.click("Tools/More", drawing(plate));
        screen.wait(2, drawing(plate));
        for (const Tool& tool : plate.tools) shown += screen.has("Tools/More/" + tool.name) ? 1 : 0;
      }
      EXPECT_EQ(shown, plate.tools.size()) << height;
      EXPECT_NEAR(bottom, 50.0 + plate.taken, 0.5) << height;
    }
  }
}

TEST(ToolColumns, AreDisabledInTheColumnAndInTheMenu) {
  for (const double height : {1000.0, 60.0}) {
    HeadlessUi screen;
    ToolPlate plate;
    plate.height = height;
    plate.tools[5].disabled_because = "open a run first";
    if (height < 1000.0) screen.click("Tools/More", drawing(plate));
    screen.wait(2, drawing(plate));
    const std::string path = height < 1000.0 ? "Tools/More/Fit" : "Tools/Fit";
    EXPECT_FALSE(screen.at(path).is_enabled);
    EXPECT_THAT(screen.at(path).tooltip, testing::HasSubstr("open a run first"));
    EXPECT_THROW(screen.click(path, drawing(plate)), std::logic_error);
    EXPECT_THAT(plate.clicked, testing::IsEmpty());
  }
}

TEST(ToolColumns, OfNoToolsTakeNoRoom) {
  HeadlessUi screen;
  screen.frame([](Ui& ui) {
    EXPECT_EQ(ui.tool_column_height({}, 100.0), 0.0);
    EXPECT_FALSE(ui.tool_column({}, 100.0));
  });
  EXPECT_TRUE(screen.controls().empty());
}

}  // namespace tools_test
}  // namespace nadir::kit
