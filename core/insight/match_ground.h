// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "core/label/label_document.h"
#include "core/map/class_statistics.h"
#include "core/mcl/measurement_model.h"

namespace nadir {

/// A map as the filter's error sees it, which can be drawn anew in places: labels, weight of each class and what each cell costs
/// a topview cell of each class. What MapMatcher is for a map that stays, with the same numbers.
///
/// The weights alpha_k depend on the whole map, so that any edit changes all of them a little. They stay as they are until
/// one is off by more than `weight_tolerance` of itself; then all are taken anew.
class MatchGround {
 public:
  /// A map without classes is allowed. O(cells x classes), parallel.
  /// @errors kUnsupported: a side longer than kMaxMapSide; kInvalidOptions: those of the options; a truncation that distances
  /// do not reach.
  [[nodiscard]] static Result<MatchGround> create(OverheadMap map,
                                                  const LocaliserOptions& options,
                                                  double weight_tolerance);

  /// Takes over what a rectangle of the map says now. O(cells of the rectangle and as far around as the truncation reaches).
  /// @param cells   Of the map; what lies outside of it is passed over.
  /// @param labels  As large as `cells`.
  /// @returns       Whether the weights were taken anew, so that costs have changed everywhere.
  bool redraw(const CellRect& cells, const Raster<ClassId>& labels);

  [[nodiscard]] const OverheadMap& map() const { return map_; }
  [[nodiscard]] const LocaliserOptions& options() const { return options_; }
  [[nodiscard]] const ClassWeights& weights() const { return weights_; }
  /// Of a class whose weight is above 0.
  [[nodiscard]] const CostRaster& cost_raster(ClassId id) const { return rasters_[id]; }
  /// A redrawn rectangle changes costs so far around it, at most.
  [[nodiscard]] double reach_m() const;

 private:
  MatchGround(OverheadMap map, const LocaliserOptions& options, double weight_tolerance);
  [[nodiscard]] int reach_cells() const;
  [[nodiscard]] bool are_weights_stale() const;
  void take_weights();
  /// Costs of a rectangle of the map from its labels and those around it.
  void rebuild(const CellRect& cells);

  OverheadMap map_;
  LocaliserOptions options_;
  double weight_tolerance_;
  ClassStatistics statistics_;
  ClassWeights weights_{};
  std::array<CostRaster, kClassCount> rasters_;
};

}  // namespace nadir
