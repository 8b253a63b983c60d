// SPDX-License-Identifier: Apache-2.0
#include "core/label/label_database.h"

#include <sqlite3.h>

#include <utility>

#include "core/label/spatial_functions.h"

namespace nadir {
namespace {

constexpr int kPatienceMs = 2'000;  // How long a gesture waits for another program's lock.
constexpr int kLargestValue =
    1 << 30;  // Bytes of one blob, so that a damaged length is not allocated.

Error error_of(const std::string& name, int extended_code, const char* reason) {
  switch (extended_code & 0xff) {
    case SQLITE_NOTADB:
      return {ErrorCode::kMalformed, name + ": is no labelling document"};
    case SQLITE_CORRUPT:
    case SQLITE_ERROR:  // A table or column that a document has is missing.
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

LabelStatement::LabelStatement(LabelStatement&& other) noexcept
    : database_(other.database_),
      statement_(std::exchange(other.statement_, nullptr)),
      bound_(other.bound_),
      bind_failure_(other.bind_failure_) {}

LabelStatement::~LabelStatement() { sqlite3_finalize(statement_); }

void LabelStatement::note(int code) {
  if (code != SQLITE_OK && bind_failure_ == SQLITE_OK) bind_failure_ = code;
}

LabelStatement& LabelStatement::add(std::int64_t value) {
  note(sqlite3_bind_int64(statement_, ++bound_, value));
  return *this;
}

LabelStatement& LabelStatement::add(double value) {
  note(sqlite3_bind_double(statement_, ++bound_, value));
  return *this;
}

LabelStatement& LabelStatement::add(std::string_view value) {
  const char* text = value.data() == nullptr ? "" : value.data();
  note(sqlite3_bind_text64(statement_, ++bound_, text, value.size(), SQLITE_STATIC, SQLITE_UTF8));
  return *this;
}

LabelStatement& LabelStatement::add(std::span<const std::uint8_t> value) {
  const void* bytes = value.empty() ? static_cast<const void*>("") : value.data();
  note(sqlite3_bind_blob64(statement_, ++bound_, bytes, value.size(), SQLITE_STATIC));
  return *this;
}

LabelStatement& LabelStatement::add_null() {
  note(sqlite3_bind_null(statement_, ++bound_));
  return *this;
}

Result<bool> LabelStatement::next() {
  const int code = bind_failure_ == SQLITE_OK ? sqlite3_step(statement_) : bind_failure_;
  if (code == SQLITE_ROW) return true;
  Result<bool> outcome = false;
  if (code != SQLITE_DONE) outcome = database_->failure();
  sqlite3_reset(statement_);
  bound_ = 0;
  bind_failure_ = SQLITE_OK;
  return outcome;
}

Result<void> LabelStatement::run() {
  const auto row = next();
  if (!row) return forward_error(row);
  return {};
}

bool LabelStatement::is_null(int column) const {
  return sqlite3_column_type(statement_, column) == SQLITE_NULL;
}

std::int64_t LabelStatement::whole(int column) const {
  return sqlite3_column_int64(statement_, column);
}

double LabelStatement::number(int column) const {
  return sqlite3_column_double(statement_, column);
}

std::string LabelStatement::text(int column) const {
  const auto* const text = sqlite3_column_text(statement_, column);
  const int bytes = sqlite3_column_bytes(statement_, column);
  return text == nullptr ? std::string() : std::string(text, text + bytes);
}

std::span<const std::uint8_t> LabelStatement::blob(int column) const {
  const auto* const bytes =
      static_cast<const std::uint8_t*>(sqlite3_column_blob(statement_, column));
  if (bytes == nullptr) return {};
  return {bytes, static_cast<std::size_t>(sqlite3_column_bytes(statement_, column))};
}

LabelDatabase::LabelDatabase(sqlite3* database, std::string name)
    : database_(database), name_(std::move(name)) {}

Result<LabelDatabase> LabelDatabase::open(const std::filesystem::path& path,
                                          const std::string& name,
                                          Access access) {
  int flags = SQLITE_OPEN_READONLY;
  if (access == Access::kWrite) flags = SQLITE_OPEN_READWRITE;
  if (access == Access::kCreate) flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
  sqlite3* handle = nullptr;
  // Absolute, since SQLite reads meaning into names such as ":memory:" and "file:...".
  std::error_code ignored;
  const std::filesystem::path absolute = std::filesystem::absolute(path, ignored);
  const int code = sqlite3_open_v2(absolute.c_str(), &handle, flags, nullptr);
  LabelDatabase database(handle, name);
  if (code != SQLITE_OK) {
    if (handle == nullptr) return fail(ErrorCode::kIo, "{}: {}", name, sqlite3_errstr(code));
    return database.failure();
  }
  sqlite3_extended_result_codes(handle, 1);
  sqlite3_busy_timeout(handle, kPatienceMs);
  sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, kLargestValue);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  // A document may come from anybody: what its schema runs is functions that do no harm. Until version 3.44 SQLite counts
  // the tables of spatial indices among what may do some, so they are let through where there are any.
  sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  if (add_spatial_functions(handle) != SQLITE_OK) return database.failure();
  if (auto checked = database.execute("PRAGMA cell_size_check = ON"); !checked) {
    return forward_error(checked);
  }
  const auto indices = database.whole(
      "SELECT count(*) FROM sqlite_schema WHERE type = 'table' AND sql LIKE 'CREATE VIRTUAL "
      "TABLE%USING rtree%'");
  if (!indices) return forward_error(indices);
  if (*indices > 0) sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 1, nullptr);
  return database;
}

LabelDatabase::LabelDatabase(LabelDatabase&& other) noexcept
    : database_(std::exchange(other.database_, nullptr)), name_(std::move(other.name_)) {}

LabelDatabase& LabelDatabase::operator=(LabelDatabase&& other) noexcept {
  std::swap(database_, other.database_);
  std::swap(name_, other.name_);
  return *this;
}

LabelDatabase::~LabelDatabase() { sqlite3_close_v2(database_); }

Result<void> LabelDatabase::execute(const std::string& sql) const {
  if (sqlite3_exec(database_, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) {
    return failure();
  }
  return {};
}

Result<LabelStatement> LabelDatabase::prepare(std::string_view sql) const {
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(database_, sql.data(), static_cast<int>(sql.size()), &statement,
                         nullptr) != SQLITE_OK) {
    return failure();
  }
  return LabelStatement(this, statement);
}

Result<std::int64_t> LabelDatabase::whole(std::string_view sql) const {
  auto statement = prepare(sql);
  if (!statement) return forward_error(statement);
  const auto row = statement->next();
  if (!row) return forward_error(row);
  return *row ? statement->whole(0) : 0;
}

tl::unexpected<Error> LabelDatabase::failure() const {
  return tl::unexpected<Error>(
      error_of(name_, sqlite3_extended_errcode(database_), sqlite3_errmsg(database_)));
}

Result<LabelTransaction> LabelTransaction::begin(const LabelDatabase& database,
                                                 const std::string& begin) {
  if (const auto begun = database.execute(begin); !begun) return forward_error(begun);
  return LabelTransaction(&database);
}

LabelTransaction::LabelTransaction(LabelTransaction&& other) noexcept
    : database_(std::exchange(other.database_, nullptr)) {}

LabelTransaction::~LabelTransaction() {
  // Where SQLite has rolled back by itself already (disk full) this fails, and nothing is left to do.
  if (database_ != nullptr) static_cast<void>(database_->execute("ROLLBACK"));
}

Result<void> LabelTransaction::commit() {
  auto committed = database_->execute("COMMIT");
  if (committed) database_ = nullptr;
  return committed;
}

}  // namespace nadir
