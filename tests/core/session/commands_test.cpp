// SPDX-License-Identifier: Apache-2.0
#include "core/session/commands.h"

#include <set>

#include "tests/core/session/session_fixture.h"

namespace nadir {
namespace commands_test {

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
      const bool is_pasted = command.text == "paste-view" || command.text == "paste-labels";
      EXPECT_NE(command.title.ends_with("..."), is_pasted) << command.title;
      std::set<std::string_view> names;
      for (const ActionHelp& help : action_helps()) names.insert(help.name);
      EXPECT_TRUE(names.contains(command.text.substr(0, command.text.find(' ')))) << command.text;
    }
  }
}

TEST(SessionCommands, HaveOneMeaningPerShortcutAndOneTitleEach) {
  std::set<std::string_view> shortcuts, label_shortcuts, titles;
  const std::set<std::string_view> menus = {"File", "Edit", "View", "Run", "Go", "Label", "Help"};
  for (const Command& command : session_commands()) {
    EXPECT_TRUE(titles.insert(command.title).second) << command.title;
    EXPECT_TRUE(menus.contains(command.menu)) << command.menu;
    if (command.shortcut.empty()) continue;
    auto& taken = command.menu == kLabelMenu ? label_shortcuts : shortcuts;
    EXPECT_TRUE(taken.insert(command.shortcut).second) << command.shortcut;
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
      "look",          "moment",        "place",         "select-particle", "layer-opacity",
      "layer-colour",  "layer-move",    "splitter",      "memory",          "strip-move",
      "strip-height",  "copy",          "bookmark-note", "bookmark-remove", "label-tab",
      "label-opacity", "point",         "trace",         "draw-area",       "draw-line",
      "draw-outline",  "draw-street",   "cut-hole",      "stroke",          "fill",
      "recode",        "select-labels", "select-box",    "move-vertex",     "add-vertex",
      "move-labels",   "split-labels"};
  for (const ActionHelp& help : action_helps()) {
    EXPECT_NE(reached.contains(help.name), others.contains(help.name)) << help.name;
  }
}

TEST(MatchingCommands, AreAllForNothingTypedInMenuOrder) {
  const auto all = matching_commands("  ");
  ASSERT_EQ(all.size(), session_commands().size());
  EXPECT_EQ(all.front(), &session_commands().front());
}

/// What people type, and the command that they mean.
struct Query {
  const char* typed;
  const char* first;
};

class MatchingQueries : public testing::TestWithParam<Query> {};

TEST_P(MatchingQueries, FindWhatIsMeantFirst) {
  const std::vector<std::string> found = found_by(GetParam().typed);
  ASSERT_FALSE(found.empty()) << GetParam().typed;
  EXPECT_EQ(found.front(), GetParam().first) << GetParam().typed;
}

INSTANTIATE_TEST_SUITE_P(Table,
                         MatchingQueries,
                         testing::Values(Query{"quit", "quit"},
                                         Query{"open", "open"},
                                         Query{"demo", "open-demo"},
                                         Query{"Dark", "theme dark"},
                                         Query{"theme l", "theme light"},
                                         Query{"light", "theme light"},
                                         Query{"next worst", "go next-worst"},
                                         Query{"worst", "go worst"},
                                         Query{"ctrl+z", "undo"},
                                         Query{"f5", "panel moment toggle"},
                                         Query{"zoom in", "zoom 1.5"},
                                         Query{"rerun", "rerun start"},
                                         Query{"rerun here", "rerun cursor"},
                                         Query{"rfh", "rerun cursor"},
                                         Query{"fitpar", "fit particles"},
                                         Query{"fp", "fit particles"},
                                         Query{"lpart", "layer particles toggle"},
                                         Query{"modes", "layer modes toggle"},
                                         Query{"rmse", "strip position-error toggle"},
                                         Query{"ess", "strip sample-size toggle"},
                                         Query{"nees", "strip nees toggle"},
                                         Query{"csv", "export-table"},
                                         Query{"svg", "export"},
                                         Query{"film", "export"},
                                         Query{"table", "export-table"},
                                         Query{"report", "report"},
                                         Query{"mgrs", "show place"},
                                         Query{"options", "preset run"},
                                         Query{"bookmark", "bookmark"},
                                         Query{"mark", "bookmark"},
                                         Query{"measure dist", "tool measure"},
                                         Query{"undo", "undo"},
                                         Query{"prefs", "show preferences"},
                                         Query{"exit", "quit"},
                                         Query{"why", "panel why toggle"},
                                         Query{"timeline", "panel timeline toggle"},
                                         Query{"keys", "show shortcuts"},
                                         Query{"speed 2", "speed 2"},
                                         Query{"seek", "seek"},
                                         Query{"?", "show shortcuts"}));

