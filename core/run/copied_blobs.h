// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>

#include "core/base/progress.h"
#include "core/base/sqlite_database.h"
#include "core/run/run_file.h"

namespace nadir::detail {

/// Copies particles and topviews of these steps from the run file `from` into the tables of another, as they are stored:
/// nothing is unpacked, so nothing is rounded, and damage (which their checksums tell) is copied too. A step without them is
/// no error. A few steps are read at a time, so that a writer of `from` need not wait long.
/// @param into  In a transaction that the caller commits.
/// @errors kCancelled, and as RunConnection.
[[nodiscard]] Result<void> copy_blobs(const std::filesystem::path& from,
                                      const SqliteDatabase& into,
                                      std::span<const RunStep> steps,
                                      const WorkContext& context);

}  // namespace nadir::detail
