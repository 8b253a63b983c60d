// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "core/session/run_document.h"
#include "widgets/views/map_overlays.h"

namespace nadir {

/// Positions of a run's steps, metres in enu; NaN where a pose is not known. Made once a document, for steps are large and a
/// frame has no time to walk through them.
struct RunPaths {
  std::shared_ptr<const RunDocument> document;
  std::vector<Eigen::Vector2d> truth, odometry, estimate;
  [[nodiscard]] static RunPaths of(const std::shared_ptr<const RunDocument>& document);
};

/// Paths of the runs that are shown; those of other runs are dropped.
class RunPathsCache {
 public:
  /// @param document  Not null. The reference is valid until the next call of keep_only().
  const RunPaths& of(const std::shared_ptr<const RunDocument>& document);
  void keep_only(std::span<const std::shared_ptr<const RunDocument>> documents);
  [[nodiscard]] std::size_t size() const { return paths_.size(); }

 private:
  std::vector<std::unique_ptr<RunPaths>> paths_;
};

using ScreenPath = std::vector<Eigen::Vector2d>;

/// A polyline in enu as the pieces of it that a page shows, in pixels: broken at points that are not finite and where it
/// leaves the page; points that lie within a third of a pixel of the line between others are left out. O(n), and few
/// points come out, however many go in.
[[nodiscard]] std::vector<ScreenPath> screen_paths(std::span<const Eigen::Vector2d> points_in_enu_m,
                                                   const MapCamera& camera,
                                                   const PageRect& where);

/// Strokes pieces with their casing; a look without casing is one line.
void stroke_paths(Canvas& canvas,
                  std::span<const ScreenPath> paths,
                  const PathLook& look,
                  double px_per_pt);

}  // namespace nadir
