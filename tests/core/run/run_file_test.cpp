// SPDX-License-Identifier: Apache-2.0
#include "core/run/run_file.h"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <limits>

#include "tests/core/run/recorded_run.h"
#include "tests/core/run/run_sql.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace run_file_test {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

void expect_same_numbers(const RunStep& read, const RunStep& written) {
  EXPECT_EQ(read.step, written.step);
  EXPECT_EQ(read.time_s, written.time_s);
  EXPECT_EQ(read.odom_from_body, written.odom_from_body);
  EXPECT_EQ(read.odometry_in_enu, written.odometry_in_enu);
  EXPECT_EQ(read.truth_in_enu, written.truth_in_enu);
  EXPECT_EQ(read.estimate.moments.mean, written.estimate.moments.mean);
  EXPECT_EQ(read.estimate.moments.covariance, written.estimate.moments.covariance);
  ASSERT_EQ(read.estimate.modes.size(), written.estimate.modes.size());
  for (std::size_t i = 0; i < read.estimate.modes.size(); ++i) {
    EXPECT_EQ(read.estimate.modes[i].mass, written.estimate.modes[i].mass);
    EXPECT_EQ(read.estimate.modes[i].moments.mean, written.estimate.modes[i].moments.mean);
    EXPECT_EQ(read.estimate.modes[i].moments.covariance,
              written.estimate.modes[i].moments.covariance);
  }
  EXPECT_EQ(read.effective_sample_size, written.effective_sample_size);
  EXPECT_EQ(read.particle_count, written.particle_count);
  EXPECT_EQ(read.was_resampled, written.was_resampled);
  EXPECT_EQ(read.agreement, written.agreement);
  EXPECT_EQ(read.topview_cells, written.topview_cells);
  EXPECT_EQ(read.update_ms, written.update_ms);
}

TEST(RunFile, GivesBackTheHeaderToTheLastDigit) {
  const ScratchFolder folder;
  record_run(folder.path() / "R.nadir", 1);
  const auto run = RunReader::open(folder.path() / "R.nadir");
  ASSERT_TRUE(run) << error_text(run);
  const RunHeader& read = run->header();
  const RunHeader written = example_header();
  EXPECT_EQ(read.program_version, written.program_version);
  EXPECT_EQ(read.flight, written.flight);
  EXPECT_EQ(read.map, written.map);
  EXPECT_EQ(read.preset, written.preset);
  EXPECT_EQ(read.flight_path, written.flight_path);
  EXPECT_EQ(read.map_path, written.map_path);
  EXPECT_EQ(read.flight_hash, written.flight_hash);
  EXPECT_EQ(read.map_hash, written.map_hash);
  EXPECT_EQ(read.seed, written.seed);
  EXPECT_EQ(read.plane_latitude_deg, written.plane_latitude_deg);
  EXPECT_EQ(read.plane_longitude_deg, written.plane_longitude_deg);
  EXPECT_EQ(read.options, written.options);
}

TEST(RunFile, GivesBackEveryNumberOfEveryStep) {
  const ScratchFolder folder;
  record_run(folder.path() / "R.nadir", 25, 10);
  const auto run = RunReader::open(folder.path() / "R.nadir");
  ASSERT_TRUE(run) << error_text(run);
  EXPECT_TRUE(run->is_complete());
  EXPECT_EQ(run->step_count(), 25);
  const auto steps = run->steps();
  ASSERT_TRUE(steps) << error_text(steps);
  ASSERT_EQ(steps->size(), 25U);
  for (int i = 0; i < 25; ++i) {
    expect_same_numbers((*steps)[static_cast<std::size_t>(i)], example_step(i, 10));
    EXPECT_FALSE((*steps)[static_cast<std::size_t>(i)].particles) << "only step() brings them";
    const auto step = run->step(i);
    ASSERT_TRUE(step) << error_text(step);
    expect_same_numbers(*step, example_step(i, 10));
  }
}

TEST(RunFile, UnknownTruthAgreementAndSpreadStayUnknown) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "R.nadir";
  RunStep written = example_step(0);
  written.truth_in_enu.reset();
  written.agreement.reset();
  written.estimate.moments.covariance(2, 2) = std::nan("");
  written.estimate.moments.covariance(0, 0) = std::numeric_limits<double>::infinity();
  written.estimate.modes.clear();
  auto writer = RunWriter::create(path, {});
  ASSERT_TRUE(writer && writer->write(written));
  const auto read = RunReader::open(path)->step(0);
  ASSERT_TRUE(read) << error_text(read);
  EXPECT_FALSE(read->truth_in_enu || read->agreement || read->particles || read->topview);
  EXPECT_TRUE(std::isnan(read->estimate.moments.covariance(2, 2)));
  EXPECT_TRUE(std::isinf(read->estimate.moments.covariance(0, 0)));
  EXPECT_TRUE(read->estimate.modes.empty());
}

