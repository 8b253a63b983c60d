// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "core/base/result.h"

struct sqlite3;
struct sqlite3_stmt;

namespace nadir {

class LabelDatabase;

/// A prepared statement; must not outlive its database. Private to this module. Values are bound from 1, columns counted
/// from 0, as in SQLite.
class LabelStatement {
 public:
  LabelStatement(LabelStatement&& other) noexcept;
  LabelStatement& operator=(LabelStatement&&) = delete;
  ~LabelStatement();

  /// Binds the next value, left to right. A failure is told by next(). Texts and blobs must live until next() returned.
  LabelStatement& add(std::int64_t value);
  LabelStatement& add(double value);
  LabelStatement& add(std::string_view value);
  LabelStatement& add(std::span<const std::uint8_t> value);
  LabelStatement& add_null();

  /// Runs to the next row. @returns whether there is one; after the last the statement can be bound and run again.
  [[nodiscard]] Result<bool> next();
  /// Runs what gives no rows.
  [[nodiscard]] Result<void> run();

  [[nodiscard]] bool is_null(int column) const;
  [[nodiscard]] std::int64_t whole(int column) const;
  [[nodiscard]] double number(int column) const;
  [[nodiscard]] std::string text(int column) const;
  [[nodiscard]] std::span<const std::uint8_t> blob(int column) const;  ///< Until the next next().

 private:
  friend class LabelDatabase;
  LabelStatement(const LabelDatabase* database, sqlite3_stmt* statement)
      : database_(database), statement_(statement) {}
  void note(int code);

  const LabelDatabase* database_;
  sqlite3_stmt* statement_;
  int bound_ = 0;
  int bind_failure_ = 0;
};

/// An open labels.gpkg whose errors are sentences that begin with the name of the file. Private to this module.
class LabelDatabase {
 public:
  enum class Access { kRead, kWrite, kCreate };
  /// With functions for the triggers of a spatial index that a GIS may have added.
  [[nodiscard]] static Result<LabelDatabase> open(const std::filesystem::path& path,
                                                  const std::string& name,
                                                  Access access);
  LabelDatabase(LabelDatabase&& other) noexcept;
  LabelDatabase& operator=(LabelDatabase&& other) noexcept;
  ~LabelDatabase();

  [[nodiscard]] Result<void> execute(const std::string& sql) const;
  [[nodiscard]] Result<LabelStatement> prepare(std::string_view sql) const;
  /// The first column of the first row as a whole number; 0 without rows.
  [[nodiscard]] Result<std::int64_t> whole(std::string_view sql) const;
  [[nodiscard]] tl::unexpected<Error> failure() const;

 private:
  LabelDatabase(sqlite3* database, std::string name);
  sqlite3* database_;
  std::string name_;
};

/// A transaction that is rolled back unless committed.
class LabelTransaction {
 public:
  /// @param begin  "BEGIN" to read, "BEGIN IMMEDIATE" to write.
  [[nodiscard]] static Result<LabelTransaction> begin(const LabelDatabase& database,
                                                      const std::string& begin);
  LabelTransaction(LabelTransaction&& other) noexcept;
  LabelTransaction& operator=(LabelTransaction&&) = delete;
  ~LabelTransaction();
  [[nodiscard]] Result<void> commit();

 private:
  explicit LabelTransaction(const LabelDatabase* database) : database_(database) {}
  const LabelDatabase* database_;
};

}  // namespace nadir
