// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "widgets/kit/headless_ui.h"

namespace nadir::kit {
namespace buttons_test {

TEST(Buttons, AreClickedByTheirPath) {
  HeadlessUi screen;
  int clicks = 0;
  const auto draw = [&clicks](Ui& ui) {
    const auto scope = ui.scope("Run");
    if (ui.button("Localise", ButtonLook::kPrimary)) ++clicks;
    (void)ui.button("Stop", ButtonLook::kQuiet);
  };
  screen.click("Run/Localise", draw);
  EXPECT_EQ(clicks, 1);
  screen.click("Run/Stop", draw);
  EXPECT_EQ(clicks, 1);
  EXPECT_EQ(screen.at("Run/Localise").kind, ControlKind::kButton);
  EXPECT_NEAR(screen.at("Run/Localise").rect.height, 28.0, 1e-9);
}

TEST(Buttons, CountTheirPressFromWhereTheMouseWentDown) {
  HeadlessUi screen;
  int clicks = 0;
  const auto draw = [&clicks](Ui& ui) { clicks += ui.button("Go") ? 1 : 0; };
  screen.drag("Go", 200.0, 0.0, draw);
  EXPECT_EQ(clicks, 0) << "let go elsewhere";
}

TEST(Buttons, ThatAreDisabledSayWhyAndDoNothing) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) {
    const auto off = ui.disabled(true, "No flight is open");
    return ui.button("Localise", ButtonLook::kNormal, {"Run the localiser", "Ctrl+R"});
  };
  EXPECT_THROW((void)screen.click("Localise", draw), std::logic_error);
  EXPECT_FALSE(screen.at("Localise").is_enabled);
  EXPECT_THAT(screen.at("Localise").tooltip, testing::HasSubstr("No flight is open"));
  (void)screen.hover("Localise", draw);
  EXPECT_EQ(screen.tooltip(), "Run the localiser · Ctrl+R · No flight is open");
  // Also by force.
  screen.input().buttons[0] = true;
  EXPECT_FALSE(screen.frame(draw));
  screen.input().buttons[0] = false;
  EXPECT_FALSE(screen.frame(draw));
}

TEST(Buttons, AreEnabledAgainAfterTheScope) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) {
    {
      const auto off = ui.disabled(true, "because");
      (void)ui.button("Off");
    }
    const auto on = ui.disabled(false, "because not");
    return ui.button("On");
  };
  EXPECT_TRUE(screen.click("On", draw));
  EXPECT_TRUE(screen.at("On").tooltip.empty());
}

TEST(Buttons, ShowATooltipOnlyAfterTheMouseRested) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) {
    (void)ui.icon_button("Play", Icon::kPlay, {"Play or pause", "Space"});
  };
  screen.frame(draw);
  screen.input().mouse_px = screen.at("Play").rect.centre();
  screen.frame(draw);
  screen.frame(draw);
  EXPECT_EQ(screen.tooltip(), "");
  EXPECT_LT(screen.context().next_frame_within_s(), 1.0) << "somebody has to draw it";
  screen.hover("Play", draw);
  EXPECT_EQ(screen.tooltip(), "Play or pause · Space");
  screen.leave();
  screen.frame(draw);
  EXPECT_EQ(screen.tooltip(), "");
}

TEST(Buttons, OfIconsMustSayWhatTheyDo) {
  HeadlessUi screen;
  EXPECT_THROW(screen.frame([](Ui& ui) { (void)ui.icon_button("Play", Icon::kPlay, {}); }),
               std::logic_error);
}

TEST(Buttons, OfIconsCanBeOn) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) {
    return ui.icon_button("Loop", Icon::kRepeat, {"Repeat the range", "L"}, true);
  };
  EXPECT_TRUE(screen.click("Loop", draw));
  EXPECT_TRUE(screen.at("Loop").is_selected);
  EXPECT_EQ(screen.at("Loop").value, "on");
  EXPECT_EQ(screen.at("Loop").rect.width, 28.0);
}

TEST(Buttons, HaveLinksAndTheRailAmongThem) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) {
    const bool linked = ui.link("read more");
    const bool railed = ui.rail_button("Label", Icon::kPencil, {"Label a map", "Ctrl+2"}, true);
    return linked || railed;
  };
  EXPECT_TRUE(screen.click("read more", draw));
  EXPECT_TRUE(screen.click("Label", draw));
  EXPECT_TRUE(screen.at("Label").is_selected);
  (void)screen.hover("read more", draw);
  EXPECT_EQ(screen.context().cursor_name(), "hand");
}

TEST(Buttons, ThatHaveNoRoomBesideOthersBeginTheNextLine) {
  for (const double width : {600.0, 200.0}) {
    HeadlessUi screen(ThemeName::kDark, 1.0, {width, 300.0});
    const auto draw = [](Ui& ui) {
      (void)ui.button("Rerun from here", ButtonLook::kPrimary);
      ui.same_line();
      const bool was_clicked = ui.button("From the start");
      (void)ui.button("Below");
      return was_clicked;
    };
    EXPECT_TRUE(screen.click("From the start", draw));
    const Rect first = screen.at("Rerun from here").rect;
    const Rect second = screen.at("From the start").rect;
    EXPECT_LE(second.right(), width - 12.0);
    if (width > 500.0) {
      EXPECT_EQ(second.top, first.top);
    } else {
      EXPECT_EQ(second.top, first.bottom() + 4.0);
      EXPECT_EQ(second.left, first.left);
    }
    EXPECT_EQ(screen.at("Below").rect.top, second.bottom() + 4.0);
  }
}

TEST(Checkboxes, SayWhatTheyShouldBecome) {
  HeadlessUi screen;
  bool is_on = false;
  const auto draw = [&is_on](Ui& ui) { return ui.checkbox("Trails", is_on); };
  const auto asked = screen.click("Trails", draw);
  ASSERT_TRUE(asked);
  EXPECT_TRUE(*asked);
  EXPECT_EQ(screen.at("Trails").value, "off") << "the model did not follow";
  is_on = true;
  const auto off = screen.click("Trails", draw);
  ASSERT_TRUE(off);
  EXPECT_FALSE(*off);
}

TEST(Eyes, OpenAndCloseAndSayWhatAClickDoes) {
  HeadlessUi screen;
  bool is_on = true;
  const auto draw = [&is_on](Ui& ui) {
    const auto scope = ui.scope("Particles");
    if (const auto seen = ui.eye("Show", is_on)) is_on = *seen;
  };
  EXPECT_EQ((screen.frame(draw), screen.at("Particles/Show").tooltip), "Hide");
  screen.click("Particles/Show", draw);
  EXPECT_FALSE(is_on);
  EXPECT_EQ(screen.at("Particles/Show").tooltip, "Show");
  EXPECT_EQ(screen.at("Particles/Show").value, "off");
}

}  // namespace buttons_test
}  // namespace nadir::kit