TEST(RunFile, ParticlesComeBackWithinAMillimetreFarFromTheEstimateToo) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "R.nadir";
  RunStep step = example_step(0, 500);
  step.particles->x_in_enu_m[0] += 8000.0;
  step.particles->yaw_rad[0] = 3.14159265358979312;  // Nearest float lies above pi.
  step.particles->weight[1] = 3e-3;
  double sum = 0.0;
  for (const double weight : step.particles->weight) sum += weight;
  for (double& weight : step.particles->weight) weight /= sum;
  ASSERT_TRUE(RunWriter::create(path, {})->write(step));
  const auto read = RunReader::open(path)->step(0);
  ASSERT_TRUE(read && read->particles) << error_text(read);
  ASSERT_EQ(read->particles->size(), 500U);
  double read_sum = 0.0;
  for (std::size_t i = 0; i < 500; ++i) {
    EXPECT_NEAR(read->particles->x_in_enu_m[i], step.particles->x_in_enu_m[i], 1e-3);
    EXPECT_NEAR(read->particles->y_in_enu_m[i], step.particles->y_in_enu_m[i], 1e-3);
    EXPECT_LT(std::abs(wrap_rad(read->particles->yaw_rad[i] - step.particles->yaw_rad[i])), 3e-7);
    EXPECT_TRUE(std::abs(read->particles->yaw_rad[i]) <= std::acos(-1.0));
    EXPECT_NEAR(read->particles->weight[i], step.particles->weight[i],
                1e-7 * step.particles->weight[i] + 1e-10);
    read_sum += read->particles->weight[i];
  }
  EXPECT_NEAR(read_sum, 1.0, 1e-12);
}

TEST(RunFile, TopviewsComeBackExactlyAndMayBeEmpty) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "R.nadir";
  auto writer = RunWriter::create(path, {}).value();
  ASSERT_TRUE(writer.write(example_step(0, 5)));
  RunStep empty = example_step(1, 5);
  empty.topview = SemanticTopview{};
  empty.particles = ParticleSet{};
  ASSERT_TRUE(writer.write(empty));
  const auto run = RunReader::open(path);
  EXPECT_EQ(run->step(0)->topview, example_step(0, 5).topview);
  EXPECT_EQ(run->step(1)->topview, SemanticTopview{});
  EXPECT_EQ(run->step(1)->particles, ParticleSet{});
}

TEST(RunFile, IsReadWhileItIsWritten) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "R.nadir";
  auto writer = RunWriter::create(path, example_header()).value();
  const auto run = RunReader::open(path);
  ASSERT_TRUE(run) << error_text(run);
  EXPECT_EQ(run->step_count(), 0);
  for (int i = 0; i < 5; ++i) {
    ASSERT_TRUE(writer.write(example_step(i, 100)));
    EXPECT_EQ(run->step_count(), i + 1);
    EXPECT_EQ(run->steps()->size(), static_cast<std::size_t>(i + 1));
    EXPECT_FALSE(run->is_complete());
  }
  ASSERT_TRUE(writer.finish());
  EXPECT_TRUE(run->is_complete());
}

TEST(RunFile, IsOneFileWithDocumentedTables) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "R.nadir";
  record_run(path, 3, 10);
  EXPECT_EQ(folder.entries(), 1) << "no journal is left";
  EXPECT_EQ(run_sql(path, "SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY name"),
            "about mode particles step topview");
  EXPECT_EQ(run_sql(path, "PRAGMA application_id"), "1312900178");
  EXPECT_EQ(run_sql(path, "PRAGMA user_version"), "1");
  EXPECT_EQ(run_sql(path, "SELECT value FROM about WHERE key = 'option.particle-count'"), "10000");
  EXPECT_EQ(run_sql(path, "SELECT estimate_x_m, truth_y_m FROM step WHERE step = 2"),
            "502.1 200.0");
  EXPECT_THAT(run_sql(path, "SELECT sql FROM sqlite_schema WHERE name = 'particles'"),
              HasSubstr("-- zstd of four float32 arrays"));
  EXPECT_EQ(run_sql(path, "PRAGMA integrity_check"), "ok");
}

