// SPDX-License-Identifier: Apache-2.0
#include "tests/core/session/session_fixture.h"

namespace nadir {
namespace session_bookmarks_test {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class SessionBookmarksTest : public SessionTest {
 protected:
  void SetUp() override { open_run(); }
  [[nodiscard]] std::vector<std::string> notes() const {
    std::vector<std::string> texts;
    for (const Bookmark& bookmark : session_->active_run()->bookmarks)
      texts.push_back(bookmark.note);
    return texts;
  }
  /// What lies in the file, which another start would read.
  [[nodiscard]] std::vector<std::string> notes_in_file() const {
    std::vector<std::string> texts;
    const Bookmarks read = read_bookmarks(run_).value();
    for (const Bookmark& bookmark : read) texts.push_back(bookmark.note);
    return texts;
  }
};

TEST_F(SessionBookmarksTest, LieInTheirFileAtOnce) {
  act("seek 2");
  act("bookmark second");
  act("seek 1");
  act("bookmark first");
  EXPECT_THAT(notes(), ElementsAre("first", "second"));
  EXPECT_THAT(notes_in_file(), ElementsAre("first", "second"));
  act("bookmark-note 2 \"the second\"");
  EXPECT_THAT(notes_in_file(), ElementsAre("first", "the second"));
  act("bookmark-remove 1");
  EXPECT_THAT(notes_in_file(), ElementsAre("the second"));
}

TEST_F(SessionBookmarksTest, AreTakenBackInTheirFileToo) {
  act("bookmark one");
  act("seek 1");
  act("bookmark two");
  act("bookmark-remove 1");
  act("undo");
  EXPECT_THAT(notes(), ElementsAre("one", "two"));
  EXPECT_THAT(notes_in_file(), ElementsAre("one", "two"));
  act("undo");
  act("undo");
  EXPECT_THAT(notes(), IsEmpty());
  EXPECT_FALSE(std::filesystem::exists(bookmarks_file(run_)));
  for (int i = 0; i < 3; ++i) act("redo");
  EXPECT_THAT(notes_in_file(), ElementsAre("two"));
}

TEST_F(SessionBookmarksTest, TakeANoteThatIsTypedBackInOneStep) {
  act("bookmark");
  for (const char* typed : {"a", "a t", "a turn"}) {
    act(std::string("bookmark-note 1 \"") + typed + "\"");
  }
  act("undo");
  EXPECT_THAT(notes_in_file(), ElementsAre(""));
}

TEST_F(SessionBookmarksTest, AreReadWithTheirRun) {
  act("bookmark kept");
  act("close-run 1");
  open_run();
  EXPECT_THAT(notes(), ElementsAre("kept"));
}

TEST_F(SessionBookmarksTest, OfAnotherWindowStay) {
  act("bookmark mine");
  ASSERT_TRUE(write_bookmarks(run_,
                              with_bookmark(read_bookmarks(run_).value(), {3.0, "theirs", {}}),
                              read_bookmarks(run_).value()));
  act("seek 1");
  act("bookmark \"mine too\"");
  EXPECT_THAT(notes_in_file(), ElementsAre("mine", "mine too", "theirs"));
}

TEST_F(SessionBookmarksTest, SayWhyTheyCannotBeKept) {
  EXPECT_EQ(refused("bookmark-remove 1"), "there is no bookmark 1: loop has 0");
  EXPECT_EQ(refused("bookmark-note 2 x"), "there is no bookmark 2: loop has 0");
  scratch_.file("loop.nadir.bookmarks.toml", "this is = = no file of ours");
  EXPECT_THAT(refused("bookmark here"), HasSubstr("bookmarks.toml"));
  EXPECT_THAT(notes(), IsEmpty());
}

TEST_F(SessionBookmarksTest, DoNotMoveTheHistoryWhereTheirFileCannotBeWritten) {
  act("bookmark here");
  scratch_.file("loop.nadir.bookmarks.toml", "this is = = no file of ours");
  EXPECT_THAT(refused("undo"), HasSubstr("bookmarks.toml"));
  EXPECT_EQ(session_->undo_title(), "Bookmark");
  EXPECT_FALSE(session_->redo_title());
  std::filesystem::remove(bookmarks_file(run_));
  act("undo");
  EXPECT_THAT(notes(), IsEmpty());
}

TEST_F(SessionBookmarksTest, ThatAreDamagedDoNotKeepTheRunFromBeingShown) {
  act("close-run 1");
  scratch_.file("loop.nadir.bookmarks.toml", "this is = = no file of ours");
  open_run();
  EXPECT_THAT(notice_texts(), Contains(HasSubstr("bookmarks.toml")));
  EXPECT_THAT(notes(), IsEmpty());
}

}  // namespace session_bookmarks_test
}  // namespace nadir
