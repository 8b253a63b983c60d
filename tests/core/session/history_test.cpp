// SPDX-License-Identifier: Apache-2.0
#include "core/session/history.h"

#include <gmock/gmock.h>

namespace nadir {
namespace history_test {

TEST(History, GoesBackAndForth) {
  History<int> history;
  EXPECT_FALSE(history.can_undo());
  history.commit(1, "to two");
  history.commit(2, "to three");
  EXPECT_EQ(history.undo_title(), "to three");
  EXPECT_EQ(history.undo(3), 2);
  EXPECT_EQ(history.redo_title(), "to three");
  EXPECT_EQ(history.undo(2), 1);
  EXPECT_FALSE(history.can_undo());
  EXPECT_EQ(history.redo(1), 2);
  EXPECT_EQ(history.redo(2), 3);
  EXPECT_FALSE(history.can_redo());
}

TEST(History, MergesWhatHasTheSameKeyUntilItIsSealed) {
  History<int> history;
  history.commit(1, "drag", "look");
  history.commit(2, "drag", "look");
  history.commit(3, "other", "zoom");
  history.commit(4, "drag", "look");
  history.seal();
  history.commit(5, "drag", "look");
  EXPECT_EQ(history.undo(6), 5);
  EXPECT_EQ(history.undo(5), 4);
  EXPECT_EQ(history.undo(4), 3);
  EXPECT_EQ(history.undo(3), 1);
}

TEST(History, ForgetsTheOldestAndWhatWasUndone) {
  History<int> history(2);
  for (int i = 1; i <= 3; ++i) history.commit(i, "step");
  EXPECT_EQ(history.undo(4), 3);
  history.commit(3, "another way");
  EXPECT_FALSE(history.can_redo());
  EXPECT_EQ(history.undo(9), 3);
  EXPECT_EQ(history.undo(3), 2);
  EXPECT_FALSE(history.can_undo()) << "the first has gone";
}

TEST(History, LosesStepsThatLeadNowhereWhenItIsAmended) {
  History<int> history;
  history.commit(0, "open a");  // 0 -> 10: the run that cannot be read
  history.commit(10, "hide");   // 10 -> 11
  const auto without_run = [](int& state) { state %= 10; };
  int now = 11;
  without_run(now);
  history.amend(without_run, now);
  EXPECT_EQ(history.undo_title(), "hide");
  EXPECT_EQ(history.undo(now), 0);
  EXPECT_FALSE(history.can_undo());
  EXPECT_EQ(history.redo(0), 1);
}

TEST(History, AmendsOnlyWhatCameSinceAChange) {
  History<int> history;
  history.commit(0, "one");   // 0 -> 1
  history.commit(1, "open");  // 1 -> 11
  const std::uint64_t opened = history.last_change();
  history.commit(11, "two");  // 11 -> 12
  EXPECT_EQ(history.undo(12), 11);
  const auto to_hundreds = [](int& state) { state += 100; };
  int now = 11;
  to_hundreds(now);
  history.amend(to_hundreds, now, opened);
  EXPECT_EQ(history.redo(now), 112) << "the value after a later change";
  EXPECT_EQ(history.undo(112), 111) << "and the one before it";
  EXPECT_EQ(history.undo(111), 1) << "from before the opening";
  EXPECT_EQ(history.undo(1), 0);
}

TEST(History, EndsADragWhenItIsAmended) {
  History<int> history;
  history.commit(0, "drag", "splitter");
  history.amend([](int& state) { state += 10; }, 11);
  history.commit(11, "drag", "splitter");
  EXPECT_EQ(history.undo(12), 11) << "what comes after is a step of its own";
  EXPECT_EQ(history.undo(11), 10);
}

TEST(History, AmendsWhatWasUndoneToo) {
  History<int> history;
  history.commit(0, "one");
  history.commit(1, "ten");
  EXPECT_EQ(history.undo(11), 1);
  history.amend([](int& state) { state %= 10; }, 1);
  EXPECT_FALSE(history.can_redo()) << "it led to 11, which is 1 now";
  EXPECT_EQ(history.undo(1), 0);
}

}  // namespace history_test
}  // namespace nadir
