// SPDX-License-Identifier: Apache-2.0
#include "core/session/rerun.h"

#include "tests/core/session/session_fixture.h"

namespace nadir {
namespace rerun_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

class RerunTest : public testing::Test {
 protected:
  ScratchFolder scratch_;
  const SmallWorld& world_ = SmallWorld::get();
  fs::path file_ = scratch_.path() / "new.nadir";
};

TEST_F(RerunTest, GivesTheSameRunAgain) {
  int published = 0;
  const auto outcome = rerun(world_.task(file_), {}, [&](RerunProgress progress) {
    EXPECT_EQ(progress.steps, ++published);
    EXPECT_EQ(RunReader::open(file_)->step_count(), progress.steps) << "it is in the file";
  });
  ASSERT_TRUE(outcome) << error_text(outcome);
  EXPECT_EQ(outcome->steps, published);
  EXPECT_FALSE(outcome->was_stopped);
  const auto first = RunReader::open(world_.run)->steps().value();
  const auto reader = RunReader::open(file_).value();
  EXPECT_TRUE(reader.is_complete());
  const auto second = reader.steps().value();
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].estimate.moments.mean, second[i].estimate.moments.mean);
  }
}

TEST_F(RerunTest, GoesOnFromAMomentWithTheStepsBeforeIt) {
  RerunTask task = world_.task(file_);
  task.parent = world_.run;
  task.from_s = 2.0;
  const auto outcome = rerun(task, {}, [](RerunProgress) {});
  ASSERT_TRUE(outcome) << error_text(outcome);
  const auto parent = RunReader::open(world_.run)->steps().value();
  const auto reader = RunReader::open(file_).value();
  const auto steps = reader.steps().value();
  ASSERT_EQ(steps.size(), parent.size());
  EXPECT_EQ(outcome->steps, static_cast<int>(parent.size()));
  for (std::size_t i = 0; i <= 8; ++i) {
    EXPECT_EQ(steps[i].estimate.moments.mean, parent[i].estimate.moments.mean) << "a copy";
    EXPECT_EQ(steps[i].time_s, parent[i].time_s);
  }
  EXPECT_TRUE(reader.step(steps[3].step)->particles) << "with its particles";
  EXPECT_EQ(reader.header().parent_run, world_.run.string()) << "which lies in another folder";
  EXPECT_DOUBLE_EQ(reader.header().started_at_s.value(), parent[8].time_s);
}

TEST_F(RerunTest, KeepsWhatItHasWhenItIsStopped) {
  std::stop_source source;
  WorkContext context;
  context.stop = source.get_token();
  const auto outcome = rerun(world_.task(file_), context, [&](RerunProgress progress) {
    if (progress.steps == 5) source.request_stop();
  });
  ASSERT_TRUE(outcome) << error_text(outcome);
  EXPECT_TRUE(outcome->was_stopped);
  const auto reader = RunReader::open(file_).value();
  EXPECT_EQ(reader.step_count(), outcome->steps);
  EXPECT_GE(outcome->steps, 5);
  EXPECT_FALSE(reader.is_complete());
}

/// A flight whose frames cannot be read from one of them on.
class BrokenFlight : public FlightRecording {
 public:
  BrokenFlight(std::shared_ptr<const FlightRecording> whole, std::size_t first_broken)
      : FlightRecording(whole->description()),
        whole_(std::move(whole)),
        first_broken_(first_broken) {}
  [[nodiscard]] Result<SemanticFrame> load(std::size_t index) const override {
    if (index < first_broken_) return whole_->load(index);
    return fail(ErrorCode::kMalformed, "frame {}: is torn", index);
  }

 private:
  std::shared_ptr<const FlightRecording> whole_;
  std::size_t first_broken_;
};

TEST_F(RerunTest, KeepsItsStepsWhereItFailsLater) {
  RerunTask task = world_.task(file_);
  task.flight = std::make_shared<BrokenFlight>(world_.recording, 7);
  const auto outcome = rerun(task, {}, [](RerunProgress) {});
  ASSERT_TRUE(outcome) << error_text(outcome);
  EXPECT_EQ(outcome->steps, 7);
  EXPECT_FALSE(outcome->was_stopped);
  EXPECT_EQ(outcome->fault, "frame 7: is torn");
  const auto reader = RunReader::open(file_).value();
  EXPECT_EQ(reader.step_count(), 7);
  EXPECT_FALSE(reader.is_complete());
}

TEST_F(RerunTest, LeavesNoFileWhereItFailsOrIsStoppedAtOnce) {
  std::stop_source source;
  source.request_stop();
  WorkContext context;
  context.stop = source.get_token();
  EXPECT_EQ(error_code(rerun(world_.task(file_), context, [](RerunProgress) {})),
            ErrorCode::kCancelled);
  RerunTask task = world_.task(file_);
  task.prior = GaussianPrior{{-900.0, 0.0, 0.0}};
  EXPECT_THAT(error_text(rerun(task, {}, [](RerunProgress) {})), HasSubstr("off map"));
  task = world_.task(file_);
  task.parent = scratch_.path() / "none.nadir";
  EXPECT_THAT(error_text(rerun(task, {}, [](RerunProgress) {})), HasSubstr("none.nadir"));
  task = world_.task(file_);
  task.flight = std::make_shared<BrokenFlight>(world_.recording, 0);
  EXPECT_THAT(error_text(rerun(task, {}, [](RerunProgress) {})), HasSubstr("frame 0: is torn"));
  task = world_.task(file_);
  task.options.topview.min_votes = 1000;
  EXPECT_THAT(error_text(rerun(task, {}, [](RerunProgress) {})),
              HasSubstr("nothing was localised"));
  task = world_.task(file_);
  task.parent = world_.run;
  task.from_s = 1e6;
  EXPECT_FALSE(rerun(task, {}, [](RerunProgress) {}));
  EXPECT_EQ(scratch_.entries(), 0);
}

}  // namespace rerun_test
}  // namespace nadir
