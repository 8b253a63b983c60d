// SPDX-License-Identifier: Apache-2.0
#include "app/gui/gui_script.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace gui_script_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::string> words_of(std::string_view line) {
  const auto lines = parse_gui_script(line, "tour.txt");
  return lines && lines->size() == 1 ? lines->front().words : std::vector<std::string>();
}

TEST(GuiScript, SplitsLinesAtBlanksAndKeepsWhatIsQuoted) {
  EXPECT_THAT(words_of("  seek   12.5\t"), ElementsAre("seek", "12.5"));
  EXPECT_THAT(words_of("click \"Menu/File/Open...\""), ElementsAre("click", "Menu/File/Open..."));
  EXPECT_THAT(words_of("type Name \"\""), ElementsAre("type", "Name", ""));
  EXPECT_THAT(words_of(R"(bookmark "it said \"here\" \\")"),
              ElementsAre("bookmark", "it said \"here\" \\"));
  EXPECT_THAT(words_of("seek 1\r\n"), ElementsAre("seek", "1"));
}

TEST(GuiScript, LeavesCommentsAndEmptyLinesOutAndCountsThem) {
  const auto lines =
      parse_gui_script("# a tour\n\n  \nplay on # quickly\nbookmark a#b \"# c\"\n", "tour.txt");
  ASSERT_TRUE(lines) << error_text(lines);
  ASSERT_EQ(lines->size(), 2U);
  EXPECT_EQ(lines->at(0).number, 4);
  EXPECT_EQ(lines->at(0).text, "play on");
  EXPECT_EQ(lines->at(1).number, 5);
  EXPECT_THAT(lines->at(1).words, ElementsAre("bookmark", "a#b", "# c"));
}

TEST(GuiScript, RefusesAQuoteThatIsNotClosed) {
  const auto lines = parse_gui_script("play on\nbookmark \"here\n", "tour.txt");
  ASSERT_FALSE(lines);
  EXPECT_EQ(lines.error().message, "tour.txt:2: a quote is not closed");
}

/// A window of one button and one input.
class GuiScriptTest : public ::testing::Test {
 protected:
  ScratchFolder folder_;
  Session session_{{folder_.path() / "config", folder_.path() / "data", {}}};
  kit::HeadlessUi screen_;
  int clicks_ = 0;
  std::string name_;
  std::vector<std::string> photographed_;
  ScriptStage stage_{session_, screen_,
                     [this](kit::Ui& ui) {
                       if (ui.button("Count")) ++clicks_;
                       const auto typed = ui.text_input("Name", name_);
                       if (typed.is_changed) name_ = typed.value;
                       const auto off = ui.disabled(true, "nothing to stop");
                       ui.button("Stop");
                     },
                     [] { return true; },
                     [this](const std::filesystem::path& file) -> Result<void> {
                       photographed_.push_back(file.string());
                       return {};
                     }};

  std::string fault_of(std::string_view script) {
    const auto done = run_gui_script(script, "tour.txt", stage_);
    return done ? "" : done.error().message;
  }
};

TEST_F(GuiScriptTest, UsesControlsByTheirPaths) {
  EXPECT_EQ(
      fault_of("click Count\nclick Count\ntype Name \"two words\"\nexpect Name \"two words\"\n"
               "expect-not Nothing\nexpect-words Count\nscreenshot a.png\nwait\nwait 0.01\n"),
      "");
  EXPECT_EQ(clicks_, 2);
  EXPECT_EQ(name_, "two words");
  EXPECT_THAT(photographed_, ElementsAre("a.png"));
}

TEST_F(GuiScriptTest, DoesActionsByTheirWords) {
  EXPECT_EQ(fault_of("theme light\nspeed 2\n"), "");
  EXPECT_EQ(session_.view().appearance.theme, LightOrDark::kLight);
  EXPECT_EQ(session_.playback().speed, 2.0);
}

TEST_F(GuiScriptTest, StopsAtTheFirstFaultAndNamesItsLine) {
  EXPECT_THAT(fault_of("click Count\nclick Cuont\nclick Count\n"), HasSubstr("tour.txt:2: "));
  EXPECT_EQ(clicks_, 1);
  EXPECT_THAT(fault_of("click Stop"), HasSubstr("nothing to stop"));
  EXPECT_THAT(fault_of("expect Name other"), HasSubstr("shows"));
  EXPECT_THAT(fault_of("expect-words \"never said\""), HasSubstr("nowhere on the screen"));
  EXPECT_THAT(fault_of("click"), HasSubstr("the form is: click PATH"));
  EXPECT_THAT(fault_of("clikc Count"), HasSubstr("clikc: no such action (did you mean click?)"));
  EXPECT_THAT(fault_of("resize 10 ten"), HasSubstr("'ten' is not a number"));
  EXPECT_THAT(fault_of("resize 10 500"), HasSubstr("10 is not in"));
  EXPECT_THAT(fault_of("speed fast"), HasSubstr("tour.txt:1: "));
}

TEST_F(GuiScriptTest, WritesWhatControlsThereAre) {
  const std::string file = (folder_.path() / "controls.txt").string();
  ASSERT_EQ(fault_of("wait\ncontrols " + file), "");
  std::ifstream read(file);
  const std::string text(std::istreambuf_iterator<char>(read), {});
  EXPECT_THAT(text, HasSubstr("Count\tbutton\t"));
  EXPECT_THAT(text, HasSubstr("Name\ttext input\t"));
}

TEST_F(GuiScriptTest, ResizesTheScreen) {
  ASSERT_EQ(fault_of("resize 960 600"), "");
  EXPECT_EQ(screen_.input().size_px, Eigen::Vector2d(960.0, 600.0));
}

}  // namespace gui_script_test
}  // namespace nadir
