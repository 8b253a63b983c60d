// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>

#include "core/run/run_file.h"
#include "tests/core/run/recorded_run.h"
#include "tests/core/run/run_sql.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace copy_steps_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* kEveryRow =
    "SELECT group_concat(t) FROM (SELECT quote(step) || quote(count) || quote(data) AS t FROM "
    "particles WHERE step < 100 ORDER BY step); "
    "SELECT group_concat(t) FROM (SELECT quote(step) || quote(metres_per_cell) || quote(count) || "
    "quote(data) AS t FROM topview WHERE step < 100 ORDER BY step); "
    "SELECT group_concat(t) FROM (SELECT quote(step) || quote(time_s) || quote(estimate_x_m) || "
    "quote(covariance_y_yaw_m_rad) || quote(truth_x_m) || quote(agreement) || quote(update_ms) AS "
    "t FROM step WHERE step < 100 ORDER BY step); "
    "SELECT group_concat(t) FROM (SELECT quote(step) || quote(rank) || quote(mass) || quote(x_m) "
    "AS t FROM mode WHERE step < 100 ORDER BY step, rank)";

class CopiedSteps : public testing::Test {
 protected:
  [[nodiscard]] fs::path path(const std::string& name) const { return folder_.path() / name; }
  [[nodiscard]] std::vector<RunStep> steps_of(const std::string& name) const {
    return RunReader::open(path(name))->steps().value();
  }
  [[nodiscard]] RunWriter writer(const std::string& name) const {
    RunHeader header = example_header();
    header.parent_run = "old.nadir";
    header.started_at_s = 9.9;
    return RunWriter::create(path(name), header).value();
  }

 private:
  ScratchFolder folder_;
};

TEST_F(CopiedSteps, AreStoredAsTheyWereByteForByte) {
  record_run(path("old.nadir"), 150, 40);
  auto steps = steps_of("old.nadir");
  steps.resize(100);
  auto run = writer("new.nadir");
  const auto copied = run.copy_steps(path("old.nadir"), steps);
  ASSERT_TRUE(copied) << error_text(copied);
  ASSERT_TRUE(run.write(example_step(100, 40)));
  ASSERT_TRUE(run.finish());
  EXPECT_EQ(RunReader::open(path("new.nadir"))->step_count(), 101);
  EXPECT_EQ(run_sql(path("new.nadir"), kEveryRow), run_sql(path("old.nadir"), kEveryRow));
  EXPECT_EQ(RunReader::open(path("new.nadir"))->step(73)->particles,
            RunReader::open(path("old.nadir"))->step(73)->particles);
}

TEST_F(CopiedSteps, NeedNoParticlesAndNoTopviews) {
  record_run(path("old.nadir"), 20);
  auto run = writer("new.nadir");
  ASSERT_TRUE(run.copy_steps(path("old.nadir"), steps_of("old.nadir")));
  ASSERT_TRUE(run.copy_steps(path("old.nadir"), {}));
  EXPECT_EQ(steps_of("new.nadir").size(), 20U);
  EXPECT_FALSE(RunReader::open(path("new.nadir"))->step(3)->particles.has_value());
}

TEST_F(CopiedSteps, AreFollowedByLaterStepsOnly) {
  record_run(path("old.nadir"), 20, 5);
  auto run = writer("new.nadir");
  ASSERT_TRUE(run.copy_steps(path("old.nadir"), steps_of("old.nadir")));
  EXPECT_THAT(error_text(run.write(example_step(19))), HasSubstr("is that of the step before"));
  EXPECT_THAT(error_text(run.copy_steps(path("old.nadir"), steps_of("old.nadir"))),
              HasSubstr("time goes back"));
  EXPECT_TRUE(run.write(example_step(20)));
}

TEST_F(CopiedSteps, ComeAllOrNotAtAll) {
  record_run(path("old.nadir"), 200, 5);
  auto run = writer("new.nadir");
  std::stop_source source;
  const WorkContext context{source.get_token(),
                            [&](double, const std::string&) { source.request_stop(); }};
  const auto stopped = run.copy_steps(path("old.nadir"), steps_of("old.nadir"), context);
  EXPECT_EQ(error_code(stopped), ErrorCode::kCancelled);
  auto faulty = steps_of("old.nadir");
  faulty[120].time_s = std::nan("");
  EXPECT_FALSE(run.copy_steps(path("old.nadir"), faulty).has_value());
  EXPECT_FALSE(run.copy_steps(path("missing.nadir"), steps_of("old.nadir")).has_value());
  EXPECT_EQ(steps_of("new.nadir").size(), 0U);
  EXPECT_EQ(run_sql(path("new.nadir"), "SELECT count(*) FROM particles"), "0");
  ASSERT_TRUE(run.write(example_step(0)));  // and the writer can be used on
  EXPECT_EQ(steps_of("new.nadir").size(), 1U);
}

TEST_F(CopiedSteps, DoNotComeFromTheFileItself) {
  record_run(path("old.nadir"), 3, 5);
  const auto steps = steps_of("old.nadir");
  auto run = writer("new.nadir");
  EXPECT_EQ(error_text(run.copy_steps(path("new.nadir"), steps)),
            path("new.nadir").string() + ": cannot go on from itself");
}

TEST_F(CopiedSteps, LeaveRowsBehindThatBelongToNoStep) {
  record_run(path("old.nadir"), 10, 5);
  run_sql(path("old.nadir"),
          "PRAGMA foreign_keys = OFF; DELETE FROM mode WHERE step = 4; DELETE FROM step WHERE step "
          "= 4");
  auto run = writer("new.nadir");
  ASSERT_TRUE(run.copy_steps(path("old.nadir"), steps_of("old.nadir")));
  EXPECT_EQ(run_sql(path("new.nadir"), "SELECT count(*) FROM particles"), "9");
  EXPECT_EQ(run_sql(path("new.nadir"), "SELECT count(*) FROM particles WHERE step = 4"), "0");
}

TEST_F(CopiedSteps, AreToldApartByTheHeader) {
  static_cast<void>(writer("new.nadir"));
  const auto run = RunReader::open(path("new.nadir")).value();
  EXPECT_EQ(run.header().parent_run, "old.nadir");
  EXPECT_EQ(run.header().started_at_s, 9.9);
  record_run(path("old.nadir"), 1);
  const auto old = RunReader::open(path("old.nadir")).value();
  EXPECT_EQ(old.header().parent_run, "");
  EXPECT_FALSE(old.header().started_at_s.has_value());
  EXPECT_EQ(run_sql(path("old.nadir"), "SELECT count(*) FROM about WHERE key LIKE '%_run'"), "0");
}

TEST_F(CopiedSteps, BeginAtATime) {
  RunHeader header = example_header();
  header.started_at_s = std::nan("");
  EXPECT_THAT(error_text(RunWriter::create(path("new.nadir"), header)), HasSubstr("is no time"));
  EXPECT_FALSE(fs::exists(path("new.nadir")));
  record_run(path("old.nadir"), 1);
  run_sql(path("old.nadir"), "INSERT INTO about VALUES ('started_at_s', 'noon')");
  EXPECT_THAT(error_text(RunReader::open(path("old.nadir"))), HasSubstr("row started_at_s: noon"));
}

}  // namespace copy_steps_test
}  // namespace nadir
