// SPDX-License-Identifier: Apache-2.0
#include "core/label/label_database.h"

#include <sqlite3.h>

#include "core/label/spatial_functions.h"

namespace nadir {
namespace {

/// A gesture waits for another program's lock, so not for long.
constexpr SqliteFileKind kLabelFile{
    .if_not_one = "is no labelling document", .patience_ms = 2'000, .most_value_bytes = 1 << 30};

}  // namespace

Result<SqliteDatabase> open_label_database(const std::filesystem::path& path,
                                           const std::string& name,
                                           SqliteAccess access) {
  auto database = SqliteDatabase::open(path, name, kLabelFile, access);
  if (!database) return database;
  if (add_spatial_functions(database->handle()) != SQLITE_OK) return database->failure();
  // What the schema of a document runs is functions that do no harm. Until version 3.44 SQLite counts the tables of spatial
  // indices among what may do some, so they are let through where there are any.
  const auto indices = database->whole(
      "SELECT count(*) FROM sqlite_schema WHERE type = 'table' AND sql LIKE 'CREATE VIRTUAL "
      "TABLE%USING rtree%'");
  if (!indices) return forward_error(indices);
  if (*indices > 0) {
    sqlite3_db_config(database->handle(), SQLITE_DBCONFIG_TRUSTED_SCHEMA, 1, nullptr);
  }
  return database;
}

}  // namespace nadir
