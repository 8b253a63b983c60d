// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "core/base/result.h"
#include "core/label/label_database.h"

namespace nadir {

/// Gives `take` all rows of a table, also of one that is damaged in the middle: from the first on up to the damage, then from
/// the last back to it. Private to this module.
/// @param columns  After the table's row id, which is column 0. @param table  By its name.
/// @returns whether the table was whole. @errors kIo, such as a disk that fails.
[[nodiscard]] Result<bool> visit_rows(const SqliteDatabase& database,
                                      const std::string& table,
                                      const std::string& columns,
                                      const std::function<void(const SqliteStatement& row)>& take);

}  // namespace nadir
