// SPDX-License-Identifier: Apache-2.0
#include "core/base/sqlite_database.h"

#include <sqlite3.h>

#include <cmath>
#include <utility>

namespace nadir {
namespace {

Error error_of(const std::string& name,
               const char* if_not_one,
               int extended_code,
               const char* reason) {
  switch (extended_code & 0xff) {
    case SQLITE_NOTADB:
      return {ErrorCode::kMalformed, name + ": " + if_not_one};
    case SQLITE_CORRUPT:
    case SQLITE_ERROR:  // A table or column that files of this kind have is missing.
    case SQLITE_SCHEMA:
    case SQLITE_TOOBIG:
    case SQLITE_MISMATCH:
      return {ErrorCode::kMalformed, name + ": is damaged or cut off (" + reason + ")"};
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return {ErrorCode::kIo, name + ": is locked by another program"};
    case SQLITE_FULL:
      return {ErrorCode::kIo, name + ": the disk is full"};
    default:
      return {ErrorCode::kIo, name + ": " + reason};
  }
}

}  // namespace

SqliteStatement::SqliteStatement(SqliteStatement&& other) noexcept
    : database_(other.database_),
      statement_(std::exchange(other.statement_, nullptr)),
      bound_(other.bound_),
      bind_failure_(other.bind_failure_) {}

SqliteStatement::~SqliteStatement() { sqlite3_finalize(statement_); }

void SqliteStatement::note(int code) {
  if (code != SQLITE_OK && bind_failure_ == SQLITE_OK) bind_failure_ = code;
}

SqliteStatement& SqliteStatement::add(double value) {
  note(sqlite3_bind_double(statement_, ++bound_, value));  // SQLite itself makes NULL of NaN.
  return *this;
}

SqliteStatement& SqliteStatement::add(std::int64_t value) {
  note(sqlite3_bind_int64(statement_, ++bound_, value));
  return *this;
}

SqliteStatement& SqliteStatement::add(std::optional<double> value) {
  return value ? add(*value) : add_null();
}

SqliteStatement& SqliteStatement::add(std::string_view value) {
  const char* text = value.data() == nullptr ? "" : value.data();
  note(sqlite3_bind_text64(statement_, ++bound_, text, value.size(), SQLITE_STATIC, SQLITE_UTF8));
  return *this;
}

SqliteStatement& SqliteStatement::add(std::span<const std::uint8_t> value) {
  const void* bytes = value.empty() ? static_cast<const void*>("") : value.data();
  note(sqlite3_bind_blob64(statement_, ++bound_, bytes, value.size(), SQLITE_STATIC));
  return *this;
}

SqliteStatement& SqliteStatement::add_null() {
  note(sqlite3_bind_null(statement_, ++bound_));
  return *this;
}

Result<bool> SqliteStatement::next() {
  const int code = bind_failure_ == SQLITE_OK ? sqlite3_step(statement_) : bind_failure_;
  if (code == SQLITE_ROW) return true;
  Result<bool> outcome = false;
  if (code != SQLITE_DONE) outcome = database_->failure();
  sqlite3_reset(statement_);
  bound_ = 0;
  bind_failure_ = SQLITE_OK;
  return outcome;
}

Result<void> SqliteStatement::run() {
  const auto row = next();
  if (!row) return forward_error(row);
  return {};
}

bool SqliteStatement::is_null(int column) const {
  return sqlite3_column_type(statement_, column) == SQLITE_NULL;
}

bool SqliteStatement::is_number(int column) const {
  return is_whole(column) || sqlite3_column_type(statement_, column) == SQLITE_FLOAT;
}

bool SqliteStatement::is_whole(int column) const {
  return sqlite3_column_type(statement_, column) == SQLITE_INTEGER;
}

std::string SqliteStatement::column_name(int column) const {
  const char* name = sqlite3_column_name(statement_, column);
  return name == nullptr ? std::string() : name;
}

double SqliteStatement::number(int column) const {
  return is_null(column) ? std::nan("") : sqlite3_column_double(statement_, column);
}

std::int64_t SqliteStatement::whole(int column) const {
  return sqlite3_column_int64(statement_, column);
}

std::string SqliteStatement::text(int column) const {
  const auto* const text = sqlite3_column_text(statement_, column);
  const int bytes = sqlite3_column_bytes(statement_, column);
  return text == nullptr ? std::string() : std::string(text, text + bytes);
}

std::span<const std::uint8_t> SqliteStatement::blob(int column) const {
  const auto* const bytes =
      static_cast<const std::uint8_t*>(sqlite3_column_blob(statement_, column));
  if (bytes == nullptr) return {};
  return {bytes, static_cast<std::size_t>(sqlite3_column_bytes(statement_, column))};
}

Result<SqliteDatabase> SqliteDatabase::open(const std::filesystem::path& path,
                                            const std::string& name,
                                            const SqliteFileKind& kind,
                                            SqliteAccess access) {
  int flags = SQLITE_OPEN_READONLY;
  if (access == SqliteAccess::kWrite) flags = SQLITE_OPEN_READWRITE;
  if (access == SqliteAccess::kCreate) flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
  sqlite3* handle = nullptr;
  // Absolute, since SQLite reads meaning into names such as ":memory:" and "file:...".
  std::error_code ignored;
  const std::filesystem::path absolute = std::filesystem::absolute(path, ignored);
  const int code = sqlite3_open_v2(absolute.c_str(), &handle, flags, nullptr);
  SqliteDatabase database(handle, name, kind.if_not_one);
  if (code != SQLITE_OK) {
    if (handle == nullptr) return fail(ErrorCode::kIo, "{}: {}", name, sqlite3_errstr(code));
    return database.failure();
  }
  sqlite3_extended_result_codes(handle, 1);
  sqlite3_busy_timeout(handle, kind.patience_ms);
  sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, kind.most_value_bytes);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  if (auto checked = database.execute("PRAGMA cell_size_check = ON"); !checked) {
    return forward_error(checked);
  }
  return database;
}

