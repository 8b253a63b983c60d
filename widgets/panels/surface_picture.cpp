// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/surface_picture.h"

#include <algorithm>
#include <cmath>

#include "widgets/views/theme.h"

namespace nadir {

double CostRange::goodness(float cost) const {
  if (!(most > least)) return 1.0;
  return 1.0 - static_cast<double>(cost - least) / static_cast<double>(most - least);
}

CostRange cost_range(std::span<const float> values) {
  if (values.empty()) return {};
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return {*least, *most};
}

Eigen::Vector2d surface_point(const MomentSurface& surface,
                              const GridPlace& place,
                              const PageRect& where) {
  const ErrorSurfaceGrid& grid = surface.volume.grid;
  return {where.left + (place.x + 0.5) / grid.count_x * where.width,
          where.bottom + (place.y + 0.5) / grid.count_y * where.height};
}

GridPlace surface_place(const MomentSurface& surface,
                        const Eigen::Vector2d& on_page,
                        const PageRect& where) {
  const ErrorSurfaceGrid& grid = surface.volume.grid;
  return {(on_page.x() - where.left) / where.width * grid.count_x - 0.5,
          (on_page.y() - where.bottom) / where.height * grid.count_y - 0.5, 0.0};
}

Raster<Rgba> surface_picture(const MomentSurface& surface,
                             std::span<const float> values,
                             const ParticleSet* particles) {
  const ErrorSurfaceGrid& grid = surface.volume.grid;
  const int width = grid.count_x * kSurfaceScale;
  const int height = grid.count_y * kSurfaceScale;
  Raster<Rgba> picture(width, height);
  const CostRange range = cost_range(values);
  for (int row = 0; row < height; ++row) {
    const int y = grid.count_y - 1 - row / kSurfaceScale;
    for (int column = 0; column < width; ++column) {
      const auto index = static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.count_x) +
                         static_cast<std::size_t>(column / kSurfaceScale);
      picture.at(column, row) = value_colour(ValueColours::kViridis, range.goodness(values[index]));
    }
  }
  if (particles == nullptr || particles->empty()) return picture;
  // Weight that falls on each pixel, so that thousands of particles still show where they are densest.
  Raster<float> weight(width, height, 0.0F);
  for (std::size_t i = 0; i < particles->size(); ++i) {
    const Eigen::Vector2d at = surface_point(surface, surface.place_of(particles->pose(i)),
                                             {0.0, 0.0, double(width), double(height)});
    if (!at.allFinite()) continue;
    const auto column = static_cast<int>(std::floor(at.x()));
    const int row = height - 1 - static_cast<int>(std::floor(at.y()));
    if (weight.contains(column, row))
      weight.at(column, row) += static_cast<float>(particles->weight[i]);
  }
  const double mean = 1.0 / static_cast<double>(particles->size());
  for (std::size_t i = 0; i < weight.size(); ++i) {
    if (!(weight.values()[i] > 0.0F)) continue;
    const double share = std::clamp(0.35 + 0.25 * weight.values()[i] / mean, 0.0, 0.9);
    Rgba& pixel = picture.values()[i];
    const auto lighter = [share](std::uint8_t channel) {
      return static_cast<std::uint8_t>(std::lround(channel + (255 - channel) * share));
    };
    pixel = {lighter(pixel.red), lighter(pixel.green), lighter(pixel.blue)};
  }
  return picture;
}

}  // namespace nadir
