// SPDX-License-Identifier: Apache-2.0
#include "tests/core/session/session_fixture.h"

namespace nadir {
namespace session_rerun_end_test {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// How a rerun ends: well, stopped, with a fault, or killed.
class SessionRerunEndTest : public SessionTest {};

TEST_F(SessionRerunEndTest, KeepsTheStepsOfARunThatFailsOnItsWay) {
  const fs::path flight = scratch_.path() / "torn";
  fs::copy(SmallWorld::get().flight, flight, fs::copy_options::recursive);
  std::vector<fs::path> images;
  for (const auto& entry : fs::directory_iterator(flight / "depth")) images.push_back(entry.path());
  std::sort(images.begin(), images.end());
  fs::resize_file(images.at(images.size() / 2), 20);
  act("open " + flight.string());
  act("open " + SmallWorld::get().map.string());
  settle();
  ask_for_a_quick_run();
  act("rerun flight");
  settle();
  ASSERT_THAT(session_->runs(), SizeIs(1));
  EXPECT_GT(document().steps.size(), 3U);
  EXPECT_FALSE(document().is_complete);
  EXPECT_THAT(notice_texts(), Contains(testing::AllOf(
                                  HasSubstr("torn failed after "), HasSubstr("they are kept: "),
                                  HasSubstr(images.at(images.size() / 2).filename().string()))));
}

TEST_F(SessionRerunEndTest, CanBeWatchedAndStoppedAndKeepsItsSteps) {
  open_run();
  ask_for_a_slow_run(*session_);
  act("rerun start");
  poll_until(*session_, [&] { return session_->view().active_run == 2; });
  EXPECT_TRUE(session_->runs()[1].is_live);
  const std::size_t seen = document().steps.size();
  poll_until(*session_, [&] { return document().steps.size() > seen; });
  EXPECT_EQ(session_->playback().time_s, document().duration_s()) << "the cursor stays at the end";
  act("seek 0");
  const std::size_t later = document().steps.size();
  poll_until(*session_, [&] { return document().steps.size() > later; });
  EXPECT_EQ(session_->playback().time_s, 0.0) << "until somebody moves it";
  act("cancel");
  settle();
  EXPECT_THAT(notice_texts(), Contains(HasSubstr("loop-2 was stopped; its")));
  EXPECT_THAT(session_->jobs(), IsEmpty());
  ASSERT_THAT(session_->runs(), SizeIs(2));
  EXPECT_FALSE(document().is_complete);
  EXPECT_EQ(static_cast<std::size_t>(RunReader::open(session_->runs()[1].path)->step_count()),
            document().steps.size());
}

TEST_F(SessionRerunEndTest, IsWatchedByWhoGoesToItBeforeItsFirstStep) {
  open_run();
  ask_for_a_slow_run(*session_);
  act("rerun start");
  act("run 2");
  poll_until(*session_, [&] { return session_->active_run()->document != nullptr; });
  const std::size_t seen = document().steps.size();
  poll_until(*session_, [&] { return document().steps.size() > seen + 1; });
  EXPECT_EQ(session_->playback().time_s, document().duration_s()) << "the cursor stays at the end";
  act("cancel");
  settle();
}

TEST_F(SessionRerunEndTest, LeavesTheCursorWaitingUntilItsEndIsRead) {
  open_run();
  ask_for_a_slow_run(*session_);
  act("rerun start");
  poll_until(*session_, [&] { return session_->view().active_run == 2; });
  act("run 1");
  act("seek 1000");
  act("run 2");  // what is being written may still come to that moment
  const double waits_at_s = session_->playback().time_s;
  ASSERT_GT(waits_at_s, document().duration_s());
  act("cancel");
  poll_until(*session_, [&] {
    const OpenRun& run = *session_->active_run();
    EXPECT_TRUE(run.is_live || session_->playback().time_s <= run.document->duration_s())
        << session_->playback().time_s << " s of " << run.document->duration_s() << " s";
    return !session_->is_busy();
  });
  EXPECT_FALSE(session_->runs()[1].is_live);
  EXPECT_LT(document().duration_s(), waits_at_s);
  EXPECT_EQ(session_->playback().time_s, document().duration_s());
}

TEST_F(SessionRerunEndTest, ComesBackToTheMomentThatWasStudiedUnlessSomebodyHasMoved) {
  open_run();
  act("seek 2");
  const double studied_s = session_->playback().time_s;
  ask_for_a_quick_run();
  act("rerun start");
  settle();
  ASSERT_EQ(session_->view().active_run, 2);
  EXPECT_EQ(session_->playback().time_s, studied_s);
  ask_for_a_slow_run(*session_);
  act("rerun start");
  poll_until(*session_, [&] { return session_->view().active_run == 3; });
  act("seek 0");
  act("cancel");
  settle();
  EXPECT_EQ(session_->playback().time_s, 0.0);
}

TEST_F(SessionRerunEndTest, LeavesAMapThatFitsItselfToDoSo) {
  open_run();
  ASSERT_EQ(session_->view().map.width_m, 0.0) << "nobody has chosen a view";
  const MapLook seen = session_->resolved_map_look();
  ask_for_a_quick_run();
  act("rerun start");
  settle();
  ASSERT_EQ(session_->view().active_run, 2);
  EXPECT_EQ(session_->view().map.width_m, 0.0);
  EXPECT_NEAR(session_->resolved_map_look().width_m, seen.width_m, 0.02 * seen.width_m);
}

TEST_F(SessionRerunEndTest, ThatIsClosedGoesOnAndIsOfferedWhenItIsDone) {
  open_run();
  ask_for_a_quick_run();
  act("rerun start");
  act("close-run 2");
  EXPECT_THAT(session_->jobs(), Not(IsEmpty()));
  settle();
  EXPECT_THAT(session_->runs(), SizeIs(1));
  ASSERT_FALSE(session_->notices().empty());
  const Notice done = session_->notices().back();
  EXPECT_THAT(done.text, HasSubstr("loop-2 is done"));
  ASSERT_TRUE(done.remedy);
  ASSERT_TRUE(session_->apply(*done.remedy));
  settle();
  EXPECT_THAT(session_->runs(), SizeIs(2));
}

TEST_F(SessionRerunEndTest, ThatFailsLeavesNothingButTheReason) {
  open_run();
  act("option min-votes 1000");
  act("rerun start");
  settle();
  EXPECT_THAT(session_->runs(), SizeIs(1));
  EXPECT_EQ(session_->view().active_run, 1);
  EXPECT_FALSE(fs::exists(scratch_.path() / "loop-2.nadir"));
  EXPECT_THAT(session_->notices().back().text, HasSubstr("loop-2 was not made: "));
  EXPECT_EQ(session_->undo_title(), "Set min-votes");
}

TEST_F(SessionRerunEndTest, IsStoppedInGoodOrderWhenTheSessionEnds) {
  open_run();
  ask_for_a_slow_run(*session_);
  act("rerun start");
  poll_until(*session_, [&] { return session_->runs()[1].document != nullptr; });
  start();
  const auto reader = RunReader::open(scratch_.path() / "loop-2.nadir");
  ASSERT_TRUE(reader) << error_text(reader);
  EXPECT_GE(reader->step_count(), 1);
  session_->restore();
  settle();
  EXPECT_THAT(session_->runs(), SizeIs(2)) << "it is open as before";
  EXPECT_THAT(session_->notices(), IsEmpty());
}

/// Run by the next test in a process of its own.
TEST(DISABLED_KilledSession, IsKilledWhileItMakesARun) {
  const fs::path folder = folder_of_this_process();
  ASSERT_FALSE(folder.empty()) << "only as part of another test";
  Session session(places_in(folder));
  ASSERT_TRUE(session.apply(actions::OpenFile{(folder / "loop.nadir").string()}));
  poll_until(session, [&] { return session.flight() && session.map() && session.map()->index; });
  ask_for_a_slow_run(session);
  const auto begun = session.apply(actions::Rerun{});
  ASSERT_TRUE(begun) << error_text(begun);
  poll_until(session, [&] {
    return session.runs()[1].document && session.runs()[1].document->steps.size() > 2;
  });
  ::raise(SIGKILL);
}

TEST_F(SessionRerunEndTest, ThatWasKilledIsOfferedByTheNextStartUpToItsLastStep) {
  session_.reset();
  ASSERT_EQ(killed_by_running("DISABLED_KilledSession.IsKilledWhileItMakesARun", scratch_.path()),
            SIGKILL);
  for (int i = 0; i < 2; ++i) {  // as often as somebody starts it otherwise: nadir gui other.nadir
    session_ = std::make_unique<Session>(places());
    EXPECT_THAT(notice_texts(), Contains(HasSubstr("loop-2.nadir was being made when")));
    act("open " + copy_run("other-" + std::to_string(i) + ".nadir").string());
    settle();
    act("rerun start");  // lists its own run beside it
    settle();
    session_->apply(actions::CloseRun{2});
    session_->apply(actions::CloseRun{1});
    session_.reset();
  }
  {
    Session session(places());  // as it was when the program was killed
    EXPECT_TRUE(session.apply(actions::OpenFile{run_.string()}));
    poll_until(session, [&] { return session.map() && session.map()->index; });
  }
  session_ = std::make_unique<Session>(places());
  session_->restore();
  settle();
  ASSERT_THAT(session_->runs(), SizeIs(1)) << "what was open before";
  ASSERT_THAT(session_->notices(), SizeIs(1));
  const Notice offer = session_->notices()[0];
  EXPECT_THAT(offer.text, HasSubstr("loop-2.nadir was being made when Nadir was ended"));
  EXPECT_EQ(offer.remedy_title, "Open it");
  ASSERT_TRUE(offer.remedy);
  ASSERT_TRUE(session_->apply(*offer.remedy));
  EXPECT_TRUE(session_->apply(actions::DismissNotice{offer.number})) << "as the same press asks";
  settle();
  ASSERT_THAT(session_->runs(), SizeIs(2));
  EXPECT_GT(document().steps.size(), 2U);
  EXPECT_FALSE(document().is_complete);
  ask_for_a_quick_run();
  act("option adapt-particles");
  act("option global-particles");
  act("go end");
  act("rerun cursor");
  settle();
  EXPECT_EQ(document().steps.size(), session_->runs()[0].document->steps.size())
      << "and can be brought to its end";
  start();
  EXPECT_THAT(notice_texts(), IsEmpty()) << "who has opened it is not asked again";
}

TEST_F(SessionRerunEndTest, ThatWasKilledIsNotOfferedAgainOnceThatIsDismissed) {
  session_.reset();
  ASSERT_EQ(killed_by_running("DISABLED_KilledSession.IsKilledWhileItMakesARun", scratch_.path()),
            SIGKILL);
  start();
  ASSERT_THAT(session_->notices(), SizeIs(1));
  act("dismiss");
  start();
  EXPECT_THAT(session_->notices(), IsEmpty());
  EXPECT_TRUE(fs::exists(scratch_.path() / "loop-2.nadir")) << "it is there for all that";
}

}  // namespace session_rerun_end_test
}  // namespace nadir
