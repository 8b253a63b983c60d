// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <memory>

#include "core/mcl/cell_agreement.h"
#include "core/topview/semantic_reconstruction.h"
#include "widgets/figures/figure_run.h"
#include "widgets/figures/map_panel.h"
#include "widgets/views/raster_view.h"

namespace nadir {

/// The panels of figure 'reconstruction'.

/// How far poses lie from enu's origin and from each other, metres.
class PoseReach {
 public:
  /// Points that are not finite do not count.
  void include(const Eigen::Vector2d& point_in_enu_m);
  [[nodiscard]] double span_m() const;      ///< The longer side of the rectangle around them.
  [[nodiscard]] double farthest_m() const;  ///< From the origin, along east or north.

 private:
  Eigen::AlignedBox2d bounds_in_enu_m_;
};

/// Size of the cells that topviews at these poses are laid in: that of the topviews' own, or twice, four times ... as large
/// where the poses lie so far apart that those would be more than a graphics card and memory take. @param seen_cell_m  > 0.
[[nodiscard]] double reconstruction_cell_m(const PoseReach& reach, double seen_cell_m);

/// A map with what has been seen so far laid on it, at the poses of one source.
class ReconstructionSide {
 public:
  using ClassCounts = std::array<CellAgreement::Count, kClassCount>;

  ReconstructionSide(std::unique_ptr<MapPanel> map, Source source, double metres_per_cell);

  void clear();
  /// Lays a step's topview, where it has one and the source a pose. Cells of another size than the map's are not compared
  /// with it, and count as not known to it.
  /// @errors kUnsupported: the topviews reach farther than can be drawn; nothing is added.
  [[nodiscard]] Result<void> add(const RunStep& step, const OverheadMap& labels);
  /// Uploads what has been added. @errors as SemanticReconstruction::labels.
  [[nodiscard]] Result<void> refresh();

  [[nodiscard]] MapPanel& map() { return *map_; }
  [[nodiscard]] Source source() const { return source_; }
  [[nodiscard]] double metres_per_cell() const { return seen_.metres_per_cell(); }
  /// Of all cells of all topviews so far.
  [[nodiscard]] const ClassCounts& counts() const { return counts_; }

 private:
  std::unique_ptr<MapPanel> map_;  ///< Before the view, which lies in its scene.
  Source source_;
  PoseReach reach_;  ///< Of what has been added.
  SemanticReconstruction seen_;
  RasterView view_;
  ClassCounts counts_{};
  bool is_changed_ = false;
};

}  // namespace nadir
