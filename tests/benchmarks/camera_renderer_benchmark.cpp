// SPDX-License-Identifier: Apache-2.0
// target: benchmark
#include <benchmark/benchmark.h>

#include <numbers>

#include "core/base/parallel.h"
#include "core/sim/camera_renderer.h"
#include "core/sim/depth_noise.h"
#include "core/sim/label_noise.h"
#include "tests/core/sim/street_map.h"

namespace nadir {
namespace {

const CameraModel& thesis_camera() {
  static const CameraModel camera =
      CameraModel::from_horizontal_view(640, 480, 59.95 * std::numbers::pi / 180.0);
  return camera;
}

const World& street() {
  static const World world = raise_world(street_map(0.1), {}, 1);
  return world;
}

/// Argument: degrees that the camera is turned from the street; along it views are long, across it
/// walls are near.
void BM_RenderFrame(benchmark::State& state) {
  const ThreadLimit one_thread(1);
  const Rigid3 pose = camera_over(10.0, 29.0, static_cast<double>(state.range(0)), 3.0, 4.0);
  for (auto _ : state) {
    benchmark::DoNotOptimize(render(street(), thesis_camera(), pose, 2.0, kFarthestLabelM));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(BM_RenderFrame)->Arg(0)->Arg(35)->Arg(90)->Unit(benchmark::kMillisecond);

void BM_LabelNoise(benchmark::State& state) {
  const ThreadLimit one_thread(1);
  const Rigid3 pose = camera_over(10.0, 29.0, 5.0, 3.0, 4.0);
  const SemanticFrame frame = render(street(), thesis_camera(), pose, 2.0, kFarthestLabelM);
  const LabelNoise noise(1);
  std::uint32_t number = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(noise.apply(frame, thesis_camera(), pose, number++));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(BM_LabelNoise)->Unit(benchmark::kMillisecond);

void BM_DepthNoise(benchmark::State& state) {
  const ThreadLimit one_thread(1);
  const Rigid3 pose = camera_over(10.0, 29.0, 5.0, 3.0, 4.0);
  const SemanticFrame frame = render(street(), thesis_camera(), pose, 2.0, kFarthestLabelM);
  std::uint32_t number = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(measure_depth(frame.depth_m, {0.05, 12.0}, 1, number++));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(BM_DepthNoise)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nadir
