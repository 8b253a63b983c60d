// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/map/map_index.h"
#include "core/mcl/cost_kernel.h"
#include "core/mcl/localiser_options.h"
#include "core/mcl/particle_set.h"

namespace nadir {

/// A topview made ready for matching: cells of the classes that the map holds, thinned evenly where
/// there are very many.
struct MatchCells {
  struct OfClass {
    ClassId id = 0;
    std::vector<HalfCell> cells;
    double weight_per_cell = 0.0;  ///< alpha_k times the cells that each kept one stands for.
  };
  std::vector<OfClass> classes;
  double total_weight = 0.0;  ///< Sum of weight_per_cell over all cells: the worst possible cost.
  double area_m2 = 0.0;       ///< Ground that the cells cover before thinning.

  [[nodiscard]] bool empty() const { return total_weight <= 0.0; }
};

/// What each cell of a map costs a topview cell of class `id`: the ground of every weight. Of a map's part it is that of the
/// whole, but within `truncation_m` of where the part was cut. O(cells), parallel.
[[nodiscard]] CostRaster class_cost_raster(const MapIndex& index,
                                           ClassId id,
                                           const LocaliserOptions& options);

/// Compares topviews with one map: the kernel behind weights, error surface and agreement.
/// Immutable after construction and safe to share between threads.
class MapMatcher {
 public:
  /// Makes one cost raster a class that the map holds; O(cells x classes), once.
  /// @errors kUnsupported: a side longer than kMaxMapSide; kMalformed: nothing to match with.
  [[nodiscard]] static Result<MapMatcher> create(std::shared_ptr<const MapIndex> index,
                                                 const LocaliserOptions& options,
                                                 InstructionSet set = best_instruction_set());

  [[nodiscard]] const OverheadMap& map() const { return index_->map(); }

  /// Drops what the map cannot answer (classes that it does not hold) and thins what is left.
  /// The topview must have the map's resolution.
  [[nodiscard]] MatchCells prepare(const SemanticTopview& seen) const;

  /// Mean cost in [0, 1] of the topview laid at a pose, weighted by alpha_k (thesis 3.5 as an
  /// error: mismatches count; divided by its greatest possible value, which no weight notices).
  [[nodiscard]] double mean_cost(const MatchCells& seen, const Rigid2& enu_from_body) const;

  /// What each class adds to mean_cost(); they sum to it.
  [[nodiscard]] std::array<double, kClassCount> class_costs(const MatchCells& seen,
                                                            const Rigid2& enu_from_body) const;

  /// mean_cost of every particle. O(particles x cells), parallel.
  [[nodiscard]] std::vector<double> mean_costs(const MatchCells& seen,
                                               const ParticleSet& particles) const;

  /// For kernels that evaluate many poses at once. @param id  Of a class that prepare() keeps.
  [[nodiscard]] const CostRaster& cost_raster(ClassId id) const { return rasters_[id]; }
  [[nodiscard]] InstructionSet instruction_set() const { return set_; }

 private:
  MapMatcher() = default;
  std::shared_ptr<const MapIndex> index_;
  std::array<double, kClassCount> alpha_{};
  std::array<CostRaster, kClassCount> rasters_;  ///< Empty for classes of weight 0.
  int max_cells_per_class_ = 0;
  InstructionSet set_ = InstructionSet::kPortable;
};

/// Multiplies weights by exp(log-likelihood) and normalises, in the log domain, so that nothing underflows.
///
/// kThesis: log-likelihood = -cost / (gamma0 max cost) (Algorithm 3). kTempered: -evidence cost / temperature, where the
/// temperature doubles until at least `min_effective_fraction` of the particles stays effective: one topview must not
/// decide between thousands of hypotheses.
/// Equal costs leave the weights as they are. @param evidence  in [0, 1]: how much of a full, fresh topview this one is.
void apply_likelihood(ParticleSet& particles,
                      const std::vector<double>& mean_costs,
                      double evidence,
                      const LocaliserOptions& options);

/// Share of topview cells on classified ground whose class is the map's there; nothing where no
/// cell is on such ground. See cell_agreement() for which cells and classes these are.
[[nodiscard]] std::optional<double> agreement(const SemanticTopview& seen,
                                              const OverheadMap& map,
                                              const Rigid2& enu_from_body);

}  // namespace nadir
