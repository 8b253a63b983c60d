// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "tests/widgets/kit/shown_tooltip.h"
#include "widgets/kit/headless_ui.h"
#include "widgets/kit/wrapped_lines.h"

namespace nadir::kit {
namespace tooltips_test {

using testing::HasSubstr;

constexpr const char* kLongHint =
    "What the filter's weights are made of: 0 fits everywhere, 1 nowhere; the first run's own "
    "options say how much a class counts";

TEST(Tooltips, AreNoWiderThanSixtyCharacters) {
  for (const double scale : {1.0, 1.5, 2.0}) {
    HeadlessUi screen(ThemeName::kDark, scale, {1280.0, 800.0});
    double widest = 0.0, line_height = 0.0;
    const auto draw = [&](Ui& ui) {
      (void)ui.button("Cost", ButtonLook::kNormal, {kLongHint, "Ctrl+K"});
      widest = ui.text_width(std::string(60, 'w'));
      line_height = ui.px(14.0);
    };
    screen.hover("Cost", draw);
    screen.wait(2, draw);
    const auto place = tooltip_place();
    ASSERT_TRUE(place);
    EXPECT_LT(place->width, widest);
    EXPECT_GT(place->width, 0.4 * widest) << "and not much narrower";
    EXPECT_GT(place->height, 3.0 * line_height);
    EXPECT_LT(place->height, 6.0 * line_height);
  }
}

TEST(Tooltips, OfOneShortLineAreOneLineHigh) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) {
    (void)ui.icon_button("Play", Icon::kPlay, {"Play or pause", "Space"});
  };
  screen.hover("Play", draw);
  screen.wait(2, draw);
  const auto place = tooltip_place();
  ASSERT_TRUE(place);
  EXPECT_LT(place->height, 40.0) << "the keys stand behind the words";
}

TEST(Tooltips, DoNotRepeatTheLabel) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) {
    (void)ui.button("Localise", ButtonLook::kNormal, {"Localise", ""});
    (void)ui.button("Open…", ButtonLook::kNormal, {"open", ""});
    (void)ui.checkbox("Trails", true, {"Trails.", ""});
    (void)ui.list_row("alpha", {.hint = {"alpha", ""}});
    ui.read_out("Error", "1.84", "m", {"Error", "", "", "evaluated"});
  };
  screen.frame(draw);
  for (const char* const path : {"Localise", "Open…", "Trails", "alpha"}) {
    EXPECT_EQ(screen.at(path).tooltip, "") << path;
    screen.hover(path, draw);
    EXPECT_EQ(screen.tooltip(), "") << path;
  }
  EXPECT_THAT(screen.at("Error").tooltip, HasSubstr("evaluated")) << "what it adds stays";
  EXPECT_THAT(screen.at("Error").tooltip, testing::Not(HasSubstr("Error")));
}

TEST(Tooltips, SayTheKeysOfWhatNeedsNoOtherWord) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) {
    (void)ui.button("Localise", ButtonLook::kNormal, {"Localise", "Ctrl+R"});
  };
  screen.hover("Localise", draw);
  EXPECT_EQ(screen.tooltip(), "Ctrl+R");
}

TEST(Tooltips, OfIconsSayTheirNameForNothingElseDoes) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) {
    (void)ui.icon_button("Close", Icon::kClose, {"Close", ""});
    if (const auto menu = ui.button_menu("Strips", Icon::kPlus, {"Strips", ""})) {
      (void)ui.menu_item("Error");
    }
  };
  screen.hover("Close", draw);
  EXPECT_EQ(screen.tooltip(), "Close");
  screen.hover("Strips", draw);
  EXPECT_EQ(screen.tooltip(), "Strips");
}

TEST(Tooltips, SayAllOfWhatWasCut) {
  HeadlessUi screen(ThemeName::kLight, 1.0, {200.0, 300.0});
  const std::string name = "a name that is much too long for so narrow a panel";
  const auto draw = [&name](Ui& ui) {
    ui.cut_text(name);
    (void)ui.list_row(name + " too");
    ui.next_width(80.0);
    (void)ui.button(name + " three");
  };
  screen.hover(name, draw);
  EXPECT_EQ(screen.tooltip(), name);
  screen.hover(name + " too", draw);
  EXPECT_EQ(screen.tooltip(), name + " too");
  screen.hover(name + " three", draw);
  EXPECT_EQ(screen.tooltip(), name + " three");
}

