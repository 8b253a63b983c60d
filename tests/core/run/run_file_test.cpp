// SPDX-License-Identifier: Apache-2.0
#include "core/run/run_file.h"

#include <gmock/gmock.h>
#include <sqlite3.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <limits>

#include "tests/core/run/recorded_run.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// Runs SQL on a file as any other program would; the text of the first value, if any.
std::string run_sql(const fs::path& path, const std::string& sql) {
  sqlite3* database = nullptr;
  sqlite3_open(path.c_str(), &database);
  std::string answer;
  const auto take = [](void* into, int columns, char** values, char**) {
    auto& text = *static_cast<std::string*>(into);
    for (int i = 0; i < columns; ++i)
      text += (text.empty() ? "" : " ") + std::string(values[i] != nullptr ? values[i] : "NULL");
    return 0;
  };
  char* message = nullptr;
  sqlite3_exec(database, sql.c_str(), take, &answer, &message);
  if (message != nullptr) answer = message;
  sqlite3_free(message);
  sqlite3_close(database);
  return answer;
}

std::string bytes_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

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

TEST(RunFile, StepNumbersOnlyRiseAndTimeNeverGoesBack) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "R.nadir";
  auto writer = RunWriter::create(path, {}).value();
  ASSERT_TRUE(writer.write(example_step(5)));
  EXPECT_FALSE(writer.write(example_step(5))) << "the same step twice";
  EXPECT_THAT(error_text(writer.write(example_step(4))),
              HasSubstr("time goes back from 0.5 s to 0.4 s at step 4"));
  ASSERT_TRUE(writer.write(example_step(6))) << "a refused step leaves the writer usable";
  EXPECT_EQ(RunReader::open(path)->step_count(), 2);
}

TEST(RunFile, PosesThatAreNoNumbersAreRefused) {
  const ScratchFolder folder;
  auto writer = RunWriter::create(folder.path() / "R.nadir", {}).value();
  RunStep step = example_step(0);
  step.estimate.moments.mean.yaw_rad = std::nan("");
  EXPECT_THAT(error_text(writer.write(step)),
              AllOf(HasSubstr("R.nadir: step 0"), HasSubstr("not finite")));
  step = example_step(0);
  step.time_s = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(writer.write(step));
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
                                          HasSubstr("is not a run file, so it is left alone")));
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

TEST(RunReader, SaysWhatIsWrongWithAFile) {
  const ScratchFolder folder;
  const auto missing = RunReader::open(folder.path() / "none.nadir");
  EXPECT_EQ(error_code(missing), ErrorCode::kNotFound);
  EXPECT_THAT(error_text(missing), HasSubstr("none.nadir: does not exist"));
  EXPECT_THAT(error_text(RunReader::open(folder.path())), HasSubstr("is a folder"));
  EXPECT_THAT(error_text(RunReader::open(folder.file("e", ""))), HasSubstr("is empty"));
  for (const auto& text : {std::string("hello"), std::string(10'000, '\0'),
                           "SQLite format 3\0" + std::string(4096, 'x')}) {
    const auto wrong = RunReader::open(folder.file("w", text));
    EXPECT_EQ(error_code(wrong), ErrorCode::kMalformed);
    EXPECT_THAT(error_text(wrong), StartsWith((folder.path() / "w: ").string()));
  }
  run_sql(folder.path() / "other.db", "CREATE TABLE precious (x)");
  EXPECT_THAT(error_text(RunReader::open(folder.path() / "other.db")),
              HasSubstr("is not a run file"));
}

TEST(RunReader, RefusesANewerFormatAndSaysSo) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "R.nadir";
  record_run(path, 2);
  run_sql(path, "PRAGMA user_version = 2");
  const auto run = RunReader::open(path);
  ASSERT_FALSE(run);
  EXPECT_EQ(error_code(run), ErrorCode::kUnsupported);
  EXPECT_THAT(error_text(run), HasSubstr("R.nadir: was written by a newer version of Nadir"));
}

TEST(RunReader, ReadsFilesWithTablesAndKeysItDoesNotKnow) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "R.nadir";
  record_run(path, 2);
  run_sql(path,
          "CREATE TABLE note (text); INSERT INTO about VALUES ('weather', 'fine'); ALTER TABLE "
          "step ADD COLUMN wind_mps REAL");
  EXPECT_EQ(RunReader::open(path)->steps()->size(), 2U);
}

