// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "widgets/kit/headless_ui.h"

namespace nadir::kit {
namespace layout_test {

TEST(Layout, PutsTextIntoTheMiddleOfItsLine) {
  HeadlessUi screen;
  screen.frame([](Ui& ui) {
    ui.text("before");
    ui.same_line();
    (void)ui.button("Go");
    ui.same_line();
    ui.text("after");
    ui.text("alone");
  });
  EXPECT_EQ(screen.at("before").rect.centre().y(), screen.at("Go").rect.centre().y());
  EXPECT_EQ(screen.at("after").rect.centre().y(), screen.at("Go").rect.centre().y());
  EXPECT_EQ(screen.at("alone").rect.top, screen.at("Go").rect.bottom() + 4.0);
}

TEST(Layout, GrowsWithTheScale) {
  for (const double scale : {0.75, 1.0, 1.5, 3.0}) {
    HeadlessUi screen(ThemeName::kLight, scale);
    double taken = 0.0;
    screen.frame([&taken](Ui& ui) {
      (void)ui.button("Go");
      taken = ui.px(28.0);
    });
    EXPECT_NEAR(screen.at("Go").rect.height, 28.0 * scale, 0.5);
    EXPECT_EQ(screen.at("Go").rect.height, taken);
    EXPECT_NEAR(screen.at("Go").rect.left, 12.0 * scale, 0.5);
  }
}

TEST(Layout, AlignsAtTheRight) {
  HeadlessUi screen;
  screen.frame([](Ui& ui) {
    ui.text("title");
    ui.same_line();
    ui.right_align(ui.px(28.0));
    (void)ui.icon_button("Close", Icon::kClose, {"Close", ""});
  });
  EXPECT_EQ(screen.at("Close").rect.right(), 1280.0 - 12.0);
}

TEST(Layout, HasColumnsByWeight) {
  HeadlessUi screen;
  screen.wait(2, [](Ui& ui) {
    if (const auto columns = ui.columns("Both", {1.0, 3.0})) {
      ui.next_width(ui.room().width);
      (void)ui.button("Left");
      ui.next_column();
      ui.next_width(ui.room().width);
      (void)ui.button("Right");
    }
  });
  EXPECT_NEAR(screen.at("Right").rect.width / screen.at("Left").rect.width, 3.0, 0.1);
  EXPECT_EQ(screen.at("Right").rect.top, screen.at("Left").rect.top);
}

TEST(Layout, NamesPathsAfterAllScopes) {
  HeadlessUi screen;
  screen.frame([](Ui& ui) {
    const auto region = ui.region("Side", {0.0, 0.0, 300.0, 300.0});
    const auto scope = ui.scope("Layers");
    {
      const auto inner = ui.scope("particles");
      (void)ui.checkbox("visible##2", true);
    }
    (void)ui.button("Add");
  });
  EXPECT_TRUE(screen.has("Side/Layers/particles/visible##2"));
  EXPECT_EQ(screen.at("Side/Layers/particles/visible##2").label, "visible");
  EXPECT_TRUE(screen.has("Side/Layers/Add"));
  EXPECT_EQ(screen.at("Side").kind, ControlKind::kRegion);
}

TEST(Layout, ScrollsToWhatIsClicked) {
  HeadlessUi screen(ThemeName::kLight, 1.0, {300.0, 200.0});
  std::string clicked;
  const auto draw = [&clicked](Ui& ui) {
    for (int i = 0; i < 50; ++i) {
      const std::string name = "row " + std::to_string(i);
      if (ui.list_row(name)) clicked = name;
    }
  };
  screen.frame(draw);
  EXPECT_FALSE(screen.at("row 40").is_visible);
  screen.click("row 40", draw);
  EXPECT_EQ(clicked, "row 40");
  EXPECT_TRUE(screen.at("row 40").is_visible);
}

TEST(Layout, DrawsOnlyTheRowsInSightOfLongLists) {
  HeadlessUi screen;
  std::size_t drawn = 0;
  const auto draw = [&drawn](Ui& ui) {
    drawn = 0;
    const auto area = ui.scroll_area("Log", 280.0);
    ui.clipped_rows(10'000, ui.px(28.0), [&](std::size_t i) {
      ++drawn;
      (void)ui.list_row(std::to_string(i));
    });
  };
  screen.wait(3, draw);
  EXPECT_THAT(drawn, testing::AllOf(testing::Ge(10U), testing::Le(13U)));
}

TEST(Splitters, ResizeWhatLiesBesideThemAndCommitOnce) {
  HeadlessUi screen;
  double width = 300.0;
  std::vector<double> commits;
  bool grows_backwards = false;
  const auto draw = [&](Ui& ui) {
    const double at = grows_backwards ? 1280.0 - width : width;
    const auto edit = ui.splitter("Side", Rect{at - 4.0, 0.0, 8.0, 800.0}, Axis::kHorizontal, width,
                                  200.0, 500.0, grows_backwards);
    if (edit.is_changed) width = edit.value;
    if (edit.was_committed) commits.push_back(edit.value);
  };
  screen.drag("Side", 50.0, 10.0, draw);
  EXPECT_THAT(commits, testing::ElementsAre(350.0));
  screen.drag("Side", 900.0, 0.0, draw);
  EXPECT_EQ(width, 500.0);
  EXPECT_EQ(screen.context().cursor_name(), "arrow");
  grows_backwards = true;
  screen.drag("Side", 100.0, 0.0, draw);
  EXPECT_EQ(width, 400.0);
  (void)screen.hover("Side", draw);
  EXPECT_EQ(screen.context().cursor_name(), "resize ew");
}

TEST(Splitters, OfARegionMoveUpAndDown) {
  HeadlessUi screen;
  double height = 100.0;
  screen.drag("Strip", 0.0, 30.0, [&height](Ui& ui) {
    ui.space(height);
    if (const auto edit = ui.splitter("Strip", height, 40.0, 200.0); edit.is_changed)
      height = edit.value;
  });
  EXPECT_EQ(height, 130.0);
}

TEST(Overlays, CloseByEscapeOrByAClickBeside) {
  HeadlessUi screen;
  int below = 0;
  const auto draw = [&below](Ui& ui) {
    if (ui.button("Below")) ++below;
    OverlayStyle style;
    const auto overlay = ui.overlay("Palette", style);
    (void)ui.button("Inside");
    return overlay.wants_close();
  };
  EXPECT_FALSE(screen.wait(3, draw));
  EXPECT_FALSE(screen.click("Palette/Inside", draw));
  EXPECT_TRUE(screen.press("Escape", draw));
  EXPECT_TRUE(screen.click("Below", draw));
  EXPECT_EQ(below, 0) << "it lies under the overlay";
  const Rect rect = screen.at("Palette").rect;
  EXPECT_NEAR(rect.centre().x(), 640.0, 1.0);
  EXPECT_NEAR(rect.centre().y(), 400.0, 1.0);
  EXPECT_EQ(rect.width, 560.0);
}

TEST(Words, AreNotedAsTheyAreRead) {
  HeadlessUi screen(ThemeName::kLight, 1.0, {300.0, 300.0});
  screen.frame([](Ui& ui) {
    ui.heading("Moment");
    ui.number("1.84", "m");
    ui.read_out("Error", "1.84", "m", {"Distance from the truth", "", "", "evaluated"});
    ui.wrapped("a long sentence that takes more than one line of this narrow panel");
    ui.cut_text("a long name that is cut where the panel ends, which is soon");
    ui.icon(Icon::kWarning, TextLook::kWarning);
    ui.colour_dot({1, 2, 255});
    ui.line();
  });
  EXPECT_EQ(screen.at("Error").value, "1.84 m");
  EXPECT_EQ(screen.at("Error").tooltip, "Distance from the truth, evaluated");
  EXPECT_GT(
      screen.at("a long sentence that takes more than one line of this narrow panel").rect.height,
      30.0);
  const Control& cut = screen.at("a long name that is cut where the panel ends, which is soon");
  EXPECT_LE(cut.rect.right(), 300.0 - 12.0 + 0.5);
  EXPECT_EQ(cut.tooltip, cut.label) << "all of it";
  EXPECT_EQ(screen.at("dot").value, "#0102FF");
  EXPECT_TRUE(screen.has("warning"));
  EXPECT_THAT(screen.words(), testing::HasSubstr("Error: 1.84 m"));
}

TEST(Words, PartNeitherWithinANumberNorBeforeItsUnit) {
  HeadlessUi screen(ThemeName::kLight, 1.0, {300.0, 300.0});
  const auto width_of = [&](const std::string& words, const std::string& first_line) {
    double expected = 0.0;
    screen.wait(2, [&](Ui& ui) {
      expected = ui.text_width(first_line);
      const auto narrow =
          ui.columns("narrow", {expected + 30.0, ui.room().width - expected - 30.0});
      ui.wrapped(words);
    });
    return screen.at(words).rect.width - expected;
  };
  // There is room for "0." and for "12" behind the first words.
  EXPECT_NEAR(width_of("a mean cost of 0.274", "a mean cost of"), 0.0, 1.5);
  EXPECT_NEAR(width_of("the place is 12 metr off", "the place is"), 0.0, 1.5);
}

TEST(Words, OfAnEmptyPanelOfferTheOneButtonThatFillsIt) {
  HeadlessUi screen;
  const auto draw = [](Ui& ui) {
    return ui.empty_state(Icon::kFolderOpen, "No run is open.", "Open a run…", "Ctrl+O");
  };
  EXPECT_TRUE(screen.click("Open a run…", draw));
  EXPECT_TRUE(screen.shows("No run is open."));
  EXPECT_NEAR(screen.at("Open a run…").rect.centre().x(), 640.0, 1.0);
}

TEST(Words, AreMeasuredInTheirFace) {
  HeadlessUi screen;
  screen.frame([](Ui& ui) {
    EXPECT_NEAR(ui.text_width("1111", TextLook::kNumber), ui.text_width("0000", TextLook::kNumber),
                1e-6);
    EXPECT_GT(ui.text_width("wide", TextLook::kHeading), ui.text_width("wide"));
  });
}

}  // namespace layout_test
}  // namespace nadir::kit
