// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/insight/localisability.h"
#include "core/mcl/cost_rows.h"

namespace nadir::detail {

/// A view, and what it was made of: the labels in its fan, and the costs that cells up to `seen_reach_m` away met when they were
/// moved by at most `margin_m`.
struct MadeView {
  ViewInformation information;
  float seen_reach_m = 0.0F, margin_m = 0.0F;
};

/// Makes views of places that lie near each other: copies the costs around them once, so that a search for competitors reads many
/// poses at a time. Refers to what it is made of, which must outlive it. One thread at a time.
class ViewMatcher {
 public:
  /// @param places  Holds all places that look() is asked for.
  ViewMatcher(const MatchGround& ground,
              const ViewFootprint& footprint,
              const LocalisabilityOptions& options,
              const PlaneBounds& places);

  [[nodiscard]] MadeView look(const Rigid2& enu_from_body);

 private:
  /// A pose of the view's own heading, beside it by whole cells.
  struct Competitor {
    int east_cells = 0, south_cells = 0;
    double cost = 2.0;
  };

  [[nodiscard]] bool take_cells(const Rigid2& enu_from_body);
  [[nodiscard]] double seen_reach_m() const;
  [[nodiscard]] double cost_at(const Rigid2& enu_from_body) const;
  [[nodiscard]] double cost_of(const Competitor& competitor, const Rigid2& enu_from_body) const;
  [[nodiscard]] bool is_competitor(int east_cells, int south_cells) const {
    const double squared = 1.0 * east_cells * east_cells + 1.0 * south_cells * south_cells;
    return squared >= least_squared_cells_ && squared <= most_squared_cells_;
  }
  /// Fills costs_, row by row from the north, with those of all poses `step_cells_` apart.
  void cost_around(const Rigid2& enu_from_body);
  [[nodiscard]] double worst_competitor() const;
  [[nodiscard]] Competitor best_competitor(const Rigid2& enu_from_body) const;
  void set_ambiguity(ViewInformation& information, const Rigid2& enu_from_body, double scale) const;

  const MatchGround& ground_;
  const ViewFootprint& footprint_;
  const LocalisabilityOptions& options_;
  InstructionSet set_;
  int step_cells_ = 1, steps_ = 0;  ///< The search goes so many steps to every side.
  double least_squared_cells_ = 0.0, most_squared_cells_ = 0.0;  ///< Of competitors.
  std::vector<CostWindow> windows_;
  std::array<int, kClassCount> window_of_class_{};
  SeenCells seen_;
  MatchCells cells_;
  std::vector<double> costs_;
  std::vector<std::uint32_t> index_;
};

}  // namespace nadir::detail
