// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>

#include "core/base/raster.h"
#include "core/map/semantic_classes.h"
#include "core/session/run_document.h"
#include "core/session/view_state.h"

namespace nadir {

/// What has been seen so far, laid on the ground: the class with the most votes of each cell, north up. Never changes.
struct ReconstructedGround {
  Raster<ClassId> labels;
  Eigen::Vector2d top_left_in_enu_m = Eigen::Vector2d::Zero();  ///< Corner of cell (0, 0).
  double metres_per_cell = 0.1;
  std::size_t steps = 0;  ///< Of the run, from its first, that are in it.
};

/// Which reconstruction: all topviews of a run up to a step, at the poses of one source.
struct ReconstructionQuestion {
  std::shared_ptr<const RunDocument> run;  ///< Null: none.
  std::size_t last_step = 0;               ///< Index in its steps.
  PoseSource poses = PoseSource::kEstimate;
};

/// Reconstructs in a thread of its own, the newest question first; nobody waits. Going on in a run costs its new steps only,
/// going back those since a state that was kept on the way (at most 96 MiB of them). All calls from one thread.
class GroundReconstruction {
 public:
  GroundReconstruction();
  ~GroundReconstruction();
  GroundReconstruction(const GroundReconstruction&) = delete;
  GroundReconstruction& operator=(const GroundReconstruction&) = delete;

  /// The same question again costs nothing.
  void ask(const ReconstructionQuestion& question);
  /// The newest there is, perhaps of fewer steps, never of more; null before the first, and once another run or other poses
  /// are asked for.
  [[nodiscard]] std::shared_ptr<const ReconstructedGround> answer() const;
  [[nodiscard]] bool is_working() const;
  /// Why the last question has no answer, once; empty: nothing failed.
  [[nodiscard]] std::string take_error();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace nadir
