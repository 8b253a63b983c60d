// SPDX-License-Identifier: Apache-2.0
#include "core/base/staged_output.h"
#include "tests/core/run/recorded_run.h"
#include "tests/core/session/session_fixture.h"

namespace nadir {
namespace session_files_test {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class SessionFilesTest : public SessionTest {};

TEST_F(SessionFilesTest, RefusesWhatIsMissingOrForeignAtOnce) {
  const std::string folder = scratch_.path().string();
  EXPECT_EQ(refused("open " + folder + "/none.nadir"), folder + "/none.nadir: does not exist");
  EXPECT_EQ(refused("open \"\""), "no file is named");
  EXPECT_THAT(refused(open(scratch_.file("text.nadir", "this is no run"))),
              HasSubstr(folder + "/text.nadir: is not a run file, for it is a text; Nadir opens"));
  EXPECT_THAT(refused(open(scratch_.file("film.mp4", "x"))),
              HasSubstr("only PNG and SVG figures carry what they show"));
  EXPECT_THAT(refused(open(scratch_.file("other.toml", "a = 1\n"))), HasSubstr("is no recipe"));
  EXPECT_THAT(refused(open(scratch_.file("broken.toml", "a = \n"))),
              HasSubstr("broken.toml: line 1"));
  EXPECT_THAT(refused(open(scratch_.file("figure.png", "x"))), HasSubstr("cannot be opened here"));
  fs::create_directory(scratch_.path() / "bad-map");
  scratch_.file("bad-map/map.toml", "name = 3\n");
  EXPECT_THAT(refused(open(scratch_.path() / "bad-map")), HasSubstr("map.toml"));
  EXPECT_FALSE(session_->undo_title());
}

TEST_F(SessionFilesTest, TakesADamagedRunAwayAgainAndSaysWhy) {
  std::string bytes = read_text_file(run_).value();
  bytes.resize(bytes.size() / 3);
  const fs::path damaged = scratch_.file("damaged.nadir", bytes);
  act("theme light");
  act(open(damaged));
  EXPECT_THAT(session_->runs(), SizeIs(1));
  settle();
  EXPECT_THAT(session_->runs(), IsEmpty());
  ASSERT_THAT(session_->notices(), SizeIs(1));
  EXPECT_EQ(session_->notices()[0].kind, Notice::Kind::kError);
  EXPECT_THAT(session_->notices()[0].text, HasSubstr("damaged.nadir"));
  EXPECT_EQ(session_->undo_title(), "Light theme") << "as if it had never been opened";
  EXPECT_THAT(session_->recents(), IsEmpty());
}

TEST_F(SessionFilesTest, TakesARunWithoutStepsAwayAgain) {
  record_run(scratch_.path() / "empty.nadir", 0);
  open_run();
  act(open(scratch_.path() / "empty.nadir"));
  settle();
  EXPECT_THAT(run_names(), ElementsAre("loop"));
  EXPECT_EQ(session_->view().active_run, 1);
  EXPECT_THAT(notice_texts(), Contains(HasSubstr("empty.nadir: holds no steps")));
}

TEST_F(SessionFilesTest, TellsRunsOfOneNameApart) {
  fs::create_directory(scratch_.path() / "two");
  fs::copy_file(run_, scratch_.path() / "two" / "loop.nadir");
  open_run();
  act(open(scratch_.path() / "two" / "loop.nadir"));
  settle();
  EXPECT_THAT(run_names(), ElementsAre("loop", "loop (two)"));
  EXPECT_EQ(session_->view().runs[0].colour, 0);
  EXPECT_EQ(session_->view().runs[1].colour, 1);
  act("close-run 1");
  EXPECT_EQ(session_->view().runs[0].colour, 1) << "a run keeps its colour";
  EXPECT_EQ(session_->view().active_run, 1);
  act(open(run_));
  EXPECT_EQ(session_->view().runs[1].colour, 0) << "the first that is free";
  settle();
}

TEST_F(SessionFilesTest, GoesToARunThatIsOpenAlready) {
  open_run();
  act(open(copy_run("second.nadir")));
  settle();
  act("show-run 1 off");
  act(open(run_));
  EXPECT_THAT(session_->runs(), SizeIs(2));
  EXPECT_EQ(session_->view().active_run, 1);
  EXPECT_TRUE(session_->view().runs[0].is_shown);
  EXPECT_EQ(refused("show-run 1 off"), "loop is the active run, which is always shown");
  EXPECT_EQ(refused("run 3"), "there is no run 3: 2 are open");
  EXPECT_EQ(refused("close-run 0"), "there is no run 0: 2 are open");
}

TEST_F(SessionFilesTest, ReopensAClosedRunByUndo) {
  open_run();
  act("seek 2");
  act("bookmark here");
  act("close-run 1");
  EXPECT_THAT(session_->runs(), IsEmpty());
  EXPECT_EQ(session_->active_run(), nullptr);
  EXPECT_FALSE(session_->is_busy() && session_->playback().is_playing);
  act("undo");
  settle();
  ASSERT_THAT(session_->runs(), SizeIs(1));
  EXPECT_EQ(session_->runs()[0].bookmarks.size(), 1U);
  EXPECT_EQ(session_->playback().time_s, 2.0);
  act("redo");
  EXPECT_THAT(session_->runs(), IsEmpty());
}

TEST_F(SessionFilesTest, SaysSoWhenARunToReopenHasGone) {
  open_run();
  act("close-run 1");
  fs::remove(run_);
  act("undo");
  settle();
  EXPECT_THAT(session_->runs(), IsEmpty());
  EXPECT_THAT(notice_texts(), Contains(HasSubstr("loop.nadir")));
}

TEST_F(SessionFilesTest, TellsOfTheDemoInTheMiddleOnlyWhereNothingElseIsSeen) {
  act("open-demo");
  ASSERT_THAT(session_->jobs(), SizeIs(1));
  EXPECT_TRUE(session_->jobs()[0].will_be_shown);
  act("open " + run_.string());
  poll_until(*session_, [&] { return session_->active_run()->document != nullptr; });
  ASSERT_FALSE(session_->jobs().empty());
  for (const JobStatus& job : session_->jobs()) EXPECT_FALSE(job.will_be_shown) << job.title;
}

TEST_F(SessionFilesTest, MakesTheDemoOnceAndOpensIt) {
  act("open-demo");
  EXPECT_EQ(refused("open-demo"), "the demo is being made already");
  const auto effects = session_->take_effects();
  ASSERT_THAT(effects, SizeIs(1));
  const auto* demo = std::get_if<MakeDemoEffect>(&effects[0]);
  ASSERT_NE(demo, nullptr);
  EXPECT_EQ(demo->folder, (scratch_.path() / "data" / "demo").string());
  fs::create_directories(demo->folder);
  const fs::path made = fs::path(demo->folder) / "run.nadir";
  fs::copy_file(run_, made);
  session_->finish_effect(demo->job, "", made.string());
  settle();
  EXPECT_THAT(run_names(), ElementsAre("run"));
  act("close-run 1");
  act("open-demo");
  EXPECT_THAT(session_->take_effects(), IsEmpty()) << "it is there already";
  settle();
  EXPECT_THAT(run_names(), ElementsAre("run"));
}

TEST_F(SessionFilesTest, MakesADemoAgainThatIsNotWhole) {
  const fs::path made = scratch_.path() / "data" / "demo" / "run.nadir";
  fs::create_directories(made.parent_path());
  record_run(made, 5, 0, false);
  act("open-demo");
  ASSERT_THAT(session_->take_effects(), SizeIs(1));
  EXPECT_THAT(session_->runs(), IsEmpty());
  EXPECT_EQ(refused("open-demo"), "the demo is being made already");
}

TEST_F(SessionFilesTest, ReadsARunAgainThatIsOpenedAgainAfterItWasReplaced) {
  const fs::path path = scratch_.path() / "again.nadir";
  record_run(path, 10);
  act(open(path));
  settle();
  EXPECT_EQ(document().steps.size(), 10U);
  const auto before = session_->active_run()->document;
  act(open(path));
  settle();
  EXPECT_EQ(session_->active_run()->document, before) << "it is the same";
  record_run(path, 25);
  act(open(path));
  settle();
  EXPECT_THAT(session_->runs(), SizeIs(1));
  EXPECT_EQ(document().steps.size(), 25U);
}

TEST_F(SessionFilesTest, ShowsTheNewStepsOfARunThatAnotherProgramWrites) {
  const fs::path path = scratch_.path() / "growing.nadir";
  auto writer = RunWriter::create(path, example_header()).value();
  for (int i = 0; i < 5; ++i) ASSERT_TRUE(writer.write(example_step(i)));
  act(open(path));
  settle();
  EXPECT_EQ(document().steps.size(), 5U);
  for (int i = 5; i < 9; ++i) ASSERT_TRUE(writer.write(example_step(i)));
  session_->poll(1.5);
  settle();
  EXPECT_EQ(document().steps.size(), 9U);
  EXPECT_FALSE(document().is_complete);
  ASSERT_TRUE(writer.finish());
  session_->poll(1.5);
  settle();
  EXPECT_TRUE(document().is_complete);
}

}  // namespace session_files_test
}  // namespace nadir
