// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <concepts>
#include <vector>

#include "core/base/field.h"
#include "core/base/progress.h"
#include "core/label/label_grid.h"
#include "core/map/map_index.h"
#include "core/mcl/cell_agreement.h"
#include "core/run/run_file.h"
#include "core/topview/semantic_reconstruction.h"

namespace nadir {

/// Where topviews are laid: at what the run said, or at what is true.
enum class FlightPose { kEstimate, kTruth };

template <>
struct EnumNames<FlightPose> {
  static constexpr std::array<std::string_view, 2> kNames = {"estimate", "truth"};
};

/// How a step's topview agrees with labels. Which of its cells do says cell_agreement() at the same pose.
struct StepAgreement {
  int step = 0;
  double time_s = 0.0;  ///< As RunStep::time_s.
  Rigid2 enu_from_body;
  std::array<CellAgreement::Count, kClassCount> of_class;  ///< By the class that was seen.
  CellAgreement::Count total;
};

/// What flights saw of the ground of a map: votes for classes on the map's own cells, whatever its labels say.
class FlightVotes {
 public:
  /// @param map  Gives the cells; its labels are not read.
  explicit FlightVotes(const OverheadMap& map);

  /// One vote a topview cell. A pose that is not finite, or beyond reach of any map, adds nothing. O(cells).
  void add(const SemanticTopview& seen, const Rigid2& enu_from_body);

  /// Calls `visit(column, row, votes)` for each cell of the map that has votes, in a fixed order.
  void visit(
      const std::function<
          void(int column, int row, const SemanticReconstruction::CellVotes& votes)>& visit) const;

 private:
  LabelGrid grid_;
  SemanticReconstruction votes_;  ///< On a plane whose origin is the map's north-western corner.
};

/// A flight laid on labels.
struct FlightBeneath {
  std::vector<StepAgreement> steps;  ///< Of those with a topview and the pose that is asked for.
  std::array<CellAgreement::Count, kClassCount> of_class;  ///< Over all steps.
  FlightVotes votes;
};

/// Lays every recorded topview of a run on labels. Memory goes with the ground that was seen.
/// @param labels  May be others than those that the run was made on.
/// @errors kInvalidOptions: no step has a topview and such a pose; topviews of other cells than the labels', kCancelled; as RunReader.
[[nodiscard]] Result<FlightBeneath> flight_beneath(const RunReader& run,
                                                   const OverheadMap& labels,
                                                   FlightPose pose,
                                                   const WorkContext& context = {});

/// When flights contradict labels.
struct ContradictionRule {
  int least_votes = 3;
  double least_share = 0.6;
  double tolerance_m = 0.4;
  double least_area_m2 = 0.5;
};

template <typename Options, typename Visitor>
requires std::same_as<std::remove_const_t<Options>, ContradictionRule>
void visit_fields(Options& options, Visitor&& visit) {
  visit(options.least_votes,
        Field{"least-votes", "", "Fewer topviews of a cell say nothing", 1, 65'535});
  visit(options.least_share,
        Field{"least-share", "", "Share of a cell's votes that have to say the same", 0, 1});
  visit(options.tolerance_m,
        Field{"tolerance", "m", "A class that is labelled so near was seen there", 0, 3});
  visit(options.least_area_m2, Field{"least-area", "m^2", "Smaller places are left out", 0, 1e6});
}

/// A connected place where flights saw one class and the labels say another.
struct ContradictedPlace {
  ClassId seen = 0,
          labelled = 0;  ///< `labelled` may be kUnclassified: nobody has labelled what is there.
  CellRect cells;        ///< Of the map: the smallest rectangle around it.
  Eigen::Vector2d middle_in_enu_m =
      Eigen::Vector2d::Zero();  ///< Mean of its cells; may lie beside it.
  double area_m2 = 0.0;
  double mean_share = 0.0;  ///< Of votes for `seen`, mean over its cells.
  double mean_votes = 0.0;  ///< Of all classes.
};

struct Contradictions {
  Raster<ClassId>
      seen;  ///< As large as the map: what flights say where they contradict it, else kUnclassified.
  std::vector<ContradictedPlace> places;  ///< By falling area times share.
};

/// Where flights say one class consistently and the labels say another.
///
/// A cell is contradicted where it has `least_votes` or more, one class has `least_share` of them, and the map has no cell of that class
/// within `tolerance_m`, for estimates and borders of images are never exact. Things that move contradict nothing, and neither do they
/// count among the votes. Neighbouring cells (8) of one pair of classes are a place. O(cells of the map).
/// @param labels  Of the votes' cells. @errors kInvalidOptions: the rule.
[[nodiscard]] Result<Contradictions> find_contradictions(const FlightVotes& votes,
                                                         const MapIndex& labels,
                                                         const ContradictionRule& rule = {});

}  // namespace nadir