SqliteDatabase::SqliteDatabase(SqliteDatabase&& other) noexcept
    : database_(std::exchange(other.database_, nullptr)),
      name_(std::move(other.name_)),
      if_not_one_(other.if_not_one_) {}

SqliteDatabase& SqliteDatabase::operator=(SqliteDatabase&& other) noexcept {
  std::swap(database_, other.database_);
  std::swap(name_, other.name_);
  std::swap(if_not_one_, other.if_not_one_);
  return *this;
}

SqliteDatabase::~SqliteDatabase() { sqlite3_close_v2(database_); }

Result<void> SqliteDatabase::execute(const std::string& sql) const {
  if (sqlite3_exec(database_, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
    return failure();
  return {};
}

Result<SqliteStatement> SqliteDatabase::prepare(std::string_view sql) const {
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(database_, sql.data(), static_cast<int>(sql.size()), &statement,
                         nullptr) != SQLITE_OK) {
    return failure();
  }
  return SqliteStatement(this, statement);
}

Result<std::int64_t> SqliteDatabase::whole(std::string_view sql) const {
  auto statement = prepare(sql);
  if (!statement) return forward_error(statement);
  const auto row = statement->next();
  if (!row) return forward_error(row);
  return *row ? statement->whole(0) : 0;
}

bool SqliteDatabase::needs_recovery() const {
  return sqlite3_extended_errcode(database_) == SQLITE_READONLY_ROLLBACK;
}

tl::unexpected<Error> SqliteDatabase::failure() const {
  return tl::unexpected<Error>(
      error_of(name_, if_not_one_, sqlite3_extended_errcode(database_), sqlite3_errmsg(database_)));
}

Result<SqliteTransaction> SqliteTransaction::begin(const SqliteDatabase& database,
                                                   const std::string& begin) {
  if (const auto begun = database.execute(begin); !begun) return forward_error(begun);
  return SqliteTransaction(&database);
}

SqliteTransaction::SqliteTransaction(SqliteTransaction&& other) noexcept
    : database_(std::exchange(other.database_, nullptr)) {}

SqliteTransaction::~SqliteTransaction() {
  // Where SQLite has rolled back by itself already (disk full) this fails, and nothing is left to
  // do.
  if (database_ != nullptr) static_cast<void>(database_->execute("ROLLBACK"));
}

Result<void> SqliteTransaction::commit() {
  auto committed = database_->execute("COMMIT");
  if (committed) database_ = nullptr;
  return committed;
}

}  // namespace nadir
