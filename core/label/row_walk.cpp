// SPDX-License-Identifier: Apache-2.0
#include "core/label/row_walk.h"

#include <cstdint>
#include <limits>

namespace nadir {

Result<bool> visit_rows(const SqliteDatabase& database,
                        const std::string& table,
                        const std::string& columns,
                        const std::function<void(const SqliteStatement& row)>& take) {
  const std::string selection =
      fmt::format("SELECT rowid, {} FROM {} ORDER BY rowid", columns, table);
  auto last = std::numeric_limits<std::int64_t>::min();
  {
    auto rows = database.prepare(selection);
    if (!rows) return forward_error(rows);
    for (;;) {
      const auto row = rows->next();
      if (!row && row.error().code != ErrorCode::kMalformed) return forward_error(row);
      if (!row) break;
      if (!*row) return true;
      last = rows->whole(0);
      take(*rows);
    }
  }
  auto rows = database.prepare(selection + " DESC");
  if (!rows) return forward_error(rows);
  for (;;) {
    const auto row = rows->next();
    if (!row && row.error().code != ErrorCode::kMalformed) return forward_error(row);
    if (!row || !*row || rows->whole(0) <= last) return false;
    take(*rows);
  }
}

}  // namespace nadir
