// SPDX-License-Identifier: Apache-2.0
#include "core/run/resume_point.h"

#include <gmock/gmock.h>

#include <limits>

#include "tests/core/run/recorded_run.h"
#include "tests/core/run/run_sql.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace resume_point_test {

using testing::HasSubstr;

/// A run of 20 steps, 0.1 s apart, and readers of it.
class PointOfARun : public testing::Test {
 protected:
  void SetUp() override { record_run(path(), 20, 10); }
  [[nodiscard]] std::filesystem::path path() const { return folder_.path() / "R.nadir"; }
  [[nodiscard]] Result<ResumePoint> at(double elapsed_s) const {
    const auto run = RunReader::open(path());
    return resume_point(run.value(), "R.nadir", elapsed_s);
  }

 private:
  ScratchFolder folder_;
};

TEST_F(PointOfARun, IsTheLastStepThatIsNotLater) {
  EXPECT_EQ(at(0.0)->after.step, 0);
  EXPECT_EQ(at(0.75)->after.step, 7);
  EXPECT_EQ(at(0.8)->after.step, 8);  // to a millionth of a second: 0.1 * 8 is not 0.8
  EXPECT_EQ(at(1.9)->after.step, 19);
  EXPECT_DOUBLE_EQ(at(0.75)->elapsed_s, 0.1 * 7);
}

TEST_F(PointOfARun, CountsTimeFromTheFirstStepOfTheRun) {
  run_sql(path(), "UPDATE step SET time_s = time_s + 1000");
  const auto point = at(0.75);
  ASSERT_TRUE(point) << error_text(point);
  EXPECT_EQ(point->after.step, 7);
  EXPECT_NEAR(point->after.time_s, 1000.7, 1e-9);
  EXPECT_NEAR(point->elapsed_s, 0.7, 1e-9);
}

TEST_F(PointOfARun, HoldsTheStepWithItsParticlesAndWhatTellsItsFlight) {
  const auto point = at(0.5);
  const RunStep recorded = RunReader::open(path())->step(5).value();
  EXPECT_EQ(point->run, "R.nadir");
  EXPECT_EQ(point->flight_hash, example_header().flight_hash);
  EXPECT_EQ(point->plane_origin->latitude_deg, example_header().plane_latitude_deg);
  EXPECT_EQ(point->plane_origin->longitude_deg, example_header().plane_longitude_deg);
  EXPECT_EQ(point->after.particles, recorded.particles);
  EXPECT_EQ(point->after.odom_from_body, recorded.odom_from_body);
}

TEST_F(PointOfARun, IsRefusedBeforeAndAfterTheRun) {
  for (const double elapsed_s : {-0.1, 1.95, 1e9, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THAT(error_text(at(elapsed_s)), HasSubstr("R.nadir: holds 0 to 1.900 s, and "));
    EXPECT_EQ(error_code(at(elapsed_s)), ErrorCode::kInvalidOptions);
  }
}

TEST_F(PointOfARun, IsRefusedWhereNoParticlesWereRecorded) {
  run_sql(path(), "DELETE FROM particles WHERE step = 7");
  EXPECT_EQ(error_text(at(0.75)),
            "R.nadir: holds no particles of step 7, so nothing can go on from there");
  EXPECT_TRUE(at(0.65).has_value());
}

TEST_F(PointOfARun, IsRefusedInARunWithoutSteps) {
  run_sql(path(), "DELETE FROM mode; DELETE FROM particles; DELETE FROM topview; DELETE FROM step");
  EXPECT_EQ(error_text(at(0.0)), "R.nadir: holds no step to go on from");
}

TEST(RecordedOptions, AreThoseThatTheRunWasMadeWith) {
  RunOptions options = run_preset("thesis").value();
  options.localiser.seed = 18446744073709551615ULL;
  options.localiser.particle_count = 777;
  options.localiser.blur_position_m = 0.1234567890123;
  options.topview.max_range_m = 17.25;
  RunHeader header;
  for (const OptionText& option : option_texts(options)) header.options[option.name] = option.value;
  header.options["prior"] = "global";
  header.options["of-a-newer-version"] = "7";
  const auto read = recorded_options(header);
  ASSERT_TRUE(read) << error_text(read);
  const auto texts = option_texts(*read);
  const auto expected = option_texts(options);
  ASSERT_EQ(texts.size(), expected.size());
  for (std::size_t i = 0; i < texts.size(); ++i) EXPECT_EQ(texts[i].value, expected[i].value);
}

TEST(RecordedOptions, AreTheDefaultsWhereTheRunSaysNothing) {
  const auto read = recorded_options({});
  ASSERT_TRUE(read) << error_text(read);
  EXPECT_EQ(read->localiser.particle_count, RunOptions{}.localiser.particle_count);
  EXPECT_EQ(read->topview.min_votes, 3);
}

TEST(RecordedOptions, AreRefusedWhereAValueIsNone) {
  RunHeader header;
  header.options["particles"] = "many";
  EXPECT_THAT(error_text(recorded_options(header)), HasSubstr("table about: --particles"));
  EXPECT_EQ(error_code(recorded_options(header)), ErrorCode::kMalformed);
  header.options["particles"] = "0";
  EXPECT_THAT(error_text(recorded_options(header)), HasSubstr("--particles: 0"));
}

}  // namespace resume_point_test
}  // namespace nadir
