// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "widgets/kit/headless_ui.h"

namespace nadir::kit {
namespace scrolling_test {

/// A panel of 300 x 400 with more in it than fits: rows, a picture, rows.
struct LongPanel {
  Wheel wheel = Wheel::kScrolls;
  AreaInput picture;
  double notches = 0.0;
  void operator()(Ui& ui) {
    const auto region = ui.region("Side", {0.0, 0.0, 300.0, 400.0});
    const auto content = ui.scroll_area("Content");
    for (int i = 0; i < 4; ++i) (void)ui.list_row("above " + std::to_string(i));
    picture = ui.area("Picture", {200.0, 150.0}, wheel);
    notches += picture.wheel.y();
    for (int i = 0; i < 20; ++i) (void)ui.list_row("below " + std::to_string(i));
  }
};

auto drawing(LongPanel& panel) {
  return [&panel](Ui& ui) { panel(ui); };
}

TEST(Scrolling, GoesOnOverAPictureThatDoesNothingWithTheWheel) {
  HeadlessUi screen;
  LongPanel panel;
  screen.wait(3, drawing(panel));
  const double before = screen.at("Side/Picture").rect.top;
  screen.scroll("Side/Picture", -2.0, drawing(panel));
  screen.wait(2, drawing(panel));
  EXPECT_LT(screen.at("Side/Picture").rect.top, before - 20.0);
  EXPECT_EQ(panel.notches, 0.0) << "the wheel was the panel's";
}

TEST(Scrolling, StaysWhereTheWheelIsTheAreasOwn) {
  HeadlessUi screen;
  LongPanel panel;
  panel.wheel = Wheel::kOwn;
  screen.wait(3, drawing(panel));
  const double before = screen.at("Side/Picture").rect.top;
  screen.scroll("Side/Picture", -2.0, drawing(panel));
  screen.wait(2, drawing(panel));
  EXPECT_EQ(screen.at("Side/Picture").rect.top, before);
  EXPECT_EQ(panel.notches, -2.0);
}

TEST(Scrolling, LeavesClicksAndDragsToThePicture) {
  HeadlessUi screen;
  LongPanel panel;
  int clicks = 0;
  const auto draw = [&](Ui& ui) {
    panel(ui);
    clicks += panel.picture.clicked ? 1 : 0;
  };
  screen.click("Side/Picture", draw);
  EXPECT_EQ(clicks, 1);
  EXPECT_TRUE(panel.picture.is_hovered);
}

TEST(Scrolling, StopsAtBothEnds) {
  HeadlessUi screen;
  LongPanel panel;
  screen.wait(3, drawing(panel));
  const double first = screen.at("Side/above 0").rect.top;
  screen.scroll("Side/above 0", 5.0, drawing(panel));
  screen.wait(2, drawing(panel));
  EXPECT_EQ(screen.at("Side/above 0").rect.top, first);
  for (int i = 0; i < 10; ++i) screen.scroll("Side/Picture", -10.0, drawing(panel));
  screen.scroll("Side/below 19", -30.0, drawing(panel));
  screen.wait(2, drawing(panel));
  EXPECT_TRUE(screen.at("Side/below 19").is_visible);
  EXPECT_FALSE(screen.at("Side/above 0").is_visible);
  EXPECT_LE(screen.at("Side/below 19").rect.bottom(), 400.0);
}

TEST(Scrolling, LeavesItsBarFree) {
  HeadlessUi screen;
  bool is_long = true;
  double room = 0.0;
  const auto draw = [&](Ui& ui) {
    const auto region = ui.region("Side", {0.0, 0.0, 300.0, 200.0});
    const auto content = ui.scroll_area("Content");
    room = ui.room().width;
    for (int i = 0; i < (is_long ? 20 : 2); ++i) (void)ui.list_row(std::to_string(i));
  };
  screen.wait(3, draw);
  const double with_bar = room;
  is_long = false;
  screen.wait(3, draw);
  EXPECT_GE(with_bar, 200.0);
  EXPECT_LE(with_bar, 300.0 - 12.0 - 10.0) << "rows end before the bar";
  EXPECT_GE(room, with_bar);
}

TEST(Scrolling, ShowsMoreBelowByItsBar) {
  // Where the bar is drawn, a press on its lower end goes down a page.
  HeadlessUi screen;
  LongPanel panel;
  screen.wait(3, drawing(panel));
  EXPECT_FALSE(screen.at("Side/below 19").is_visible);
  bool has_found_bar = false;
  for (double x = 299.0; x > 270.0 && !has_found_bar; x -= 1.0) {
    screen.input().mouse_px = Eigen::Vector2d(x, 370.0);
    screen.wait(2, drawing(panel));
    screen.input().buttons[0] = true;
    screen.wait(3, drawing(panel));
    screen.input().buttons[0] = false;
    screen.wait(2, drawing(panel));
    has_found_bar = !screen.at("Side/above 0").is_visible;
  }
  EXPECT_TRUE(has_found_bar);
}

TEST(Scrolling, BringsWhatIsAskedForIntoSightOnce) {
  HeadlessUi screen;
  LongPanel panel;
  screen.wait(3, drawing(panel));
  screen.context().scroll_to("Side/below 15");
  screen.wait(3, drawing(panel));
  EXPECT_TRUE(screen.at("Side/below 15").is_visible);
  screen.scroll("Side/below 15", 50.0, drawing(panel));
  screen.wait(3, drawing(panel));
  EXPECT_TRUE(screen.at("Side/above 0").is_visible) << "and does not hold it there";
}

TEST(Scrolling, OfWhatLiesInsideGoesBeforeThatOfWhatLiesAround) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) {
    RegionStyle style;
    style.has_scroll = true;
    const auto region = ui.region("Side", {0.0, 0.0, 300.0, 300.0}, style);
    {
      const auto inner = ui.scroll_area("Inner", 120.0);
      for (int i = 0; i < 20; ++i) (void)ui.list_row("inner " + std::to_string(i));
    }
    for (int i = 0; i < 20; ++i) (void)ui.list_row("outer " + std::to_string(i));
  };
  screen.wait(3, draw);
  const double outer = screen.at("Side/outer 0").rect.top;
  const double inner = screen.at("Side/inner 1").rect.top;
  screen.scroll("Side/inner 1", -1.0, draw);
  screen.wait(2, draw);
  EXPECT_LT(screen.at("Side/inner 1").rect.top, inner);
  EXPECT_EQ(screen.at("Side/outer 0").rect.top, outer);
}

