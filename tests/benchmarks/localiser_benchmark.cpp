// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <numbers>

#include "core/base/parallel.h"
#include "core/mcl/error_surface.h"
#include "core/mcl/localiser.h"
#include "core/mcl/resampling.h"
#include "core/sim/camera_renderer.h"
#include "tests/core/sim/street_map.h"

namespace nadir {
namespace {

/// The thesis's camera (640 x 480, 59.95 degrees, 2 m up) over a street at 0.1 m a cell, depth to
/// 20 m.
struct Scene {
  CameraModel camera =
      CameraModel::from_horizontal_view(640, 480, 59.95 * std::numbers::pi / 180.0);
  std::shared_ptr<const MapIndex> index =
      std::make_shared<const MapIndex>(std::make_shared<const OverheadMap>(street_map(0.1)));
  Rigid2 enu_from_body{15.0, 29.0, 0.2};
  SemanticFrame frame = render(raise_world(index->map(), {}, 1),
                               camera,
                               Rigid3{rotation_of({0.0, 0.0, enu_from_body.yaw_rad}),
                                      {enu_from_body.x_m, enu_from_body.y_m, 2.0}} *
                                   Rigid3{forward_body_from_camera(), Eigen::Vector3d::Zero()},
                               0.0,
                               20.0);
  Eigen::Isometry3d level_from_camera{forward_body_from_camera()};

