// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "core/session/moment_surface.h"
#include "widgets/canvas/canvas.h"

namespace nadir {

/// Pixels of the picture for a sample of the surface, each way.
inline constexpr int kSurfaceScale = 4;

/// The x-y cut of an error surface as a picture, north up: low costs are light (viridis), and particles lie on it as white
/// dots that grow denser with their weight.
/// @param values     MomentSurface::plane or best_turn.
/// @param particles  May be null.
[[nodiscard]] Raster<Rgba> surface_picture(const MomentSurface& surface,
                                           std::span<const float> values,
                                           const ParticleSet* particles);

/// Where a place of the grid lies on a picture of the surface that fills a rectangle.
[[nodiscard]] Eigen::Vector2d surface_point(const MomentSurface& surface,
                                            const GridPlace& place,
                                            const PageRect& where);
/// The inverse for the plane: x and y in samples.
[[nodiscard]] GridPlace surface_place(const MomentSurface& surface,
                                      const Eigen::Vector2d& on_page,
                                      const PageRect& where);

/// Least and greatest of some costs; {0, 1} for none.
struct CostRange {
  float least = 0.0F, most = 1.0F;
  /// 1 for the least cost, 0 for the greatest: how light it is.
  [[nodiscard]] double goodness(float cost) const;
};
[[nodiscard]] CostRange cost_range(std::span<const float> values);

}  // namespace nadir
