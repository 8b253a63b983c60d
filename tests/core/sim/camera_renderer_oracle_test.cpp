// SPDX-License-Identifier: Apache-2.0
// The renderer against rays that are walked step by step: minutes without optimisation.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/sim/camera_renderer.h"
#include "tests/core/sim/solid_oracle.h"
#include "tests/core/sim/street_map.h"

namespace nadir {
namespace camera_renderer_oracle_test {

struct Seen {
  ClassId label;
  double depth_m;
};

/// What a ray hits, found by walking along it in steps of 4 mm. Knows columns and solids, and no
/// short cut.
Seen walk_ray(const World& world,
              const std::vector<Solid>& solids,
              const Eigen::Vector3d& origin,
              const Eigen::Vector3d& direction) {
  std::vector<Solid> beside_ray;  // nothing else can be hit
  const Eigen::Vector2d across = Eigen::Vector2d(-direction.y(), direction.x()).normalized();
  for (const Solid& solid : solids) {
    const Eigen::Vector3d offset = solid.centre_in_enu_m - origin;
    if (std::abs(across.dot(offset.head<2>())) < 4.0) beside_ray.push_back(solid);
  }
  for (double t = 0.0; t <= kFarthestLabelM; t += 0.004) {
    const Eigen::Vector3d point = origin + t * direction;
    if (point.z() > 12.0) break;
    for (const Solid& solid : beside_ray) {
      if (is_inside(solid, point)) return {solid.label, t};
    }
    const Eigen::Vector2d cell = world.map.overhead_from_enu(point.head<2>());
    const int column = static_cast<int>(std::floor(cell.x()));
    const int row = static_cast<int>(std::floor(cell.y()));
    const bool is_on_map = world.map.labels.contains(column, row);
    const double height_m =
        is_on_map ? static_cast<double>(world.relief.height_m.at(column, row)) : 0.0;
    if (point.z() <= height_m) {
      return {is_on_map ? world.map.labels.at(column, row) : ClassId{kUnclassified}, t};
    }
  }
  return {kSky, 0.0};
}

TEST(CameraRenderer, AgreesWithARayThatIsWalkedInTinySteps) {
  const OverheadMap map = street_map();
  World world = raise_world(map, {}, 4);
  const CameraModel small =
      CameraModel::from_horizontal_view(40, 30, 59.95 * std::numbers::pi / 180.0);
  int pixels = 0;
  int differing_labels = 0;
  int differing_depths = 0;
  for (const Rigid3& pose :
       {camera_over(20.0, 28.0, 10.0, 4.0, 3.0), camera_over(41.0, 12.0, 80.0, -9.0, -2.0),
        camera_over(70.0, 33.0, 200.0), camera_over(2.0, 30.0, 170.0, 1.0, 6.0)}) {
    const double time_s = 3.25;
    const SemanticFrame frame = render(world, small, pose, time_s, kFarthestLabelM);
    const std::vector<Solid> solids = world.solids_at(time_s);
    for (int row = 0; row < small.height; ++row) {
      for (int column = 0; column < small.width; ++column) {
        const Seen seen = walk_ray(world, solids, pose.translation_m,
                                   pose.rotation * small.ray({column + 0.5, row + 0.5}));
        ++pixels;
        if (frame.labels.at(column, row) != seen.label) {
          ++differing_labels;
        } else if (std::abs(static_cast<double>(frame.depth_m.at(column, row)) - seen.depth_m) >
                   0.02) {
          ++differing_depths;
        }
      }
    }
  }
  EXPECT_LE(differing_labels, pixels / 1000);
  EXPECT_LE(differing_depths, pixels / 1000);
}

}  // namespace camera_renderer_oracle_test
}  // namespace nadir
