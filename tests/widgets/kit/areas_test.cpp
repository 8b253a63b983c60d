// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "widgets/kit/headless_ui.h"

namespace nadir::kit {
namespace areas_test {

/// Keeps what an area of 400 x 300 said in each frame.
struct Watched {
  std::vector<AreaInput> inputs;
  void operator()(Ui& ui) { inputs.push_back(ui.area("map", {400.0, 300.0})); }
  [[nodiscard]] std::vector<AreaDrag> drags() const {
    std::vector<AreaDrag> found;
    for (const AreaInput& input : inputs) {
      if (input.drag) found.push_back(*input.drag);
    }
    return found;
  }
  [[nodiscard]] int clicks(MouseButton button) const {
    int found = 0;
    for (const AreaInput& input : inputs) found += input.clicked == button ? 1 : 0;
    return found;
  }
};

TEST(Areas, CountUpFromTheirLowerLeftCorner) {
  HeadlessUi screen;
  Watched map;
  const auto draw = [&map](Ui& ui) { map(ui); };
  screen.click_at("map", 10.0, 20.0, draw);
  EXPECT_EQ(map.inputs.back().mouse, Eigen::Vector2d(10.0, 280.0));
  EXPECT_TRUE(map.inputs.back().is_hovered);
  EXPECT_EQ(map.inputs.back().page(), (PageRect{0.0, 0.0, 400.0, 300.0}));
  EXPECT_EQ(map.clicks(MouseButton::kLeft), 1);
  EXPECT_TRUE(map.drags().empty());
}

TEST(Areas, ReportADragFromItsStartToItsEnd) {
  for (const MouseButton button : {MouseButton::kLeft, MouseButton::kMiddle, MouseButton::kRight}) {
    HeadlessUi screen;
    Watched map;
    screen.drag("map", 40.0, -20.0, [&map](Ui& ui) { map(ui); }, button, {false, true});
    const auto drags = map.drags();
    ASSERT_GE(drags.size(), 3U);
    EXPECT_TRUE(drags.front().was_started);
    EXPECT_FALSE(drags[1].was_started);
    EXPECT_TRUE(drags.back().was_released);
    EXPECT_EQ(drags.back().button, button);
    EXPECT_EQ(drags.back().start, Eigen::Vector2d(200.0, 150.0));
    EXPECT_EQ(drags.back().total, Eigen::Vector2d(40.0, 20.0)) << "up is up";
    Eigen::Vector2d moved = Eigen::Vector2d::Zero();
    for (const AreaDrag& drag : drags) moved += drag.delta;
    EXPECT_EQ(moved, drags.back().total) << "nothing is lost before the threshold";
    EXPECT_EQ(map.clicks(button), 0) << "a drag is no click";
  }
}

TEST(Areas, TakeATrembleForAClick) {
  HeadlessUi screen;
  Watched map;
  screen.drag("map", 2.0, 2.0, [&map](Ui& ui) { map(ui); });
  EXPECT_TRUE(map.drags().empty());
  EXPECT_EQ(map.clicks(MouseButton::kLeft), 1);
}

TEST(Areas, FollowADragOutsideAndIgnoreOneFromOutside) {
  HeadlessUi screen;
  Watched map;
  screen.drag("map", 600.0, 0.0, [&map](Ui& ui) { map(ui); });
  EXPECT_EQ(map.drags().back().total.x(), 600.0);
  map.inputs.clear();
  const auto draw = [&map](Ui& ui) {
    map(ui);
    (void)ui.button("Below");
  };
  screen.drag("Below", 0.0, -100.0, draw);
  EXPECT_TRUE(map.drags().empty());
}

TEST(Areas, TellDoubleClicksAndTheWheel) {
  HeadlessUi screen;
  Watched map;
  const auto draw = [&map](Ui& ui) { map(ui); };
  screen.double_click("map", draw);
  int doubles = 0;
  for (const AreaInput& input : map.inputs) doubles += input.double_clicked ? 1 : 0;
  EXPECT_EQ(doubles, 1);
  EXPECT_EQ(map.clicks(MouseButton::kLeft), 2);
  map.inputs.clear();
  screen.scroll("map", 3.0, draw, {true});
  double notches = 0.0;
  for (const AreaInput& input : map.inputs) {
    notches += input.wheel.y();
    EXPECT_TRUE(input.wheel.y() == 0.0 || input.modifiers.ctrl);
  }
  EXPECT_EQ(notches, 3.0);
}

TEST(Areas, AreNotHoveredUnderARegionAbove) {
  HeadlessUi screen;
  Watched map;
  const auto draw = [&map](Ui& ui) {
    {
      const auto region = ui.region("Map", {0.0, 0.0, 600.0, 400.0});
      map(ui);
    }
    RegionStyle above;
    above.is_above = true;
    above.surface = Surface::kPlate;
    const auto legend = ui.region("Legend", {100.0, 100.0, 100.0, 100.0}, above);
    (void)ui.button("Fold");
  };
  screen.wait(3, draw);
  map.inputs.clear();
  screen.click("Legend/Fold", draw);
  EXPECT_EQ(map.clicks(MouseButton::kLeft), 0);
  EXPECT_FALSE(map.inputs.back().is_hovered);
}

TEST(Areas, LetTheMouseThroughRegionsThatTakeNoInput) {
  HeadlessUi screen;
  Watched map;
  const auto draw = [&map](Ui& ui) {
    {
      const auto region = ui.region("Map", {0.0, 0.0, 600.0, 400.0});
      map(ui);
    }
    RegionStyle above;
    above.is_above = true;
    above.takes_input = false;
    const auto legend = ui.region("Legend", {100.0, 100.0, 100.0, 100.0}, above);
    ui.text("road");
  };
  screen.wait(3, draw);
  screen.input().mouse_px = Eigen::Vector2d(150.0, 150.0);
  screen.wait(2, draw);
  EXPECT_TRUE(map.inputs.back().is_hovered);
}

TEST(Areas, FillTheRoomThereIsAndKeepTheirMouseApart) {
  HeadlessUi screen(ThemeName::kLight, 1.0, {500.0, 400.0});
  bool wants_mouse = true;
  const auto draw = [&wants_mouse](Ui& ui) {
    const AreaInput input = ui.area("map");
    const std::vector<std::string> lines = {"road", "E 12.3"};
    if (input.is_hovered) ui.mouse_tooltip(lines);
    wants_mouse = ui.wants_mouse();
  };
  screen.frame(draw);
  EXPECT_EQ(screen.at("map").rect, (Rect{12.0, 12.0, 476.0, 376.0}));
  screen.input().mouse_px = Eigen::Vector2d(200.0, 200.0);
  screen.wait(2, draw);
  EXPECT_FALSE(wants_mouse);
  EXPECT_EQ(screen.tooltip(), "road · E 12.3") << "at once";
}

TEST(Areas, CanvasAndImagesNeedAnArea) {
  HeadlessUi screen;
  EXPECT_THROW(screen.frame([](Ui& ui) { (void)ui.canvas(); }), std::logic_error);
  EXPECT_THROW(screen.frame([](Ui& ui) { ui.image(7); }), std::logic_error);
}

}  // namespace areas_test
}  // namespace nadir::kit
