// SPDX-License-Identifier: Apache-2.0
// What holds for all controls at all sizes: nothing overlaps, nothing leaves its panel, everything grows with the scale.
#include <gmock/gmock.h>

#include <random>
#include <set>

#include "tests/widgets/kit/demo_sheet.h"
#include "widgets/kit/headless_ui.h"

namespace nadir::kit {
namespace geometry_test {

const std::vector<std::string>& picture_kinds() {
  static const std::vector<std::string> names = {"Image", "Labels", "Depth"};
  return names;
}

/// A panel of every control that takes a row.
void draw_panel(Ui& ui) {
  NumberOptions options;
  options.least = 0.0;
  options.most = 100.0;
  options.unit = "m/s";
  options.reset = 3.0;
  ui.heading("Settings");
  (void)ui.search_input("Find", "");
  (void)ui.slider("Particles of the filter", 50.0, options);
  (void)ui.number_input("Heading noise", 1.25, options);
  (void)ui.text_input("Name", "loop medium 7");
  (void)ui.combo("Preset", picture_kinds(), 1);
  (void)ui.choice("Picture", picture_kinds(), 0);
  (void)ui.checkbox("Trails", true);
  (void)ui.colour("Estimate", {10, 20, 30});
  (void)ui.list_row("alpha", {.detail = "12.5 m"});
  (void)ui.button("Localise", ButtonLook::kPrimary, {}, Icon::kPlay);
  (void)ui.radio("Topview at", std::vector<std::string>{"estimate", "truth"}, 0);
  (void)ui.small_slider("Opacity", 20.0, options);
  (void)ui.progress("Localising", 0.4, "12 s left");
  ui.read_out("Error", "1.84", "m");
  ui.wrapped("a sentence that takes more than one line where the panel is narrow, as here");
  (void)ui.tabs("Tabs", picture_kinds(), 2);
  (void)ui.button("Last");
}

bool overlaps(const Rect& a, const Rect& b) {
  constexpr double kTouch = 1.0;  // texts end between pixels, and what follows begins at one
  return a.left + kTouch < b.right() && b.left + kTouch < a.right() &&
         a.top + kTouch < b.bottom() && b.top + kTouch < a.bottom();
}

class Geometry : public testing::TestWithParam<double> {};

TEST_P(Geometry, ControlsOfAPanelDoNotOverlap) {
  const double scale = GetParam();
  for (const double width : {200.0, 260.0, 380.0}) {
    HeadlessUi screen(ThemeName::kDark, scale, {width * scale, 1200.0 * scale});
    screen.wait(3, draw_panel);
    const auto& controls = screen.controls();
    for (std::size_t i = 0; i < controls.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const Control& a = controls[k];
        const Control& b = controls[i];
        const bool is_part = b.path.rfind(a.path + "/", 0) == 0;
        if (is_part) continue;
        EXPECT_FALSE(overlaps(a.rect, b.rect))
            << a.path << " and " << b.path << " at scale " << scale << ", width " << width;
      }
    }
  }
}

TEST_P(Geometry, ControlsStayInTheirPanel) {
  const double scale = GetParam();
  for (const double width : {180.0, 240.0, 400.0}) {
    HeadlessUi screen(ThemeName::kLight, scale, {width * scale, 1200.0 * scale});
    screen.wait(3, draw_panel);
    for (const Control& control : screen.controls()) {
      EXPECT_GE(control.rect.left, 12.0 * scale - 1.0) << control.path;
      EXPECT_LE(control.rect.right(), (width - 12.0) * scale + 1.0)
          << control.path << " at scale " << scale << ", width " << width;
    }
  }
}

TEST_P(Geometry, PartsOfAControlLieInIt) {
  const double scale = GetParam();
  HeadlessUi screen(ThemeName::kDark, scale, {300.0 * scale, 1200.0 * scale});
  screen.wait(3, draw_panel);
  const Rect whole = screen.at("Picture").rect;
  for (const std::string& kind : picture_kinds()) {
    const Rect part = screen.at("Picture/" + kind).rect;
    EXPECT_GE(part.left, whole.left);
    EXPECT_LE(part.right(), whole.right());
    EXPECT_EQ(part.top, whole.top);
    EXPECT_EQ(part.height, whole.height);
  }
  EXPECT_LE(screen.at("Particles of the filter").rect.right(),
            screen.at("Particles of the filter/value").rect.left);
  EXPECT_LE(screen.at("Particles of the filter").label_rect.right(),
            screen.at("Particles of the filter").rect.left);
}

TEST_P(Geometry, RowsAreAsHighAsTheDesignHasThem) {
  const double scale = GetParam();
  HeadlessUi screen(ThemeName::kDark, scale, {400.0 * scale, 1200.0 * scale});
  screen.wait(3, draw_panel);
  for (const char* const path : {"Find", "Heading noise", "Name", "Preset", "Picture", "Trails",
                                 "alpha", "Localise", "Opacity", "Last"}) {
    EXPECT_NEAR(screen.at(path).rect.height, 28.0 * scale, 1.0) << path;
  }
}

INSTANTIATE_TEST_SUITE_P(AtAllScales, Geometry, testing::Values(0.75, 1.0, 1.25, 1.5, 2.0, 3.0));

TEST(GeometryOfTabs, WrapsIntoRowsThatShowEveryTitleWhole) {
  const std::vector<std::string> titles = {"Moment", "Why", "Settings", "Camera", "Topview", "3D"};
  for (double width = 120.0; width <= 420.0; width += 20.0) {
    HeadlessUi screen(ThemeName::kDark, 1.0, {width, 400.0});
    const auto draw = [&titles](Ui& ui) {
      (void)ui.tabs("Tabs", titles, 1);
      (void)ui.button("After");
    };
    screen.wait(2, draw);
    Rect before{0.0, 0.0, 0.0, 0.0};
    for (const std::string& title : titles) {
      const Control& tab = screen.at("Tabs/" + title);
      EXPECT_LE(tab.rect.right(), width - 12.0 + 0.5) << title << " at " << width;
      EXPECT_EQ(tab.tooltip, "") << title << " is not cut at " << width;
      EXPECT_FALSE(overlaps(before, tab.rect));
      EXPECT_TRUE(tab.rect.top > before.top || tab.rect.left >= before.right() || before.width == 0)
          << "in their order";
      EXPECT_GE(screen.at("After").rect.top, tab.rect.bottom());
      before = tab.rect;
    }
  }
}

TEST(GeometryOfTabs, AreInOneRowWhereTheyFit) {
  const std::vector<std::string> titles = {"Layers", "Runs", "Moments", "Log"};
  HeadlessUi screen(ThemeName::kDark, 1.0, {320.0, 400.0});
  screen.wait(2, [&titles](Ui& ui) { (void)ui.tabs("Tabs", titles, 0); });
  for (const std::string& title : titles)
    EXPECT_EQ(screen.at("Tabs/" + title).rect.top, screen.at("Tabs/Layers").rect.top);
}

TEST(GeometryOfTabs, AreClickedInEveryRow) {
  const std::vector<std::string> titles = {"Moment", "Why", "Settings", "Camera"};
  HeadlessUi screen(ThemeName::kDark, 1.0, {150.0, 400.0});
  const auto draw = [&titles](Ui& ui) { return ui.tabs("Tabs", titles, 0); };
  for (std::size_t i = 1; i < titles.size(); ++i)
    EXPECT_EQ(screen.click("Tabs/" + titles[i], draw), std::optional(i));
}

TEST(DemoSheets, HaveNoTwoControlsOfOnePath) {
  HeadlessUi screen;
  screen.leave_out_region();
  DemoSheet sheet;
  sheet.shows_palette = true;
  screen.wait(3, [&sheet](Ui& ui) { sheet.draw(ui); });
  std::set<std::string> paths;
  for (const Control& control : screen.controls()) {
    if (control.kind == ControlKind::kText) continue;
    EXPECT_TRUE(paths.insert(control.path).second) << control.path;
  }
  EXPECT_GT(paths.size(), 60U);
}

TEST(DemoSheets, SurviveAHandThatDoesAnything) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    HeadlessUi screen(seed == 2U ? ThemeName::kLight : ThemeName::kDark, seed == 3U ? 1.5 : 1.0);
    screen.leave_out_region();
    DemoSheet sheet;
    std::mt19937 random(seed);
    const auto roll = [&random](unsigned sides) { return static_cast<int>(random() % sides); };
    for (int i = 0; i < 400; ++i) {
      FrameInput& input = screen.input();
      switch (roll(8)) {
        case 0:
          input.buttons[static_cast<std::size_t>(roll(3))] = roll(2) == 0;
          break;
        case 1:
          input.wheel.y() = roll(7) - 3;
          break;
        case 2:
          input.keys = {static_cast<Key>(256 + roll(14))};
          break;
        case 3:
          input.keys.clear();
          input.modifiers = {roll(4) == 0, roll(4) == 0};
          break;
        case 4:
          input.characters = std::string(1, static_cast<char>(' ' + roll(90)));
          break;
        case 5:
          sheet.shows_palette = roll(6) == 0;
          break;
        default:
          input.mouse_px = Eigen::Vector2d(roll(1280), roll(800));
      }
      screen.frame([&sheet](Ui& ui) { sheet.draw(ui); });
      for (const Control& control : screen.controls()) {
        ASSERT_TRUE(std::isfinite(control.rect.left + control.rect.top + control.rect.width +
                                  control.rect.height))
            << control.path;
        ASSERT_GE(control.rect.width, 0.0) << control.path;
        ASSERT_GE(control.rect.height, 0.0) << control.path;
      }
    }
  }
}

}  // namespace geometry_test
}  // namespace nadir::kit
