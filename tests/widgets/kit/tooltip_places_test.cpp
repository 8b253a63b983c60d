// SPDX-License-Identifier: Apache-2.0
// Where tooltips stand.
#include <gmock/gmock.h>

#include "tests/widgets/kit/shown_tooltip.h"
#include "widgets/kit/headless_ui.h"

namespace nadir::kit {
namespace tooltip_places_test {

constexpr const char* kLongHint =
    "What the filter's weights are made of: 0 fits everywhere, 1 nowhere; the first run's own "
    "options say how much a class counts";

TEST(Tooltips, StayInTheWindow) {
  HeadlessUi screen(ThemeName::kLight, 1.0, {700.0, 300.0});
  const auto draw = [](Ui& ui) {
    ui.space(240.0);
    ui.text("left");
    ui.same_line();
    ui.right_align(80.0);
    (void)ui.button("Cost", ButtonLook::kNormal, {kLongHint, ""});
  };
  screen.hover("Cost", draw);
  screen.wait(2, draw);
  const auto place = tooltip_place();
  ASSERT_TRUE(place);
  EXPECT_GE(place->left, 0.0);
  EXPECT_LE(place->right(), 700.0);
  EXPECT_LE(place->bottom(), 300.0);
}

/// Whether a tooltip lies wholly in the window and on nothing of these.
void expect_clear(HeadlessUi& screen, const std::vector<std::string>& paths) {
  const auto place = tooltip_place();
  ASSERT_TRUE(place) << screen.tooltip();
  const Eigen::Vector2d window = screen.input().size_px;
  EXPECT_GE(place->left, 0.0);
  EXPECT_GE(place->top, 0.0);
  EXPECT_LE(place->right(), window.x());
  EXPECT_LE(place->bottom(), window.y());
  for (const std::string& path : paths) {
    const Rect rect = screen.at(path).rect;
    const bool is_apart = place->right() <= rect.left || rect.right() <= place->left ||
                          place->bottom() <= rect.top || rect.bottom() <= place->top;
    EXPECT_TRUE(is_apart) << "on " << path;
  }
}

TEST(Tooltips, ByMouseAndByKeyboardStayInTheWindowAndOffTheirControl) {
  for (const double scale : {1.0, 1.5, 2.0}) {
    for (const double top : {0.0, 120.0, 360.0, 560.0}) {
      for (const double width : {60.0, 300.0, 690.0}) {
        HeadlessUi screen(ThemeName::kDark, scale, {700.0, 620.0});
        const auto draw = [&](Ui& ui) {
          ui.space(top);
          ui.text(".");
          ui.same_line();
          ui.right_align(width);
          ui.next_width(width);
          (void)ui.button("Preset", ButtonLook::kNormal, {kLongHint, "Ctrl+P"});
        };
        screen.hover("Preset", draw);
        screen.wait(2, draw);
        expect_clear(screen, {"Preset"});
        screen.leave();
        screen.press("Shift+Tab", draw);
        screen.input().delta_s = 0.5;
        screen.wait(3, draw);
        expect_clear(screen, {"Preset"});
      }
    }
  }
}

TEST(Tooltips, KeepOffTheMessageBelowTheirControl) {
  for (const double top : {20.0, 200.0, 330.0}) {
    HeadlessUi screen(ThemeName::kLight, 1.0, {420.0, 420.0});
    NumberOptions options;
    options.least = 0.0;
    options.most = 10.0;
    options.hint = {"Metres that the estimate may be off", "", "m"};
    const auto draw = [&](Ui& ui) {
      ui.space(top);
      (void)ui.number_input("Noise", 5.0, options);
      ui.wrapped("12 is not in 0 to 10. The run keeps 5.", TextLook::kBad);
    };
    const std::vector<std::string> all = {"Noise", "12 is not in 0 to 10. The run keeps 5."};
    screen.type("Noise", "12", draw, false);
    screen.leave();
    screen.wait(2, draw);
    EXPECT_EQ(screen.tooltip(), "at most 10.00");
    expect_clear(screen, all);
    screen.press("Escape", draw);
    screen.hover("Noise", draw);
    screen.wait(2, draw);
    expect_clear(screen, all);
  }
}

}  // namespace tooltip_places_test
}  // namespace nadir::kit
