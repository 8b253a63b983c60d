// SPDX-License-Identifier: Apache-2.0
#include "core/label/row_walk.h"

#include <gmock/gmock.h>

#include "tests/core/label/other_program.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace row_walk_test {

namespace fs = std::filesystem;

/// A table of 500 rows over many pages.
fs::path made(const ScratchFolder& scratch) {
  const fs::path path = scratch.path() / "rows.gpkg";
  OtherProgram(path).run(
      "PRAGMA page_size = 4096; CREATE TABLE thing (id INTEGER PRIMARY KEY, data BLOB);"
      "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 500) "
      "INSERT INTO thing SELECT i, zeroblob(700) FROM n");
  return path;
}

TEST(VisitRows, GivesAllRowsOfASoundTableInOrder) {
  const ScratchFolder scratch;
  const auto database = open_label_database(made(scratch), "rows", SqliteAccess::kRead);
  ASSERT_TRUE(database) << error_text(database);
  std::vector<std::int64_t> seen;
  const auto is_whole = visit_rows(*database, "thing", "data", [&](const SqliteStatement& row) {
    seen.push_back(row.whole(0));
    EXPECT_EQ(row.blob(1).size(), 700U);
  });
  ASSERT_TRUE(is_whole) << error_text(is_whole);
  EXPECT_TRUE(*is_whole);
  EXPECT_EQ(seen.size(), 500U);
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
}

TEST(VisitRows, GivesEachRowAroundTheDamageOnce) {
  const ScratchFolder scratch;
  const fs::path path = made(scratch);
  {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(fs::file_size(path) / 4096 / 2 * 4096));
    file << std::string(4096, '\xA5');
  }
  const auto database = open_label_database(path, "rows", SqliteAccess::kRead);
  ASSERT_TRUE(database) << error_text(database);
  std::map<std::int64_t, int> seen;
  const auto is_whole = visit_rows(*database, "thing", "data",
                                   [&](const SqliteStatement& row) { ++seen[row.whole(0)]; });
  ASSERT_TRUE(is_whole) << error_text(is_whole);
  EXPECT_FALSE(*is_whole);
  EXPECT_GT(seen.size(), 480U);
  EXPECT_LT(seen.size(), 500U);
  for (const auto& [id, times] : seen) EXPECT_EQ(times, 1) << id;
}

TEST(VisitRows, SaysWhatIsNotThere) {
  const ScratchFolder scratch;
  const auto database = open_label_database(made(scratch), "rows", SqliteAccess::kRead);
  ASSERT_TRUE(database);
  const auto is_whole = visit_rows(*database, "nowhere", "data", [](const SqliteStatement&) {});
  EXPECT_THAT(error_text(is_whole), testing::HasSubstr("no such table: nowhere"));
}

}  // namespace row_walk_test
}  // namespace nadir
