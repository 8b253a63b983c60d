// SPDX-License-Identifier: Apache-2.0
#include "core/label/label_raster.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/require.h"
#include "core/label/cell_fill.h"

namespace nadir {
namespace {

constexpr std::int64_t kRowsAtOnce = 64;

/// Objects that reach into a window, in the order in which they are drawn.
std::vector<const PlacedObject*> objects_in(const LabelDocument& document,
                                            const LabelGrid& grid,
                                            const CellRect& window) {
  std::vector<const PlacedObject*> objects;
  for (const auto& [id, placed] : document.objects()) {
    if (!grid.cells_of(placed.bounds, 1).cut_to(window).empty()) objects.push_back(&placed);
  }
  // By id they come from the map.
  std::stable_sort(objects.begin(), objects.end(),
                   [](const PlacedObject* a, const PlacedObject* b) {
                     return a->object->order < b->object->order;
                   });
  return objects;
}

std::vector<Ring> rings_in_cells(const LabelObject& object, const LabelGrid& grid) {
  std::vector<Ring> rings = object.rings;
  for (Ring& ring : rings) {
    for (Eigen::Vector2d& point : ring) point = grid.cells_from_enu(point);
  }
  return rings;
}

/// Some rows of a raster, drawn by one thread.
class Band {
 public:
  Band(const LabelGrid& grid, const CellRect& window, bool keeps_levels, ClassId* labels)
      : grid_(grid), window_(window), labels_(labels) {
    if (keeps_levels) levels_.assign(count(), std::numeric_limits<std::int8_t>::min());
  }

  void draw(const PlacedObject& placed) {
    const CellRect part = grid_.cells_of(placed.bounds, 1).cut_to(window_);
    if (part.empty()) return;
    const LabelObject& object = *placed.object;
    level_ = static_cast<std::int8_t>(std::clamp<std::int64_t>(
        level_of_order(object.order), std::numeric_limits<std::int8_t>::min(),
        std::numeric_limits<std::int8_t>::max()));
    const std::vector<Ring> rings = rings_in_cells(object, grid_);
    switch (object.kind) {
      case ObjectKind::kArea:
        fill_rings(rings, part, put(object.class_id));
        break;
      case ObjectKind::kLine:
        draw_line(rings.front(), object.width_m / grid_.metres_per_cell, part, object.class_id);
        break;
      case ObjectKind::kOutline:
        draw_outline(rings, object.width_m / grid_.metres_per_cell, part, object.class_id);
        break;
    }
  }

  void draw_paint(const LabelDocument& document) {
    const LabelGrid& of_paint = document.grid();
    std::vector<std::int64_t> columns;  // Of the paint, a column of the window.
    columns.reserve(static_cast<std::size_t>(window_.width()));
    for (std::int64_t column = window_.left; column < window_.right; ++column) {
      columns.push_back(static_cast<std::int64_t>(
          std::floor(of_paint.cells_from_enu(centre(column, window_.top)).x())));
    }
    for (std::int64_t row = window_.top; row < window_.bottom; ++row) {
      const auto paint_row = static_cast<std::int64_t>(
          std::floor(of_paint.cells_from_enu(centre(window_.left, row)).y()));
      for (std::int64_t column = window_.left; column < window_.right; ++column) {
        const PaintValue value =
            document.paint_at(columns[static_cast<std::size_t>(column - window_.left)], paint_row);
        if (value == kNoPaint) continue;
        const std::size_t at = index(column, row);
        const ClassId id = painted_class(value);
        if (covers_everything(value) || levels_[at] <= drawing_level(id)) labels_[at] = id;
      }
    }
  }

 private:
  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(window_.width()) * static_cast<std::size_t>(window_.height());
  }
  [[nodiscard]] std::size_t index(std::int64_t column, std::int64_t row) const {
    return static_cast<std::size_t>(row - window_.top) * static_cast<std::size_t>(window_.width()) +
           static_cast<std::size_t>(column - window_.left);
  }
  [[nodiscard]] Eigen::Vector2d centre(std::int64_t column, std::int64_t row) const {
    return grid_.enu_from_cells(
        {static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5});
  }

  TakeCells put(ClassId id) {
    return [this, id](std::int64_t row, std::int64_t from, std::int64_t to) {
      std::fill(labels_ + index(from, row), labels_ + index(from, row) + (to - from), id);
      if (levels_.empty()) return;
      const auto first = levels_.begin() + static_cast<std::ptrdiff_t>(index(from, row));
      std::fill(first, first + (to - from), level_);
    };
  }

  void draw_line(const Ring& line, double width, const CellRect& part, ClassId id) {
    fill_stroke(line, false, width / 2.0, part, put(id));
    if (width < 1.0 || path_length(line) < 1.0) fill_path(line, false, part, put(id));
  }

