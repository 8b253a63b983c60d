// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

#include "core/edit/edge_tree.h"
#include "core/label/cell_fill.h"
#include "core/quality/check_parts.h"

namespace nadir {
namespace {

constexpr std::int64_t kTileSide = 512;
constexpr std::int64_t kStripOfOverlap = 256;

using Claimants = std::vector<const PlacedObject*>;
/// Numbers of two objects of a list, the lower one first.
using PairKey = std::uint64_t;

PairKey key_of(std::size_t lower, std::size_t upper) {
  return (static_cast<std::uint64_t>(lower) << 32U) | upper;
}

/// Areas that lie in one level, the lowest first.
std::map<std::int64_t, Claimants> areas_by_level(const CheckInput& input) {
  std::map<std::int64_t, Claimants> levels;
  for (const auto& [id, placed] : input.document.objects()) {
    const LabelObject& object = *placed.object;
    if (!is_closed(object.kind) || object.class_id == kUnclassified) continue;
    if (is_asked_for(input, placed.bounds)) levels[level_of_order(object.order)].push_back(&placed);
  }
  for (auto& [level, areas] : levels) {
    std::stable_sort(areas.begin(), areas.end(), [](const auto* a, const auto* b) {
      return a->object->order < b->object->order;
    });
  }
  return levels;
}

/// How many cells each pair has in common, of areas that lie on each other with no third between them.
class OverlapCounter {
 public:
  OverlapCounter(const CheckInput& input, const Claimants& areas) : input_(input), areas_(areas) {}

