// SPDX-License-Identifier: Apache-2.0
#include "tests/core/session/session_fixture.h"

namespace nadir {
namespace session_rerun_test {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::SizeIs;

class SessionRerunTest : public SessionTest {};

TEST_F(SessionRerunTest, StartsAsTheRunWasStarted) {
  RerunTask task = SmallWorld::get().task(scratch_.path() / "lost.nadir");
  task.prior = GlobalPrior{};
  task.options.localiser.global_particle_count = 400;
  ASSERT_TRUE(rerun(task, {}, [](RerunProgress) {}));
  act("open " + task.run.string());
  settle();
  act("rerun start");
  settle();
  ASSERT_THAT(session_->runs(), SizeIs(2));
  EXPECT_EQ(document().header.options.at("prior"), "global");
  const auto& first = session_->runs()[0].document->steps;
  ASSERT_EQ(document().steps.size(), first.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(document().steps[i].estimate.moments.mean, first[i].estimate.moments.mean);
  }
  // What goes on from such a run began as it did.
  act("seek 2");
  act("rerun cursor");
  settle();
  act("rerun start");
  settle();
  EXPECT_EQ(document().header.parent_run, "");
  EXPECT_EQ(document().header.options.at("prior"), "global");
}

TEST_F(SessionRerunTest, RefusesToGuessHowARunWasStarted) {
  open_run();
  act("seek 2");
  act("rerun cursor");
  settle();
  act("close-run 1");
  fs::remove(run_);
  EXPECT_THAT(
      refused("rerun start"),
      HasSubstr("goes on from loop.nadir, which is not there, so how its flight began is not "
                "known"));
  EXPECT_THAT(session_->runs(), SizeIs(1));
}

TEST_F(SessionRerunTest, CountsOnlyTheNumbersThatItHasGiven) {
  fs::copy_file(run_, scratch_.path() / "kitti-00.nadir");
  fs::copy_file(run_, scratch_.path() / "drive-12.nadir");
  for (const auto& [run, made] :
       {std::pair("kitti-00", "kitti-00-2"), std::pair("drive-12", "drive-12-2")}) {
    act("open " + (scratch_.path() / (std::string(run) + ".nadir")).string());
    settle();
    act("rerun start");
    settle();
    EXPECT_EQ(session_->active_run()->name, made);
  }
  act("rerun start");
  settle();
  EXPECT_EQ(session_->active_run()->name, "drive-12-3") << "that one was ours";
}

TEST_F(SessionRerunTest, LocalisesTheRunsFlightWhateverElseWasOpened) {
  const fs::path other = scratch_.path() / "other";
  fs::copy(SmallWorld::get().flight, other, fs::copy_options::recursive);
  open_run();
  EXPECT_EQ(refused("rerun flight"), "no flight is open: open one first");
  act("open " + other.string());
  settle();
  EXPECT_EQ(session_->flight()->description().path, SmallWorld::get().flight);
  EXPECT_EQ(session_->flight_to_rerun(RerunFrom::kFlight).value()->description().path, other);
  ASSERT_TRUE(session_->notices().back().remedy);
  EXPECT_EQ(action_text(*session_->notices().back().remedy), "rerun flight") << "that is offered";
  act("rerun start");
  settle();
  EXPECT_EQ(document().header.flight_path, SmallWorld::get().flight.string());
  act("rerun flight");
  settle();
  EXPECT_EQ(document().header.flight_path, other.string());
  EXPECT_EQ(session_->active_run()->path, scratch_.path() / "other.nadir") << "of its own name";
  EXPECT_EQ(document().header.options.at("prior"), "truth of the first frame");
}

TEST_F(SessionRerunTest, SaysThatTheMapIsNotTheOneOfTheRun) {
  open_run();
  OverheadMap changed = SmallWorld::get().index->map();
  changed.labels.at(3, 3) = changed.labels.at(3, 3) == kRoad ? kCurb : kRoad;
  const fs::path map = scratch_.path() / "street";
  ASSERT_TRUE(
      write_overhead_map(changed, {"street", "made for a test", "CC0-1.0", ""}, std::nullopt, map));
  act("rerun start");
  settle();
  EXPECT_THAT(notice_texts(), testing::Each(Not(HasSubstr("whose cells are not those")))) << "yet";
  act("open " + map.string());
  settle();
  act("rerun start");
  EXPECT_THAT(notice_texts(),
              Contains(HasSubstr("whose cells are not those of the map that is open")));
  settle();
}

TEST_F(SessionRerunTest, MakesARunBesideTheActiveOneAndOpensIt) {
  open_run();
  const std::size_t steps = document().steps.size();
  ask_for_a_quick_run();
  act("rerun start");
  const fs::path made = scratch_.path() / "loop-2.nadir";
  ASSERT_THAT(session_->runs(), SizeIs(2));
  EXPECT_EQ(session_->runs()[1].path, made);
  EXPECT_TRUE(session_->runs()[1].is_live);
  EXPECT_EQ(session_->view().active_run, 1) << "it has nothing to show yet";
  EXPECT_THAT(session_->jobs()[0].title, HasSubstr("localising loop-2"));
  EXPECT_EQ(session_->undo_title(), "Rerun");
  settle();
  EXPECT_EQ(session_->view().active_run, 2);
  EXPECT_FALSE(session_->runs()[1].is_live);
  ASSERT_NE(session_->runs()[1].document, nullptr);
  EXPECT_EQ(document().steps.size(), steps);
  EXPECT_TRUE(document().is_complete);
  EXPECT_EQ(session_->playback().time_s, 0.0)
      << "the cursor went with it, and is back at the moment that was studied";
  EXPECT_THAT(notice_texts(), Contains(HasSubstr("loop-2 is done")));
  EXPECT_EQ(document().header.map_path, SmallWorld::get().map.string());
  for (std::size_t i = 0; i < steps; ++i) {  // the same options give the same bits
    EXPECT_EQ(document().steps[i].estimate.moments.mean,
              session_->runs()[0].document->steps[i].estimate.moments.mean);
  }
  act("undo");
  EXPECT_THAT(session_->runs(), SizeIs(1));
  EXPECT_TRUE(fs::exists(made)) << "its file stays";
  act("redo");
  settle();
  EXPECT_EQ(session_->runs()[1].document->steps.size(), steps);
}

TEST_F(SessionRerunTest, WhatIsSeenStaysUntilTheNewRunHasAStepThatIsDecoded) {
  open_run();
  act("seek 2");
  settle();
  const MapLook seen = session_->resolved_map_look();
  ask_for_a_slow_run(*session_);
  for (const char* from : {"rerun start", "rerun cursor"}) {
    act(from);
    const int made = static_cast<int>(session_->runs().size());
    const int before = session_->view().active_run;
    ASSERT_NE(before, made);
    while (session_->view().active_run != made) {
      ASSERT_EQ(session_->view().active_run, before);
      ASSERT_NE(session_->active_run()->document, nullptr) << "timeline and moment have something";
      ASSERT_NE(session_->step(), nullptr) << "and so have map and layers";
      ASSERT_TRUE(session_->is_busy());
      session_->poll(0.01);
      std::this_thread::yield();
    }
    ASSERT_NE(session_->step(), nullptr) << "from the first frame on";
    const MapLook now = session_->resolved_map_look();
    EXPECT_EQ(now.centre_in_enu_m, seen.centre_in_enu_m) << "the map does not jump";
    EXPECT_EQ(now.width_m, seen.width_m);
    act("cancel");
    settle();
    EXPECT_EQ(session_->view().active_run, made);
    act("run 1");
  }
}

TEST_F(SessionRerunTest, LeavesTheCursorWhereSomebodyMovedItBeforeItsFirstStep) {
  open_run();
  ask_for_a_quick_run();
  act("rerun start");
  act("seek 2");
  ASSERT_EQ(session_->view().active_run, 1);
  const double wanted_s = session_->playback().time_s;
  settle();
  EXPECT_EQ(session_->view().active_run, 2);
  EXPECT_EQ(session_->playback().time_s, wanted_s) << "neither its end nor where it was begun";
}

TEST_F(SessionRerunTest, UntilItIsSeenTheNextOneGoesByItInEveryWay) {
  RerunTask task = SmallWorld::get().task(scratch_.path() / "lost.nadir");
  task.prior = GlobalPrior{};
  task.options.localiser.global_particle_count = 400;
  ASSERT_TRUE(rerun(task, {}, [](RerunProgress) {}));
  open_run();
  EXPECT_EQ(session_->draft_prior(), "truth of the first frame");
  act(open(task.run));
  settle();
  EXPECT_EQ(session_->draft_prior(), "global");
  act("rerun start");
  act("close-run 2");
  ASSERT_EQ(session_->active_run()->name, "loop");
  EXPECT_EQ(session_->draft_base()->localiser.global_particle_count, 400);
  EXPECT_EQ(session_->draft_prior(), "global") << "of the same run as the options";
  act("rerun start");
  settle();
  EXPECT_EQ(session_->active_run()->name, "lost-3");
  EXPECT_EQ(document().header.options.at("global-particles"), "400");
  EXPECT_EQ(document().header.options.at("prior"), "global");
}

TEST_F(SessionRerunTest, LeavesWhatSomebodyTurnedToMeanwhileAlone) {
  open_run();
  act(open(copy_run("second.nadir")));
  settle();
  ask_for_a_quick_run();
  act("rerun start");
  act("run 1");
  settle();
  EXPECT_EQ(session_->view().active_run, 1);
  ASSERT_THAT(session_->runs(), SizeIs(3));
  EXPECT_TRUE(session_->runs()[2].document->is_complete);
}

TEST_F(SessionRerunTest, TakenBackBeforeItsFirstStepShowsWhatWasSeen) {
  open_run();
  const MapLook before = session_->view().map;
  ask_for_a_slow_run(*session_);
  act("rerun start");
  act("undo");
  EXPECT_EQ(session_->view().map, before) << "all of the run, as it was";
  act("cancel");
  settle();
  EXPECT_THAT(session_->runs(), SizeIs(1));
  EXPECT_EQ(session_->view().active_run, 1);
}

TEST_F(SessionRerunTest, NeverOverwritesARun) {
  open_run();
  ask_for_a_quick_run();
  scratch_.file("loop-2.nadir", "somebody's");
  act("rerun start");
  EXPECT_EQ(session_->runs()[1].name, "loop-3");
  act("rerun start");
  ASSERT_THAT(session_->runs(), SizeIs(3));
  EXPECT_EQ(session_->runs()[2].name, "loop-4") << "another one while the first is made";
  settle();
  EXPECT_THAT(session_->runs(), SizeIs(3));
  act("rerun start");
  ASSERT_THAT(session_->runs(), SizeIs(4));
  EXPECT_EQ(session_->runs()[3].name, "loop-5") << "of loop-4, which is not called loop-4-2";
  settle();
}

TEST_F(SessionRerunTest, GoesOnFromTheCursorWithTheRecordedParticles) {
  open_run();
  ask_for_a_quick_run();
  act("seek 2");
  act("option seed 7");
  act("rerun cursor");
  settle();
  ASSERT_THAT(session_->runs(), SizeIs(2));
  const RunDocument& before = *session_->runs()[0].document;
  const RunDocument& after = document();
  ASSERT_EQ(after.steps.size(), before.steps.size());
  EXPECT_EQ(after.header.parent_run, "loop.nadir");
  for (std::size_t i = 0; i <= 8; ++i) {
    EXPECT_EQ(after.steps[i].estimate.moments.mean, before.steps[i].estimate.moments.mean);
  }
  EXPECT_NE(after.steps.back().estimate.moments.mean, before.steps.back().estimate.moments.mean);
  act("go end");
  EXPECT_EQ(refused("rerun cursor"), "nothing of the flight comes after this moment");
}

TEST_F(SessionRerunTest, LocalisesAFlightThatWasOpenedByItself) {
  fs::copy(SmallWorld::get().flight, scratch_.path() / "flight", fs::copy_options::recursive);
  act("open " + (scratch_.path() / "flight").string());
  settle();
  EXPECT_EQ(refused("rerun start"), "no map is open: open one first");
  act("open " + SmallWorld::get().map.string());
  settle();
  ask_for_a_quick_run();
  act("rerun start");
  EXPECT_EQ(session_->runs()[0].path, scratch_.path() / "flight.nadir") << "beside the flight";
  settle();
  EXPECT_GT(document().steps.size(), 10U);
  EXPECT_EQ(refused("rerun cursor"), "nothing of the flight comes after this moment");
}

}  // namespace session_rerun_test
}  // namespace nadir
