// SPDX-License-Identifier: Apache-2.0
#include "core/run/run_connection.h"

#include <cstdlib>
#include <system_error>
#include <utility>

#include "core/run/run_database.h"
#include "core/run/run_schema.h"

namespace nadir::detail {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kTouch = "SELECT count(*) FROM sqlite_schema";

Result<void> check_format(const SqliteDatabase& database, const std::string& name) {
  const auto id = database.whole("PRAGMA application_id");
  if (!id) return forward_error(id);
  if (*id != kRunApplicationId) return fail(ErrorCode::kMalformed, "{}: is not a run file", name);
  const auto version = database.whole("PRAGMA user_version");
  if (!version) return forward_error(version);
  if (*version > kRunFormatVersion) {
    return fail(
        ErrorCode::kUnsupported,
        "{}: was written by a newer version of Nadir (run format {}, this one reads up to {})",
        name, *version, kRunFormatVersion);
  }
  // Views and virtual tables under our names could run code of the file's author.
  const auto tables = database.whole(
      "SELECT count(*) FROM sqlite_schema WHERE type = 'table' AND sql LIKE 'CREATE TABLE%' "
      "AND name IN ('about', 'step', 'mode', 'particles', 'topview')");
  if (!tables) return forward_error(tables);
  if (*version < 1 || *tables != 5) {
    return fail(ErrorCode::kMalformed, "{}: is damaged (tables of a run are missing)", name);
  }
  return {};
}

/// SQLite itself reads the missing part of a last page as zeros. Called in a read transaction, when
/// no writer changes the size.
Result<void> check_size(const SqliteDatabase& database, const fs::path& path) {
  const auto pages = database.whole("PRAGMA page_count");
  if (!pages) return forward_error(pages);
  const auto page_bytes = database.whole("PRAGMA page_size");
  if (!page_bytes) return forward_error(page_bytes);
  std::error_code error;
  const std::uintmax_t bytes = fs::file_size(path, error);
  if (error ||
      bytes / static_cast<std::uintmax_t>(*page_bytes) < static_cast<std::uintmax_t>(*pages)) {
    return fail(ErrorCode::kMalformed, "{}: is damaged or cut off ({} bytes of {})", path.string(),
                error ? 0 : bytes, *pages * *page_bytes);
  }
  return {};
}

}  // namespace

RunConnection::RemovedFolder::~RemovedFolder() {
  std::error_code ignored;
  fs::remove_all(path, ignored);
}

Result<RunConnection> RunConnection::open(const fs::path& path) {
  const std::string name = path.string();
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return fail(ErrorCode::kNotFound, "{}: does not exist", name);
  if (fs::is_directory(status)) {
    return fail(ErrorCode::kMalformed, "{}: is a folder, not a run file", name);
  }
  if (fs::is_regular_file(status) && fs::file_size(path, error) == 0) {
    return fail(ErrorCode::kMalformed, "{}: is empty", name);
  }
  auto database = open_run_database(path, name, SqliteAccess::kRead);
  if (!database) return forward_error(database);
  RunConnection connection(path, std::move(*database));
  const auto checked = connection.read([&](const SqliteDatabase& opened) -> Result<void> {
    auto format = check_format(opened, name);
    if (!format || connection.copy_ != nullptr) return format;
    return check_size(opened, path);
  });
  if (!checked) return forward_error(checked);
  return connection;
}

Result<SqliteTransaction> RunConnection::begin() {
  bool needs_recovery = false;
  const auto attempt = [&]() -> Result<SqliteTransaction> {
    auto transaction = SqliteTransaction::begin(database_, "BEGIN");
    if (!transaction) return transaction;
    const auto touched = database_.whole(kTouch);
    needs_recovery = !touched && database_.needs_recovery();
    if (!touched) return forward_error(touched);
    return transaction;
  };
  auto first = attempt();
  if (!needs_recovery) return first;
  if (const auto recovered = recover(); !recovered) return forward_error(recovered);
  return attempt();
}

Result<void> RunConnection::recover() {
  const std::string name = path_.string();
  bool is_recovered = false;
  if (const auto writable = open_run_database(path_, name, SqliteAccess::kWrite)) {
    is_recovered = writable->whole(kTouch).has_value();
  }
  if (!is_recovered) return recover_a_copy();
  auto reopened = open_run_database(path_, name, SqliteAccess::kRead);
  if (!reopened) return forward_error(reopened);
  database_ = std::move(*reopened);
  return {};
}

Result<void> RunConnection::recover_a_copy() {
  const std::string name = path_.string();
  std::error_code error;
  std::string folder = (fs::temp_directory_path(error) / "nadir-run-XXXXXX").string();
  if (error || ::mkdtemp(folder.data()) == nullptr) {
    return fail(ErrorCode::kIo,
                "{}: its writer was killed, and there is no temporary folder to repair a copy in",
                name);
  }
  auto copy = std::make_unique<RemovedFolder>(folder);
  const fs::path copied = copy->path / "run.nadir";
  fs::copy_file(path_, copied, error);
  if (!error) fs::copy_file(name + "-journal", copied.string() + "-journal", error);
  if (!error) fs::permissions(copied, fs::perms::owner_write, fs::perm_options::add, error);
  if (!error) {
    fs::permissions(copied.string() + "-journal", fs::perms::owner_write, fs::perm_options::add,
                    error);
  }
  if (error) {
    return fail(ErrorCode::kIo, "{}: its writer was killed, and a copy cannot be repaired: {}",
                name, error.message());
  }
  auto repaired = open_run_database(copied, name, SqliteAccess::kWrite);
  if (!repaired) return forward_error(repaired);
  if (const auto touched = repaired->whole(kTouch); !touched) return forward_error(touched);
  database_ = std::move(*repaired);
  copy_ = std::move(copy);
  return {};
}

}  // namespace nadir::detail
