// SPDX-License-Identifier: Apache-2.0
#include "app/gui/undo_pace.h"

#include <gmock/gmock.h>

#include <string>

#include "core/session/history.h"

namespace nadir {
namespace undo_pace_test {

/// A view that a hand zooms and drags, frame by frame, with a clock of the test's own.
struct HandledView {
  History<int> history;
  UndoPace pace;
  int view = 0;

  void frame(double elapsed_s, const std::string& asked = {}, bool is_held = false) {
    if (pace.is_over(elapsed_s)) history.seal();
    if (!asked.empty()) {
      history.commit(view, asked, asked);
      ++view;
    }
    pace.note(!asked.empty(), is_held);
  }
  /// Frames in which nothing happens.
  void rest(double seconds) {
    for (double passed = 0.0; passed < seconds - 1e-9; passed += 0.05) frame(0.05);
  }
  [[nodiscard]] int steps() {
    int count = 0;
    for (; history.can_undo(); ++count) view = history.undo(view);
    return count;
  }
};

TEST(UndoPace, MakesOneStepOfNotchesThatFollowEachOther) {
  HandledView view;
  view.frame(3.0, "zoom");
  for (int i = 0; i < 9; ++i) {
    view.rest(0.4);
    view.frame(0.2, "zoom");
  }
  EXPECT_EQ(view.view, 10);
  EXPECT_EQ(view.steps(), 1) << "though all of them took 5.4 s";
  EXPECT_EQ(view.view, 0) << "what undo goes back to is the view before the first";
}

TEST(UndoPace, BeginsAnotherStepAfterARest) {
  for (const bool draws : {true, false}) {
    HandledView view;
    for (int i = 0; i < 3; ++i) {
      if (draws) view.rest(0.75);
      view.frame(draws ? 0.0 : 0.75, "zoom");  // without input the window draws no frames
    }
    EXPECT_EQ(view.steps(), 3);
  }
}

TEST(UndoPace, KeepsDifferentDoingsApartHoweverFast) {
  HandledView view;
  for (const char* const asked : {"zoom", "zoom", "look", "zoom"}) view.frame(0.05, asked);
  EXPECT_EQ(view.steps(), 3);
}

TEST(UndoPace, TakesADragForOneDoingHoweverLongItRests) {
  HandledView view;
  view.frame(1.0, "look", true);
  view.frame(5.0, "look", true);  // no frame was drawn while the hand held still
  view.frame(0.3, {}, true);
  view.frame(9.0, "look", true);
  view.frame(0.1);
  EXPECT_EQ(view.steps(), 1);
}

TEST(UndoPace, JoinsDragsThatFollowEachOther) {
  HandledView view;
  for (int i = 0; i < 3; ++i) {
    view.frame(0.3, "look", true);
    view.frame(0.1, "look", true);
    view.frame(0.1);
  }
  view.rest(1.0);
  view.frame(0.1, "look", true);
  EXPECT_EQ(view.steps(), 2);
}

}  // namespace undo_pace_test
}  // namespace nadir