TEST(MatchingCommands, AreNotFoundByLettersScatteredOverWords) {
  EXPECT_THAT(found_by("rmse"), Not(Contains("layer modes toggle")));
  EXPECT_THAT(found_by("theme"), Not(Contains("quit")));
  EXPECT_THAT(found_by("opm"), Not(Contains("panel timeline toggle"))) << "p, m of other words";
  EXPECT_TRUE(found_by("qqqq").empty());
  EXPECT_TRUE(found_by("xtheme").empty());
}

TEST(MatchingCommands, HaveBeginningsOfWordsBeforeInitialsBeforeParts) {
  const auto place = [](std::string_view typed, std::string_view text) {
    const std::vector<std::string> found = found_by(typed);
    return std::find(found.begin(), found.end(), text) - found.begin();
  };
  EXPECT_LT(place("par", "fit particles"), place("par", "export")) << "a part of nothing there";
  EXPECT_LT(place("run", "run"), place("run", "rerun start")) << "a word before a part of one";
  EXPECT_LT(place("st", "go start"), place("st", "go worst"));
  EXPECT_LT(place("ti", "panel timeline toggle"), place("ti", "layer particles toggle"));
}

TEST(MatchingCommands, BeginWithThoseThatWereChosenLately) {
  const std::vector<std::string> recent = {"layer modes toggle", "quit"};
  const auto all = matching_commands("", recent);
  ASSERT_EQ(all.size(), session_commands().size());
  EXPECT_EQ(all[0]->text, "layer modes toggle");
  EXPECT_EQ(all[1]->text, "quit");
  EXPECT_EQ(all[2], &session_commands().front());
  EXPECT_EQ(matching_commands("layer", recent).front()->text, "layer modes toggle");
  EXPECT_EQ(matching_commands("undo", recent).front()->text, "undo") << "what fits better is first";
  const std::vector<std::string> unknown = {"no such command"};
  EXPECT_EQ(matching_commands("", unknown).front(), &session_commands().front());
}

TEST(MatchingCommands, OfEveryTitleAreLedByTheirOwn) {
  for (const Command& command : session_commands()) {
    const auto by_title = matching_commands(command.title),
               by_text = matching_commands(command.text);
    ASSERT_FALSE(by_title.empty()) << command.title;
    EXPECT_EQ(by_title.front(), &command) << command.title;
    ASSERT_FALSE(by_text.empty()) << command.text;
    EXPECT_EQ(by_text.front()->text, command.text);
  }
}

TEST(MatchingCommands, HaveAllLettersThatWereTypedInOrder) {
  for (const std::string_view typed : {"e", "an", "tog", "run", "s1", "m w", "opt", "par"}) {
    for (const Command* command : matching_commands(typed)) {
      const auto has_all = [typed](std::string_view text) {
        return std::all_of(typed.begin(), typed.end(), [text](char letter) {
          return letter == ' ' || std::any_of(text.begin(), text.end(), [letter](char other) {
                   return std::tolower(other) == letter;
                 });
        });
      };
      EXPECT_TRUE(has_all(command->title) || has_all(command->text) || has_all(command->shortcut) ||
                  has_all(command->also))
          << typed << ": " << command->title;
    }
  }
}

TEST(MatchingCommands, TakeAnythingThatCanBeTyped) {
  for (int code = 1; code < 256; ++code) {
    const std::string one(1, static_cast<char>(code));
    EXPECT_LE(matching_commands(one).size(), session_commands().size());
    EXPECT_LE(matching_commands(one + one + " " + one).size(), session_commands().size());
  }
  EXPECT_TRUE(found_by(std::string(5000, 'l')).empty());
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
    // Those on labels would draw on the map that all tests share.
    if (command.menu == kLabelMenu || command.text == "workspace label") continue;
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
    if (command.menu == kLabelMenu && command.text.starts_with("label-option")) continue;
    if (command.text == "dismiss" || command.text == "measure" || command.text == "loop") continue;
    if (command.text.starts_with("lay-at") || command.text.starts_with("follow")) continue;
    if (command.text.starts_with("show") || command.text.starts_with("tool")) continue;
    if (command.text == "fit flight") continue;  // harmless: it shows the map
    EXPECT_FALSE(session_->apply(*parse_action(command.text))) << command.text;
  }
}

}  // namespace commands_test
}  // namespace nadir
