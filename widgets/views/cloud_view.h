// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>

#include "core/geo/rigid3.h"
#include "core/topview/semantic_cloud.h"
#include "widgets/views/space_scene.h"

namespace nadir {

/// Shows a labelled cloud in space, each point in the colour of its class. Owns its VTK pipeline; holds no core data after
/// show() returns.
class CloudView final : public SizedView {
 public:
  explicit CloudView(SpaceScene& scene);
  ~CloudView() override;  ///< Takes its prop out of the scene.
  CloudView(const CloudView&) = delete;
  CloudView& operator=(const CloudView&) = delete;

  /// Copies; call only when the points changed. Points that are not finite or have no class are left out.
  void show(const SemanticCloud& cloud);
  /// Moves the cloud without uploading it again.
  void place(const Rigid3& enu_from_level);
  void set_size_pt(double size_pt);  ///< Side of a point on the page, whatever its distance.
  void set_visible(bool visible);
  void set_px_per_pt(double px_per_pt) override;
  /// Of the last show().
  [[nodiscard]] std::size_t drawn_count() const { return drawn_; }

 private:
  SpaceScene& scene_;
  std::size_t drawn_ = 0;
  double size_pt_ = 1.2;
  double px_per_pt_ = 1.0;
  vtkNew<vtkPolyData> points_;
  vtkNew<vtkPolyDataMapper> mapper_;
  vtkNew<vtkActor> actor_;
};

}  // namespace nadir
