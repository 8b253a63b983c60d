// SPDX-License-Identifier: Apache-2.0
#include "core/label/label_tables.h"

#include <array>
#include <cstdlib>
#include <memory>

#include "core/label/label_blobs.h"
#include "core/label/label_schema.h"
#include "core/label/row_walk.h"

namespace nadir {
namespace {

constexpr std::array<ObjectKind, 3> kKinds{ObjectKind::kArea, ObjectKind::kLine,
                                           ObjectKind::kOutline};

std::string upsert_of(ObjectKind kind) {
  switch (kind) {
    case ObjectKind::kArea:
      return "INSERT INTO area (fid, geom, class, drawing_order, note) VALUES (?, ?, ?, ?, ?) "
             "ON CONFLICT (fid) DO UPDATE SET geom = excluded.geom, class = excluded.class, "
             "drawing_order = excluded.drawing_order, note = excluded.note";
    case ObjectKind::kLine:
      return "INSERT INTO line (fid, geom, class, drawing_order, note, width_m) VALUES (?, ?, ?, "
             "?, ?, ?) "
             "ON CONFLICT (fid) DO UPDATE SET geom = excluded.geom, class = excluded.class, "
             "drawing_order = excluded.drawing_order, note = excluded.note, width_m = "
             "excluded.width_m";
    case ObjectKind::kOutline:
      return "INSERT INTO outline (fid, geom, class, drawing_order, note, thickness_m) VALUES (?, "
             "?, ?, ?, ?, ?) "
             "ON CONFLICT (fid) DO UPDATE SET geom = excluded.geom, class = excluded.class, "
             "drawing_order = excluded.drawing_order, note = excluded.note, "
             "thickness_m = excluded.thickness_m";
  }
  return {};
}

Result<void> write_object(const SqliteDatabase& database, const LabelObject& object) {
  auto row = database.prepare(upsert_of(object.kind));
  if (!row) return forward_error(row);
  const Bytes geometry = geopackage_geometry(object, kPlaneSrsId);
  row->add(object.id).add(ByteSpan(geometry)).add(class_info(object.class_id).name);
  row->add(object.order);
  if (object.note.empty()) {
    row->add_null();
  } else {
    row->add(std::string_view(object.note));
  }
  if (object.kind != ObjectKind::kArea) row->add(object.width_m);
  if (auto written = row->run(); !written) return written;
  auto shadow = database.prepare("INSERT OR REPLACE INTO nadir_object VALUES (?, ?)");
  if (!shadow) return forward_error(shadow);
  const Bytes image = object_image(object);
  return shadow->add(object.id).add(ByteSpan(image)).run();
}

Result<void> write_objects(const SqliteDatabase& database,
                           const std::vector<ObjectChange>& changes) {
  for (const auto& [before, after] : changes) {
    if (before != nullptr && (after == nullptr || after->kind != before->kind)) {
      if (auto removed = remove_row(database, before->kind, before->id); !removed) return removed;
    }
    if (after != nullptr) {
      if (auto written = write_object(database, *after); !written) return written;
      continue;
    }
    auto shadow = database.prepare("DELETE FROM nadir_object WHERE object = ?");
    if (!shadow) return forward_error(shadow);
    if (auto removed = shadow->add(before->id).run(); !removed) return removed;
  }
  return {};
}

Result<void> write_tiles(const SqliteDatabase& database, const std::vector<TileChange>& changes) {
  auto put = database.prepare("INSERT OR REPLACE INTO nadir_tile VALUES (?, ?, ?)");
  if (!put) return forward_error(put);
  auto remove = database.prepare("DELETE FROM nadir_tile WHERE tile_column = ? AND tile_row = ?");
  if (!remove) return forward_error(remove);
  for (const TileChange& change : changes) {
    const auto column = std::int64_t{change.address.column};
    const auto row = std::int64_t{change.address.row};
    Result<void> written;
    if (change.tile.after == nullptr) {
      written = remove->add(column).add(row).run();
    } else {
      const Bytes packed = packed_tile(*change.tile.after);
      written = put->add(column).add(row).add(ByteSpan(packed)).run();
    }
    if (!written) return written;
  }
  return {};
}

Result<void> write_values(const SqliteDatabase& database, const std::vector<ValueChange>& changes) {
  for (const ValueChange& change : changes) {
    const bool is_kept = change.value.after != nullptr;
    auto statement = database.prepare(is_kept ? "INSERT OR REPLACE INTO nadir_value VALUES (?, ?)"
                                              : "DELETE FROM nadir_value WHERE key = ?");
    if (!statement) return forward_error(statement);
    statement->add(std::string_view(change.key));
    if (is_kept) statement->add(std::string_view(*change.value.after));
    if (auto written = statement->run(); !written) return written;
  }
  return {};
}

PlaneBounds bounds_of_kind(const LabelDocument& document, ObjectKind kind) {
  PlaneBounds bounds;
  for (const auto& [id, placed] : document.objects()) {
    if (placed.object->kind != kind) continue;
    for (const Ring& ring : placed.object->rings) {
      for (const Eigen::Vector2d& point : ring) bounds.include(point);
    }
  }
  return bounds;
}

}  // namespace

Result<void> remove_row(const SqliteDatabase& database, ObjectKind kind, ObjectId id) {
  auto row = database.prepare(fmt::format("DELETE FROM {} WHERE fid = ?", enum_name(kind)));
  if (!row) return forward_error(row);
  return row->add(id).run();
}

Result<ReadContents> read_contents(const SqliteDatabase& database, LabelDocument& document) {
  ReadContents read;
  LabelEdit edit;
  const auto objects =
      visit_rows(database, "nadir_object", "image", [&](const SqliteStatement& row) {
        auto object = object_of_image(row.blob(1), row.whole(0));
        if (object) {
          edit.objects.push_back(
              {nullptr, std::make_shared<const LabelObject>(std::move(*object))});
        } else {
          read.notices.push_back(object.error().message);
          read.is_whole = false;
        }
      });
  if (!objects) return forward_error(objects);
  const auto tiles = visit_rows(
      database, "nadir_tile", "tile_column, tile_row, data", [&](const SqliteStatement& row) {
        const std::int64_t column = row.whole(1);
        const std::int64_t tile_row = row.whole(2);
        auto tile = unpacked_tile(row.blob(3));
        if (tile && std::abs(column) <= kMostPaintAddress &&
            std::abs(tile_row) <= kMostPaintAddress) {
          edit.tiles.push_back({{static_cast<int>(column), static_cast<int>(tile_row)},
                                {nullptr, std::move(*tile)}});
        } else {
          read.notices.push_back(
              fmt::format("the paint of tile {}, {} is damaged", column, tile_row));
          read.is_whole = false;
        }
      });
  if (!tiles) return forward_error(tiles);
  const auto values =
      visit_rows(database, "nadir_value", "key, value", [&](const SqliteStatement& row) {
        edit.values.push_back(
            {row.text(1), {nullptr, std::make_shared<const std::string>(row.text(2))}});
      });
  if (!values) return forward_error(values);
  read.is_whole = read.is_whole && *objects && *tiles && *values;
  document.apply(edit);
  const auto given = database.whole("SELECT max(object) FROM nadir_object_change");
  if (given) {
    document.reserve_ids(*given + 1);
  } else {
    read.is_whole = false;
  }
  return read;
}

Result<void> write_edit(const SqliteDatabase& database, const LabelEdit& edit) {
  if (auto written = write_objects(database, edit.objects); !written) return written;
  if (!edit.tiles.empty()) {
    if (auto written = write_tiles(database, edit.tiles); !written) return written;
  }
  return write_values(database, edit.values);
}

Result<void> write_layer_facts(const SqliteDatabase& database, const LabelDocument& document) {
  auto contents = database.prepare(
      "UPDATE gpkg_contents SET last_change = strftime('%Y-%m-%dT%H:%M:%fZ','now'), min_x = ?, "
      "min_y = ?, max_x = ?, max_y = ? WHERE table_name = ?");
  if (!contents) return forward_error(contents);
  for (const ObjectKind kind : kKinds) {
    const PlaneBounds bounds = bounds_of_kind(document, kind);
    if (bounds.is_empty) {
      contents->add_null().add_null().add_null().add_null();
    } else {
      contents->add(bounds.low.x()).add(bounds.low.y()).add(bounds.high.x()).add(bounds.high.y());
    }
    if (auto written = contents->add(enum_name(kind)).run(); !written) return written;
    // So that what a GIS adds gets a number that no object of any layer has.
    auto sequence = database.prepare("DELETE FROM sqlite_sequence WHERE name = ?");
    if (!sequence) return forward_error(sequence);
    if (auto written = sequence->add(enum_name(kind)).run(); !written) return written;
    auto next = database.prepare("INSERT INTO sqlite_sequence (name, seq) VALUES (?, ?)");
    if (!next) return forward_error(next);
    if (auto written = next->add(enum_name(kind)).add(document.next_id() - 1).run(); !written) {
      return written;
    }
  }
  return {};
}

}  // namespace nadir
