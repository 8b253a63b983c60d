// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "widgets/kit/headless_ui.h"

namespace nadir::kit {
namespace regions_test {

TEST(Regions, LieWhereTheyAreAskedFor) {
  HeadlessUi screen;
  screen.wait(2, [](Ui& ui) {
    const auto region = ui.region("Side", {40.0, 60.0, 300.0, 200.0});
    (void)ui.button("Go");
  });
  EXPECT_EQ(screen.at("Side").rect, (Rect{40.0, 60.0, 300.0, 200.0}));
  EXPECT_EQ(screen.at("Side/Go").rect.left, 52.0);
  EXPECT_EQ(screen.at("Side/Go").rect.top, 72.0);
}

TEST(Regions, MoveWithWhoeverPlacesThem) {
  HeadlessUi screen;
  double left = 40.0;
  const auto draw = [&left](Ui& ui) {
    const auto region = ui.region("Side", {left, 60.0, 300.0, 200.0});
    return ui.button("Go");
  };
  screen.wait(2, draw);
  left = 500.0;
  screen.frame(draw);
  EXPECT_EQ(screen.at("Side/Go").rect.left, 512.0);
  EXPECT_TRUE(screen.click("Side/Go", draw));
}

TEST(Regions, HaveThePaddingTheyAreGiven) {
  for (const double padding : {0.0, 4.0, 20.0}) {
    HeadlessUi screen;
    Rect room;
    screen.frame([&](Ui& ui) {
      RegionStyle style;
      style.padding = padding;
      const auto region = ui.region("Side", {0.0, 0.0, 300.0, 200.0}, style);
      room = ui.room();
    });
    EXPECT_EQ(room, (Rect{padding, padding, 300.0 - 2.0 * padding, 200.0 - 2.0 * padding}));
  }
}

TEST(Regions, TellWhatRoomIsLeft) {
  HeadlessUi screen;
  Rect before, after;
  screen.frame([&](Ui& ui) {
    const auto region = ui.region("Side", {0.0, 0.0, 300.0, 200.0});
    before = ui.room();
    (void)ui.button("Go");
    after = ui.room();
  });
  EXPECT_EQ(after.top, before.top + 32.0);
  EXPECT_EQ(after.bottom(), before.bottom());
  EXPECT_EQ(after.width, before.width);
}

TEST(Regions, AboveOthersTakeTheMouseAlsoWhereTheyAreDrawnFirst) {
  HeadlessUi screen;
  int above = 0, below = 0;
  const auto draw = [&](Ui& ui) {
    {
      RegionStyle style;
      style.is_above = true;
      style.padding = 0.0;
      const auto region = ui.region("Above", {100.0, 100.0, 28.0, 28.0}, style);
      above += ui.icon_button("Fold", Icon::kMinus, {"Fold", ""}) ? 1 : 0;
    }
    RegionStyle style;
    style.padding = 0.0;
    const auto region = ui.region("Below", {0.0, 0.0, 400.0, 400.0}, style);
    below += ui.area("map", {400.0, 400.0}).clicked ? 1 : 0;
  };
  screen.wait(3, draw);
  screen.click("Above/Fold", draw);
  EXPECT_EQ(above, 1);
  EXPECT_EQ(below, 0);
  screen.click_at("Below/map", 20.0, 20.0, draw);
  EXPECT_EQ(below, 1);
  screen.click("Above/Fold", draw);
  EXPECT_EQ(above, 2) << "a click below does not bring that to the front";
}

TEST(Regions, MayBeDrawnInAnyOrderFromFrameToFrame) {
  HeadlessUi screen;
  bool is_turned = false;
  std::vector<std::string> clicks;
  const auto side = [&](Ui& ui, const std::string& name, double left) {
    const auto region = ui.region(name, {left, 0.0, 200.0, 200.0});
    if (ui.button("Go")) clicks.push_back(name);
  };
  const auto draw = [&](Ui& ui) {
    if (is_turned) side(ui, "B", 200.0);
    side(ui, "A", 0.0);
    if (!is_turned) side(ui, "B", 200.0);
  };
  screen.click("A/Go", draw);
  is_turned = true;
  screen.click("B/Go", draw);
  screen.click("A/Go", draw);
  EXPECT_THAT(clicks, testing::ElementsAre("A", "B", "A"));
}

TEST(Regions, OfNoSizeDoNoHarm) {
  HeadlessUi screen;
  screen.wait(2, [](Ui& ui) {
    const auto region = ui.region("Side", {100.0, 100.0, 0.0, -5.0});
    (void)ui.button("Go");
    NumberOptions options;
    options.least = 0.0;
    options.most = 2.0;
    (void)ui.slider("Noise", 1.0, options);
    (void)ui.area("map");
    EXPECT_GE(ui.room().width, 0.0);
  });
  EXPECT_FALSE(screen.at("Side/Go").is_visible);
}

TEST(OverlayPlaces, AreInTheWindowHoweverSmallThatIs) {
  for (const double scale : {1.0, 1.5, 2.0}) {
    for (const double width : {300.0, 700.0, 1280.0}) {
      HeadlessUi screen(ThemeName::kDark, scale, {width, 500.0});
      screen.wait(3, [](Ui& ui) {
        OverlayStyle style;
        style.width = ui.px(640.0);
        style.height = ui.px(480.0);
        style.place = OverlayPlace::kUpperThird;
        const auto overlay = ui.overlay("Palette", style);
        (void)ui.button("Go");
      });
      const Rect rect = screen.at("Palette").rect;
      EXPECT_GE(rect.left, 0.0);
      EXPECT_LE(rect.right(), width);
      EXPECT_LE(rect.bottom(), 500.0) << width << " at " << scale;
      EXPECT_NEAR(rect.centre().x(), width / 2.0, 1.0);
    }
  }
}

TEST(OverlayPlaces, AreAsHighAsTheirContent) {
  HeadlessUi screen;
  int rows = 2;
  const auto draw = [&rows](Ui& ui) {
    const auto overlay = ui.overlay("Sheet");
    for (int i = 0; i < rows; ++i) (void)ui.list_row("row " + std::to_string(i));
  };
  screen.wait(3, draw);
  const double low = screen.at("Sheet").rect.height;
  EXPECT_NEAR(low, 2.0 * 28.0 + 2.0 * 16.0, 2.0);
  rows = 6;
  screen.wait(3, draw);
  EXPECT_NEAR(screen.at("Sheet").rect.height, low + 4.0 * 28.0, 2.0);
}

TEST(OverlayPlaces, ScrollWhereTheirContentIsHigherThanTheWindow) {
  HeadlessUi screen(ThemeName::kDark, 1.0, {800.0, 400.0});
  std::string clicked;
  const auto draw = [&clicked](Ui& ui) {
    const auto overlay = ui.overlay("Sheet");
    for (int i = 0; i < 40; ++i) {
      const std::string name = "row " + std::to_string(i);
      if (ui.list_row(name)) clicked = name;
    }
  };
  screen.wait(3, draw);
  EXPECT_LE(screen.at("Sheet").rect.height, 400.0);
  screen.click("Sheet/row 39", draw);
  EXPECT_EQ(clicked, "row 39");
}

TEST(OverlayPlaces, LieOverEachOtherInTheOrderOfTheirCalls) {
  HeadlessUi screen;
  int first = 0, second = 0;
  const auto draw = [&](Ui& ui) {
    {
      const auto overlay = ui.overlay("First");
      first += ui.button("Go") ? 1 : 0;
    }
    const auto overlay = ui.overlay("Second");
    second += ui.button("Go") ? 1 : 0;
  };
  screen.click("Second/Go", draw);
  EXPECT_EQ(second, 1);
  EXPECT_EQ(first, 0) << "they lie at the same place";
}

TEST(SplitterHandles, ChangeOnlyAlongTheirAxis) {
  for (const Axis axis : {Axis::kHorizontal, Axis::kVertical}) {
    HeadlessUi screen;
    double size = 100.0;
    const auto draw = [&](Ui& ui) {
      const auto edit = ui.splitter("Handle", Rect{200.0, 200.0, 40.0, 40.0}, axis, size, 50, 300);
      if (edit.is_changed) size = edit.value;
    };
    screen.drag("Handle", axis == Axis::kHorizontal ? 0.0 : 33.0,
                axis == Axis::kHorizontal ? 33.0 : 0.0, draw);
    EXPECT_EQ(size, 100.0);
    (void)screen.hover("Handle", draw);
    EXPECT_EQ(screen.context().cursor_name(),
              axis == Axis::kHorizontal ? "resize ew" : "resize ns");
  }
}

TEST(SplitterHandles, StayBetweenTheirEndsAndComeBackWithTheMouse) {
  HeadlessUi screen;
  double size = 100.0;
  const auto draw = [&size](Ui& ui) {
    const auto edit = ui.splitter("Handle", Rect{size - 4.0, 0.0, 8.0, 300.0}, Axis::kHorizontal,
                                  size, 80.0, 160.0);
    if (edit.is_changed) size = edit.value;
    return edit.was_committed;
  };
  screen.wait(2, draw);
  screen.input().mouse_px = screen.at("Handle").rect.centre();
  screen.frame(draw);
  screen.input().buttons[0] = true;
  screen.frame(draw);
  const Eigen::Vector2d start = *screen.input().mouse_px;
  for (const auto& [moved, expected] :
       {std::pair(300.0, 160.0), std::pair(-90.0, 80.0), std::pair(20.0, 120.0)}) {
    screen.input().mouse_px = start + Eigen::Vector2d(moved, 0.0);
    screen.frame(draw);
    EXPECT_EQ(size, expected) << moved;
  }
  screen.input().buttons[0] = false;
  EXPECT_TRUE(screen.frame(draw));
}

TEST(SplitterHandles, LieOverTheRegionsThatTheyPart) {
  HeadlessUi screen;
  double size = 300.0;
  int clicks = 0;
  const auto draw = [&](Ui& ui) {
    {
      RegionStyle style;
      style.padding = 0.0;
      const auto region = ui.region("Map", {0.0, 0.0, 1280.0, 800.0}, style);
      clicks += ui.area("Ground").clicked ? 1 : 0;
    }
    const auto edit = ui.splitter("Handle", Rect{size - 4.0, 0.0, 8.0, 800.0}, Axis::kHorizontal,
                                  size, 200.0, 500.0);
    if (edit.is_changed) size = edit.value;
  };
  screen.drag("Handle", 50.0, 0.0, draw);
  EXPECT_EQ(size, 350.0);
  EXPECT_EQ(clicks, 0);
}

TEST(ColumnsOfARegion, ShareItsWidthByWeight) {
  const std::vector<std::vector<double>> all = {{1.0, 1.0}, {1.0, 2.0, 3.0}, {5.0, 1.0}};
  for (const auto& weights : all) {
    HeadlessUi screen;
    std::vector<double> widths;
    screen.wait(2, [&](Ui& ui) {
      widths.clear();
      const auto columns = ui.columns("All", weights);
      for (std::size_t i = 0; i < weights.size(); ++i) {
        if (i > 0) ui.next_column();
        widths.push_back(ui.room().width);
      }
    });
    double width = 0.0, weight = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      width += widths[i];
      weight += weights[i];
    }
    for (std::size_t i = 0; i < weights.size(); ++i)
      EXPECT_NEAR(widths[i] / width, weights[i] / weight, 0.03);
    EXPECT_LE(width, 1280.0 - 24.0);
  }
}

TEST(ColumnsOfARegion, EndWhereTheLongestEnds) {
  HeadlessUi screen;
  screen.wait(2, [](Ui& ui) {
    {
      const auto columns = ui.columns("Both", {1.0, 1.0});
      (void)ui.button("Short");
      ui.next_column();
      for (int i = 0; i < 5; ++i) (void)ui.list_row("row " + std::to_string(i));
    }
    (void)ui.button("Below");
  });
  EXPECT_GE(screen.at("Below").rect.top, screen.at("row 4").rect.bottom());
  EXPECT_EQ(screen.at("Short").rect.top, screen.at("row 0").rect.top);
}

}  // namespace regions_test
}  // namespace nadir::kit