TEST(RunReader, DamagedRowsGiveASentenceThatNamesTheStep) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "R.nadir";
  const auto damaged = [&](const std::string& sql, int step) {
    record_run(path, 3, 20);
    const std::string complaint = run_sql(path, sql);
    EXPECT_EQ(complaint, "") << sql;
    const auto run = RunReader::open(path);
    return run ? error_text(run->step(step)) : error_text(run);
  };
  EXPECT_THAT(damaged("UPDATE particles SET count = 21 WHERE step = 1", 1),
              HasSubstr("particles of step 1: its data do not hold 21 elements"));
  EXPECT_THAT(damaged("UPDATE particles SET count = 1000000000000 WHERE step = 1", 1),
              HasSubstr("is not in [0, 10000000]"));
  EXPECT_THAT(damaged("UPDATE particles SET data = x'00' WHERE step = 1", 1),
              HasSubstr("R.nadir: particles of step 1"));
  EXPECT_THAT(
      damaged("UPDATE particles SET data = substr(data, 1, length(data) - 1) WHERE step = 1", 1),
      HasSubstr("cannot be unpacked"));
  EXPECT_THAT(damaged("UPDATE topview SET metres_per_cell = -1 WHERE step = 2", 2),
              HasSubstr("topview of step 2: its cells are -1 m wide"));
  EXPECT_THAT(damaged("UPDATE step SET truth_y_m = NULL WHERE step = 2", 2),
              HasSubstr("step 2 is damaged"));
  EXPECT_THAT(damaged("UPDATE step SET estimate_x_m = 9e999 WHERE step = 0", 0),
              HasSubstr("step 0 is damaged"));
  EXPECT_THAT(damaged("UPDATE step SET particle_count = -1 WHERE step = 0", 0),
              HasSubstr("step 0 is damaged"));
  EXPECT_THAT(damaged("DROP TABLE mode", 0), HasSubstr("tables of a run are missing"));
  EXPECT_THAT(damaged("DROP TABLE mode; CREATE VIEW mode AS SELECT 1", 0),
              HasSubstr("tables of a run are missing"));
  EXPECT_THAT(damaged("ALTER TABLE step DROP COLUMN update_ms", 0),
              HasSubstr("is damaged or cut off"));
  EXPECT_THAT(damaged("SELECT 1 WHERE 0", 7), HasSubstr("holds no step 7"));
}

TEST(RunReader, AFileCutOffAnywhereGivesOneSentence) {
  const ScratchFolder folder;
  record_run(folder.path() / "R.nadir", 6, 300);
  const std::string whole = bytes_of(folder.path() / "R.nadir");
  ASSERT_GT(whole.size(), 20'000U);
  for (std::size_t size = 0; size < whole.size(); size += 512) {
    const fs::path path = folder.file("cut.nadir", whole.substr(0, size));
    const auto run = RunReader::open(path);
    if (!run) {
      EXPECT_EQ(error_code(run), ErrorCode::kMalformed) << size;
      EXPECT_THAT(error_text(run), StartsWith(path.string() + ": ")) << size;
      continue;
    }
    const auto steps = run->steps();
    EXPECT_FALSE(steps && steps->size() == 6 && run->step(5).has_value()) << size;
  }
}

TEST(RunReader, FlippedBytesNeverCrash) {
  const ScratchFolder folder;
  record_run(folder.path() / "R.nadir", 4, 50);
  const std::string whole = bytes_of(folder.path() / "R.nadir");
  for (std::size_t at = 0; at < whole.size(); at += 61) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(~damaged[at]);
    const auto run = RunReader::open(folder.file("bad.nadir", damaged));
    if (!run) continue;
    const auto steps = run->steps();
    if (steps) {
      EXPECT_LE(steps->size(), 4U);
    }
    for (int i = 0; i < 4; ++i) {
      const auto step = run->step(i);
      if (step && step->particles) {
        EXPECT_EQ(step->particles->weight.size(), step->particles->x_in_enu_m.size());
      }
    }
  }
}

TEST(RunReader, StepsOfTenThousandParticlesAreWrittenInMilliseconds) {
  const ScratchFolder folder;
  auto writer = RunWriter::create(folder.path() / "R.nadir", {}).value();
  const RunStep first = example_step(0, 10'000);
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < 50; ++i) {
    RunStep step = first;
    step.step = i;
    ASSERT_TRUE(writer.write(step));
  }
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - begin;
  RecordProperty("ms_a_step", std::to_string(spent.count() / 50));
  EXPECT_LT(spent.count() / 50, 50.0) << "generous, since machines of CI are slow and shared";
}

}  // namespace
}  // namespace nadir
