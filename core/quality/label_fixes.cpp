// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "core/edit/edge_tree.h"
#include "core/edit/edit_builder.h"
#include "core/edit/edit_objects.h"
#include "core/edit/edit_vertices.h"
#include "core/edit/polygon_algebra.h"
#include "core/label/edit_paint.h"
#include "core/label/label_raster.h"
#include "core/quality/check_parts.h"

namespace nadir {
namespace {

/// More neighbours than these are not joined at a gap: it is closed by paint.
constexpr std::size_t kMostJoined = 8;

tl::unexpected<Error> gone(const Finding& finding) {
  return fail(ErrorCode::kInvalidOptions, "{}: the labels have changed since", finding.sentence);
}

/// The cells of a finding as they are now.
struct FoundCells {
  RegionOfCells region;
  std::vector<CellRect> rows;
};

Result<FoundCells> found_cells(const LabelDocument& document,
                               const LabelGrid& grid,
                               const Finding& finding,
                               const CheckSettings& settings) {
  const Eigen::Vector2d place = grid.cells_from_enu(finding.place_in_enu_m);
  // Its corners lie on corners of cells, and may be rounded into the next one.
  PlaneBounds inner = finding.bounds;
  inner.grow(-0.25 * grid.metres_per_cell);
  const CellRect window = grid.cells_of(inner, 1).cut_to(grid.whole());
  const auto column = static_cast<std::int64_t>(std::floor(place.x()));
  const auto row = static_cast<std::int64_t>(std::floor(place.y()));
  if (CellRect{column, row, column + 1, row + 1}.cut_to(window).empty()) return gone(finding);
  const Raster<CellCode> codes = CellCoder(document, grid, settings).codes(window);
  const CellCode code =
      codes.at(static_cast<int>(column - window.left), static_cast<int>(row - window.top));
  const bool is_gap = finding.kind == FindingKind::kGap;
  if (code != (is_gap ? CellCode{kNarrowGround} : CellCode{finding.class_id})) return gone(finding);
  FoundCells found;
  found.rows = rows_of_region(codes.values(), window, column, row, joins_corners(code));
  RegionFinder finder(window, {column, row, column + 1, row + 1},
                      [](CellValue value) { return joins_corners(static_cast<CellCode>(value)); });
  for (int i = 0; i < codes.height(); ++i) finder.add_row(codes.row(i));
  for (RegionOfCells& region : finder.finish()) {
    if (region.is_touched) found.region = std::move(region);
  }
  if (found.region.bounds != grid.cells_of(inner, 0)) return gone(finding);
  return found;
}

std::vector<Ring> rings_of(const LabelGrid& grid, const std::vector<CellRect>& rows) {
  std::vector<Ring> rings;
  rings.reserve(rows.size());
  for (const CellRect& cells : rows) {
    const PlaneBounds box = bounds_of_cells(grid, cells);
    rings.push_back({box.low, {box.high.x(), box.low.y()}, box.high, {box.low.x(), box.high.y()}});
  }
  return rings;
}

/// Whether an edit labels all cells of a gap and changes no other.
bool fills_only(const LabelDocument& document,
                const LabelGrid& grid,
                const LabelEdit& edit,
                const std::vector<CellRect>& rows) {
  const CellRect window = changed_cells(edit, document.grid(), grid).cut_to(grid.whole());
  if (window.empty()) return false;
  LabelDocument after = document;
  after.apply(edit);
  const Raster<ClassId> was = rasterise(document, grid, window);
  Raster<ClassId> becomes = rasterise(after, grid, window);
  for (const CellRect& cells : rows) {
    if (!(cells.cut_to(window) == cells)) return false;
    for (std::int64_t column = cells.left; column < cells.right; ++column) {
      ClassId& id = becomes.at(static_cast<int>(column - window.left),
                               static_cast<int>(cells.top - window.top));
      if (id == kUnclassified) return false;
      id = kUnclassified;
    }
  }
  return was == becomes;
}

/// Closes a gap between areas by making one border of theirs; nothing where that changes anything else.
std::optional<LabelEdit> joined_at(const LabelDocument& document,
                                   const LabelGrid& grid,
                                   const Finding& finding,
                                   const std::vector<CellRect>& rows,
                                   double reach_m) {
  PlaneBounds around = finding.bounds;
  around.grow(reach_m);
  std::vector<ObjectId> areas;
  for (const auto& [id, placed] : document.objects()) {
    if (!do_meet(placed.bounds, around)) continue;
    if (placed.object->kind == ObjectKind::kArea) areas.push_back(id);
  }
  if (areas.size() < 2 || areas.size() > kMostJoined || reach_m < kLatticeM) return std::nullopt;
  auto edit = join_borders(document, areas, reach_m);
  if (!edit || !fills_only(document, grid, *edit, rows)) return std::nullopt;
  edit->title = "Close gap";
  return std::move(*edit);
}

Result<LabelEdit> painted(const LabelDocument& document,
                          const LabelGrid& grid,
                          const Finding& finding,
                          const CheckSettings& settings) {
  const auto found = found_cells(document, grid, finding, settings);
  if (!found) return forward_error(found);
  const ClassId around = class_around(found->region);
  if (around == kUnclassified) return gone(finding);
  const std::vector<Ring> rings = rings_of(grid, found->rows);
  if (finding.kind == FindingKind::kIsland) {
    return paint_rings(document, rings, static_cast<PaintValue>(around + kPaintOver),
                       fmt::format("Make island {}", class_info(around).name));
  }
  auto joined = joined_at(document, grid, finding, found->rows, settings.gap_width_m);
  if (joined) return std::move(*joined);
  return paint_rings(document, rings, around, "Close gap");
}

Result<LabelEdit> closed(const LabelDocument& document, const Finding& finding) {
  const auto line = document.object(finding.objects.front());
  if (line == nullptr || line->kind != ObjectKind::kLine) return gone(finding);
  EditBuilder builder(document, "Close outline");
  Ring& places = builder.change(line->id).rings.front();
  places.push_back(places.front());
  return builder.edit();
}

/// The ends of two lines that are nearest to each other become one place.
Result<LabelEdit> ends_joined(const LabelDocument& document, const Finding& finding) {
  const auto line = document.object(finding.objects[0]);
  const auto other = document.object(finding.objects[1]);
  if (line == nullptr || other == nullptr || line->kind != ObjectKind::kLine ||
      other->kind != ObjectKind::kLine) {
    return gone(finding);
  }
  EditBuilder builder(document, "Join ends");
  Ring& places = builder.change(line->id).rings.front();
  const Ring& others = other->rings.front();
  const auto distance = [&](bool is_first, bool is_others_first) {
    return ((is_first ? places.front() : places.back()) -
            (is_others_first ? others.front() : others.back()))
        .norm();
  };
  std::pair<bool, bool> nearest{true, true};
  for (const auto& [mine, theirs] : {std::pair{true, false}, {false, true}, {false, false}}) {
    if (distance(mine, theirs) < distance(nearest.first, nearest.second)) nearest = {mine, theirs};
  }
  (nearest.first ? places.front() : places.back()) =
      nearest.second ? others.front() : others.back();
  return builder.edit();
}

/// What an object that crosses itself surrounds, by odd and even, so that no cell changes.
Result<LabelEdit> untangled(const LabelDocument& document, const Finding& finding) {
  const auto object = document.object(finding.objects.front());
  if (object == nullptr) return gone(finding);
  auto region = region_of(*object);
  if (!region) return forward_error(region, named(*object));
  EditBuilder builder(document, "Untangle");
  builder.replace(object->id, std::move(region->parts));
  return builder.edit();
}

}  // namespace

Result<LabelEdit> fix(const LabelDocument& document,
                      const LabelGrid& grid,
                      const Finding& finding,
                      const CheckSettings& settings) {
  if (!finding.why_not_fix.empty()) {
    return fail(ErrorCode::kInvalidOptions, "{}: {}", finding.sentence, finding.why_not_fix);
  }
  for (const ObjectId id : finding.objects) {
    if (document.object(id) == nullptr) return gone(finding);
  }
  switch (finding.kind) {
    case FindingKind::kSelfCrossing:
      return untangled(document, finding);
    case FindingKind::kDegenerate:
    case FindingKind::kDuplicate:
      return remove(document, std::span(finding.objects).first(1));
    case FindingKind::kOpenOutline:
      return finding.objects.size() > 1 ? ends_joined(document, finding)
                                        : closed(document, finding);
    case FindingKind::kOverlap:
      return subtract(document, finding.objects[0], std::span(finding.objects).subspan(1, 1));
    case FindingKind::kGap:
    case FindingKind::kIsland:
      return painted(document, grid, finding, settings);
    case FindingKind::kFarOutside:
    case FindingKind::kStrayCurb:
    case FindingKind::kUnlabelled:
      break;
  }
  return fail(ErrorCode::kInvalidOptions, "{}: there is no one way to mend it", finding.sentence);
}

}  // namespace nadir
