// SPDX-License-Identifier: Apache-2.0
#include "core/insight/view_footprint.h"

#include <gmock/gmock.h>

#include <numbers>
#include <set>
#include <tuple>

#include "core/base/random.h"
#include "core/sim/camera_renderer.h"
#include "tests/core/sim/street_map.h"
#include "tests/support/error_text.h"
#include "tests/support/scenery.h"

namespace nadir {
namespace view_footprint_test {

constexpr double kHeightM = 2.0;

CameraModel camera() { return CameraModel::from_horizontal_view(640, 480, 1.0463); }

ViewFootprint footprint(double metres_per_cell, const TopviewOptions& topview = {.min_votes = 3}) {
  return ViewFootprint::create(camera(), kHeightM, topview, metres_per_cell).value();
}

using CellSet = std::set<std::tuple<ClassId, int, int>>;

CellSet cells_of(const SemanticTopview& topview) {
  CellSet cells;
  for (ClassId id = 0; id < kClassCount; ++id) {
    for (const TopviewCell& cell : topview.of_class(id))
      cells.insert({id, cell.forward, cell.left});
  }
  return cells;
}

/// What core/sim's camera sees of the same map without anything that the map does not hold, by the program's own way.
SemanticTopview rendered_topview(const World& world, const Rigid2& pose, int min_votes) {
  const double yaw_deg = Angle::radians(pose.yaw_rad).degrees();
  const SemanticFrame frame = render(
      world, camera(), camera_over(pose.x_m, pose.y_m, yaw_deg, 0.0, 0.0, kHeightM), 0.0, 40.0);
  const Eigen::Isometry3d level_from_camera{forward_body_from_camera()};
  const auto cloud =
      build_semantic_cloud(frame.labels, frame.depth_m, camera(), level_from_camera, 40.0);
  return build_semantic_topview(*cloud, world.map.metres_per_cell, {.min_votes = min_votes})
      .value();
}

TEST(ViewFootprint, SeesWhatTheSimulatedCameraSees) {
  const OverheadMap map = street_map(0.2);
  const World world = raise_world(map, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 1);
  const ViewFootprint view = footprint(0.2);
  for (const Rigid2& pose : {Rigid2{20.1, 28.3, 0.0}, Rigid2{38.0, 12.0, 1.3},
                             Rigid2{44.0, 40.0, -2.2}, Rigid2{30.0, 37.0, 2.9}}) {
    const CellSet found = cells_of(view.topview(map, pose));
    const CellSet rendered = cells_of(rendered_topview(world, pose, 3));
    std::size_t both = 0;
    for (const auto& cell : found) both += rendered.count(cell);
    const auto either = static_cast<double>(found.size() + rendered.size() - both);
    EXPECT_GT(static_cast<double>(both) / either, 0.8)
        << pose.x_m << ": " << found.size() << " cells, rendered " << rendered.size();
  }
}

TEST(ViewFootprint, OfOpenGroundEndsWhereACellHasTooFewPixels) {
  OverheadMap map = patchwork_map(400, 400, 0.1);
  map.labels = Raster<ClassId>(400, 400, kRoad);
  const CameraModel lens = camera();
  for (const int votes : {1, 3, 10}) {
    const auto topview = footprint(0.1, {.min_votes = votes}).topview(map, {20.0, 20.0, 0.4});
    // Pixels on a cell of side a at depth d, seen from height h: f_x f_y h a^2 / d^3.
    const double farthest_m =
        std::cbrt(lens.focal_x_px * lens.focal_y_px * kHeightM * 0.01 / votes);
    const double nearest_m = kHeightM * lens.focal_y_px / 240.0;
    ASSERT_FALSE(topview.cells.empty());
    for (const TopviewCell& cell : topview.cells) {
      const double depth_m = (cell.forward + 0.5) * 0.1;
      ASSERT_LE(depth_m, farthest_m);
      ASSERT_GE(depth_m, nearest_m);
      ASSERT_LE(std::abs(cell.left + 0.5) * 0.1, depth_m * 320.0 / lens.focal_x_px);
    }
  }
}

TEST(ViewFootprint, SeesNothingBehindAWallAndOverAFence) {
  OverheadMap map = patchwork_map(300, 300, 0.1);
  const auto with_line_at = [&](ClassId id) {
    map.labels = Raster<ClassId>(300, 300, kRoad);
    for (int row = 0; row < 300; ++row) {
      for (int column = 200; column < 203; ++column) map.labels.at(column, row) = id;
    }
    return footprint(0.1).topview(map, {13.0, 15.0, 0.0});  // the line is 7 m ahead
  };
  const auto behind = [](const SemanticTopview& topview) {
    int count = 0;
    for (const TopviewCell& cell : topview.of_class(kRoad)) count += cell.forward >= 73 ? 1 : 0;
    return count;
  };
  const auto wall = with_line_at(kBuilding);
  EXPECT_EQ(behind(wall), 0);
  EXPECT_GT(wall.of_class(kBuilding).size(), 50U);
  for (const TopviewCell& cell : wall.of_class(kBuilding))
    EXPECT_LE(cell.forward, 71) << "its face";
  // A line of sight over a fence of 1.1 m, 7.3 m away, comes down 7.3 * 2 / 0.9 = 16 m away: too far for votes.
  const auto fence = with_line_at(kFence);
  EXPECT_EQ(behind(fence), 0);
  EXPECT_GT(behind(with_line_at(kCurb)), 500);
}

TEST(ViewFootprint, DependsOnNothingThatItsFanDoesNotReach) {
  const ViewFootprint view = footprint(0.2);
  OverheadMap map = patchwork_map(300, 300, 0.2);
  const Rigid2 pose{30.0, 30.0, 2.1};
  const auto before = view.topview(map, pose);
  int unseen = 0;
  for (std::uint32_t i = 0; i < 400; ++i) {
    const auto words = random_words({.seed = 9, .particle = i});
    const int column = static_cast<int>(words[0] % 300);
    const int row = static_cast<int>(words[1] % 300);
    PlaneBounds cell;
    cell.include(map.enu_from_overhead({column, row}));
    cell.include(map.enu_from_overhead({column + 1.0, row + 1.0}));
    if (view.may_reach(cell, pose, view.reach_m(), 0.0)) continue;
    ++unseen;
    ClassId& label = map.labels.at(column, row);
    const ClassId kept = std::exchange(label, ClassId{kBuilding});
    ASSERT_EQ(view.topview(map, pose), before) << column << ' ' << row;
    label = kept;
  }
  EXPECT_GT(unseen, 200) << "and it says so of most of the map";
}

TEST(ViewFootprint, RefusesWhatNoCameraIs) {
  const auto fault = [](const CameraModel& lens, double height_m, const TopviewOptions& topview) {
    return error_text(ViewFootprint::create(lens, height_m, topview, 0.1));
  };
  EXPECT_THAT(fault(camera(), 0.0, {}), testing::HasSubstr("0 m above the ground"));
  EXPECT_THAT(fault(camera(), std::nan(""), {}), testing::HasSubstr("above the ground"));
  EXPECT_THAT(fault({}, 2.0, {}), testing::HasSubstr("camera"));
  EXPECT_THAT(fault(camera(), 2.0, {.min_votes = 0}), testing::HasSubstr("min-votes"));
}

}  // namespace view_footprint_test
}  // namespace nadir
