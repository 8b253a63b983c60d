// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>

#include <span>
#include <vector>

#include "widgets/views/space_scene.h"

namespace nadir {

/// A polyline in enu, metres. A point that is not finite breaks it.
using SpacePath = std::vector<Eigen::Vector3d>;

/// Shows lines in space, all of one colour and width. Owns its VTK pipeline.
class SpaceLines final : public SizedView {
 public:
  SpaceLines(SpaceScene& scene, SpaceLayer layer, Rgba colour, double width_pt);
  ~SpaceLines() override;  ///< Takes its prop out of the scene.
  SpaceLines(const SpaceLines&) = delete;
  SpaceLines& operator=(const SpaceLines&) = delete;

  void show(std::span<const SpacePath> paths_in_enu_m);
  void set_visible(bool visible);
  void set_px_per_pt(double px_per_pt) override;

 private:
  SpaceScene& scene_;
  double width_pt_;
  vtkNew<vtkPolyData> lines_;
  vtkNew<vtkPolyDataMapper> mapper_;
  vtkNew<vtkActor> actor_;
};

/// A path of the plane laid on the ground.
[[nodiscard]] SpacePath on_ground(std::span<const Eigen::Vector2d> points_in_enu_m);
/// A path cut into dashes, lengths in metres, > 0. A stretch of more than 100,000 dashes is left out; after it, as after a
/// break, the first dash begins anew.
[[nodiscard]] std::vector<SpacePath> dashes_of(const SpacePath& path, double dash_m, double gap_m);

}  // namespace nadir
