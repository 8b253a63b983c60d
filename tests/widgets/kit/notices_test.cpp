// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "widgets/kit/headless_ui.h"

namespace nadir::kit {
namespace notices_test {

/// Notices over a button that fills the window.
struct Shown {
  std::vector<Notice> notices;
  std::vector<NoticeWish> wishes;
  int clicks_below = 0;
  void operator()(Ui& ui) {
    {
      const auto region = ui.region("Below", ui.screen());
      ui.next_width(ui.room().width);
      if (ui.button("Under")) ++clicks_below;
    }
    if (const auto wish = ui.notices(notices, ui.screen())) wishes.push_back(*wish);
  }
};

auto drawing(Shown& shown) {
  return [&shown](Ui& ui) { shown(ui); };
}

Notice notice(const std::string& id, const std::string& text) {
  Notice made;
  made.id = id;
  made.text = text;
  return made;
}

TEST(NoticeStacks, KeepTheirButtonsClearOfTheirWords) {
  HeadlessUi screen;
  Shown shown;
  const std::string words =
      "loop-2.nadir was being written when the program ended: its steps up to 00:43.0 are there";
  shown.notices = {notice("1", words)};
  screen.wait(3, drawing(shown));
  const double without = screen.at("Notices/1").rect.height;
  shown.notices[0].action = "Open it";
  screen.wait(3, drawing(shown));
  constexpr double kPadding = 8.0, kClear = 6.0;
  EXPECT_GE(screen.at("Notices/1/Open it").rect.top - screen.at("Notices/1").rect.top,
            without - kPadding + kClear);
}

TEST(NoticeStacks, OfNoneShowNothing) {
  HeadlessUi screen;
  Shown shown;
  screen.wait(3, drawing(shown));
  for (const Control& control : screen.controls()) EXPECT_NE(control.kind, ControlKind::kNotice);
  EXPECT_TRUE(shown.wishes.empty());
}

TEST(NoticeStacks, HaveTheNewestAtTheBottomAndDoNotOverlap) {
  HeadlessUi screen;
  Shown shown;
  for (int i = 0; i < 5; ++i)
    shown.notices.push_back(notice(std::to_string(i), "The figure was written to moment.svg."));
  screen.wait(3, drawing(shown));
  for (int i = 0; i + 1 < 5; ++i) {
    const Rect upper = screen.at("Notices/" + std::to_string(i)).rect;
    const Rect lower = screen.at("Notices/" + std::to_string(i + 1)).rect;
    EXPECT_LT(upper.bottom(), lower.top) << i;
    EXPECT_EQ(upper.right(), lower.right());
  }
}

TEST(NoticeStacks, GrowWithTheirWords) {
  HeadlessUi screen;
  Shown shown;
  shown.notices = {
      notice("short", "Saved."),
      notice("long",
             "maps/town.png: the file ends after 812 of 4,096 rows; fetch it again, or "
             "open another map that covers the flight, such as the one beside it.")};
  screen.wait(3, drawing(shown));
  EXPECT_GT(screen.at("Notices/long").rect.height, screen.at("Notices/short").rect.height + 15.0);
  EXPECT_EQ(screen.at("Notices/long").rect.width, screen.at("Notices/short").rect.width);
  EXPECT_EQ(screen.at("Notices/long").value, shown.notices[1].text);
}

TEST(NoticeStacks, StayInNarrowWindows) {
  for (const double scale : {1.0, 1.5, 2.0}) {
    HeadlessUi screen(ThemeName::kDark, scale, {420.0, 500.0});
    Shown shown;
    shown.notices = {notice("a", "The figure was written to a folder with a rather long name.")};
    shown.notices[0].action = "Open the folder";
    screen.wait(3, drawing(shown));
    const Rect rect = screen.at("Notices/a").rect;
    EXPECT_GE(rect.left, 0.0) << scale;
    EXPECT_LE(rect.right(), 420.0) << scale;
    EXPECT_LE(rect.bottom(), 500.0) << scale;
    EXPECT_LE(screen.at("Notices/a/Open the folder").rect.right(), rect.right()) << scale;
  }
}

TEST(NoticeStacks, TakeTheMouseWhereTheyLie) {
  HeadlessUi screen;
  Shown shown;
  shown.notices = {notice("a", "Saved.")};
  screen.wait(3, drawing(shown));
  screen.click("Below/Under", drawing(shown));
  EXPECT_EQ(shown.clicks_below, 1);
  const Rect rect = screen.at("Notices/a").rect;
  screen.input().mouse_px = rect.centre();
  screen.frame(drawing(shown));
  screen.input().buttons[0] = true;
  screen.frame(drawing(shown));
  screen.input().buttons[0] = false;
  screen.frame(drawing(shown));
  EXPECT_EQ(shown.clicks_below, 1);
  EXPECT_TRUE(shown.wishes.empty()) << "a click on the words is no wish";
}

TEST(NoticeStacks, SayWhichOneAndWhatIsWished) {
  HeadlessUi screen;
  Shown shown;
  shown.notices = {notice("a", "Saved."), notice("b", "Cut short.")};
  shown.notices[0].action = "Open the folder";
  shown.notices[1].details = "libpng: read error";
  screen.click("Notices/b/Dismiss", drawing(shown));
  screen.click("Notices/a/Open the folder", drawing(shown));
  screen.click("Notices/b/Copy", drawing(shown));
  ASSERT_EQ(shown.wishes.size(), 3U);
  EXPECT_EQ(shown.wishes[0].id, "b");
  EXPECT_EQ(shown.wishes[0].kind, NoticeWish::Kind::kDismiss);
  EXPECT_EQ(shown.wishes[1].id, "a");
  EXPECT_EQ(shown.wishes[1].kind, NoticeWish::Kind::kAction);
  EXPECT_EQ(shown.wishes[2].id, "b");
  EXPECT_EQ(shown.wishes[2].kind, NoticeWish::Kind::kCopy);
}

TEST(NoticeStacks, HaveOnlyTheButtonsThatDoSomething) {
  HeadlessUi screen;
  Shown shown;
  shown.notices = {notice("a", "Saved.")};
  screen.wait(3, drawing(shown));
  EXPECT_TRUE(screen.has("Notices/a/Dismiss"));
  EXPECT_FALSE(screen.has("Notices/a/Details"));
  EXPECT_FALSE(screen.has("Notices/a/Copy"));
}

TEST(NoticeStacks, FoldTheirDetailsEachByItself) {
  HeadlessUi screen;
  Shown shown;
  shown.notices = {notice("a", "First."), notice("b", "Second.")};
  shown.notices[0].details = "errno 28";
  shown.notices[1].details = "errno 13";
  screen.click("Notices/a/Details", drawing(shown));
  screen.wait(2, drawing(shown));
  EXPECT_TRUE(screen.shows("errno 28"));
  EXPECT_FALSE(screen.shows("errno 13"));
  EXPECT_EQ(screen.at("Notices/a/Details").value, "open");
  screen.click("Notices/a/Details", drawing(shown));
  screen.wait(2, drawing(shown));
  EXPECT_FALSE(screen.shows("errno 28"));
}

TEST(NoticeStacks, KeepTheirDetailsOpenWhileOthersComeAndGo) {
  HeadlessUi screen;
  Shown shown;
  shown.notices = {notice("a", "First.")};
  shown.notices[0].details = "errno 28";
  screen.click("Notices/a/Details", drawing(shown));
  shown.notices.push_back(notice("b", "Second."));
  screen.wait(3, drawing(shown));
  EXPECT_TRUE(screen.shows("errno 28"));
  shown.notices.erase(shown.notices.begin() + 1);
  screen.wait(3, drawing(shown));
  EXPECT_TRUE(screen.shows("errno 28"));
}

/// Notices in a window over which a box lies.
struct UnderABox {
  Shown shown;
  double box_width = 640.0, box_height = 480.0;
  int clicks = 0;
  void operator()(Ui& ui) {
    OverlayStyle style;
    style.width = box_width;
    style.height = box_height;
    {
      const auto box = ui.overlay("Box", style);
      ui.next_width(ui.room().width);
      ui.space(ui.room().height - ui.px(40.0));
      ui.next_width(ui.room().width);
      if (ui.button("Do")) ++clicks;
    }
    shown(ui);
  }
};

TEST(NoticeStacks, CoverNothingOfAnOpenBox) {
  for (const double width : {400.0, 640.0, 900.0, 1240.0}) {
    HeadlessUi screen;
    screen.leave_out_region();
    UnderABox window;
    window.box_width = width;
    window.box_height = 760.0;
    for (int i = 0; i < 3; ++i)
      window.shown.notices.push_back(notice(std::to_string(i), "The figure could not be written."));
    screen.wait(4, window);
    const Rect box = screen.at("Box").rect;
    for (int i = 0; i < 3; ++i) {
      const Rect lies = screen.at("Notices/" + std::to_string(i)).rect;
      EXPECT_LE(lies.right(), 1280.0);
      EXPECT_EQ(lies.left >= box.right(), width < 700.0) << i << ": where words have room";
    }
    // What is pressed at its very edge is the box's own.
    const Rect button = screen.at("Box/Do").rect;
    screen.click_at("Box/Do", button.width - 3.0, button.height / 2.0, window);
    EXPECT_EQ(window.clicks, 1) << width;
    EXPECT_TRUE(window.shown.wishes.empty());
  }
}

TEST(NoticeStacks, BesideABoxAreReadAndDismissed) {
  HeadlessUi screen;
  screen.leave_out_region();
  UnderABox window;
  window.shown.notices = {notice("1", "The figure could not be written.")};
  screen.wait(4, window);
  screen.click("Notices/1/Dismiss", window);
  ASSERT_EQ(window.shown.wishes.size(), 1U);
  EXPECT_EQ(window.shown.wishes[0].kind, NoticeWish::Kind::kDismiss);
}

TEST(NoticeStacks, LieUnderOpenMenus) {
  HeadlessUi screen(ThemeName::kDark, 1.0, {500.0, 400.0});
  Shown shown;
  shown.notices = {notice("a", "Saved.")};
  int chosen = 0;
  const auto draw = [&](Ui& ui) {
    {
      const auto region = ui.region("Foot", {350.0, 340.0, 150.0, 60.0});
      if (const auto menu = ui.button_menu("More", Icon::kMore, {"More", ""})) {
        for (int i = 0; i < 6; ++i) chosen += ui.menu_item("item " + std::to_string(i)) ? 1 : 0;
      }
    }
    (void)ui.notices(shown.notices, {0.0, 0.0, 500.0, 330.0});
  };
  screen.click("Foot/More", draw);
  screen.wait(2, draw);
  screen.click("Foot/More/item 4", draw);
  EXPECT_EQ(chosen, 1);
}

}  // namespace notices_test
}  // namespace nadir::kit
