// SPDX-License-Identifier: Apache-2.0
#include "core/label/label_journal.h"

#include <memory>
#include <string>
#include <utility>

#include "core/label/label_blobs.h"

namespace nadir {
namespace {

constexpr std::string_view kStepColumns =
    "SELECT step, parent, time, author, title FROM nadir_step";

LabelStep step_of_row(const SqliteStatement& row) {
  return {row.whole(0), row.whole(1), row.text(2), row.text(3), row.text(4)};
}

Result<std::optional<LabelStep>> first_step(const SqliteDatabase& database,
                                            std::string_view condition,
                                            std::int64_t number) {
  auto rows = database.prepare(fmt::format("{} {}", kStepColumns, condition));
  if (!rows) return forward_error(rows);
  const auto row = rows->add(number).next();
  if (!row) return forward_error(row);
  if (!*row) return std::optional<LabelStep>();
  return step_of_row(*rows);
}

Bytes image_of(const std::shared_ptr<const LabelObject>& object) {
  return object != nullptr ? object_image(*object) : Bytes();
}

Result<void> add_objects(const SqliteDatabase& database, std::int64_t step, const LabelEdit& edit) {
  auto insert = database.prepare("INSERT INTO nadir_object_change VALUES (?, ?, ?)");
  if (!insert) return forward_error(insert);
  for (const auto& [before, after] : edit.objects) {
    const Bytes delta = byte_delta(image_of(before), image_of(after));
    const ObjectId id = after != nullptr ? after->id : before->id;
    if (auto added = insert->add(step).add(id).add(ByteSpan(delta)).run(); !added) return added;
  }
  return {};
}

Result<void> add_tiles(const SqliteDatabase& database, std::int64_t step, const LabelEdit& edit) {
  auto insert = database.prepare("INSERT INTO nadir_tile_change VALUES (?, ?, ?, ?)");
  if (!insert) return forward_error(insert);
  for (const TileChange& change : edit.tiles) {
    const Bytes delta = tile_delta(change.tile.before.get(), change.tile.after.get());
    insert->add(step).add(std::int64_t{change.address.column});
    insert->add(std::int64_t{change.address.row}).add(ByteSpan(delta));
    if (auto added = insert->run(); !added) return added;
  }
  return {};
}

Result<void> add_values(const SqliteDatabase& database, std::int64_t step, const LabelEdit& edit) {
  auto insert = database.prepare("INSERT INTO nadir_value_change VALUES (?, ?, ?, ?)");
  if (!insert) return forward_error(insert);
  for (const ValueChange& change : edit.values) {
    insert->add(step).add(std::string_view(change.key));
    for (const auto& value : {change.value.before, change.value.after}) {
      if (value != nullptr) {
        insert->add(std::string_view(*value));
      } else {
        insert->add_null();
      }
    }
    if (auto added = insert->run(); !added) return added;
  }
  return {};
}

/// Undoes or does again what a step has kept.
class StepReader {
 public:
  StepReader(const SqliteDatabase& database,
             const LabelStep& step,
             StepDirection direction,
             const LabelDocument& document)
      : database_(database), step_(step), direction_(direction), document_(document) {
    edit_.title = step.title;
  }

  Result<LabelEdit> read() {
    if (auto read = read_objects(); !read) return forward_error(read);
    if (auto read = read_tiles(); !read) return forward_error(read);
    if (auto read = read_values(); !read) return forward_error(read);
    return std::move(edit_);
  }

 private:
  [[nodiscard]] Result<SqliteStatement> rows_of(std::string_view selection) const {
    auto rows = database_.prepare(selection);
    if (rows) rows->add(step_.number);
    return rows;
  }

  Result<void> read_objects() {
    auto rows = rows_of("SELECT object, delta FROM nadir_object_change WHERE step = ?");
    if (!rows) return forward_error(rows);
    for (;;) {
      const auto row = rows->next();
      if (!row) return forward_error(row);
      if (!*row) return {};
      const ObjectId id = rows->whole(0);
      const auto now = document_.object(id);
      const Bytes image = image_of(now);
      const auto other = direction_ == StepDirection::kUndo ? before_of(rows->blob(1), image)
                                                            : after_of(rows->blob(1), image);
      if (!other) return forward_error(other, fmt::format("object {}", id));
      if (other->empty()) {
        edit_.objects.push_back({now, nullptr});
        continue;
      }
      auto object = object_of_image(*other, id);
      if (!object) return forward_error(object);
      edit_.objects.push_back({now, std::make_shared<const LabelObject>(std::move(*object))});
    }
  }