TEST(Tooltips, SayWhyAControlIsDisabledAfterWhatItDoes) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) {
    const auto off = ui.disabled(true, "open a run first");
    (void)ui.checkbox("Follow", false, {"Keep the estimate in the middle", "L"});
    (void)ui.checkbox("Fit", false);
  };
  screen.hover("Follow", draw);
  EXPECT_EQ(screen.tooltip(), "Keep the estimate in the middle · L · open a run first");
  screen.hover("Fit", draw);
  EXPECT_EQ(screen.tooltip(), "open a run first");
}

TEST(Tooltips, SayTheInnermostReason) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) {
    const auto outer = ui.disabled(true, "running");
    const auto inner = ui.disabled(true, "no map");
    (void)ui.button("Fit");
  };
  screen.frame(draw);
  EXPECT_THAT(screen.at("Fit").tooltip, HasSubstr("no map"));
}

TEST(Tooltips, ComeLateAndGoWithTheMouse) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) {
    (void)ui.icon_button("First", Icon::kFirst, {"To the start", "Home"});
    (void)ui.icon_button("Last", Icon::kLast, {"To the end", "End"});
  };
  screen.frame(draw);
  screen.input().mouse_px = screen.at("First").rect.centre();
  screen.wait(5, draw);
  EXPECT_EQ(screen.tooltip(), "") << "not at once";
  screen.input().delta_s = 0.5;
  screen.frame(draw);
  EXPECT_EQ(screen.tooltip(), "To the start · Home");
  screen.input().mouse_px = screen.at("Last").rect.centre();
  screen.frame(draw);
  EXPECT_EQ(screen.tooltip(), "") << "the next one waits again";
}

TEST(Tooltips, AreNotInTheWayOfAPress) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) {
    (void)ui.icon_button("Play", Icon::kPlay, {"Play or pause", "Space"});
  };
  screen.hover("Play", draw);
  screen.input().buttons[0] = true;
  screen.frame(draw);
  EXPECT_EQ(screen.tooltip(), "");
}

TEST(Tooltips, AtTheMouseComeAtOnceAndAreWrappedToo) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) {
    if (ui.area("map", {300.0, 200.0}).is_hovered) {
      ui.mouse_tooltip(std::vector<std::string>{"road", kLongHint});
    }
  };
  screen.frame(draw);
  screen.input().mouse_px = screen.at("map").rect.centre();
  screen.wait(3, draw);
  EXPECT_THAT(screen.tooltip(), testing::StartsWith("road · What the filter's"));
  double widest = 0.0;
  screen.frame([&](Ui& ui) {
    draw(ui);
    widest = ui.text_width(std::string(60, '0'), TextLook::kNumber);
  });
  const auto place = tooltip_place();
  ASSERT_TRUE(place);
  EXPECT_LE(place->width, widest + 40.0);
}

TEST(Tooltips, OfANumberThatIsTypedSayWhatIsWrongWithIt) {
  HeadlessUi screen;
  NumberOptions options;
  options.least = 0.0;
  options.most = 10.0;
  options.unit = "m";
  const auto draw = [&options](Ui& ui) { (void)ui.number_input("Noise", 5.0, options); };
  screen.type("Noise", "many", draw, false);
  EXPECT_EQ(screen.tooltip(), "not a number in m");
  const Rect field = screen.at("Noise").rect;
  screen.leave();
  screen.wait(2, draw);
  EXPECT_EQ(screen.tooltip(), "not a number in m") << "also without the mouse";
  const auto place = tooltip_place();
  ASSERT_TRUE(place);
  EXPECT_GE(place->top, field.bottom()) << "and does not cover what is typed";
  screen.type("Noise", "12", draw, false);
  EXPECT_EQ(screen.tooltip(), "at most 10.00 m");
  screen.type("Noise", "7", draw, false);
  screen.wait(1, draw);
  EXPECT_EQ(screen.tooltip(), "");
}

}  // namespace tooltips_test
}  // namespace nadir::kit
