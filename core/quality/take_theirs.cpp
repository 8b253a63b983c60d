// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/edit/edge_tree.h"
#include "core/label/edit_paint.h"
#include "core/label/label_raster.h"
#include "core/quality/cell_regions.h"
#include "core/quality/check_parts.h"
#include "core/quality/label_agreement.h"

namespace nadir {
namespace {

/// More objects than these at a region are not tried one by one: it is painted.
constexpr std::size_t kMostTried = 64;

/// The cells of a region as they are now; none where it is not there any more.
std::vector<CellRect> rows_of(const LabelDocument& mine,
                              const LabelDocument& theirs,
                              const LabelGrid& grid,
                              const DisagreementRegion& region) {
  PlaneBounds inner = region.bounds;
  inner.grow(-0.25 * grid.metres_per_cell);
  const CellRect window = grid.cells_of(inner, 1).cut_to(grid.whole());
  const Eigen::Vector2d place = grid.cells_from_enu(region.place_in_enu_m);
  const auto column = static_cast<std::int64_t>(std::floor(place.x()));
  const auto row = static_cast<std::int64_t>(std::floor(place.y()));
  if (CellRect{column, row, column + 1, row + 1}.cut_to(window).empty()) return {};
  const Raster<ClassId> a = rasterise(mine, grid, window);
  const Raster<ClassId> b = rasterise(theirs, grid, window);
  std::vector<std::uint8_t> is_in(a.size());
  for (std::size_t i = 0; i < is_in.size(); ++i) {
    is_in[i] = a.values()[i] == region.mine && b.values()[i] == region.theirs ? 1 : 0;
  }
  if (is_in[static_cast<std::size_t>((row - window.top) * window.width() + column - window.left)] ==
      0) {
    return {};
  }
  std::vector<CellRect> rows = rows_of_region(is_in, window, column, row, false);
  CellRect bounds;
  std::int64_t cells = 0;
  for (const CellRect& one : rows) {
    bounds = bounds.joined(one);
    cells += one.width();
  }
  if (cells != region.cells || bounds != grid.cells_of(inner, 0)) rows.clear();
  return rows;
}

/// Whether an edit of mine makes all of some cells theirs, and no cell anything else than theirs.
bool makes_theirs(const LabelDocument& mine,
                  const LabelDocument& theirs,
                  const LabelGrid& grid,
                  const LabelEdit& edit,
                  const std::vector<CellRect>& rows) {
  if (edit.empty() || !mine.check(edit)) return false;
  const CellRect window = changed_cells(edit, mine.grid(), grid).cut_to(grid.whole());
  if (window.empty()) return false;
  LabelDocument after = mine;
  after.apply(edit);
  const Raster<ClassId> was = rasterise(mine, grid, window);
  const Raster<ClassId> is = rasterise(after, grid, window);
  const Raster<ClassId> wanted = rasterise(theirs, grid, window);
  for (std::size_t i = 0; i < is.size(); ++i) {
    if (is.values()[i] != was.values()[i] && is.values()[i] != wanted.values()[i]) return false;
  }
  return std::all_of(rows.begin(), rows.end(), [&](const CellRect& cells) {
    if (!(cells.cut_to(window) == cells)) return false;
    const int row = static_cast<int>(cells.top - window.top);
    const auto from = static_cast<std::size_t>(cells.left - window.left);
    const auto width = static_cast<std::size_t>(cells.width());
    const auto a = is.row(row).subspan(from, width);
    const auto b = wanted.row(row).subspan(from, width);
    return std::equal(a.begin(), a.end(), b.begin());
  });
}

LabelEdit edit_of(ObjectChange change) {
  return {.title = "Take theirs", .objects = {std::move(change)}, .tiles = {}, .values = {}};
}

/// Each way in which one object could become what it is in theirs.
std::vector<LabelEdit> object_edits(const LabelDocument& mine,
                                    const LabelDocument& theirs,
                                    const DisagreementRegion& region) {
  std::vector<LabelEdit> edits;
  for (const auto& [id, placed] : theirs.objects()) {
    if (!do_meet(placed.bounds, region.bounds)) continue;
    const auto own = mine.object(id);
    if (own != nullptr && *own == *placed.object) continue;
    if (own != nullptr) edits.push_back(edit_of({own, placed.object}));
    auto copy = std::make_shared<LabelObject>(*placed.object);
    if (own != nullptr) copy->id = std::max(mine.next_id(), theirs.next_id());
    edits.push_back(edit_of({nullptr, std::move(copy)}));
  }
  for (const auto& [id, placed] : mine.objects()) {
    if (!do_meet(placed.bounds, region.bounds)) continue;
    const auto other = theirs.object(id);
    if (other == nullptr || !(*other == *placed.object)) {
      edits.push_back(edit_of({placed.object, nullptr}));
    }
  }
  return edits;
}

}  // namespace

Result<LabelEdit> take_theirs(const LabelDocument& mine,
                              const LabelDocument& theirs,
                              const LabelGrid& grid,
                              const DisagreementRegion& region) {
  const std::vector<CellRect> rows = rows_of(mine, theirs, grid, region);
  if (rows.empty()) {
    return fail(ErrorCode::kInvalidOptions, "the labels have changed since they were compared");
  }
  std::vector<LabelEdit> objects = object_edits(mine, theirs, region);
  if (objects.size() <= kMostTried) {
    for (LabelEdit& edit : objects) {
      if (makes_theirs(mine, theirs, grid, edit, rows)) return std::move(edit);
    }
  }
  std::vector<Ring> rings;
  rings.reserve(rows.size());
  for (const CellRect& cells : rows) {
    const PlaneBounds box = bounds_of_cells(grid, cells);
    rings.push_back({box.low, {box.high.x(), box.low.y()}, box.high, {box.low.x(), box.high.y()}});
  }
  const bool is_class = region.theirs != kUnclassified;
  const PaintValue in_level = region.theirs;
  const PaintValue over =
      is_class ? static_cast<PaintValue>(region.theirs + kPaintOver) : PaintValue{kUnclassified};
  // Erasing, and paint that keeps what lies above it, leave less behind.
  for (const PaintValue value : {kNoPaint, in_level}) {
    LabelEdit edit = paint_rings(mine, rings, value, "Take theirs");
    if (makes_theirs(mine, theirs, grid, edit, rows)) return edit;
  }
  return paint_rings(mine, rings, over, "Take theirs");
}

}  // namespace nadir
