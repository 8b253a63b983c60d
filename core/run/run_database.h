// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "core/base/sqlite_database.h"
#include "core/run/run_file.h"

namespace nadir::detail {

/// A run file as any database, unread. @param name  Stands for the file in messages.
[[nodiscard]] Result<SqliteDatabase> open_run_database(const std::filesystem::path& path,
                                                       const std::string& name,
                                                       SqliteAccess access);

/// @param name  Stands for the file in messages.
/// @errors kMalformed: the origin of the plane is no place on Earth or the time at which the
/// run goes on is none, which a reader would refuse.
[[nodiscard]] Result<void> check_header(const RunHeader& header, const std::string& name);

/// Makes the tables of a run in an empty file, with the header and no steps. A journal of its name is
/// that of a run whose file somebody took away; it goes, for it would be rolled back into this one.
/// @errors kIo; then the file is to be removed.
[[nodiscard]] Result<SqliteDatabase> create_run_database(const std::filesystem::path& path,
                                                         const RunHeader& header);

}  // namespace nadir::detail
