// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/edit/edge_tree.h"
#include "core/edit/edit_builder.h"
#include "core/edit/edit_objects.h"
#include "core/edit/polygon_algebra.h"
#include "core/label/cell_fill.h"
#include "core/label/tile_painter.h"

namespace nadir {
namespace {

/// What a cell becomes when its class does; others stay.
PaintValue recoded_paint(PaintValue value, ClassId from, ClassId to) {
  if (value == kNoPaint || painted_class(value) != from) return value;
  if (to == kUnclassified) return kUnclassified;
  return static_cast<PaintValue>(covers_everything(value) ? to + kPaintOver : to);
}

/// Parts of an object within a region and outside of it, as it is cut there.
struct RecodedParts {
  std::vector<std::vector<Ring>> inside, outside;
};

Result<RecodedParts> recoded_parts(const LabelObject& object, const Region& within) {
  RecodedParts parts;
  if (object.kind == ObjectKind::kLine) {
    for (CutLine::Piece& piece : cut(object.rings.front(), within).pieces) {
      (piece.is_inside ? parts.inside : parts.outside).push_back({std::move(piece.places)});
    }
    return parts;
  }
  const auto whole = region_of(object);
  if (!whole) return forward_error(whole, object_name(object));
  auto inside = common(*whole, within);
  if (!inside) return forward_error(inside, object_name(object));
  if (object.kind == ObjectKind::kOutline) {
    const bool is_most = 2.0 * area_m2(*inside) > area_m2(*whole);
    (is_most ? parts.inside : parts.outside).push_back(object.rings);
    return parts;
  }
  auto outside = without(*whole, within);
  if (!outside) return forward_error(outside, object_name(object));
  parts.inside = std::move(inside->parts);
  parts.outside = std::move(outside->parts);
  return parts;
}

void recode_paint(LabelEdit& edit,
                  const LabelDocument& document,
                  ClassId from,
                  ClassId to,
                  const std::optional<Ring>& within) {
  const auto changes = [&](PaintValue value) { return recoded_paint(value, from, to) != value; };
  TilePainter painter(document);
  const auto recode_cells = [&](const PaintTile& tile, std::int64_t left, std::int64_t row,
                                int row_in_tile, std::int64_t begin, std::int64_t end) {
    for (std::int64_t column = begin; column < end; ++column) {
      const PaintValue value = tile.at(static_cast<int>(column - left), row_in_tile);
      if (changes(value)) painter.put(row, column, column + 1, recoded_paint(value, from, to));
    }
  };
  std::vector<Ring> rings;
  if (within) {
    rings.push_back(*within);
    for (Eigen::Vector2d& place : rings.front()) place = document.grid().cells_from_enu(place);
  }
  for (const auto& [address, shared_tile] : document.paint()) {
    const PaintTile& tile = *shared_tile;
    if (std::none_of(tile.values.begin(), tile.values.end(), changes)) continue;
    const std::int64_t left = std::int64_t{address.column} * kPaintTileSide;
    const std::int64_t top = std::int64_t{address.row} * kPaintTileSide;
    const CellRect cells{left, top, left + kPaintTileSide, top + kPaintTileSide};
    if (within) {
      fill_rings(rings, cells, [&](std::int64_t row, std::int64_t begin, std::int64_t end) {
        recode_cells(tile, left, row, static_cast<int>(row - top), begin, end);
      });
    } else {
      for (std::int64_t row = cells.top; row < cells.bottom; ++row) {
        recode_cells(tile, left, row, static_cast<int>(row - top), cells.left, cells.right);
      }
    }
  }
  edit.tiles = painter.edit({}).tiles;
}

}  // namespace

Result<LabelEdit> recode(const LabelDocument& document,
                         ClassId from,
                         ClassId to,
                         const std::optional<Ring>& within) {
  for (const ClassId id : {from, to}) {
    if (id != kUnclassified && !can_lie_in_overhead(id)) {
      return fail(ErrorCode::kInvalidOptions, "no overhead can hold the class {}", id);
    }
  }
  EditBuilder builder(document,
                      fmt::format("Recode {} to {}", class_info(from).name, class_info(to).name));
  if (from == to) return builder.edit();
  Region region;
  PlaneBounds bounds;
  if (within) {
    LabelObject ring;
    ring.id = 1;
    ring.rings = {*within};
    if (const auto sound = check_object(ring); !sound) {
      return fail(ErrorCode::kInvalidOptions, "the ring to recode in has no inside");
    }
    auto inside = region_of(ring);
    if (!inside) return forward_error(inside);
    region = std::move(*inside);
    bounds = drawn_bounds(ring);
  }
  std::vector<const LabelObject*> objects;
  for (const auto& [id, placed] : document.objects()) {
    const bool counts =
        placed.object->class_id == from && (!within || do_meet(placed.bounds, bounds));
    if (counts) objects.push_back(placed.object.get());
  }
  std::stable_sort(objects.begin(), objects.end(),
                   [](const LabelObject* a, const LabelObject* b) { return a->order < b->order; });
  for (const LabelObject* const object : objects) {
    LabelObject recoded = *object;
    recoded.class_id = to;
    if (within) {
      auto parts = recoded_parts(*object, region);
      if (!parts) return forward_error(parts);
      if (parts->inside.empty()) continue;
      if (!parts->outside.empty()) {
        recoded.order = builder.next_order(to);
        for (std::vector<Ring>& rings : parts->inside) {
          recoded.rings = std::move(rings);
          builder.add(recoded);
        }
        builder.replace(object->id, std::move(parts->outside));
        continue;
      }
    }
    recoded.order = builder.next_order(to);
    builder.change(object->id) = recoded;
  }
  builder.share_new_places();
  auto edit = builder.edit();
  if (edit) recode_paint(*edit, document, from, to, within);
  return edit;
}

}  // namespace nadir
