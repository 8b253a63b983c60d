// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

struct sqlite3;
struct sqlite3_stmt;

namespace nadir {

class SqliteDatabase;

/// A prepared statement; must not outlive its database. Values are bound from 1, columns counted
/// from 0, as in SQLite.
class SqliteStatement {
 public:
  SqliteStatement(SqliteStatement&& other) noexcept;
  SqliteStatement& operator=(SqliteStatement&&) = delete;
  ~SqliteStatement();

  /// Binds the next value, left to right; NaN and nothing become NULL. A failure is told by next().
  /// Text and blobs must live until next() returned.
  SqliteStatement& add(double value);
  SqliteStatement& add(std::int64_t value);
  SqliteStatement& add(std::optional<double> value);
  SqliteStatement& add(std::string_view value);
  SqliteStatement& add(std::span<const std::uint8_t> value);
  SqliteStatement& add_null();

  /// Runs to the next row. @returns whether there is one; after the last the statement can be bound
  /// and run again.
  [[nodiscard]] Result<bool> next();
  /// Runs what gives no rows.
  [[nodiscard]] Result<void> run();

  [[nodiscard]] bool is_null(int column) const;
  /// Whether the value is a number, not NULL, text or a blob: SQLite gives 0 for those, for a column
  /// takes values of any kind, whatever its type says.
  [[nodiscard]] bool is_number(int column) const;
  [[nodiscard]] bool is_whole(int column) const;  ///< The same, without a fraction.
  [[nodiscard]] std::string column_name(int column) const;
  [[nodiscard]] double number(int column) const;  ///< NULL gives NaN.
  [[nodiscard]] std::int64_t whole(int column) const;
  [[nodiscard]] std::string text(int column) const;
  [[nodiscard]] std::span<const std::uint8_t> blob(
      int column) const;  ///< Until the next call of next().

 private:
  friend class SqliteDatabase;
  SqliteStatement(const SqliteDatabase* database, sqlite3_stmt* statement)
      : database_(database), statement_(statement) {}
  void note(int code);

  const SqliteDatabase* database_;
  sqlite3_stmt* statement_;
  int bound_ = 0;
  int bind_failure_ = 0;
};

/// What tells our files in SQLite's format from each other.
struct SqliteFileKind {
  const char* if_not_one;  ///< Said of a file that is no database: "is not a run file".
  int patience_ms;         ///< How long to wait for another program's lock.
  int most_value_bytes;    ///< Of a text or blob, so that a damaged length is not allocated.
};

enum class SqliteAccess { kRead, kWrite, kCreate };

/// An open database whose errors are sentences that begin with the name of the file. It may come
/// from anybody: nothing in its schema may run code.
class SqliteDatabase {
 public:
  /// @param name  Stands for the file in messages.
  /// @errors kMalformed: no database, damaged; kIo.
  [[nodiscard]] static Result<SqliteDatabase> open(const std::filesystem::path& path,
                                                   const std::string& name,
                                                   const SqliteFileKind& kind,
                                                   SqliteAccess access);
  SqliteDatabase(SqliteDatabase&& other) noexcept;
  SqliteDatabase& operator=(SqliteDatabase&& other) noexcept;
  ~SqliteDatabase();

  [[nodiscard]] Result<void> execute(const std::string& sql) const;
  [[nodiscard]] Result<SqliteStatement> prepare(std::string_view sql) const;
  /// The first column of the first row as a whole number; 0 without rows.
  [[nodiscard]] Result<std::int64_t> whole(std::string_view sql) const;

  /// The last failure is a journal left by a killed writer that this read-only connection may not
  /// roll back.
  [[nodiscard]] bool needs_recovery() const;
  [[nodiscard]] tl::unexpected<Error> failure() const;
  /// For what only one kind of file needs, such as functions of its own.
  [[nodiscard]] sqlite3* handle() const { return database_; }

 private:
  SqliteDatabase(sqlite3* database, std::string name, const char* if_not_one)
      : database_(database), name_(std::move(name)), if_not_one_(if_not_one) {}
  sqlite3* database_;
  std::string name_;
  const char* if_not_one_;
};

/// A transaction that is rolled back unless committed.
class SqliteTransaction {
 public:
  /// @param begin  "BEGIN" to read, "BEGIN IMMEDIATE" to write.
  [[nodiscard]] static Result<SqliteTransaction> begin(const SqliteDatabase& database,
                                                       const std::string& begin);
  SqliteTransaction(SqliteTransaction&& other) noexcept;
  SqliteTransaction& operator=(SqliteTransaction&&) = delete;
  ~SqliteTransaction();
  [[nodiscard]] Result<void> commit();

 private:
  explicit SqliteTransaction(const SqliteDatabase* database) : database_(database) {}
  const SqliteDatabase* database_;
};

}  // namespace nadir
