// SPDX-License-Identifier: Apache-2.0
// Names of files are bytes, and notes and names of layouts may be pasted from anywhere: nothing of it is lost in files of text.
#include "core/base/staged_output.h"
#include "core/session/unfinished_runs.h"
#include "core/session/view_text.h"
#include "tests/core/session/session_fixture.h"

namespace nadir {
namespace session_bytes_test {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// A session whose run, flight and map have names in Latin-1.
class SessionBytesTest : public SessionTest {
 protected:
  SessionBytesTest() {
    fs::create_directory(folder_);
    fs::copy_file(run_, latin_run_);
    fs::copy(SmallWorld::get().map, latin_map_, fs::copy_options::recursive);
    fs::copy(SmallWorld::get().flight, latin_flight_, fs::copy_options::recursive);
  }
  /// What is kept can be read by whoever knows TOML: it is UTF-8.
  void expect_files_to_be_readable() const {
    for (const fs::path& file : {session_file(), preferences_file()}) {
      const auto text = read_text_file(file);
      ASSERT_TRUE(text) << error_text(text);
      const auto read = Settings::parse(*text, file.string());
      EXPECT_TRUE(read) << error_text(read);
      EXPECT_THAT(*text, testing::Not(HasSubstr("\xE9")));
    }
  }

  fs::path folder_ = scratch_.path() / "M\xFCnchen \xFF\xFE";
  fs::path latin_run_ = folder_ / "caf\xE9.nadir";
  fs::path latin_map_ = folder_ /
                        "stra\xDF"
                        "e";
  fs::path latin_flight_ = folder_ / "\xC3\xA9t\xE9";  // half of it is UTF-8
};

TEST_F(SessionBytesTest, OpensWhatWasOpenWhateverItIsCalled) {
  act(open(latin_run_));
  settle();
  act(open(latin_map_));
  act(open(latin_flight_));
  settle();
  ASSERT_THAT(session_->runs(), SizeIs(1));
  const ViewState view = session_->view();
  EXPECT_EQ(view.map_path, latin_map_.string());
  EXPECT_EQ(view.flight_path, latin_flight_.string());
  restart();
  EXPECT_EQ(session_->view(), view);
  EXPECT_THAT(notice_texts(), ElementsAre(HasSubstr("can be localised"))) << "no complaint";
  ASSERT_NE(session_->active_run(), nullptr);
  EXPECT_EQ(session_->active_run()->path, latin_run_);
  EXPECT_NE(session_->active_run()->document, nullptr);
  ASSERT_NE(session_->map(), nullptr);
  EXPECT_NE(session_->map()->index, nullptr);
  EXPECT_TRUE(session_->flight_to_rerun(RerunFrom::kFlight));
  for (const fs::path& path : {latin_run_, latin_map_, latin_flight_}) {
    EXPECT_THAT(session_->recents(), Contains(path.string()));
  }
  session_.reset();
  expect_files_to_be_readable();
}

TEST_F(SessionBytesTest, OpensARecentFileAgain) {
  act(open(latin_run_));
  settle();
  start();
  ASSERT_THAT(session_->recents(), SizeIs(2)) << "the run and its map";
  EXPECT_THAT(session_->runs(), IsEmpty());
  ASSERT_TRUE(session_->apply(actions::OpenFile{session_->recents().front()}));
  ASSERT_TRUE(session_->apply(actions::OpenFile{session_->recents().back()}));
  settle();
  EXPECT_THAT(notice_texts(), IsEmpty());
  EXPECT_THAT(session_->runs(), SizeIs(1));
}

TEST_F(SessionBytesTest, SaysTheSameInTheLogAsWasDone) {
  act(open(latin_run_));
  settle();
  const auto again = parse_action(session_->log().back());
  ASSERT_TRUE(again) << error_text(again);
  EXPECT_EQ(*again, Action(actions::OpenFile{latin_run_.string()}));
}

TEST_F(SessionBytesTest, KeepsNotesLayoutsAndCommands) {
  act(open(latin_run_));
  settle();
  act("bookmark caf\xE9 \xEF\xBF\xBF"
      "E9");
  act("save-layout gr\xFCn");
  session_->remember_command("layout gr\xFCn");
  restart();
  ASSERT_THAT(session_->active_run()->bookmarks, SizeIs(1));
  EXPECT_EQ(session_->active_run()->bookmarks[0].note,
            "caf\xE9 \xEF\xBF\xBF"
            "E9");
  EXPECT_THAT(session_->layout_names(), ElementsAre("default", "gr\xFCn"));
  EXPECT_THAT(session_->recent_commands(), ElementsAre("layout gr\xFCn"));
  act("layout gr\xFCn");
}

TEST_F(SessionBytesTest, MakesARunBesideAndGoesOnFromIt) {
  act(open(latin_run_));
  settle();
  ask_for_a_quick_run();
  act("seek 2");
  act("rerun cursor");
  settle();
  ASSERT_THAT(session_->runs(), SizeIs(2));
  EXPECT_EQ(session_->runs()[1].path, folder_ / "caf\xE9-2.nadir");
  EXPECT_EQ(document().header.parent_run, "caf\xE9.nadir");
  EXPECT_TRUE(document().is_complete);
  act("rerun start");
  settle();
  EXPECT_THAT(session_->runs(), SizeIs(3));
}

TEST_F(SessionBytesTest, CopiesAViewThatCanBePasted) {
  act(open(latin_run_));
  settle();
  act("copy-view");
  const auto effects = session_->take_effects();
  ASSERT_THAT(effects, SizeIs(1));
  const std::string copied = std::get<SetClipboardEffect>(effects[0]).text;
  EXPECT_THAT(copied, testing::Not(HasSubstr("\xE9"))) << "a clipboard holds text";
  start();
  ASSERT_TRUE(session_->apply(actions::PasteView{copied}));
  settle();
  ASSERT_NE(session_->active_run(), nullptr);
  EXPECT_EQ(session_->active_run()->path, latin_run_);
}

TEST_F(SessionBytesTest, AsksForFiguresByARecipeThatNamesTheRun) {
  act(open(latin_run_));
  settle();
  act("export " + (scratch_.path() / "gr\xFCn.svg").string());
  const auto effects = session_->take_effects();
  ASSERT_THAT(effects, SizeIs(1));
  const auto& figure = std::get<DrawFigureEffect>(effects[0]);
  EXPECT_EQ(figure.file, (scratch_.path() / "gr\xFCn.svg").string());
  const auto recipe = Settings::parse(figure.recipe, "recipe");
  ASSERT_TRUE(recipe) << error_text(recipe);
  EXPECT_THAT(recipe->texts("runs").value(), ElementsAre(latin_run_.string()));
  const fs::path file = scratch_.file("moment.toml", figure.recipe);
  start();
  act(open(file));
  settle();
  ASSERT_NE(session_->active_run(), nullptr);
  EXPECT_EQ(session_->active_run()->path, latin_run_);
}

TEST_F(SessionBytesTest, ListsARunThatIsBeingWritten) {
  const fs::path config = scratch_.path() / "config";
  const std::string made = (folder_ / "made\xE9.nadir").string();
  WritingList list(config);
  ASSERT_TRUE(list.keep({made}));
  EXPECT_THAT(listed_runs(config).incomplete, ElementsAre(made));
  ASSERT_TRUE(list.keep({}));
}

}  // namespace session_bytes_test
}  // namespace nadir
