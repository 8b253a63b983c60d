// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <array>
#include <filesystem>
#include <vector>

#include "core/map/overhead_map_file.h"
#include "core/sim/camera_renderer.h"
#include "core/sim/label_noise.h"
#include "core/sim/route.h"

namespace nadir {
namespace label_noise_map_test {

using testing::AllOf;
using testing::Ge;
using testing::Le;

/// What became of the pixels of each class.
struct ClassCounts {
  std::array<double, kClassCount> all{}, right{}, taken_for_it{};

  void add(const Raster<ClassId>& truth, const Raster<ClassId>& seen) {
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const ClassId true_label = truth.values()[i];
      const ClassId label = seen.values()[i];
      if (true_label >= kClassCount) continue;
      all[true_label] += 1.0;
      if (label == true_label) {
        right[true_label] += 1.0;
      } else if (label < kClassCount) {
        taken_for_it[label] += 1.0;
      }
    }
  }
  [[nodiscard]] double accuracy(ClassId id) const { return right[id] / all[id]; }
  [[nodiscard]] double overlap(ClassId id) const {
    return right[id] / (all[id] + taken_for_it[id]);
  }
};

/// Frames all along a route of the bundled town, by turns in four worlds with errors of their own.
ClassCounts fly(const char* route_file) {
  const std::filesystem::path town = NADIR_PROVING_GROUND;
  const OverheadMap map = read_overhead_map(town).value();
  const Trajectory flight =
      plan_flight(read_route(town / "routes" / route_file).value(), 1).value();
  std::vector<World> worlds;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) worlds.push_back(raise_world(map, {}, seed));
  const CameraModel camera =
      CameraModel::from_horizontal_view(320, 240, Angle::degrees(59.95).radians());
  constexpr std::size_t kFrames = 32;
  ClassCounts counts;
  for (std::size_t i = 0; i < kFrames; ++i) {
    const TimedPose& timed = flight.poses()[(2 * i + 1) * flight.size() / (2 * kFrames)];
    const Rigid3 pose = timed.pose * Rigid3{forward_body_from_camera(), Eigen::Vector3d::Zero()};
    const SemanticFrame frame = render(worlds[i % 4], camera, pose, timed.time_s, kFarthestLabelM);
    const LabelNoise noise(1 + i % 4);
    counts.add(frame.labels, noise.apply(frame, camera, pose, static_cast<std::uint32_t>(i)));
  }
  return counts;
}

class LabelNoiseOverTheTown : public testing::TestWithParam<const char*> {};

TEST_P(LabelNoiseOverTheTown, IsAboutThatOfThePublishedNetwork) {
  const ClassCounts counts = fly(GetParam());
  for (const ClassId id : {kRoad, kSidewalk, kBuilding, kFence, kVegetation, kTerrain, kSky, kCar,
                           kCurb, kLaneMarking, kPole}) {
    ASSERT_GT(counts.all[id], 5000.0) << class_info(id).name;
    EXPECT_NEAR(counts.accuracy(id), class_errors(id).accuracy, 0.12) << class_info(id).name;
  }
  // The class IoUs of thesis 4.1 over its five data sets.
  EXPECT_THAT(counts.overlap(kRoad), AllOf(Ge(0.85), Le(0.91)));
  EXPECT_THAT(counts.overlap(kSidewalk), AllOf(Ge(0.41), Le(0.72)));
  EXPECT_THAT(counts.overlap(kBuilding), AllOf(Ge(0.69), Le(0.91)));
  EXPECT_THAT(counts.overlap(kVegetation), AllOf(Ge(0.50), Le(0.83)));
}

INSTANTIATE_TEST_SUITE_P(Routes,
                         LabelNoiseOverTheTown,
                         testing::Values("loop.toml", "figure-eight.toml"));

}  // namespace label_noise_map_test
}  // namespace nadir
