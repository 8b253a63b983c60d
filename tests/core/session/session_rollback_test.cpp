// SPDX-License-Identifier: Apache-2.0
// What fails halfway leaves everything as it was, also what nobody sees.
#include "tests/core/session/session_fixture.h"

namespace nadir {
namespace session_rollback_test {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class SessionRollbackTest : public SessionTest {
 protected:
  [[nodiscard]] std::vector<std::string> notes_of(const fs::path& run) const {
    std::vector<std::string> notes;
    const Bookmarks read = read_bookmarks(run).value();
    for (const Bookmark& bookmark : read) notes.push_back(bookmark.note);
    return notes;
  }
  /// A recipe of the run that opens it, and the map, and then says something that is no time.
  [[nodiscard]] std::string recipe_that_fails_late() const {
    return "figure = \"moment\"\nruns = [\"loop.nadir\"]\nmap = \"" +
           SmallWorld::get().map.string() + "\"\n[options]\ntime = \"soon\"\n";
  }
};

TEST_F(SessionRollbackTest, ARecipeThatFailsAtItsEndHasOpenedNothing) {
  act("theme light");
  EXPECT_THAT(refused(open(scratch_.file("late.toml", recipe_that_fails_late()))),
              HasSubstr("time is not a number"));
  EXPECT_THAT(session_->runs(), IsEmpty());
  EXPECT_EQ(session_->map(), nullptr);
  EXPECT_EQ(session_->undo_title(), "Light theme");
  EXPECT_FALSE(session_->is_busy());
}

TEST_F(SessionRollbackTest, AFigureWhoseRecipeFailsAtItsEndHasOpenedNothing) {
  SessionPlaces with_figures = places();
  with_figures.recipe_in_figure = [this](const fs::path& /*figure*/) -> Result<std::string> {
    return recipe_that_fails_late();
  };
  session_ = std::make_unique<Session>(with_figures);
  act("theme light");
  act(open(scratch_.file("moment.svg", "x")));
  settle();
  EXPECT_THAT(notice_texts(), ElementsAre(HasSubstr("time is not a number")));
  EXPECT_THAT(session_->runs(), IsEmpty());
  EXPECT_EQ(session_->map(), nullptr);
  EXPECT_EQ(session_->undo_title(), "Light theme");
}

TEST_F(SessionRollbackTest, ARunThatIsBeingReadStillGetsItsMapAfterSomethingElseHasFailed) {
  act(open(run_));  // its map is known only once it is read
  EXPECT_THAT(refused(open(scratch_.file("late.toml", recipe_that_fails_late()))),
              HasSubstr("time is not a number"));
  settle();
  ASSERT_NE(session_->map(), nullptr);
  EXPECT_EQ(session_->map()->path, SmallWorld::get().map);
}

TEST_F(SessionRollbackTest, TheMomentOfARecipeIsGoneToThoughSomethingElseFailsMeanwhile) {
  act(open(scratch_.file("moment.toml",
                         "figure = \"moment\"\nruns = [\"loop.nadir\"]\n[options]\ntime = 2.5\n")));
  EXPECT_EQ(refused("redo"), "there is nothing to do again");
  settle();
  EXPECT_EQ(session_->playback().time_s, 2.5);
}

TEST_F(SessionRollbackTest, ARerunThatIsRefusedKeepsTheCursorWhereItIsWatched) {
  open_run();
  ask_for_a_slow_run(*session_);
  act("rerun start");
  poll_until(*session_, [&] { return session_->view().active_run == 2; });
  EXPECT_EQ(refused("option particles 0"), "particles: 0 is not in [1, 1000000]");
  EXPECT_THAT(refused("rerun flight"), HasSubstr("no flight is open"));
  const std::size_t seen = document().steps.size();
  poll_until(*session_, [&] { return document().steps.size() > seen; });
  EXPECT_EQ(session_->playback().time_s, document().duration_s()) << "it still goes along";
  act("cancel");
  settle();
}

TEST_F(SessionRollbackTest, ARerunIsShownWithItsFirstStepThoughSomethingElseFailsMeanwhile) {
  open_run();
  ask_for_a_slow_run(*session_);
  act("rerun start");
  ASSERT_EQ(session_->view().active_run, 1) << "what is seen stays until there is something else";
  EXPECT_THAT(refused(open(scratch_.file("late.toml", recipe_that_fails_late()))),
              HasSubstr("time is not a number"));
  poll_until(*session_, [&] { return session_->view().active_run == 2; });
  act("cancel");
  settle();
}

TEST_F(SessionRollbackTest, AnUndoThatFailsForOneRunHasNotChangedTheOther) {
  const fs::path second = copy_run("second.nadir");
  open_run();
  act("bookmark \"of the first\"");
  act(open(second));
  settle();
  act("bookmark \"of the second\"");
  act("run 1");
  scratch_.file("second.nadir.bookmarks.toml", "this is = = no file of ours");
  act("bookmark-note 1 \"the first\"");
  act("undo");
  EXPECT_THAT(notes_of(run_), ElementsAre("of the first"));
  act("undo");  // to run 1
  EXPECT_THAT(refused("undo"), HasSubstr("second.nadir.bookmarks.toml"));
  EXPECT_EQ(session_->undo_title(), "Bookmark");
  EXPECT_THAT(notes_of(run_), ElementsAre("of the first"));
  fs::remove(bookmarks_file(second));
  act("undo");
  act("redo");
  EXPECT_THAT(notes_of(second), ElementsAre("of the second"));
}

TEST_F(SessionRollbackTest, UndoLeavesWhatAnotherWindowHasMarked) {
  open_run();
  act("bookmark mine");
  ASSERT_TRUE(write_bookmarks(run_,
                              with_bookmark(read_bookmarks(run_).value(), {3.0, "theirs", {}}),
                              read_bookmarks(run_).value()));
  act("seek 1");
  act("bookmark \"mine too\"");
  act("undo");
  EXPECT_THAT(notes_of(run_), ElementsAre("mine", "theirs"));
  act("undo");
  EXPECT_THAT(notes_of(run_), ElementsAre("theirs"));
  act("redo");
  act("redo");
  EXPECT_THAT(notes_of(run_), ElementsAre("mine", "mine too", "theirs"));
}

TEST_F(SessionRollbackTest, UndoTakesBackEachStepThoughOneMetWhatAnotherWindowHasMarked) {
  open_run();
  act("bookmark mine");
  ASSERT_TRUE(write_bookmarks(run_,
                              with_bookmark(read_bookmarks(run_).value(), {3.0, "theirs", {}}),
                              read_bookmarks(run_).value()));
  act("bookmark-remove 1");
  EXPECT_THAT(notes_of(run_), ElementsAre("theirs"));
  act("undo");
  EXPECT_THAT(notes_of(run_), ElementsAre("mine", "theirs"));
  EXPECT_EQ(session_->undo_title(), "Bookmark");
  act("undo");
  EXPECT_THAT(notes_of(run_), ElementsAre("theirs"));
  act("redo");
  EXPECT_THAT(notes_of(run_), ElementsAre("mine", "theirs"));
  act("redo");
  EXPECT_THAT(notes_of(run_), ElementsAre("theirs"));
}

TEST_F(SessionRollbackTest, UndoDoesNotBringBackWhatAnotherWindowHasRemoved) {
  open_run();
  act("bookmark one");
  act("seek 1");
  act("bookmark two");
  ASSERT_TRUE(write_bookmarks(run_, {{1.0, "two", {}}}, read_bookmarks(run_).value()));
  act("seek 2");
  act("bookmark three");
  act("undo");
  EXPECT_THAT(notes_of(run_), ElementsAre("two"));
}

TEST_F(SessionRollbackTest, UndoLeavesWhatWasMarkedWhileTheRunWasClosed) {
  open_run();
  act("bookmark mine");
  act("close-run 1");
  ASSERT_TRUE(write_bookmarks(run_,
                              with_bookmark(read_bookmarks(run_).value(), {3.0, "theirs", {}}),
                              read_bookmarks(run_).value()));
  open_run();
  ASSERT_THAT(session_->active_run()->bookmarks, SizeIs(2));
  while (session_->undo_title() && *session_->undo_title() != "Bookmark") act("undo");
  EXPECT_THAT(notes_of(run_), ElementsAre("mine", "theirs"));
  act("undo");
  EXPECT_THAT(notes_of(run_), ElementsAre("theirs"));
}

}  // namespace session_rollback_test
}  // namespace nadir
