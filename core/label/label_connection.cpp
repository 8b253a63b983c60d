// SPDX-License-Identifier: Apache-2.0
#include "core/label/label_connection.h"

#include <sqlite3.h>
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkdtemp is POSIX's.
#include <unistd.h>

#include <system_error>

namespace nadir {
namespace {

namespace fs = std::filesystem;

fs::path changes_of(const fs::path& document) {
  fs::path changes = document;
  changes += "-wal";
  return changes;
}

bool has_changes(const fs::path& document) {
  std::error_code error;
  const auto bytes = fs::file_size(changes_of(document), error);
  return !error && bytes > 0;
}

Result<SqliteDatabase> open_database(const fs::path& path,
                                     const std::string& name,
                                     bool is_for_reading) {
  // Reading too needs to write beside a file that another program is writing.
  const bool can_be_written = ::access(path.c_str(), W_OK) == 0;
  auto database =
      open_label_database(path, name, can_be_written ? SqliteAccess::kWrite : SqliteAccess::kRead);
  if (!database) return database;
  int has_moved = 0;
  sqlite3_file_control(database->handle(), "main", SQLITE_FCNTL_HAS_MOVED, &has_moved);
  if (has_moved != 0) {
    return fail(ErrorCode::kIo, "{}: another program has replaced it while it was opened", name);
  }
  if (!is_for_reading) return database;
  if (auto only = database->execute("PRAGMA query_only = ON"); !only) return forward_error(only);
  return database;
}

}  // namespace

LabelConnection::TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path, ignored);
}

Result<LabelConnection> LabelConnection::open(const fs::path& path,
                                              const std::string& name,
                                              bool is_for_reading) {
  auto database = open_database(path, name, is_for_reading);
  if (database) return LabelConnection(nullptr, std::move(*database));
  if (database.error().code != ErrorCode::kIo || !has_changes(path)) return forward_error(database);
  return open_copy(path, name);
}

void LabelConnection::let_go(bool has_changes) {
  if (has_changes) static_cast<void>(database_.execute("PRAGMA wal_checkpoint(TRUNCATE)"));
  sqlite3_db_config(database_.handle(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
}

Result<LabelConnection> LabelConnection::open_copy(const fs::path& path, const std::string& name) {
  std::error_code error;
  std::string folder = (fs::temp_directory_path(error) / "nadir-label-XXXXXX").string();
  if (error || ::mkdtemp(folder.data()) == nullptr) {
    return fail(ErrorCode::kIo, "{}: there is no temporary folder to copy its last edits to", name);
  }
  auto copy = std::make_unique<TemporaryFolder>(folder);
  const fs::path copied = copy->path / "labels.gpkg";
  fs::copy_file(path, copied, error);
  if (!error) fs::copy_file(changes_of(path), changes_of(copied), error);
  for (const fs::path& file : {copied, changes_of(copied)}) {
    if (!error) fs::permissions(file, fs::perms::owner_write, fs::perm_options::add, error);
  }
  if (error) {
    return fail(ErrorCode::kIo, "{}: cannot be copied with its last edits ({})", name,
                error.message());
  }
  auto database = open_database(copied, name, true);
  if (!database) return forward_error(database);
  return LabelConnection(std::move(copy), std::move(*database));
}

}  // namespace nadir
