// SPDX-License-Identifier: Apache-2.0
#include "core/session/commands.h"

#include <set>

#include "tests/core/session/session_fixture.h"

namespace nadir {
namespace {

using testing::Contains;
using testing::Not;

const Command& command_of(std::string_view text) {
  for (const Command& command : session_commands()) {
    if (command.text == text) return command;
  }
  throw std::logic_error("no such command: " + std::string(text));
}

std::vector<std::string> found_by(std::string_view typed) {
  std::vector<std::string> texts;
  for (const Command* command : matching_commands(typed)) texts.emplace_back(command->text);
  return texts;
}

TEST(SessionCommands, AreActionsThatCanBeParsed) {
  for (const Command& command : session_commands()) {
    const auto action = parse_action(command.text);
    if (command.is_whole) {
      EXPECT_TRUE(action) << command.text << ": " << error_text(action);
      EXPECT_EQ(action ? action_text(*action) : "", command.text);
    } else {
      // Of the clipboard's text nobody is asked.
      EXPECT_NE(command.title.ends_with("..."), command.text == "paste-view") << command.title;
      std::set<std::string_view> names;
      for (const ActionHelp& help : action_helps()) names.insert(help.name);
      EXPECT_TRUE(names.contains(command.text)) << command.text;
    }
  }
}

TEST(SessionCommands, HaveOneMeaningPerShortcutAndOneTitleEach) {
  std::set<std::string_view> shortcuts, titles;
  const std::set<std::string_view> menus = {"File", "Edit", "View", "Run", "Go", "Help"};
  for (const Command& command : session_commands()) {
    EXPECT_TRUE(titles.insert(command.title).second) << command.title;
    EXPECT_TRUE(menus.contains(command.menu)) << command.menu;
    if (command.shortcut.empty()) continue;
    EXPECT_TRUE(shortcuts.insert(command.shortcut).second) << command.shortcut;
  }
}

TEST(SessionCommands, HaveTheShortcutsThatEveryUserKnows) {
  const std::vector<std::pair<std::string_view, std::string_view>> known = {
      {"Space", "play toggle"},    {"Left", "step -1"},        {"Right", "step 1"},
      {"Home", "go start"},        {"End", "go end"},          {"F", "fit flight"},
      {"G", "show place"},         {"M", "tool measure"},      {"1", "layer picture toggle"},
      {"9", "layer truth toggle"}, {"[", "go previous-worst"}, {"]", "go next-worst"},
      {"B", "bookmark"},           {"Tab", "map-only toggle"}, {"Ctrl+Z", "undo"},
      {"Ctrl+Y", "redo"},          {"Ctrl+P", "show palette"}, {"?", "show shortcuts"},
      {"Ctrl+O", "open"},          {"Ctrl+Q", "quit"},         {"Ctrl+S", "export"}};
  for (const auto& [shortcut, text] : known) {
    EXPECT_EQ(command_of(text).shortcut, shortcut) << text;
  }
}

TEST(SessionCommands, ReachEveryActionThatNeedsNoPointer) {
  std::set<std::string_view> reached;
  for (const Command& command : session_commands()) {
    reached.insert(command.text.substr(0, command.text.find(' ')));
  }
  // Those are what a pointer does, or a control with a value.
  const std::set<std::string_view> others = {
      "look",       "place",         "select-particle", "layer-opacity", "layer-colour",
      "layer-move", "splitter",      "memory",          "strip-move",    "strip-height",
      "copy",       "bookmark-note", "bookmark-remove"};
  for (const ActionHelp& help : action_helps()) {
    EXPECT_NE(reached.contains(help.name), others.contains(help.name)) << help.name;
  }
}

TEST(MatchingCommands, AreAllForNothingTypedInMenuOrder) {
  const auto all = matching_commands("  ");
  ASSERT_EQ(all.size(), session_commands().size());
  EXPECT_EQ(all.front(), &session_commands().front());
}

TEST(MatchingCommands, BeginWithTheBest) {
  EXPECT_EQ(found_by("quit").front(), "quit");
  EXPECT_EQ(found_by("Dark").front(), "theme dark");
  EXPECT_EQ(found_by("next worst").front(), "go next-worst");
  EXPECT_EQ(found_by("ctrl+z").front(), "undo");
  EXPECT_EQ(found_by("zoom in").front(), "zoom 1.5");
  EXPECT_EQ(found_by("rerun").front(), "rerun start");
  EXPECT_EQ(found_by("fitpar").front(), "fit particles") << "letters in order";
  EXPECT_THAT(found_by("lpart"), Contains("layer particles toggle"));
}

TEST(MatchingCommands, LeaveOutWhatLacksALetter) {
  EXPECT_THAT(found_by("theme"), Not(Contains("quit")));
  EXPECT_TRUE(found_by("qqqq").empty());
}

TEST(MatchingCommands, HaveAllLettersThatWereTypedInOrder) {
  for (const std::string_view typed : {"e", "an", "tog", "run", "s1", "m w"}) {
    for (const Command* command : matching_commands(typed)) {
      const auto has_all = [typed](std::string_view text) {
        std::size_t at = 0;
        for (const char letter : typed) {
          if (letter == ' ') continue;
          while (at < text.size() && std::tolower(text[at]) != letter) ++at;
          if (at++ >= text.size()) return false;
        }
        return true;
      };
      EXPECT_TRUE(has_all(command->title) || has_all(command->text) || has_all(command->shortcut))
          << typed << ": " << command->title;
    }
  }
}

TEST_F(SessionTest, SaysWhyCommandsCannotBeDoneBeforeAnythingIsOpen) {
  EXPECT_EQ(why_not(command_of("play toggle"), *session_), "open a run first");
  EXPECT_EQ(why_not(command_of("go next-worst"), *session_), "open a run first");
  EXPECT_EQ(why_not(command_of("rerun start"), *session_), "open a run or a flight first");
  EXPECT_EQ(why_not(command_of("rerun cursor"), *session_), "open a run first");
  EXPECT_EQ(why_not(command_of("undo"), *session_), "nothing has been changed yet");
  EXPECT_EQ(why_not(command_of("redo"), *session_), "nothing has been taken back");
  EXPECT_EQ(why_not(command_of("cancel"), *session_), "no work is going on");
  EXPECT_EQ(why_not(command_of("split-view toggle"), *session_), "open a second run first");
  EXPECT_EQ(why_not(command_of("show place"), *session_), "open a map or a run first");
  EXPECT_EQ(why_not(command_of("measure"), *session_), "nothing is measured");
  EXPECT_EQ(why_not(command_of("close-run"), *session_), "open a run first");
  EXPECT_EQ(why_not(command_of("open"), *session_), "");
  EXPECT_EQ(why_not(command_of("theme light"), *session_), "");
}

TEST_F(SessionTest, CanDoEveryCommandOfWhichItSaysNothing) {
  open_run();
  act("open " + copy_run("second.nadir").string());
  settle();
  for (const Command& command : session_commands()) {
    const bool begins_work = command.text.starts_with("rerun") || command.text == "open-demo";
    if (!command.is_whole || begins_work || !why_not(command, *session_).empty()) continue;
    const auto done = session_->apply(*parse_action(command.text));
    const bool is_at_the_edge = command.text.starts_with("go ");  // no moment comes after the last
    EXPECT_TRUE(done || is_at_the_edge) << command.text << ": " << error_text(done);
    settle();
  }
  act("play off");
}

TEST_F(SessionTest, CannotDoWhatACommandIsRefusedFor) {
  for (const Command& command : session_commands()) {
    if (!command.is_whole || why_not(command, *session_).empty()) continue;
    if (command.text == "dismiss" || command.text == "measure" || command.text == "loop") continue;
    if (command.text.starts_with("lay-at") || command.text.starts_with("follow")) continue;
    if (command.text.starts_with("show") || command.text.starts_with("tool")) continue;
    if (command.text == "fit flight") continue;  // harmless: it shows the map
    EXPECT_FALSE(session_->apply(*parse_action(command.text))) << command.text;
  }
}

}  // namespace
}  // namespace nadir
