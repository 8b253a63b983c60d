// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/run_labels.h"

#include <gmock/gmock.h>

#include "tests/core/session/made_run.h"

namespace nadir {
namespace run_labels_test {

/// Letters as wide as each other; of UTF-8 each byte that begins one.
double letters(const std::string& line) {
  double count = 0.0;
  for (const char letter : line) count += (static_cast<unsigned char>(letter) & 0xC0U) != 0x80U;
  return count;
}

TEST(FittedName, StaysWholeWhereThereIsRoom) {
  EXPECT_EQ(fitted_name("loop-2", 6.0, letters), "loop-2");
  EXPECT_EQ(fitted_name("", 0.0, letters), "");
}

TEST(FittedName, GivesWayInItsMiddleAndKeepsItsEnd) {
  for (double room = 4.0; room < 22.0; room += 1.0) {
    const std::string fitted = fitted_name("medium loop, noisy-12", room, letters);
    EXPECT_LE(letters(fitted), room);
    if (room >= 21.0) continue;
    EXPECT_EQ(letters(fitted), room) << "all the room is used";
    EXPECT_THAT(fitted, testing::HasSubstr("…"));
    EXPECT_EQ(fitted.substr(fitted.size() - 2), "12");
  }
}

TEST(FittedName, KeepsThreeCharactersWhateverTheRoom) {
  EXPECT_EQ(letters(fitted_name("medium loop", 0.5, letters)), 3.0);
  EXPECT_EQ(letters(fitted_name("Wörlitz über Alles", 5.0, letters)), 5.0);
}

TEST(NamesToldApart, LoseWhatTheyHaveInCommon) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(told_apart(Names{"town-noise-1.5", "town-noise-2", "town-noise-10"}),
            (Names{"…1.5", "…2", "…10"}));
  EXPECT_EQ(told_apart(Names{"loop slow 1", "loop fast 1"}), (Names{"…slow…", "…fast…"}));
  EXPECT_EQ(told_apart(Names{"slow loop", "fast loop"}), (Names{"slow…", "fast…"}));
}

TEST(NamesToldApart, KeepWordsWholeAndSomethingOfEach) {
  using Names = std::vector<std::string>;
  for (const Names& names :
       {Names{"run", "run-2"}, Names{"noise10", "noise12"}, Names{"a-1", "b-1"}, Names{"sptam"},
        Names{"same-1", "same-1"}, Names{}}) {
    const Names told = told_apart(names);
    ASSERT_EQ(told.size(), names.size());
    for (std::size_t i = 0; i < told.size(); ++i) {
      EXPECT_FALSE(told[i].empty());
      EXPECT_LE(letters(told[i]), letters(names[i]));
    }
  }
  EXPECT_EQ(told_apart(Names{"run", "run-2"}), (Names{"run", "run-2"}));
  EXPECT_EQ(told_apart(Names{"noise10", "noise12"}), (Names{"noise10", "noise12"}));
  EXPECT_EQ(told_apart(Names{"old run", "old run-2"}), (Names{"…run", "…run-2"}));
}

TEST(IncompleteRun, IsOneThatEndedBeforeItsEnd) {
  RunDocument made = made_run(431);
  EXPECT_FALSE(is_incomplete(*RunDocument::from_steps(made), false));
  made.is_complete = false;
  const auto stopped = RunDocument::from_steps(made);
  EXPECT_TRUE(is_incomplete(*stopped, false));
  EXPECT_FALSE(is_incomplete(*stopped, true)) << "it is still being written";
  EXPECT_EQ(incomplete_words(*stopped), "stopped at 00:43.0, after 431 steps");
  EXPECT_EQ(incomplete_words(*stopped, 100.0), "stopped at 00:43.0 of 01:40.0, after 431 steps");
  EXPECT_EQ(incomplete_words(*stopped, 20.0), "stopped at 00:43.0, after 431 steps")
      << "the flight of another run";
  RunDocument one = made_run(1);
  one.is_complete = false;
  EXPECT_EQ(incomplete_words(*RunDocument::from_steps(one)), "stopped at 00:00.0, after 1 step");
  RunDocument none = made_run(0);
  none.is_complete = false;
  EXPECT_FALSE(is_incomplete(*RunDocument::from_steps(none), false)) << "it has only begun";
}

}  // namespace run_labels_test
}  // namespace nadir
