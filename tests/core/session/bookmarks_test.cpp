// SPDX-License-Identifier: Apache-2.0
#include "core/session/bookmarks.h"

#include <gmock/gmock.h>

#include "core/base/staged_output.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace bookmarks_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const Bookmark kEarly{1.5, "early", {}};
const Bookmark kSpan{2.0, "a span", 3.25};
const Bookmark kLate{1.7e9 + 0.125, "late", {}};

class BookmarkFile : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path run() const { return scratch_.path() / "R.nadir"; }
  [[nodiscard]] std::string text() const {
    return read_text_file(bookmarks_file(run())).value_or("(no file)");
  }
  void write_by_hand(std::string_view text) const {
    (void)scratch_.file("R.nadir.bookmarks.toml", text);
  }
  [[nodiscard]] std::string refusal(std::string_view text) const {
    write_by_hand(text);
    return error_text(read_bookmarks(run()));
  }

  ScratchFolder scratch_;
};

TEST(Bookmarks, AreKeptInOrderAndOnceEach) {
  Bookmarks bookmarks = with_bookmark({}, kLate);
  bookmarks = with_bookmark(bookmarks, kEarly);
  bookmarks = with_bookmark(bookmarks, kSpan);
  EXPECT_THAT(bookmarks, ElementsAre(kEarly, kSpan, kLate));
  EXPECT_EQ(with_bookmark(bookmarks, kSpan), bookmarks);
  const Bookmark moment{2.0, "z", {}};
  EXPECT_THAT(with_bookmark(bookmarks, moment), ElementsAre(kEarly, moment, kSpan, kLate));
}

TEST(Bookmarks, MoveWhenTheirTimeIsChanged) {
  const Bookmarks bookmarks = {kEarly, kSpan, kLate};
  const Bookmark moved{5.0, "early", {}};
  EXPECT_THAT(with_bookmark_changed(bookmarks, 0, moved), ElementsAre(kSpan, moved, kLate));
  EXPECT_THAT(without_bookmark(bookmarks, 1), ElementsAre(kEarly, kLate));
}

TEST(Bookmarks, WithImpossibleTimesOrIndicesAreOurBug) {
  EXPECT_THROW((void)with_bookmark({}, {std::nan(""), "", {}}), std::logic_error);
  EXPECT_THROW((void)with_bookmark({}, {2.0, "", 2.0}), std::logic_error);
  EXPECT_THROW((void)without_bookmark({kEarly}, 1), std::logic_error);
}

TEST(Bookmarks, AreSteppedThroughWithoutStandingStill) {
  const Bookmarks bookmarks = {kEarly, kSpan, kLate};
  EXPECT_EQ(next_bookmark(bookmarks, 0.0), 0U);
  EXPECT_EQ(next_bookmark(bookmarks, 1.5), 1U);
  EXPECT_EQ(next_bookmark(bookmarks, kLate.time_s), std::nullopt);
  EXPECT_EQ(previous_bookmark(bookmarks, 2.0), 0U);
  EXPECT_EQ(previous_bookmark(bookmarks, 1.5), std::nullopt);
}

TEST_F(BookmarkFile, LiesBesideTheRun) {
  EXPECT_EQ(bookmarks_file("runs/R.nadir"), "runs/R.nadir.bookmarks.toml");
  EXPECT_THAT(*read_bookmarks(run()), IsEmpty()) << "none yet";
}

TEST_F(BookmarkFile, GivesBackWhatWasWritten) {
  const Bookmarks written = {
      {-0.5, "", {}}, kEarly, kSpan, {7.0, "lines\nand \"quotes\", \xC3\xA9 \t\\", 1e9}, kLate};
  const auto outcome = write_bookmarks(run(), written, {});
  ASSERT_TRUE(outcome) << error_text(outcome);
  EXPECT_EQ(*outcome, written);
  EXPECT_EQ(*read_bookmarks(run()), written);
  EXPECT_EQ(scratch_.entries(), 1) << "nothing half-written stays";
}

TEST_F(BookmarkFile, IsReadableByPeople) {
  ASSERT_TRUE(write_bookmarks(run(), {kSpan}, {}));
  EXPECT_EQ(text(),
            "# Bookmarks of a Nadir run; times are seconds after its first step.\nversion = 1\n\n"
            "[[bookmark]]\ntime_s = 2\nuntil_s = 3.25\nnote = \"a span\"\n");
}