  [[nodiscard]] SemanticTopview topview() const {
    const auto cloud =
        build_semantic_cloud(frame.labels, frame.depth_m, camera, level_from_camera, 40.0);
    return build_semantic_topview(*cloud, 0.1).value();
  }
  [[nodiscard]] Localiser localiser(const LocaliserOptions& options) const {
    return Localiser::create(index, options, GaussianPrior{.mean_in_enu = enu_from_body}).value();
  }
};

const Scene& scene() {
  static const Scene the_scene;
  return the_scene;
}

LocaliserOptions fixed_count(const char* preset, std::int64_t particles) {
  LocaliserOptions options = localiser_preset(preset).value();
  options.particle_count = static_cast<int>(particles);
  options.adapt_particle_count = false;
  return options;
}

void BM_BuildTopview(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(scene().topview());
  state.counters["cells"] = static_cast<double>(scene().topview().cells.size());
}
BENCHMARK(BM_BuildTopview)->Unit(benchmark::kMillisecond);

/// Arguments: particles, threads, and 1 for all cells of the topview (preset thesis) or 0 for the
/// default's thinned ones.
void BM_WeighParticles(benchmark::State& state) {
  const ThreadLimit limit(static_cast<int>(state.range(1)));
  const auto options = fixed_count(state.range(2) == 1 ? "thesis" : "default", state.range(0));
  const Localiser localiser = scene().localiser(options);
  const MatchCells cells = localiser.matcher().prepare(scene().topview());
  std::size_t cell_count = 0;
  for (const auto& group : cells.classes) cell_count += group.cells.size();
  for (auto _ : state) {
    benchmark::DoNotOptimize(localiser.matcher().mean_costs(cells, localiser.particles()));
  }
  state.SetItemsProcessed(state.iterations() * state.range(0) *
                          static_cast<std::int64_t>(cell_count));
  state.counters["cells"] = static_cast<double>(cell_count);
}
BENCHMARK(BM_WeighParticles)
    ->ArgNames({"particles", "threads", "all_cells"})
    ->ArgsProduct({{1'000, 10'000, 100'000}, {1, 2}, {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// The same kernel with each instruction set: 0 portable, 1 AVX2, 2 AVX-512.
void BM_InstructionSets(benchmark::State& state) {
  const auto set = static_cast<InstructionSet>(state.range(0));
  if (!is_available(set)) {
    state.SkipWithError("this machine does not have it");
    return;
  }
  const ThreadLimit limit(1);
  const Localiser localiser = scene().localiser(fixed_count("thesis", 2'000));
  const auto matcher = MapMatcher::create(scene().index, localiser.options(), set).value();
  const MatchCells cells = matcher.prepare(scene().topview());
  for (auto _ : state) benchmark::DoNotOptimize(matcher.mean_costs(cells, localiser.particles()));
}
BENCHMARK(BM_InstructionSets)->Arg(0)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);

/// Arguments: particles, and the kind of resampling: 0 multinomial, 1 systematic.
void BM_Resample(benchmark::State& state) {
  LocaliserOptions options = fixed_count("default", state.range(0));
  options.resampling = static_cast<ResamplingKind>(state.range(1));
  Localiser localiser = scene().localiser(options);
  ParticleSet particles = localiser.particles();
  const MatchCells cells = localiser.matcher().prepare(scene().topview());
  apply_likelihood(particles, localiser.matcher().mean_costs(cells, particles), 1.0, options);
  std::uint32_t step = 0;
  for (auto _ : state) benchmark::DoNotOptimize(resample(particles, options, ++step));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(BM_Resample)->ArgsProduct({{10'000, 100'000}, {0, 1}})->Unit(benchmark::kMillisecond);

void BM_FindModes(benchmark::State& state) {
  const Localiser localiser = scene().localiser(fixed_count("default", 10'000));
  for (auto _ : state) benchmark::DoNotOptimize(find_modes(localiser.particles()));
}
BENCHMARK(BM_FindModes)->Unit(benchmark::kMillisecond);

/// What "why here?" asks for: 64 x 64 x 36 poses. Arguments: 1 where the poses are whole cells apart (0.2 m), 0 where they are not
/// (0.25 m on cells of 0.1 m); 1 for all cells of the topview, 0 for the default's thinned ones; threads.
void BM_ErrorSurface(benchmark::State& state) {
  const ThreadLimit limit(static_cast<int>(state.range(2)));
  const Localiser localiser =
      scene().localiser(fixed_count(state.range(1) == 1 ? "thesis" : "default", 1'000));
  const SemanticTopview seen = scene().topview();
  const ErrorSurfaceGrid grid{64, 64, 36, state.range(0) == 1 ? 0.2 : 0.25, 0.05};
  for (auto _ : state) {
    benchmark::DoNotOptimize(error_surface(localiser.matcher(), seen, scene().enu_from_body, grid));
  }
}
BENCHMARK(BM_ErrorSurface)
    ->ArgNames({"whole_cells", "all_cells", "threads"})
    ->ArgsProduct({{0, 1}, {0, 1}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// The rows of poses of such a surface with each instruction set: 0 portable, 1 AVX2, 2 AVX-512.
void BM_ErrorSurfaceInstructionSets(benchmark::State& state) {
  const auto set = static_cast<InstructionSet>(state.range(0));
  if (!is_available(set)) {
    state.SkipWithError("this machine does not have it");
    return;
  }
  const ThreadLimit limit(1);
  const auto matcher =
      MapMatcher::create(scene().index, localiser_preset("default").value(), set).value();
  const SemanticTopview seen = scene().topview();
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        error_surface(matcher, seen, scene().enu_from_body, {64, 64, 36, 0.2, 0.05}));
  }
}
BENCHMARK(BM_ErrorSurfaceInstructionSets)
    ->Arg(0)
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// From labels and depth to estimate and modes. Arguments: particles, threads, 1 for preset thesis,
/// 0 for default.
void BM_WholeUpdate(benchmark::State& state) {
  const ThreadLimit limit(static_cast<int>(state.range(1)));
  Localiser localiser =
      scene().localiser(fixed_count(state.range(2) == 1 ? "thesis" : "default", state.range(0)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(localiser.update({{0.0, 0.0, 0.0}, 0.25}, scene().topview()));
  }
  state.counters["updates_per_s"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(BM_WholeUpdate)
    ->ArgNames({"particles", "threads", "thesis"})
    ->ArgsProduct({{10'000}, {1, 2}, {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace nadir