  void draw_outline(const std::vector<Ring>& rings,
                    double thickness,
                    const CellRect& part,
                    ClassId id) {
    // With a cell more on every side, for whether a cell is at the edge is told by its neighbours.
    const CellRect wider{part.left - 1, part.top - 1, part.right + 1, part.bottom + 1};
    Raster<std::uint8_t> inside(static_cast<int>(wider.width()), static_cast<int>(wider.height()),
                                0);
    const auto at = [&](std::int64_t column, std::int64_t row) -> std::uint8_t& {
      return inside.at(static_cast<int>(column - wider.left), static_cast<int>(row - wider.top));
    };
    fill_rings(rings, wider, [&](std::int64_t row, std::int64_t from, std::int64_t to) {
      for (std::int64_t column = from; column < to; ++column) at(column, row) = 1;
    });
    const TakeCells put_class = put(id);
    const TakeCells put_nothing = put(kUnclassified);
    for (std::int64_t row = part.top; row < part.bottom; ++row) {
      for (std::int64_t column = part.left; column < part.right; ++column) {
        if (at(column, row) == 0) continue;
        const bool is_at_edge = at(column - 1, row) == 0 || at(column + 1, row) == 0 ||
                                at(column, row - 1) == 0 || at(column, row + 1) == 0;
        (is_at_edge ? put_class : put_nothing)(row, column, column + 1);
      }
    }
    for (const Ring& ring : rings) {
      fill_stroke(ring, true, thickness, part,
                  [&](std::int64_t row, std::int64_t from, std::int64_t to) {
                    for (std::int64_t column = from; column < to; ++column) {
                      if (at(column, row) != 0) put_class(row, column, column + 1);
                    }
                  });
    }
    if (mean_width(rings) >= 1.0) return;
    for (const Ring& ring : rings) fill_path(ring, true, part, put_class);
  }

  const LabelGrid& grid_;
  CellRect window_;
  ClassId* labels_;
  std::vector<std::int8_t> levels_;  ///< Of what was drawn last in a cell; empty where nobody asks.
  std::int8_t level_ = 0;
};

/// Cells of a tile's grid that are not the same before and after.
CellRect changed_paint(const TileChange& change) {
  const auto is_same = [&](int column, int row) {
    const auto value = [&](const std::shared_ptr<const PaintTile>& tile) {
      return tile != nullptr ? tile->at(column, row) : kNoPaint;
    };
    return value(change.tile.before) == value(change.tile.after);
  };
  CellRect changed;
  for (int row = 0; row < kPaintTileSide; ++row) {
    int left = 0;
    int right = kPaintTileSide;
    while (left < right && is_same(left, row)) ++left;
    while (left < right && is_same(right - 1, row)) --right;
    changed = changed.joined({left, row, right, row + 1});
  }
  const std::int64_t column_of_tile = std::int64_t{change.address.column} * kPaintTileSide;
  const std::int64_t row_of_tile = std::int64_t{change.address.row} * kPaintTileSide;
  return {changed.left + column_of_tile, changed.top + row_of_tile, changed.right + column_of_tile,
          changed.bottom + row_of_tile};
}

}  // namespace

Raster<ClassId> rasterise(const LabelDocument& document,
                          const LabelGrid& grid,
                          const CellRect& window) {
  constexpr std::int64_t kMostSide = std::numeric_limits<int>::max();
  NADIR_REQUIRE(grid.metres_per_cell > 0.0);
  NADIR_REQUIRE(window.width() <= kMostSide && window.height() <= kMostSide);
  Raster<ClassId> labels(static_cast<int>(window.width()), static_cast<int>(window.height()),
                         kUnclassified);
  if (window.empty()) return labels;
  const std::vector<const PlacedObject*> objects = objects_in(document, grid, window);
  parallel_for(static_cast<std::size_t>(window.height()), kRowsAtOnce,
               [&](std::size_t begin, std::size_t end) {
                 const CellRect rows{window.left, window.top + static_cast<std::int64_t>(begin),
                                     window.right, window.top + static_cast<std::int64_t>(end)};
                 Band band(grid, rows, !document.paint().empty(),
                           labels.row(static_cast<int>(begin)).data());
                 for (const PlacedObject* object : objects) band.draw(*object);
                 if (!document.paint().empty()) band.draw_paint(document);
               });
  return labels;
}

Raster<ClassId> rasterise(const LabelDocument& document) {
  return rasterise(document, document.grid(), document.grid().whole());
}

CellRect changed_cells(const LabelEdit& edit, const LabelGrid& of_document, const LabelGrid& grid) {
  CellRect changed;
  for (const ObjectChange& change : edit.objects) {
    for (const auto& object : {change.before, change.after}) {
      if (object != nullptr) changed = changed.joined(grid.cells_of(drawn_bounds(*object), 1));
    }
  }
  for (const TileChange& change : edit.tiles) {
    const CellRect cells = changed_paint(change);
    if (cells.empty()) continue;
    PlaneBounds bounds;
    bounds.include(of_document.enu_from_cells(
        {static_cast<double>(cells.left), static_cast<double>(cells.top)}));
    bounds.include(of_document.enu_from_cells(
        {static_cast<double>(cells.right), static_cast<double>(cells.bottom)}));
    changed = changed.joined(grid.cells_of(bounds, 1));
  }
  return changed;
}

}  // namespace nadir
