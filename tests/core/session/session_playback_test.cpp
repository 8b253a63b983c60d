// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "core/session/run_comparison.h"
#include "tests/core/run/recorded_run.h"
#include "tests/core/session/session_fixture.h"

namespace nadir {
namespace session_playback_test {

using testing::HasSubstr;

class SessionPlaybackTest : public SessionTest {
 protected:
  void SetUp() override { open_run(); }
  [[nodiscard]] double now_s() const { return session_->playback().time_s; }
  [[nodiscard]] double end_s() const { return document().duration_s(); }
};

TEST_F(SessionPlaybackTest, SeeksWithinTheRun) {
  act("seek 1.1");
  EXPECT_EQ(now_s(), 1.1);
  EXPECT_EQ(session_->step_index(), 4U) << "the last step that is not after it";
  act("seek 9999");
  EXPECT_EQ(now_s(), end_s());
  act("seek -3");
  EXPECT_EQ(now_s(), 0.0);
  EXPECT_FALSE(session_->apply(actions::Seek{std::nan("")}));
  EXPECT_EQ(session_->undo_title(), "Open loop.nadir") << "time is not undone";
}

TEST_F(SessionPlaybackTest, StepsFromStepToStep) {
  act("step 3");
  EXPECT_EQ(session_->step_index(), 3U);
  EXPECT_EQ(now_s(), document().time_s[3]);
  act("step -1");
  EXPECT_EQ(session_->step_index(), 2U);
  act("step -100");
  EXPECT_EQ(session_->step_index(), 0U);
  act("step 2147483647");
  EXPECT_EQ(session_->step_index(), document().steps.size() - 1);
  act("seek 1.1");
  act("step 1");
  EXPECT_EQ(session_->step_index(), 5U);
}

TEST_F(SessionPlaybackTest, PlaysAtItsSpeedAndStopsAtTheEnd) {
  act("play");
  EXPECT_TRUE(session_->playback().is_playing);
  EXPECT_TRUE(session_->is_busy());
  session_->poll(0.5);
  EXPECT_DOUBLE_EQ(now_s(), 0.5);
  act("speed 4");
  session_->poll(0.25);
  EXPECT_DOUBLE_EQ(now_s(), 1.5);
  act("play");
  session_->poll(1.0);
  EXPECT_DOUBLE_EQ(now_s(), 1.5) << "paused";
  act("play on");
  act("play on");
  session_->poll(1e6);
  EXPECT_EQ(now_s(), end_s());
  EXPECT_FALSE(session_->playback().is_playing);
  act("play on");
  EXPECT_EQ(now_s(), 0.0) << "again from the beginning";
  session_->poll(-1.0);
  EXPECT_EQ(now_s(), 0.0) << "time does not go back";
}

TEST_F(SessionPlaybackTest, KeepsSpeedWithinItsRange) {
  EXPECT_EQ(refused("speed 0.01"), "a speed of 0.01 is not in [0.1, 20]");
  EXPECT_EQ(refused("speed 21"), "a speed of 21 is not in [0.1, 20]");
  act("speed 0.1");
  act("speed 20");
}

TEST_F(SessionPlaybackTest, LoopsOverItsRange) {
  act("loop 1 2");
  act("seek 1.5");
  act("play on");
  session_->poll(0.75);
  EXPECT_NEAR(now_s(), 1.25, 1e-12) << "0.25 after the beginning";
  session_->poll(10.5);
  EXPECT_NEAR(now_s(), 1.75, 1e-12);
  EXPECT_TRUE(session_->playback().is_playing);
  act("seek 4");
  session_->poll(0.1);
  EXPECT_GE(now_s(), 1.0);
  EXPECT_LT(now_s(), 2.0) << "it comes into the range";
  act("go end");
  EXPECT_EQ(now_s(), 2.0);
  act("go start");
  EXPECT_EQ(now_s(), 1.0);
  act("loop");
  EXPECT_FALSE(session_->playback().loop_from_s);
  act("go end");
  EXPECT_EQ(now_s(), end_s());
}

TEST_F(SessionPlaybackTest, RefusesRangesOfNothing) {
  EXPECT_THAT(refused("loop 2 1"), HasSubstr("from 2 s to 1 s there is nothing of this run"));
  EXPECT_THAT(refused("loop 999 1000"), HasSubstr("there is nothing of this run"));
  EXPECT_FALSE(session_->apply(actions::SetLoop{1.0, {}}));
  act("loop -5 1");
  EXPECT_EQ(session_->playback().loop_from_s, 0.0) << "what there is of it";
}

TEST_F(SessionPlaybackTest, GoesFromOneWorstMomentToTheNext) {
  const auto& moments = session_->active_run()->moments;
  ASSERT_FALSE(moments.empty());
  act("go worst");
  EXPECT_EQ(now_s(), most_severe(moments)->time_s);
  act("go start");
  std::vector<double> seen;
  if (moments.front().time_s == 0.0) seen.push_back(0.0);
  while (session_->apply(actions::GoTo{Moment::kNextWorst})) seen.push_back(now_s());
  std::vector<double> expected;
  for (const WorstMoment& moment : moments) {
    if (expected.empty() || moment.time_s > expected.back() + 1e-6)
      expected.push_back(moment.time_s);
  }
  EXPECT_EQ(seen, expected) << "each once, in order";
  EXPECT_EQ(refused("go next-worst"), "no worst moment comes after this one");
  while (session_->apply(actions::GoTo{Moment::kPreviousWorst})) {
  }
  EXPECT_EQ(now_s(), expected.front());
  EXPECT_EQ(refused("go previous-worst"), "no worst moment lies before this one");
}

TEST_F(SessionPlaybackTest, GoesFromBookmarkToBookmark) {
  EXPECT_EQ(refused("go next-bookmark"), "no bookmark comes after this moment");
  for (const char* time : {"seek 2", "seek 1"}) {
    act(time);
    act("bookmark");
  }
  act("go start");
  act("go next-bookmark");
  EXPECT_EQ(now_s(), 1.0);
  act("go next-bookmark");
  EXPECT_EQ(now_s(), 2.0);
  act("go previous-bookmark");
  EXPECT_EQ(now_s(), 1.0);
  EXPECT_EQ(refused("go previous-bookmark"), "no bookmark lies before this moment");
}

TEST_F(SessionPlaybackTest, KeepsTheMomentOfTheFlightWhenAnotherRunBecomesActive) {
  RerunTask task = SmallWorld::get().task(scratch_.path() / "later.nadir");
  task.options.localiser.min_update_interval_s = 0.9;
  ASSERT_TRUE(rerun(task, {}, [](RerunProgress) {}));
  act("seek 3.1");
  const double clock_s = document().clock_s(now_s());
  act("open " + task.run.string());
  settle();
  EXPECT_EQ(session_->view().active_run, 2);
  EXPECT_NEAR(document().clock_s(now_s()), clock_s, 1e-9);
  EXPECT_EQ(session_->step_index(), 3U) << "steps of another run, at 3 s";
  EXPECT_EQ(session_->step_index_of(1), 12U);
  EXPECT_EQ(session_->step_index_of(2), 3U);
  EXPECT_FALSE(session_->step_index_of(3));
  act("run 1");
  EXPECT_NEAR(now_s(), 3.1, 1e-9);
}

TEST_F(SessionPlaybackTest, ShortensARangeToARunThatEndsSooner) {
  const fs_path path = scratch_.path() / "short.nadir";
  {
    const auto reader = RunReader::open(run_).value();
    auto writer = RunWriter::create(path, reader.header()).value();
    const std::vector<RunStep> steps = reader.steps().value();
    for (const RunStep& step : steps) {
      if (step.step > 10) break;
      ASSERT_TRUE(writer.write(step));
    }
    ASSERT_TRUE(writer.finish());
  }
  act("loop 1 4");
  act("open " + path.string());
  settle();
  EXPECT_EQ(session_->playback().loop_from_s, 1.0);
  EXPECT_EQ(session_->playback().loop_to_s, document().duration_s());
}

TEST_F(SessionPlaybackTest, BeginsAtTheStartOfARunOfAnotherFlight) {
  record_run(scratch_.path() / "foreign.nadir", 50, 10);
  act("seek 3.1");
  act("loop 1 2");
  act("open " + (scratch_.path() / "foreign.nadir").string());
  settle();
  EXPECT_EQ(now_s(), 0.0);
  EXPECT_FALSE(session_->playback().loop_from_s);
}

TEST_F(SessionPlaybackTest, FindsWhereRunsPart) {
  act("open " + copy_run("same.nadir").string());
  settle();
  EXPECT_EQ(refused("divergence 1"),
            "same and loop never part: they are nowhere " + divergence_words());
  EXPECT_EQ(refused("divergence 2"), "same is the active run itself");
  EXPECT_EQ(refused("divergence 9"), "there is no run 9: 2 are open");
  record_run(scratch_.path() / "foreign.nadir", 20, 10);
  act("open " + (scratch_.path() / "foreign.nadir").string());
  settle();
  EXPECT_EQ(refused("divergence 1"), "foreign and loop are of different flights");
}

TEST_F(SessionPlaybackTest, GoesToWhereARunLeavesTheActiveOne) {
  // The same flight, told to start in another place.
  RerunTask task = SmallWorld::get().task(scratch_.path() / "astray.nadir");
  task.prior = GaussianPrior{{60.0, 50.0, 2.0}, 0.2, 0.05};
  ASSERT_TRUE(rerun(task, {}, [](RerunProgress) {}));
  act("seek 4");
  act("open " + task.run.string());
  settle();
  act("run 1");
  act("divergence 2");
  EXPECT_EQ(now_s(), 0.0) << "they are apart from the first step on";
  ASSERT_FALSE(session_->notices().empty());
  EXPECT_THAT(session_->notices().back().text,
              testing::AllOf(HasSubstr("loop and astray part here, "),
                             HasSubstr("parted is " + divergence_words())));
}

}  // namespace session_playback_test
}  // namespace nadir