TEST(Scrolling, IsKeptWhileThePanelIsNotDrawn) {
  HeadlessUi screen;
  LongPanel panel;
  bool shows = true;
  const auto draw = [&](Ui& ui) {
    if (shows) panel(ui);
  };
  screen.wait(3, draw);
  screen.scroll("Side/Picture", -2.0, draw);
  screen.wait(2, draw);
  const double there = screen.at("Side/Picture").rect.top;
  shows = false;
  screen.wait(5, draw);
  shows = true;
  screen.wait(3, draw);
  EXPECT_EQ(screen.at("Side/Picture").rect.top, there);
}

TEST(Regions, WithoutScrollCutWhatIsTooLong) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) {
    const auto region = ui.region("Side", {0.0, 0.0, 300.0, 100.0});
    for (int i = 0; i < 20; ++i) (void)ui.list_row(std::to_string(i));
  };
  screen.wait(2, draw);
  EXPECT_TRUE(screen.at("Side/1").is_visible);
  EXPECT_FALSE(screen.at("Side/10").is_visible);
  screen.scroll("Side/1", -5.0, draw);
  EXPECT_TRUE(screen.at("Side/1").is_visible);
  EXPECT_FALSE(screen.at("Side/10").is_visible);
}

TEST(ClippedRows, DrawAsManyAsThereAreAndNoMore) {
  HeadlessUi screen;
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{3}}) {
    std::size_t drawn = 0;
    screen.wait(3, [&](Ui& ui) {
      drawn = 0;
      ui.clipped_rows(count, ui.px(28.0), [&](std::size_t i) {
        ++drawn;
        EXPECT_LT(i, count);
        (void)ui.list_row(std::to_string(i));
      });
    });
    EXPECT_EQ(drawn, count);
  }
}

TEST(ClippedRows, TakeTheRoomOfAllOfThem) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) {
    ui.clipped_rows(1000, ui.px(28.0),
                    [&](std::size_t i) { (void)ui.list_row("row " + std::to_string(i)); });
    (void)ui.button("After");
  };
  screen.wait(3, draw);
  EXPECT_NEAR(screen.at("After").rect.top, 12.0 + 1000.0 * 28.0, 30.0);
  screen.click("After", draw);
  EXPECT_TRUE(screen.has("row 999"));
  EXPECT_FALSE(screen.has("row 500"));
}

}  // namespace scrolling_test
}  // namespace nadir::kit
