// SPDX-License-Identifier: Apache-2.0
#include "core/base/sqlite_database.h"

#include <gmock/gmock.h>

#include <cmath>

#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace sqlite_database_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

constexpr SqliteFileKind kKind{
    .if_not_one = "is no file of ours", .patience_ms = 0, .most_value_bytes = 1 << 20};

class SqliteFile : public testing::Test {
 protected:
  [[nodiscard]] SqliteDatabase open(SqliteAccess access = SqliteAccess::kCreate) const {
    return SqliteDatabase::open(path_, "it", kKind, access).value();
  }
  [[nodiscard]] SqliteDatabase table() const {
    SqliteDatabase database = open();
    EXPECT_TRUE(database.execute("CREATE TABLE t (x)"));
    return database;
  }

  ScratchFolder folder_;
  std::filesystem::path path_ = folder_.path() / "a.db";
};

TEST_F(SqliteFile, GivesBackEveryKindOfValue) {
  const SqliteDatabase database = open();
  ASSERT_TRUE(database.execute("CREATE TABLE t (a, b, c, d, e, f, g)"));
  auto insert = database.prepare("INSERT INTO t VALUES (?, ?, ?, ?, ?, ?, ?)");
  ASSERT_TRUE(insert);
  const std::string text("with \0 inside", 13);
  const std::vector<std::uint8_t> bytes = {0, 255, 7};
  insert->add(1.0 / 3.0).add(INT64_MIN).add(std::optional<double>());
  insert->add(std::string_view(text)).add(std::span(bytes)).add(std::nan("")).add_null();
  ASSERT_TRUE(insert->run());

  auto select = database.prepare("SELECT * FROM t");
  ASSERT_TRUE(select);
  ASSERT_TRUE(select->next().value());
  EXPECT_EQ(select->number(0), 1.0 / 3.0);
  EXPECT_EQ(select->whole(1), INT64_MIN);
  EXPECT_TRUE(select->is_null(2));
  EXPECT_TRUE(std::isnan(select->number(2)));
  EXPECT_EQ(select->text(3), text);
  EXPECT_THAT(select->blob(4), ElementsAre(0, 255, 7));
  EXPECT_TRUE(select->is_null(5)) << "NaN is unknown";
  EXPECT_TRUE(select->is_null(6));
  EXPECT_FALSE(select->next().value());
}

TEST_F(SqliteFile, TellsNumbersFromWhatOnlyStandsInTheirPlace) {
  const SqliteDatabase database = table();
  ASSERT_TRUE(database.execute("INSERT INTO t VALUES (7), (7.0), ('7'), (x'37'), (NULL)"));
  auto rows = database.prepare("SELECT x FROM t ORDER BY rowid");
  ASSERT_TRUE(rows);
  for (const auto& [is_number, is_whole] :
       {std::pair(true, true), {true, false}, {false, false}, {false, false}, {false, false}}) {
    ASSERT_TRUE(rows->next().value());
    EXPECT_EQ(rows->is_number(0), is_number);
    EXPECT_EQ(rows->is_whole(0), is_whole);
    EXPECT_EQ(rows->column_name(0), "x");
  }
}

TEST_F(SqliteFile, KeepsEmptyTextsAndBlobsApartFromNull) {
  const SqliteDatabase database = table();
  auto insert = database.prepare("INSERT INTO t VALUES (?)");
  ASSERT_TRUE(insert->add(std::string_view()).next());
  ASSERT_TRUE(insert->add(std::span<const std::uint8_t>()).next()) << "a statement is used again";
  EXPECT_EQ(database.whole("SELECT count(*) FROM t WHERE x IS NULL").value(), 0);
  EXPECT_EQ(database.whole("SELECT count(*) FROM t").value(), 2);
}

TEST_F(SqliteFile, TellsOfAValueTooManyWhenTheStatementRuns) {
  const SqliteDatabase database = table();
  auto insert = database.prepare("INSERT INTO t VALUES (?)");
  EXPECT_FALSE(insert->add(1.0).add(2.0).next());
  EXPECT_TRUE(insert->add(3.0).next()) << "and can be used again";
  EXPECT_EQ(database.whole("SELECT x FROM t").value(), 3);
}

