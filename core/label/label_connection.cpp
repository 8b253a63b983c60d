// SPDX-License-Identifier: Apache-2.0
#include "core/label/label_connection.h"

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
  if (!database || !is_for_reading) return database;
  if (auto only = database->execute("PRAGMA query_only = ON"); !only) return forward_error(only);
  return database;
}

}  // namespace

LabelConnection::TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path, ignored);
}

Result<LabelConnection> LabelConnection::open(const fs::path& path, bool is_for_reading) {
  auto database = open_database(path, path.string(), is_for_reading);
  if (database) return LabelConnection(nullptr, std::move(*database));
  if (database.error().code != ErrorCode::kIo || !has_changes(path)) return forward_error(database);
  return open_copy(path);
}

Result<LabelConnection> LabelConnection::open_copy(const fs::path& path) {
  const std::string name = path.string();
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