  /// @errors kCancelled.
  Result<std::vector<PairKey>> pairs_above(std::int64_t least_cells) {
    std::map<std::pair<std::int64_t, std::int64_t>, std::vector<std::size_t>> tiles;
    for (std::size_t i = 0; i < areas_.size(); ++i) {
      const CellRect cells = input_.grid.cells_of(areas_[i]->bounds, 0).cut_to(input_.grid.whole());
      if (cells.empty()) continue;
      for (std::int64_t row = cells.top / kTileSide; row <= (cells.bottom - 1) / kTileSide; ++row) {
        for (std::int64_t column = cells.left / kTileSide; column <= (cells.right - 1) / kTileSide;
             ++column) {
          tiles[{row, column}].push_back(i);
        }
      }
    }
    for (const auto& [tile, areas] : tiles) {
      if (input_.work.is_stopped()) return fail(ErrorCode::kCancelled, "the check was stopped");
      if (areas.size() > 1) count_in_tile(tile.first * kTileSide, tile.second * kTileSide, areas);
    }
    std::vector<PairKey> pairs;
    for (const auto& [pair, cells] : counts_) {
      if (cells >= least_cells) pairs.push_back(pair);
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

 private:
  void count_in_tile(std::int64_t top, std::int64_t left, const std::vector<std::size_t>& areas) {
    const CellRect tile =
        CellRect{left, top, left + kTileSide, top + kTileSide}.cut_to(input_.grid.whole());
    constexpr std::uint32_t kNobody = 0xFFFFFFFF;
    owners_.assign(static_cast<std::size_t>(tile.width() * tile.height()), kNobody);
    for (const std::size_t area : areas) {
      visit_claimed(*areas_[area]->object, input_.grid, tile,
                    [&](std::int64_t row, std::int64_t from, std::int64_t to) {
                      const auto begin =
                          static_cast<std::size_t>((row - top) * tile.width() + from - left);
                      claim(area, begin, begin + static_cast<std::size_t>(to - from));
                    });
    }
  }
  void claim(std::size_t area, std::size_t begin, std::size_t end) {
    while (begin < end) {
      const std::uint32_t owner = owners_[begin];
      std::size_t to = begin;
      while (to < end && owners_[to] == owner) owners_[to++] = static_cast<std::uint32_t>(area);
      if (owner < areas_.size() && owner != area) {
        counts_[key_of(owner, area)] += static_cast<std::int64_t>(to - begin);
      }
      begin = to;
    }
  }

  const CheckInput& input_;
  const Claimants& areas_;
  std::vector<std::uint32_t> owners_;
  std::unordered_map<PairKey, std::int64_t> counts_;
};

/// The cells that two objects both claim, as regions.
std::vector<RegionOfCells> common_regions(const CheckInput& input,
                                          const PlacedObject& a,
                                          const PlacedObject& b) {
  const CellRect window = input.grid.cells_of(a.bounds, 0)
                              .cut_to(input.grid.cells_of(b.bounds, 0))
                              .cut_to(input.grid.whole());
  RegionFinder finder(window, window, [](CellValue) { return true; });
  for (std::int64_t top = window.top; top < window.bottom; top += kStripOfOverlap) {
    const CellRect strip{window.left, top, window.right,
                         std::min(window.bottom, top + kStripOfOverlap)};
    Raster<std::uint8_t> claims(static_cast<int>(strip.width()), static_cast<int>(strip.height()));
    for (const PlacedObject* const one : {&a, &b}) {
      const std::uint8_t mark = one == &a ? 1 : 2;
      visit_claimed(*one->object, input.grid, strip,
                    [&](std::int64_t row, std::int64_t from, std::int64_t to) {
                      auto cells = claims.row(static_cast<int>(row - strip.top));
                      for (std::int64_t column = from; column < to; ++column) {
                        cells[static_cast<std::size_t>(column - strip.left)] |= mark;
                      }
                    });
    }
    for (int row = 0; row < claims.height(); ++row) {
      finder.add_row(std::span<const std::uint8_t>(claims.row(row)));
    }
  }
  std::vector<RegionOfCells> regions = finder.finish();
  std::erase_if(regions, [](const RegionOfCells& region) { return region.value != 3; });
  return regions;
}

void find_overlap(const CheckInput& input,
                  const PlacedObject& lower,
                  const PlacedObject& upper,
                  std::vector<Finding>& findings) {
  const double cell_m = input.grid.metres_per_cell;
  Finding finding;
  finding.kind = FindingKind::kOverlap;
  finding.severity = FindingSeverity::kDoubt;
  finding.class_id = lower.object->class_id;
  finding.objects = {lower.object->id, upper.object->id};
  finding.has_area = true;
  CellRect cells;
  std::int64_t most = 0;
  for (const RegionOfCells& region : common_regions(input, lower, upper)) {
    if (region.mean_width() * cell_m < input.settings.overlap_width_m) continue;
    finding.size += static_cast<double>(region.cells) * cell_m * cell_m;
    cells = cells.joined(region.bounds);
    if (region.cells <= most) continue;
    most = region.cells;
    finding.place_in_enu_m = centre_of_cell(input.grid, region.column, region.row);
  }
  if (most == 0 || finding.size < input.settings.overlap_m2) return;
  finding.bounds = bounds_of_cells(input.grid, cells);
  if (!is_asked_for(input, finding.bounds)) return;
  finding.sentence = fmt::format("{} and {} overlap by {} m2", named(*lower.object),
                                 named(*upper.object), size_text(finding.size));
  if (lower.object->kind != ObjectKind::kArea) {
    finding.why_not_fix = "which of the two walls stands there is seen in the image only";
  }
  findings.push_back(std::move(finding));
}

}  // namespace

void visit_claimed(const LabelObject& object,
                   const LabelGrid& grid,
                   const CellRect& window,
                   const std::function<void(std::int64_t, std::int64_t, std::int64_t)>& take) {
  std::vector<Ring> rings = object.rings;
  for (Ring& ring : rings) {
    for (Eigen::Vector2d& place : ring) place = grid.cells_from_enu(place);
  }
  fill_rings(rings, window, take);
}

Result<void> check_overlaps(const CheckInput& input, std::vector<Finding>& findings) {
  std::vector<std::pair<ObjectId, ObjectId>> same;  // Told already.
  for (const Finding& finding : findings) {
    if (finding.kind == FindingKind::kDuplicate) {
      same.emplace_back(finding.objects[0], finding.objects[1]);
    }
  }
  std::sort(same.begin(), same.end());
  const double cell_m2 = input.grid.metres_per_cell * input.grid.metres_per_cell;
  const auto least = static_cast<std::int64_t>(std::min(input.settings.overlap_m2 / cell_m2, 1e15));
  for (const auto& [level, areas] : areas_by_level(input)) {
    const auto pairs =
        OverlapCounter(input, areas).pairs_above(std::max<std::int64_t>(1, least / 2));
    if (!pairs) return forward_error(pairs);
    for (const PairKey pair : *pairs) {
      if (input.work.is_stopped()) return fail(ErrorCode::kCancelled, "the check was stopped");
      const PlacedObject& lower = *areas[pair >> 32U];
      const PlacedObject& upper = *areas[pair & 0xFFFFFFFFU];
      const auto ids = std::make_pair(lower.object->id, upper.object->id);
      if (std::binary_search(same.begin(), same.end(), ids)) continue;
      find_overlap(input, lower, upper, findings);
    }
  }
  return {};
}

}  // namespace nadir
