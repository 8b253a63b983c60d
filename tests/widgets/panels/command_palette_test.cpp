// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/command_palette.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "tests/widgets/panels/asked.h"
#include "widgets/kit/headless_ui.h"

namespace nadir {
namespace command_palette_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// An open palette of all commands.
struct OpenPalette {
  OpenPalette() {
    model.is_open = true;
    model.commands = all_offered();
  }
  kit::HeadlessUi screen;
  CommandPaletteModel model;
  PaletteState state;
  Actions operator()(kit::Ui& ui) { return draw_command_palette(ui, model, state); }
  std::vector<std::string> type(const std::string& words) {
    return texts(screen.type("Palette/Command", words, *this));
  }
};

TEST(CommandPalette, DrawsNothingWhileItIsClosed) {
  OpenPalette palette;
  palette.model.is_open = false;
  EXPECT_THAT(palette.screen.wait(2, palette), IsEmpty());
  EXPECT_FALSE(palette.screen.has("Palette"));
}

TEST(CommandPalette, TakesWhatIsTypedWithoutAClick) {
  OpenPalette palette;
  palette.screen.wait(3, palette);
  palette.screen.type_here("demo", palette);
  EXPECT_EQ(palette.state.typed, "demo");
}

TEST(CommandPalette, DoesTheBestMatchOnEnterAndCloses) {
  OpenPalette palette;
  EXPECT_THAT(palette.type("open demo"), ElementsAre("show none", "open-demo"));
}

TEST(CommandPalette, DoesWhatIsClicked) {
  OpenPalette palette;
  palette.screen.type("Palette/Command", "theme", palette, false);
  EXPECT_THAT(texts(palette.screen.click("Palette/" + line_of("theme light"), palette)),
              ElementsAre("show none", "theme light"));
}

TEST(CommandPalette, GoesDownTheListByArrowsAndAroundItsEnd) {
  OpenPalette palette;
  palette.screen.type("Palette/Command", "theme", palette, false);
  const std::vector<const Command*> found = matching_commands("theme");
  ASSERT_GE(found.size(), 2U);
  palette.screen.press("Down", palette);
  EXPECT_EQ(palette.state.highlighted, 1U);
  palette.screen.press("Up", palette);
  palette.screen.press("Up", palette);
  EXPECT_EQ(palette.state.highlighted, found.size() - 1);
  palette.screen.press("Down", palette);
  EXPECT_EQ(palette.state.highlighted, 0U);
}

TEST(CommandPalette, KeepsTheHighlightedLineInSight) {
  OpenPalette palette;
  palette.screen.wait(2, palette);
  for (int i = 0; i < 20; ++i) palette.screen.press("Down", palette);
  EXPECT_EQ(palette.state.highlighted, 20U);
  const Command& command = *matching_commands("")[20];
  const kit::Control& line = palette.screen.at("Palette/" + line_of(command.text));
  EXPECT_TRUE(line.is_selected);
  EXPECT_TRUE(palette.screen.at("Palette").rect.contains(line.rect.centre()));
}

TEST(CommandPalette, ShowsWholeRowsOnlyInWindowsOfAllSizes) {
  for (const double scale : {1.0, 1.5, 2.0}) {
    for (const double height : {480.0, 600.0, 733.0, 800.0, 1080.0}) {
      OpenPalette palette;
      palette.screen.context().set_look(ThemeName::kDark, scale);
      palette.screen.input().size_px = {1280.0, height};
      palette.screen.wait(4, palette);
      const double bottom = palette.screen.at("Palette").rect.bottom();
      EXPECT_LE(bottom, height);
      const auto lowest = [&] {
        double lowest_px = 0.0;
        for (const kit::Control& control : palette.screen.controls()) {
          if (control.path == "Palette") continue;
          lowest_px = std::max(lowest_px, control.rect.bottom());
          EXPECT_TRUE(control.is_visible) << control.path;
        }
        return lowest_px;
      };
      EXPECT_LE(lowest(), bottom) << height << " by " << scale;
      for (int i = 0; i < 30; ++i) palette.screen.press("Down", palette);
      EXPECT_LE(lowest(), bottom) << "also further down the list";
      EXPECT_TRUE(std::any_of(palette.screen.controls().begin(), palette.screen.controls().end(),
                              [](const kit::Control& control) { return control.is_selected; }));
    }
  }
}

TEST(CommandPalette, SaysWhyACommandCannotBeDoneAndDoesNotDoIt) {
  OpenPalette palette;
  for (OfferedCommand& offered : palette.model.commands) offered.why_not = "open a run first";
  EXPECT_THAT(palette.type("open demo"), IsEmpty());
  EXPECT_TRUE(palette.state.is_open);
  EXPECT_TRUE(
      palette.screen.shows("open a run first") ||
      palette.screen.at("Palette/" + line_of("open-demo")).tooltip.find("open a run first") !=
          std::string::npos);
}

TEST(CommandPalette, TakesAnActionWithItsArguments) {
  OpenPalette palette;
  EXPECT_THAT(palette.type("seek 12.5"), ElementsAre("show none", "seek 12.5"));
}

TEST(CommandPalette, TakesNumbersAsTypedRatherThanACommandThatBeginsLikeThem) {
  OpenPalette palette;
  EXPECT_THAT(palette.type("rotate 1"), ElementsAre("show none", "rotate 1"));
}

TEST(CommandPalette, SaysWhatIsWrongWithArgumentsWhileTheyAreTyped) {
  OpenPalette palette;
  palette.screen.type("Palette/Command", "seek abc", palette, false);
  EXPECT_TRUE(palette.screen.shows("seek SECONDS")) << palette.screen.words();
  EXPECT_TRUE(palette.screen.shows("is not a number")) << palette.screen.words();
  EXPECT_THAT(palette.screen.press("Enter", palette), IsEmpty());
}

TEST(CommandPalette, SaysThatNothingIsFound) {
  OpenPalette palette;
  palette.screen.type("Palette/Command", "qqqzzzxxx", palette, false);
  EXPECT_TRUE(palette.screen.shows("Nothing found"));
  EXPECT_THAT(palette.screen.press("Enter", palette), IsEmpty());
}

TEST(CommandPalette, ClosesByEscapeAndByAClickBesideIt) {
  OpenPalette palette;
  palette.screen.wait(3, palette);
  EXPECT_THAT(texts(palette.screen.press("Escape", palette)), testing::Contains("show none"));
  OpenPalette other;
  other.screen.wait(3, other);
  other.screen.input().mouse_px = Eigen::Vector2d(20.0, 780.0);
  other.screen.frame(other);
  other.screen.input().buttons[0] = true;
  EXPECT_THAT(texts(other.screen.frame(other)), ElementsAre("show none"));
}

TEST(CommandPalette, ForgetsWhatWasTypedWhenItIsOpenedAgain) {
  OpenPalette palette;
  palette.screen.type("Palette/Command", "theme", palette, false);
  palette.model.is_open = false;
  palette.screen.wait(3, palette);
  EXPECT_EQ(palette.state.typed, "");
  palette.model.is_open = true;
  palette.screen.wait(3, palette);
  EXPECT_EQ(palette.screen.at("Palette/Command").value, "");
}

TEST(CommandPalette, AsksForTheArgumentsOfACommandThatLacksThem) {
  OpenPalette palette;
  palette.state.begun = "export";
  palette.screen.wait(3, palette);
  EXPECT_TRUE(palette.screen.shows("export FILE [FIGURE] [WIDTH]")) << palette.screen.words();
  EXPECT_THAT(texts(palette.screen.type("Palette/##Arguments", "a.svg", palette)),
              ElementsAre("show none", "export a.svg"));
}

TEST(CommandPalette, GoesOnToArgumentsWhereSuchACommandIsChosen) {
  OpenPalette palette;
  EXPECT_THAT(palette.type("to a time"), IsEmpty());
  EXPECT_EQ(palette.state.begun, "seek");
  palette.screen.wait(3, palette);
  palette.screen.type_here("12", palette);
  EXPECT_EQ(palette.state.arguments, "12");
}

TEST(CommandPalette, GoesOnToTheBoxOfFilesWhereFilesAreAskedFor) {
  for (const auto& [typed, shown] :
       {std::pair("open", "show open"), std::pair("csv", "show export"),
        std::pair("save options", "show save-recipe")}) {
    OpenPalette palette;
    EXPECT_THAT(palette.type(typed), ElementsAre(shown)) << typed;
  }
}

TEST(CommandPalette, HasThoseChosenLatelyOnTopAndTellsWhatIsChosen) {
  OpenPalette palette;
  palette.model.recent_commands = {"theme light", "go worst"};
  palette.screen.wait(2, palette);
  EXPECT_LT(palette.screen.at("Palette/" + line_of("theme light")).rect.top,
            palette.screen.at("Palette/" + line_of("go worst")).rect.top);
  EXPECT_LT(palette.screen.at("Palette/" + line_of("go worst")).rect.top,
            palette.screen.at("Palette/" + line_of("open")).rect.top);
  EXPECT_THAT(palette.type("dark"), ElementsAre("show none", "theme dark"));
  EXPECT_EQ(palette.state.chosen, "theme dark");
}

TEST(CommandPalette, OffersRecentFilesToOpenByTheArrows) {
  OpenPalette palette;
  palette.state.begun = "open";
  palette.model.recents = {"/flights/one.nadir", "/flights/two.nadir"};
  palette.screen.wait(3, palette);
  palette.screen.press("Down", palette);
  palette.screen.press("Down", palette);
  EXPECT_THAT(texts(palette.screen.press("Enter", palette)),
              ElementsAre("show none", "open /flights/two.nadir"));
}

TEST(CommandPalette, OpensATypedPathRatherThanARecentOne) {
  OpenPalette palette;
  palette.state.begun = "open";
  palette.model.recents = {"/flights/one.nadir"};
  const Actions asked = palette.screen.type("Palette/##Arguments", "/flights/one", palette);
  ASSERT_THAT(asked, SizeIs(2));
  EXPECT_EQ(std::get<actions::OpenFile>(asked[1]).path, "/flights/one");
}

TEST(CommandPalette, Shows500RecentFilesWithinItsFrame) {
  OpenPalette palette;
  palette.state.begun = "open";
  for (int i = 0; i < 500; ++i) {
    palette.model.recents.push_back("/flights/" + std::string(120, 'x') + std::to_string(i) +
                                    ".nadir");
  }
  palette.screen.wait(3, palette);
  const kit::Rect frame = palette.screen.at("Palette").rect;
  for (const kit::Control& control : palette.screen.controls()) {
    EXPECT_GE(control.rect.left, frame.left) << control.path;
    EXPECT_LE(control.rect.bottom(), frame.bottom()) << control.path;
  }
}

TEST(BeginCommand, GivesTheActionOfAWholeCommand) {
  PaletteState state;
  const Command command{"theme dark", "Dark theme", "View", "", true};
  EXPECT_THAT(texts(begin_command(command, state)), ElementsAre("theme dark"));
  EXPECT_EQ(state.begun, "");
}

TEST(BeginCommand, OpensThePaletteForTheArgumentsOfOthers) {
  PaletteState state;
  const Command command{"seek", "To a time…", "Go", "", false};
  EXPECT_THAT(texts(begin_command(command, state)), ElementsAre("show palette"));
  EXPECT_EQ(state.begun, "seek");
}

TEST(FinishCommand, TakesATextWithBlanksAsOneArgument) {
  const auto action = finish_command("open", " my flights/a b.nadir ");
  ASSERT_TRUE(action) << action.error().message;
  EXPECT_EQ(std::get<actions::OpenFile>(*action).path, "my flights/a b.nadir");
}

TEST(CommandPalette, HasOneHighlightWhereverTabGoes) {
  OpenPalette palette;
  palette.screen.wait(3, palette);
  for (const char* const chord : {"Tab", "Down", "Tab", "Down"})
    palette.screen.press(chord, palette);
  for (const kit::Control& control : palette.screen.controls())
    EXPECT_FALSE(control.is_focused && control.kind == kit::ControlKind::kRow) << control.path;
  EXPECT_EQ(palette.state.highlighted, 2U);
}

TEST(FinishCommand, LeavesQuotesAndSeveralArgumentsToTheWordsOfActions) {
  const auto quoted = finish_command("open", "\"a b.nadir\"");
  ASSERT_TRUE(quoted) << quoted.error().message;
  EXPECT_EQ(std::get<actions::OpenFile>(*quoted).path, "a b.nadir");
  EXPECT_FALSE(finish_command("seek", "1 2"));
  EXPECT_FALSE(finish_command("open", "  "));
}

TEST(HelpOf, IsThatOfTheFirstWord) {
  ASSERT_TRUE(help_of("seek 12"));
  EXPECT_EQ(help_of("seek 12")->form, "seek SECONDS");
  EXPECT_FALSE(help_of("see"));
  EXPECT_FALSE(help_of(""));
}

TEST(OfferedArguments, AreRecentsLayoutsOrTheFormsWords) {
  CommandPaletteModel model;
  model.recents = {"/a"};
  model.layout_names = {"default", "wide"};
  EXPECT_THAT(offered_arguments("open", model), ElementsAre("/a"));
  EXPECT_THAT(offered_arguments("layout", model), ElementsAre("default", "wide"));
  EXPECT_THAT(offered_arguments("theme", model), ElementsAre("light", "dark"));
  EXPECT_THAT(offered_arguments("layer particles", model), ElementsAre("on", "off", "toggle"));
  EXPECT_THAT(offered_arguments("export", model), IsEmpty());
  EXPECT_THAT(offered_arguments("no such action", model), IsEmpty());
}

}  // namespace command_palette_test
}  // namespace nadir
