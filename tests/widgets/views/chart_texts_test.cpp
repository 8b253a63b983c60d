// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/chart_texts.h"

#include <gmock/gmock.h>

namespace nadir {
namespace chart_texts_test {

using testing::Each;
using testing::ElementsAre;
using testing::EndsWith;
using testing::IsEmpty;
using testing::SizeIs;

TextStyle words_of_12_px() { return {.size_px = 12.0}; }

double width_of(const std::string& text) { return measure_text(text, words_of_12_px()).width; }

std::vector<std::string> title_in(const std::string& title, double most_px, std::size_t lines) {
  return title_lines(title, words_of_12_px(), most_px, lines);
}

TEST(TitleLines, AreOneWhereItFits) {
  EXPECT_THAT(title_in("east error [m]", width_of("east error [m]") + 0.1, 2),
              ElementsAre("east error [m]"));
}

TEST(TitleLines, AreBrokenAtSpacesWhereTheyMayBe) {
  const double room = width_of("position error");
  EXPECT_THAT(title_in("position error [m]", room + 0.1, 2), ElementsAre("position error", "[m]"));
}

TEST(TitleLines, LoseWordsButKeepTheUnit) {
  EXPECT_THAT(title_in("orientation error [deg]", width_of("error [deg]") + 0.1, 1),
              ElementsAre("error [deg]"));
  EXPECT_THAT(title_in("orientation error [deg]", width_of("[deg]") + 0.1, 1),
              ElementsAre("[deg]"));
  EXPECT_THAT(title_in("orientation error [deg]", width_of("[deg]") - 1.0, 1), IsEmpty());
}

TEST(TitleLines, AreNotCutToWordsThatSaySomethingElse) {
  EXPECT_THAT(title_in("share of steps", width_of("of steps") + 0.1, 1), IsEmpty());
}

TEST(TitleLines, AreNoneWhereNoneAreAllowedOrThereIsNoTitle) {
  EXPECT_THAT(title_in("NEES", 500.0, 0), IsEmpty());
  EXPECT_THAT(title_in("", 500.0, 2), IsEmpty());
  EXPECT_THAT(title_in("error [m]", -4.0, 2), IsEmpty());
}

TEST(HeightOf, GrowsByALineAtATime) {
  const double one = height_of({"a"}, words_of_12_px());
  EXPECT_GT(one, 6.0);
  EXPECT_DOUBLE_EQ(height_of({"a", "b", "c"}, words_of_12_px()) - one, 2.0 * 1.3 * 12.0);
  EXPECT_EQ(height_of({}, words_of_12_px()), 0.0);
}

TEST(PartsOf, AreNeverEmpty) {
  EXPECT_THAT(parts_of("  a bc  d ", ' '), ElementsAre("a", "bc", "d"));
  EXPECT_THAT(parts_of("", ' '), IsEmpty());
  EXPECT_THAT(parts_of("one\ntwo", '\n'), ElementsAre("one", "two"));
}

BarsSpec groups_of(std::vector<std::string> names) {
  BarsSpec bars;
  bars.groups = std::move(names);
  return bars;
}

TEST(GroupTicks, BreakNamesAtSpacesAndCutLongWords) {
  const Ticks ticks =
      group_ticks(groups_of({"a", "proving ground", "ein-ganz-überaus-langer-name"}),
                  words_of_12_px(), width_of("proving ") + 5.0);
  EXPECT_THAT(ticks.at, ElementsAre(0.0, 1.0, 2.0));
  EXPECT_EQ(ticks.labels[0], "a");
  EXPECT_EQ(ticks.labels[1], "proving\nground");
  EXPECT_THAT(ticks.labels[2], EndsWith("…"));
  EXPECT_LE(width_of(ticks.labels[2]), width_of("proving ") + 5.0);
}

TEST(GroupTicks, StandOnLinesOfTheirOwnWhereNeighboursLeaveNoRoom) {
  const double group_px = width_of("vegetation") / 2.0;
  const Ticks ticks = group_ticks(groups_of({"road", "sidewalk", "building", "vegetation", "curb"}),
                                  words_of_12_px(), group_px);
  EXPECT_THAT(ticks.at, ElementsAre(0.0, 1.0, 2.0, 3.0, 4.0));
  EXPECT_THAT(ticks.labels,
              ElementsAre("road", " \nsidewalk", " \n \nbuilding", "vegetation", " \ncurb"));
}

TEST(GroupTicks, HaveThreeLinesAtMost) {
  const Ticks ticks = group_ticks(groups_of({"one two three four five six seven eight nine ten"}),
                                  words_of_12_px(), width_of("three") + 5.0);
  EXPECT_THAT(parts_of(ticks.labels[0], '\n'), SizeIs(3));
  EXPECT_THAT(ticks.labels[0], EndsWith("…"));
}

TEST(GroupTicks, NameOnlySomeOfManyNarrowGroups) {
  std::vector<std::string> names;
  for (int i = 0; i < 100; ++i) names.push_back("run-" + std::to_string(i));
  const Ticks ticks = group_ticks(groups_of(names), words_of_12_px(), 4.0);
  ASSERT_GE(ticks.at.size(), 5U);
  for (std::size_t i = 1; i < ticks.at.size(); ++i) {
    const double distance_px = 4.0 * (ticks.at[i] - ticks.at[i - 1]);
    EXPECT_GE(distance_px, (width_of(ticks.labels[i]) + width_of(ticks.labels[i - 1])) / 2.0);
  }
  EXPECT_THAT(group_ticks(groups_of({}), words_of_12_px(), 4.0).at, IsEmpty());
  EXPECT_THAT(group_ticks(groups_of(names), words_of_12_px(), 0.0).at, SizeIs(1));
}

TEST(StyleFor, TakesTheFaceOfWordsOnlyForARaisedMinus) {
  TextStyle numbers = words_of_12_px();
  numbers.face = FontFace::kNumbers;
  EXPECT_EQ(style_for({"0.1", "−3", "2×10⁵"}, numbers).face, FontFace::kNumbers);
  const TextStyle raised = style_for({"1", "10⁻⁵"}, numbers);
  EXPECT_EQ(raised.face, FontFace::kText);
  EXPECT_EQ(raised.size_px, numbers.size_px);
}

}  // namespace chart_texts_test
}  // namespace nadir
