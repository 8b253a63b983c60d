// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "core/run/run_file.h"
#include "tests/core/run/recorded_run.h"
#include "tests/core/run/run_sql.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace run_reader_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

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

TEST(RunReader, ReadsTheStepsFromANumberOn) {
  const ScratchFolder folder;
  const fs::path path = folder.path() / "R.nadir";
  record_run(path, 9);
  run_sql(path, "DELETE FROM mode WHERE step = 5; DELETE FROM step WHERE step = 5");
  const auto run = RunReader::open(path);
  const auto all = run->steps();
  ASSERT_EQ(all->size(), 8U);
  for (int first = -1; first < 12; ++first) {
    const auto some = run->steps_from(first);
    ASSERT_TRUE(some) << error_text(some);
    std::vector<int> expected, numbers;
    for (const RunStep& step : *all) {
      if (step.step >= first) expected.push_back(step.step);
    }
    for (const RunStep& step : *some) {
      numbers.push_back(step.step);
      EXPECT_EQ(step.estimate.modes.size(), 2U);
    }
    EXPECT_EQ(numbers, expected) << first;
  }
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
              HasSubstr("table step, row 2: truth_y_m is NULL, not a finite number"));
  EXPECT_THAT(damaged("UPDATE step SET estimate_x_m = 9e999 WHERE step = 0", 0),
              HasSubstr("table step, row 0: estimate_x_m is Inf, not a finite number"));
  EXPECT_THAT(damaged("UPDATE step SET particle_count = -1 WHERE step = 0", 0),
              HasSubstr("table step, row 0: particle_count is -1, not a whole number"));
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

}  // namespace run_reader_test
}  // namespace nadir
