// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "core/base/sqlite_database.h"

namespace nadir {

/// Opens a labels.gpkg as a database, unread, with functions for the triggers of a spatial index that a GIS may have added.
/// Private to this module.
/// @param name  Stands for the file in messages. @errors as SqliteDatabase::open().
[[nodiscard]] Result<SqliteDatabase> open_label_database(const std::filesystem::path& path,
                                                         const std::string& name,
                                                         SqliteAccess access);

}  // namespace nadir
