// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>

#include "core/mcl/particle_set.h"
#include "widgets/views/map_scene.h"

namespace nadir {

/// How a cloud of particles is drawn.
struct ParticleLook {
  double size_px = 3.0;
  double heading_m = 0.0;  ///< Length of the tick along each particle's heading; 0: none.
  std::size_t most_drawn =
      20'000;  ///< Of more, every k-th is drawn, so that a million draws as fast.
};

/// Shows a particle set on the map: viridis by weight, opacity falling with number, so that a dense cloud does not hide
/// the ground. Owns its VTK pipeline; holds no core data after show() returns.
class ParticleView {
 public:
  explicit ParticleView(MapScene& scene);
  ~ParticleView();  ///< Takes its props out of the scene.
  ParticleView(const ParticleView&) = delete;
  ParticleView& operator=(const ParticleView&) = delete;

  /// Copies; call only when the particles changed. Particles that are not finite are left out.
  void show(const ParticleSet& particles, const ParticleLook& look = {});
  void set_visible(bool visible);
  /// Of the last show().
  [[nodiscard]] std::size_t drawn_count() const { return drawn_; }

 private:
  MapScene& scene_;
  std::size_t drawn_ = 0;
  vtkNew<vtkPolyData> cloud_;
  vtkNew<vtkPolyDataMapper> mapper_;
  vtkNew<vtkActor> actor_;
};

}  // namespace nadir