TEST(RunFile, StepNumbersAndTimesOnlyRise) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "R.nadir";
  auto writer = RunWriter::create(path, {}).value();
  ASSERT_TRUE(writer.write(example_step(5)));
  EXPECT_FALSE(writer.write(example_step(5))) << "the same step twice";
  EXPECT_THAT(error_text(writer.write(example_step(4))),
              HasSubstr("time goes back from 0.5 s to 0.4 s at step 4"));
  RunStep same_time = example_step(6);
  same_time.time_s = 0.5;
  EXPECT_THAT(error_text(writer.write(same_time)),
              HasSubstr("time 0.5 s of step 6 is that of the step before"));
  RunStep late = example_step(4);
  late.time_s = 0.6;
  EXPECT_THAT(error_text(writer.write(late)), HasSubstr("R.nadir: step 4 comes after step 5"));
  ASSERT_TRUE(writer.write(example_step(6))) << "a refused step leaves the writer usable";
  EXPECT_EQ(RunReader::open(path)->step_count(), 2);
}

TEST(RunFile, ReplacesAnOlderRunAndItsJournalButNothingElse) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "R.nadir";
  record_run(path, 9, 10);
  static_cast<void>(folder.file("R.nadir-journal", "a journal of the run before"));
  record_run(path, 2);
  EXPECT_EQ(RunReader::open(path)->step_count(), 2);
  EXPECT_EQ(folder.entries(), 1);

  for (const fs::path& other :
       {folder.file("notes.txt", "years of work"), folder.file("short", "x"),
        folder.file("big.txt", std::string(5000, 'x'))}) {
    const std::string before = bytes_of(other);
    const auto writer = RunWriter::create(other, {});
    ASSERT_FALSE(writer);
    EXPECT_THAT(error_text(writer), AllOf(HasSubstr(other.string()),
                                          HasSubstr("will not be overwritten: it is no run file")));
    EXPECT_EQ(bytes_of(other), before);
  }
  const fs::path database = folder.path() / "other.db";
  run_sql(database, "CREATE TABLE precious (x)");
  EXPECT_FALSE(RunWriter::create(database, {})) << "another program's database";
  EXPECT_TRUE(RunWriter::create(folder.file("empty.nadir", ""), {})) << "a run killed at birth";
}

TEST(RunFile, CannotBeMadeWhereThereIsNoFolder) {
  const ScratchFolder folder;
  EXPECT_THAT(error_text(RunWriter::create(folder.path() / "no" / "R.nadir", {})),
              HasSubstr("does not exist"));
  EXPECT_THAT(error_text(RunWriter::create(folder.path(), {})), HasSubstr("is a folder"));
  EXPECT_FALSE(RunWriter::create("", {}));
  EXPECT_EQ(folder.entries(), 0);
}

TEST(RunFile, ADiskThatIsFullGivesOneSentenceAndKeepsTheStepsBefore) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "R.nadir";
  auto writer = RunWriter::create(path, example_header()).value();
  // A limit on the size of files stands for the end of the disk.
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{.rlim_cur = 300'000, .rlim_max = before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  int written = 0;
  Result<void> outcome;
  while (written < 1000 && (outcome = writer.write(example_step(written, 1000)))) ++written;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  ASSERT_FALSE(outcome);
  EXPECT_EQ(error_code(outcome), ErrorCode::kIo);
  EXPECT_THAT(error_text(outcome), StartsWith(path.string() + ": "));
  ASSERT_GT(written, 2);
  EXPECT_EQ(RunReader::open(path)->steps()->size(), static_cast<std::size_t>(written));
  EXPECT_TRUE(writer.write(example_step(written, 1000))) << "room again: it goes on";
  EXPECT_EQ(RunReader::open(path)->step_count(), written + 1);
}

TEST(RunFile, StepsOfTenThousandParticlesAreWrittenInMilliseconds) {
  const ScratchFolder folder;
  auto writer = RunWriter::create(folder.path() / "R.nadir", {}).value();
  const RunStep first = example_step(0, 10'000);
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < 50; ++i) {
    RunStep step = first;
    step.step = i;
    step.time_s = 0.1 * i;
    ASSERT_TRUE(writer.write(step));
  }
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - begin;
  RecordProperty("ms_a_step", std::to_string(spent.count() / 50));
  EXPECT_LT(spent.count() / 50, 50.0) << "generous, since machines of CI are slow and shared";
}

}  // namespace run_file_test
}  // namespace nadir
