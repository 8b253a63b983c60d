// SPDX-License-Identifier: Apache-2.0
#include "core/sim/camera_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/base/require.h"
#include "core/sim/column_ray.h"

namespace nadir {
namespace {

constexpr std::size_t kRowsAtOnce = 16;

/// A solid and the pixels [first, last) in which it may show.
struct Sprite {
  Solid solid;
  int first_column, last_column, first_row, last_row;
};

struct Bounds {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  /// Pixels whose centres may lie inside, cut to [0, size).
  [[nodiscard]] std::array<int, 2> pixels(int size) const {
    const double first = std::clamp(std::floor(low), 0.0, static_cast<double>(size));
    const double last = std::clamp(std::ceil(high) + 1.0, 0.0, static_cast<double>(size));
    return {static_cast<int>(first), static_cast<int>(last)};
  }
};

/// Projects the corners of the solid's upright bounding box. False where it is out of sight.
bool find_sprite(const Solid& solid,
                 const CameraModel& camera,
                 const Rigid3& enu_from_camera,
                 Sprite& sprite) {
  constexpr double kNearestM = 0.1;
  const Eigen::Vector2d offset =
      solid.centre_in_enu_m.head<2>() - enu_from_camera.translation_m.head<2>();
  const double radius_m = solid.footprint_radius_m();
  if (offset.norm() > 1.5 * kFarthestLabelM + radius_m) return false;
  const Rigid3 camera_from_enu = enu_from_camera.inverse();
  Bounds columns, rows;
  int in_front = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d sides((corner & 1) != 0 ? radius_m : -radius_m,
                                (corner & 2) != 0 ? radius_m : -radius_m,
                                (corner & 4) != 0 ? solid.half_size_m.z() : -solid.half_size_m.z());
    const Eigen::Vector3d in_camera = camera_from_enu * (solid.centre_in_enu_m + sides);
    if (in_camera.z() < kNearestM) continue;
    ++in_front;
    const Eigen::Vector2d pixel = camera.project(in_camera);
    columns.add(pixel.x());
    rows.add(pixel.y());
  }
  if (in_front == 0) return false;
  sprite = {solid, 0, camera.width, 0, camera.height};
  if (in_front == 8) {
    const auto [first_column, last_column] = columns.pixels(camera.width);
    const auto [first_row, last_row] = rows.pixels(camera.height);
    sprite = {solid, first_column, last_column, first_row, last_row};
  }
  return sprite.first_column < sprite.last_column && sprite.first_row < sprite.last_row;
}

std::vector<Sprite> visible_sprites(const World& world,
                                    const CameraModel& camera,
                                    const Rigid3& enu_from_camera,
                                    double time_s) {
  std::vector<Sprite> sprites;
  Sprite sprite{};
  for (const Solid& solid : world.solids_at(time_s)) {
    if (find_sprite(solid, camera, enu_from_camera, sprite)) sprites.push_back(sprite);
  }
  return sprites;
}

/// Everything that the rows share.
struct View {
  const World& world;
  const CameraModel& camera;
  Eigen::Vector3d centre_in_enu_m;
  Eigen::Matrix3d enu_from_camera;
  std::vector<Sprite> sprites;

  [[nodiscard]] Eigen::Vector3d direction(int column, int row) const {
    return enu_from_camera * camera.ray({column + 0.5, row + 0.5});
  }

  void draw_row(int row,
                std::vector<double>& depth_m,
                std::span<ClassId> labels,
                std::span<std::int32_t> solids) const {
    const double cells_per_metre = 1.0 / world.map.metres_per_cell;
    ColumnRay ray{.start = world.map.overhead_from_enu(centre_in_enu_m.head<2>()),
                  .rate = Eigen::Vector2d::Zero(),
                  .z_m = centre_in_enu_m.z()};
    for (int column = 0; column < camera.width; ++column) {
      const Eigen::Vector3d along = direction(column, row);
      ray.rate = {along.x() * cells_per_metre, -along.y() * cells_per_metre};
      ray.z_rate_m = along.z();
      const ColumnHit hit = trace_columns(world, ray, kFarthestLabelM);
      depth_m[static_cast<std::size_t>(column)] = hit.t;
      labels[static_cast<std::size_t>(column)] = hit.label;
    }
    for (std::size_t i = 0; i < sprites.size(); ++i) {
      const Sprite& sprite = sprites[i];
      if (row < sprite.first_row || row >= sprite.last_row) continue;
      for (int column = sprite.first_column; column < sprite.last_column; ++column) {
        const double t = first_hit(sprite.solid, centre_in_enu_m, direction(column, row));
        double& nearest = depth_m[static_cast<std::size_t>(column)];
        if (t >= nearest || t > kFarthestLabelM) continue;
        nearest = t;
        labels[static_cast<std::size_t>(column)] = sprite.solid.label;
        solids[static_cast<std::size_t>(column)] = static_cast<std::int32_t>(i);
      }
    }
  }
};

}  // namespace

SemanticFrame render(const World& world,
                     const CameraModel& camera,
                     const Rigid3& enu_from_camera,
                     double time_s,
                     double max_range_m) {
  return render_surfaces(world, camera, enu_from_camera, time_s, max_range_m).frame;
}

SurfaceView render_surfaces(const World& world,
                            const CameraModel& camera,
                            const Rigid3& enu_from_camera,
                            double time_s,
                            double max_range_m) {
  NADIR_REQUIRE(camera.width > 0 && camera.height > 0 && !world.map.labels.empty());
  const View view{world, camera, enu_from_camera.translation_m,
                  enu_from_camera.rotation.toRotationMatrix(),
                  visible_sprites(world, camera, enu_from_camera, time_s)};
  SurfaceView seen{
      .frame = {.time_s = time_s,
                .labels = Raster<ClassId>(camera.width, camera.height, kSky),
                .depth_m = Raster<float>(camera.width, camera.height)},
      .solids = {},
      .solid = Raster<std::int32_t>(camera.width, camera.height, SurfaceView::kNoSolid)};
  seen.solids.reserve(view.sprites.size());
  for (const Sprite& sprite : view.sprites) seen.solids.push_back(sprite.solid);
  const auto draw_rows = [&](std::size_t begin, std::size_t end) {
    std::vector<double> depth_m(static_cast<std::size_t>(camera.width));
    for (int row = static_cast<int>(begin); row < static_cast<int>(end); ++row) {
      view.draw_row(row, depth_m, seen.frame.labels.row(row), seen.solid.row(row));
      std::transform(
          depth_m.begin(), depth_m.end(), seen.frame.depth_m.row(row).begin(),
          [&](double depth) { return depth <= max_range_m ? static_cast<float>(depth) : 0.0F; });
    }
  };
  parallel_for(static_cast<std::size_t>(camera.height), kRowsAtOnce, draw_rows);
  return seen;
}

}  // namespace nadir