TEST_F(BookmarkFile, GoesWithItsLastBookmark) {
  ASSERT_TRUE(write_bookmarks(run(), {kEarly}, {}));
  ASSERT_TRUE(write_bookmarks(run(), {}, {kEarly}));
  EXPECT_EQ(scratch_.entries(), 0);
  ASSERT_TRUE(write_bookmarks(run(), {}, {})) << "none and none to write";
}

TEST_F(BookmarkFile, KeepsWhatAnotherWindowDid) {
  ASSERT_TRUE(write_bookmarks(run(), {kEarly, kSpan}, {}));
  const Bookmarks known = *read_bookmarks(run());
  const Bookmark theirs{9.0, "theirs", {}};
  ASSERT_TRUE(write_bookmarks(run(), {kSpan, theirs}, known));  // adds one, removes kEarly
  const auto merged = write_bookmarks(run(), {kEarly, kSpan, kLate}, known);
  ASSERT_TRUE(merged);
  EXPECT_THAT(*merged, ElementsAre(kSpan, theirs, kLate));
  EXPECT_EQ(*read_bookmarks(run()), *merged);
}

TEST_F(BookmarkFile, TellsWhatIsWrongWithIt) {
  EXPECT_THAT(refusal("version = 1\n[[bookmark]]\ntime = 2\n"),
              HasSubstr("time is no known key (did you mean time_s?)"));
  EXPECT_THAT(refusal("version = 1\nbookmarks = 3\n"), HasSubstr("did you mean bookmark?"));
  EXPECT_THAT(refusal("[[bookmark]]\ntime_s = 2\n"), HasSubstr("version is missing"));
  EXPECT_THAT(refusal("version = 1\n[[bookmark]]\nnote = \"x\"\n"), HasSubstr("time_s is missing"));
  EXPECT_THAT(refusal("version = 1\n[[bookmark]]\ntime_s = 5\nuntil_s = 4\n"),
              HasSubstr("until_s is 4, not after time_s 5"));
  EXPECT_THAT(refusal("version = 1\n[[bookmark]]\ntime_s = nan\n"), HasSubstr("time_s"));
  EXPECT_THAT(refusal("version = 2\n"), HasSubstr("was written by a newer version"));
  EXPECT_THAT(refusal("version = 1\nbookmark = 4\n"), HasSubstr("bookmark"));
  EXPECT_THAT(refusal("version = 1\n[[bookmark]]\ntime_s = \"2\"\n"), HasSubstr("R.nadir"));
}

TEST_F(BookmarkFile, IsSortedWhereSomebodyEditedIt) {
  write_by_hand(
      "version = 1\n[[bookmark]]\ntime_s = 2\nnote = \"b\"\n"
      "[[bookmark]]\ntime_s = 1\nnote = \"a\"\n[[bookmark]]\ntime_s = 1\nnote = \"a\"\n");
  const Bookmark a{1.0, "a", {}};
  const Bookmark b{2.0, "b", {}};
  EXPECT_THAT(*read_bookmarks(run()), ElementsAre(a, b));
}

TEST_F(BookmarkFile, StaysAsItIsWhereItIsDamaged) {
  const std::string damaged = "version = 1\n[[bookmark]]\ntime_s = 2\nnote = \"somebody's wo";
  write_by_hand(damaged);
  const auto outcome = write_bookmarks(run(), {kEarly}, {});
  EXPECT_EQ(error_code(outcome), ErrorCode::kMalformed);
  EXPECT_THAT(error_text(outcome), HasSubstr("R.nadir.bookmarks.toml"));
  EXPECT_EQ(text(), damaged);
}

TEST_F(BookmarkFile, KeepsNotesThatAreNoText) {
  const Bookmark bookmark{1.0, "\xFF\xFE and \xEF\xBF\xBF", {}};
  const auto written = write_bookmarks(run(), {bookmark}, {});
  ASSERT_TRUE(written) << error_text(written);
  EXPECT_THAT(*written, ElementsAre(bookmark));
  EXPECT_THAT(*read_bookmarks(run()), ElementsAre(bookmark));
}

TEST_F(BookmarkFile, TakesNothingThatCouldNotBeReadAgain) {
  const auto endless = write_bookmarks(run(), {{1.0, "", 0.0}}, {});
  EXPECT_THAT(error_text(endless), HasSubstr("is no time span"));
  EXPECT_EQ(scratch_.entries(), 0);
}

TEST_F(BookmarkFile, NeedsAFolder) {
  const auto outcome = write_bookmarks(scratch_.path() / "no" / "R.nadir", {kEarly}, {});
  EXPECT_EQ(error_code(outcome), ErrorCode::kIo);
}

}  // namespace bookmarks_test
}  // namespace nadir