TEST_F(SqliteFile, TakesBackATransactionThatIsNotCommitted) {
  const SqliteDatabase database = table();
  {
    const auto transaction = SqliteTransaction::begin(database, "BEGIN IMMEDIATE");
    ASSERT_TRUE(transaction);
    ASSERT_TRUE(database.execute("INSERT INTO t VALUES (1)"));
  }
  EXPECT_EQ(database.whole("SELECT count(*) FROM t").value(), 0);
  {
    auto transaction = SqliteTransaction::begin(database, "BEGIN IMMEDIATE");
    ASSERT_TRUE(database.execute("INSERT INTO t VALUES (1)"));
    EXPECT_FALSE(SqliteTransaction::begin(database, "BEGIN")) << "one at a time";
    SqliteTransaction moved = std::move(*transaction);
    EXPECT_TRUE(moved.commit());
  }
  EXPECT_EQ(open(SqliteAccess::kRead).whole("SELECT count(*) FROM t").value(), 1);
}

TEST_F(SqliteFile, MayNotBeWrittenByAReader) {
  static_cast<void>(table());
  const auto written = open(SqliteAccess::kRead).execute("INSERT INTO t VALUES (1)");
  EXPECT_EQ(error_code(written), ErrorCode::kIo);
  EXPECT_THAT(error_text(written), StartsWith("it: "));
}

TEST_F(SqliteFile, IsNotMadeByAReader) {
  const auto missing = SqliteDatabase::open(path_, "it", kKind, SqliteAccess::kRead);
  EXPECT_EQ(error_code(missing), ErrorCode::kIo);
  EXPECT_THAT(error_text(missing), StartsWith("it: "));
  EXPECT_EQ(folder_.entries(), 0);
}

TEST_F(SqliteFile, SaysThatAMissingTableIsDamage) {
  const auto missing = table().whole("SELECT y FROM nothing");
  EXPECT_EQ(error_code(missing), ErrorCode::kMalformed);
  EXPECT_THAT(error_text(missing), StartsWith("it: is damaged or cut off ("));
}

TEST_F(SqliteFile, SaysOfAnotherFileWhatItIsNot) {
  folder_.file("a.db", std::string(5000, 'x'));
  const auto database = SqliteDatabase::open(path_, "it", kKind, SqliteAccess::kRead);
  const auto read = database ? database->whole("SELECT count(*) FROM sqlite_schema")
                             : Result<std::int64_t>(forward_error(database));
  EXPECT_EQ(error_text(read), "it: is no file of ours");
}

TEST_F(SqliteFile, SaysWhoHoldsItUp) {
  const SqliteDatabase first = table();
  const SqliteDatabase second = open();
  const auto transaction = SqliteTransaction::begin(first, "BEGIN IMMEDIATE");
  ASSERT_TRUE(transaction);
  const auto refused = SqliteTransaction::begin(second, "BEGIN IMMEDIATE");
  EXPECT_EQ(error_code(refused), ErrorCode::kIo);
  EXPECT_EQ(error_text(refused), "it: is locked by another program");
}

TEST_F(SqliteFile, SaysThatTheDiskIsFull) {
  const SqliteDatabase database = table();
  ASSERT_TRUE(database.execute("PRAGMA max_page_count = 2"));  // as many as it has
  const auto refused = database.execute("INSERT INTO t VALUES (zeroblob(100000))");
  EXPECT_EQ(error_code(refused), ErrorCode::kIo);
  EXPECT_EQ(error_text(refused), "it: the disk is full");
}

TEST_F(SqliteFile, AllocatesNoValueLongerThanItsKindHas) {
  const SqliteDatabase database = table();
  ASSERT_TRUE(database.execute("INSERT INTO t VALUES (zeroblob(1000000))"));
  const auto refused = database.execute("INSERT INTO t VALUES (zeroblob(1100000))");
  EXPECT_EQ(error_code(refused), ErrorCode::kMalformed);
}

TEST_F(SqliteFile, KeepsWhatItSaysWhenItIsMoved) {
  folder_.file("b.db", std::string(5000, 'x'));
  SqliteDatabase moved = table();
  auto other = SqliteDatabase::open(folder_.path() / "b.db", "other", kKind, SqliteAccess::kRead);
  if (other) moved = std::move(*other);
  const auto read = other ? moved.whole("SELECT count(*) FROM sqlite_schema")
                          : Result<std::int64_t>(forward_error(other));
  EXPECT_EQ(error_text(read), "other: is no file of ours");
}

TEST_F(SqliteFile, MayHaveANameThatSqliteWouldReadMeaningInto) {
  const auto odd = folder_.path() / "file:x?mode=memory";
  const auto database = SqliteDatabase::open(odd, "odd", kKind, SqliteAccess::kCreate);
  ASSERT_TRUE(database && database->execute("CREATE TABLE t (x)"));
  EXPECT_TRUE(std::filesystem::exists(odd));
}

TEST_F(SqliteFile, GivesZeroForAQuestionWithoutAnAnswer) {
  EXPECT_EQ(table().whole("SELECT x FROM t").value(), 0);
}

}  // namespace sqlite_database_test
}  // namespace nadir
