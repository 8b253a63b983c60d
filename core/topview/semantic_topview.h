// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/field.h"
#include "core/base/raster.h"
#include "core/base/result.h"
#include "core/map/semantic_classes.h"
#include "core/topview/semantic_cloud.h"

namespace nadir {

/// One occupied square of a topview. Its centre lies (forward + 0.5, left + 0.5) cells from the
/// body, on `level`.
struct TopviewCell {
  std::int16_t forward = 0;
  std::int16_t left = 0;
  friend bool operator==(const TopviewCell&, const TopviewCell&) = default;
};

/// Cells between the body and the farthest cell of a topview, at most.
inline constexpr int kMaxTopviewReachCells = 4'000;

/// The ground as the vehicle sees it, from above: occupied cells grouped by class (thesis 3.4: K
/// point sets and their union).
struct SemanticTopview {
  double metres_per_cell = 0.1;
  std::vector<TopviewCell>
      cells;  ///< Class 0 first, then class 1, and so on; inside a class by forward, then left.
  std::array<std::uint32_t, kClassCount + 1>
      class_begin{};  ///< Cells of class k: [class_begin[k], class_begin[k + 1]).

  [[nodiscard]] std::span<const TopviewCell> of_class(ClassId id) const {
    return std::span(cells).subspan(class_begin[id], class_begin[id + 1U] - class_begin[id]);
  }
  friend bool operator==(const SemanticTopview&, const SemanticTopview&) = default;
};

/// How a labelled cloud is collapsed onto the ground.
struct TopviewOptions {
  int min_votes = 1;  ///< The thesis's beta: 1 in simulation, 5 for real flights.
  double max_range_m =
      20.0;  ///< Horizontal distance from the body beyond which points are left out.
  double lane_marking_vote =
      1.0;  ///< Votes of a lane-marking point: thin and worn, so the real flight counted it more.
  double curb_vote = 1.0;  ///< Votes of a curb point.
};

template <typename Options, typename Visitor>
requires std::same_as<std::remove_const_t<Options>, TopviewOptions>
void visit_fields(Options& options, Visitor&& visit) {
  visit(options.min_votes,
        Field{"min-votes", "", "Votes that a cell needs to take a class (beta)", 1, 1000});
  visit(options.max_range_m,
        Field{"max-range", "m", "Points farther from the vehicle are left out", 0.5, 200});
  visit(options.lane_marking_vote,
        Field{"lane-marking-vote", "", "Votes of one lane-marking point", 0, 100});
  visit(options.curb_vote, Field{"curb-vote", "", "Votes of one curb point", 0, 100});
}

/// Collapses a labelled cloud onto the ground plane: the map patch that the vehicle sees from
/// above.
///
/// The cell takes the class with the most votes if that class has at least `min_votes`, else it
/// stays undefined; equal votes go to the smaller class id. Points of classes that no overhead can
/// hold (sky, unclassified) do not vote.
///
/// @param cloud            Points in `level` (x forward, y left, z up), metres; z is ignored.
/// @param metres_per_cell  The overhead's resolution.
/// @errors kInvalidOptions. An empty cloud gives an empty topview, which is not an error.
/// See Rouben, MIT MEng thesis 2018, section 3.4.
[[nodiscard]] Result<SemanticTopview> build_semantic_topview(const SemanticCloud& cloud,
                                                             double metres_per_cell,
                                                             const TopviewOptions& options = {});

/// The topview as a picture: row 0 farthest ahead, column 0 leftmost, kUnclassified where nothing
/// was seen.
struct TopviewRaster {
  Raster<ClassId> labels;
  int body_column =
      0;  ///< The body is at the lower right corner of cells (body_column - 1, body_row - 1),
  int body_row = 0;  ///< so a cell `forward, left` is at column body_column - 1 - left, row
                     ///< body_row - 1 - forward.
};
[[nodiscard]] TopviewRaster topview_raster(const SemanticTopview& topview);
/// Groups the labelled cells of a picture again; the inverse of topview_raster.
[[nodiscard]] SemanticTopview topview_from_raster(const TopviewRaster& raster,
                                                  double metres_per_cell);

}  // namespace nadir
