// SPDX-License-Identifier: Apache-2.0
#include "core/insight/match_ground.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/base/require.h"

namespace nadir {
namespace {

CellRect whole_of(const OverheadMap& map) {
  return {0, 0, map.labels.width(), map.labels.height()};
}

CellRect grown(CellRect cells, std::int64_t by) {
  return {cells.left - by, cells.top - by, cells.right + by, cells.bottom + by};
}

/// A rectangle that lies on a map, as a map.
OverheadMap part_of(const OverheadMap& map, const CellRect& cells) {
  OverheadMap part{
      .name = map.name,
      .plane = map.plane,
      .metres_per_cell = map.metres_per_cell,
      .top_left_in_enu_m =
          map.enu_from_overhead({static_cast<double>(cells.left), static_cast<double>(cells.top)}),
      .labels = Raster<ClassId>(static_cast<int>(cells.width()), static_cast<int>(cells.height()))};
  for (int row = 0; row < part.labels.height(); ++row) {
    const auto from = map.labels.row(static_cast<int>(cells.top) + row);
    std::copy_n(from.begin() + cells.left, cells.width(), part.labels.row(row).begin());
  }
  return part;
}

}  // namespace

MatchGround::MatchGround(OverheadMap map, const LocaliserOptions& options, double weight_tolerance)
    : map_(std::move(map)),
      options_(options),
      weight_tolerance_(weight_tolerance),
      statistics_(class_statistics(map_.labels)) {
  take_weights();
}

Result<MatchGround> MatchGround::create(OverheadMap map,
                                        const LocaliserOptions& options,
                                        double weight_tolerance) {
  if (const auto valid = validate(options); !valid) return forward_error(valid);
  if (map.labels.empty() || map.labels.width() > kMaxMapSide || map.labels.height() > kMaxMapSide) {
    return fail(ErrorCode::kUnsupported,
                "map '{}': {} x {} cells, but 1 to {} on a side can be matched", map.name,
                map.labels.width(), map.labels.height(), kMaxMapSide);
  }
  return MatchGround(std::move(map), options, weight_tolerance);
}

double MatchGround::reach_m() const { return reach_cells() * map_.metres_per_cell; }

int MatchGround::reach_cells() const {
  if (options_.match == MatchKind::kClass) return 0;
  return static_cast<int>(std::ceil(options_.truncation_m / map_.metres_per_cell)) + 1;
}

bool MatchGround::redraw(const CellRect& cells, const Raster<ClassId>& labels) {
  NADIR_REQUIRE(labels.width() == cells.width() && labels.height() == cells.height());
  const CellRect inside = cells.cut_to(whole_of(map_));
  if (inside.empty()) return false;
  for (std::int64_t row = inside.top; row < inside.bottom; ++row) {
    const auto to = map_.labels.row(static_cast<int>(row));
    const auto from = labels.row(static_cast<int>(row - cells.top));
    for (std::int64_t column = inside.left; column < inside.right; ++column) {
      ClassId& label = to[static_cast<std::size_t>(column)];
      const ClassId now = from[static_cast<std::size_t>(column - cells.left)];
      if (label < kClassCount) {
        --statistics_.cells[label];
        --statistics_.classified_cells;
      }
      if (now < kClassCount) {
        ++statistics_.cells[now];
        ++statistics_.classified_cells;
      }
      label = now;
    }
  }
  if (are_weights_stale()) {
    take_weights();
    return true;
  }
  rebuild(grown(inside, reach_cells()).cut_to(whole_of(map_)));
  return false;
}

bool MatchGround::are_weights_stale() const {
  const ClassWeights now = importance_weights(statistics_, options_.alpha);
  for (std::size_t id = 0; id < now.size(); ++id) {
    if (std::abs(now[id] - weights_[id]) > weight_tolerance_ * weights_[id]) return true;
  }
  return false;
}

void MatchGround::take_weights() {
  weights_ = importance_weights(statistics_, options_.alpha);
  const CellRect whole = whole_of(map_);
  for (ClassId id = 0; id < kClassCount; ++id) {
    rasters_[id] = {};
    if (weights_[id] <= 0.0) continue;
    // The border stands for the ground off the map, and what loads may touch behind the end is never used.
    rasters_[id] = {map_.labels.width(), map_.labels.height(), {}};
    rasters_[id].values.assign(static_cast<std::size_t>(rasters_[id].stride()) *
                                       static_cast<std::size_t>(map_.labels.height() + 2) +
                                   3,
                               static_cast<std::uint8_t>(std::lround(options_.unknown_cost * 255)));
  }
  rebuild(whole);
}

void MatchGround::rebuild(const CellRect& cells) {
  const CellRect around = grown(cells, reach_cells()).cut_to(whole_of(map_));
  const MapIndex part(std::make_shared<const OverheadMap>(part_of(map_, around)));
  for (ClassId id = 0; id < kClassCount; ++id) {
    if (weights_[id] <= 0.0) continue;
    const CostRaster costs = class_cost_raster(part, id, options_);
    CostRaster& whole = rasters_[id];
    for (std::int64_t row = cells.top; row < cells.bottom; ++row) {
      const auto from = costs.values.begin() + (row - around.top + 1) * costs.stride() + 1 +
                        (cells.left - around.left);
      std::copy_n(from, cells.width(),
                  whole.values.begin() + (row + 1) * whole.stride() + 1 + cells.left);
    }
  }
}

}  // namespace nadir
