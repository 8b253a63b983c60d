// SPDX-License-Identifier: Apache-2.0
#include "core/run/copied_blobs.h"

#include <algorithm>

#include "core/run/run_connection.h"

namespace nadir::detail {
namespace {

constexpr std::size_t kStepsAtATime = 64;

/// One row of a table for each step that has one.
struct CopiedTable {
  const char* select;
  const char* insert;
  bool has_cell_size;
};

constexpr CopiedTable kCopiedTables[] = {
    {"SELECT step, count, data FROM particles WHERE step BETWEEN ? AND ? ORDER BY step",
     "INSERT INTO particles (step, count, data) VALUES (?, ?, ?)", false},
    {"SELECT step, count, data, metres_per_cell FROM topview WHERE step BETWEEN ? AND ? ORDER BY "
     "step",
     "INSERT INTO topview (step, count, data, metres_per_cell) VALUES (?, ?, ?, ?)", true}};

/// Rows of steps [first, last]. Rows that no step has belong to a file that somebody edited, and stay there.
Result<void> copy_rows(const CopiedTable& table,
                       const SqliteDatabase& from,
                       const SqliteDatabase& into,
                       std::span<const RunStep> steps) {
  auto rows = from.prepare(table.select);
  if (!rows) return forward_error(rows);
  auto insert = into.prepare(table.insert);
  if (!insert) return forward_error(insert);
  rows->add(std::int64_t{steps.front().step}).add(std::int64_t{steps.back().step});
  auto step = steps.begin();
  for (;;) {
    const auto row = rows->next();
    if (!row) return forward_error(row);
    if (!*row) return {};
    const std::int64_t number = rows->whole(0);
    while (step != steps.end() && step->step < number) ++step;
    if (step == steps.end() || step->step != number) continue;
    insert->add(number).add(rows->whole(1)).add(rows->blob(2));
    if (table.has_cell_size) insert->add(rows->number(3));
    if (const auto done = insert->next(); !done) return forward_error(done);
    ++step;
  }
}

}  // namespace

Result<void> copy_blobs(const std::filesystem::path& from,
                        const SqliteDatabase& into,
                        std::span<const RunStep> steps,
                        const WorkContext& context) {
  if (steps.empty()) return {};
  auto connection = RunConnection::open(from);
  if (!connection) return forward_error(connection);
  const auto all = static_cast<double>(steps.size());
  for (std::size_t begin = 0; begin < steps.size(); begin += kStepsAtATime) {
    if (context.is_stopped())
      return fail(ErrorCode::kCancelled, "copying earlier steps was stopped");
    const auto part = steps.subspan(begin, std::min(kStepsAtATime, steps.size() - begin));
    auto copied = connection->read([&](const SqliteDatabase& database) -> Result<void> {
      for (const CopiedTable& table : kCopiedTables) {
        if (auto done = copy_rows(table, database, into, part); !done) return done;
      }
      return {};
    });
    if (!copied) return copied;
    context.report(static_cast<double>(begin + part.size()) / all, "copying earlier steps");
  }
  return {};
}

}  // namespace nadir::detail