  Result<void> read_tiles() {
    auto rows =
        rows_of("SELECT tile_column, tile_row, delta FROM nadir_tile_change WHERE step = ?");
    if (!rows) return forward_error(rows);
    for (;;) {
      const auto row = rows->next();
      if (!row) return forward_error(row);
      if (!*row) return {};
      const PaintAddress address{static_cast<int>(rows->whole(0)),
                                 static_cast<int>(rows->whole(1))};
      const auto now = document_.tile(address);
      auto other = other_tile(rows->blob(2), now.get());
      if (!other) return forward_error(other);
      edit_.tiles.push_back({address, {now, std::move(*other)}});
    }
  }

  Result<void> read_values() {
    auto rows = rows_of("SELECT key, before, after FROM nadir_value_change WHERE step = ?");
    if (!rows) return forward_error(rows);
    const int column = direction_ == StepDirection::kUndo ? 1 : 2;
    for (;;) {
      const auto row = rows->next();
      if (!row) return forward_error(row);
      if (!*row) return {};
      const std::string key = rows->text(0);
      std::shared_ptr<const std::string> other;
      if (!rows->is_null(column)) other = std::make_shared<const std::string>(rows->text(column));
      edit_.values.push_back({key, {document_.value(key), std::move(other)}});
    }
  }

  const SqliteDatabase& database_;
  const LabelStep& step_;
  StepDirection direction_;
  const LabelDocument& document_;
  LabelEdit edit_;
};

}  // namespace

Result<std::int64_t> read_head(const SqliteDatabase& database) {
  return database.whole("SELECT step FROM nadir_head");
}

Result<void> write_head(const SqliteDatabase& database, std::int64_t step) {
  auto update = database.prepare("UPDATE nadir_head SET step = ?");
  if (!update) return forward_error(update);
  return update->add(step).run();
}

Result<std::int64_t> add_step(const SqliteDatabase& database,
                              LabelStep step,
                              const LabelEdit& edit) {
  const auto last = database.whole("SELECT max(step) FROM nadir_step");
  if (!last) return forward_error(last);
  step.number = *last + 1;
  auto insert = database.prepare("INSERT INTO nadir_step VALUES (?, ?, ?, ?, ?)");
  if (!insert) return forward_error(insert);
  insert->add(step.number).add(step.parent).add(std::string_view(step.time));
  insert->add(std::string_view(step.author)).add(std::string_view(step.title));
  if (auto added = insert->run(); !added) return forward_error(added);
  for (const auto add : {add_objects, add_tiles, add_values}) {
    if (auto added = add(database, step.number, edit); !added) return forward_error(added);
  }
  return step.number;
}

Result<std::optional<LabelStep>> read_step(const SqliteDatabase& database, std::int64_t number) {
  return first_step(database, "WHERE step = ?", number);
}

Result<std::optional<LabelStep>> youngest_after(const SqliteDatabase& database,
                                                std::int64_t number) {
  return first_step(database, "WHERE parent = ? ORDER BY step DESC LIMIT 1", number);
}

Result<std::vector<LabelStep>> read_steps(const SqliteDatabase& database,
                                          std::int64_t first,
                                          int count) {
  auto rows =
      database.prepare(fmt::format("{} WHERE step >= ? ORDER BY step LIMIT ?", kStepColumns));
  if (!rows) return forward_error(rows);
  rows->add(first).add(std::int64_t{count});
  std::vector<LabelStep> steps;
  for (;;) {
    const auto row = rows->next();
    if (!row) return forward_error(row);
    if (!*row) return steps;
    steps.push_back(step_of_row(*rows));
  }
}

Result<LabelEdit> edit_of_step(const SqliteDatabase& database,
                               const LabelStep& step,
                               StepDirection direction,
                               const LabelDocument& document) {
  return StepReader(database, step, direction, document).read();
}

}  // namespace nadir
