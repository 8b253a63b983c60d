// SPDX-License-Identifier: Apache-2.0
// What a frame of each view and a whole figure cost, on the bundled map and a made-up run over it.
#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "tests/support/scratch_folder.h"
#include "tests/widgets/figures/recorded_flight.h"
#include "widgets/figures/figures.h"
#include "widgets/figures/film.h"
#include "widgets/gl/offscreen_renderer.h"
#include "widgets/views/overhead_view.h"
#include "widgets/views/particle_view.h"

namespace nadir {
namespace {

constexpr int kWidth = 1280;
constexpr int kHeight = 720;

template <typename T>
T demand(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().message);
  return std::move(*result);
}

/// A map and a run of so many steps over it, in a folder that goes with it.
struct Recorded {
  explicit Recorded(int steps) {
    write_street(folder.path() / "map");
    write_drive(folder.path() / "run.nadir", folder.path() / "map", steps);
  }
  [[nodiscard]] FigureRecipe recipe(const std::string& figure) const {
    FigureRecipe made;
    made.figure = figure;
    made.runs = {(folder.path() / "run.nadir").string()};
    made.map = (folder.path() / "map").string();
    return made;
  }
  ScratchFolder folder;
};

void BM_OverheadFrame(benchmark::State& state) {
  const auto renderer = demand(OffscreenRenderer::create());
  MapScene scene({0.0, 0.0});
  OverheadView view(scene, demand(OverheadTiles::open(NADIR_MAP, OverheadTiles::Layer::kPicture)),
                    OverheadTiles::Layer::kPicture);
  MapCamera camera;
  camera.metres_per_px = 0.2;
  for (auto _ : state) {
    camera.centre_in_enu_m.x() =
        camera.centre_in_enu_m.x() > 20.0 ? -20.0 : camera.centre_in_enu_m.x() + 0.5;
    benchmark::DoNotOptimize(demand(view.update(camera, kWidth, kHeight, 1000)));
    scene.look({camera, kWidth, kHeight, 1.5});
    benchmark::DoNotOptimize(demand(renderer->render(scene.renderer(), kWidth, kHeight)));
  }
}
BENCHMARK(BM_OverheadFrame)->Unit(benchmark::kMillisecond);

/// So many particles over 40 m x 40 m.
ParticleSet swirl(std::size_t count) {
  ParticleSet particles;
  particles.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = static_cast<double>(i);
    particles.set_pose(
        i, {20.0 * std::sin(angle), 20.0 * std::cos(1.7 * angle), std::sin(0.3 * angle)});
    particles.weight[i] = 1.0 / static_cast<double>(count);
  }
  return particles;
}

/// New particles in every frame, as in a replay.
void BM_ParticlesFrame(benchmark::State& state) {
  const auto renderer = demand(OffscreenRenderer::create());
  MapScene scene({0.0, 0.0});
  ParticleView view(scene);
  const ParticleSet particles = swirl(static_cast<std::size_t>(state.range(0)));
  scene.look({{{0.0, 0.0}, 0.1}, kWidth, kHeight, 1.5});
  for (auto _ : state) {
    view.show(particles);
    benchmark::DoNotOptimize(demand(renderer->render(scene.renderer(), kWidth, kHeight)));
  }
  state.counters["drawn"] = static_cast<double>(view.drawn_count());
}
BENCHMARK(BM_ParticlesFrame)
    ->Arg(1'000)
    ->Arg(10'000)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

/// The same particles while the map is moved, from afar (0) and near (1), where few are in sight.
void BM_ParticlesPan(benchmark::State& state) {
  const auto renderer = demand(OffscreenRenderer::create());
  MapScene scene({0.0, 0.0});
  ParticleView view(scene);
  view.show(swirl(static_cast<std::size_t>(state.range(0))));
  MapCamera camera;
  camera.metres_per_px = state.range(1) == 0 ? 0.1 : 0.002;
  for (auto _ : state) {
    camera.centre_in_enu_m.x() =
        std::remainder(camera.centre_in_enu_m.x() + 20.0 * camera.metres_per_px, 10.0);
    scene.look({camera, kWidth, kHeight, 1.5});
    benchmark::DoNotOptimize(demand(renderer->render(scene.renderer(), kWidth, kHeight)));
  }
  state.counters["drawn"] = static_cast<double>(view.drawn_count());
}
BENCHMARK(BM_ParticlesPan)
    ->ArgsProduct({{10'000, 1'000'000}, {0, 1}})
    ->ArgNames({"particles", "near"})
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

/// From the recipe to the bytes of the file, OpenGL's start included.
void BM_Figure(benchmark::State& state, const std::string& figure, PageFile kind) {
  const Recorded recorded(400);
  const FigureRecipe recipe = recorded.recipe(figure);
  for (auto _ : state) {
    const auto drawn = demand(make_figure(recipe));
    FigureContext context(page_format(recipe.options, demand(figure_kind(figure)).aspect));
    benchmark::DoNotOptimize(demand(draw_file(*drawn, context, kind, {})));
  }
}
BENCHMARK_CAPTURE(BM_Figure, trajectories_png, "trajectories", PageFile::kPng)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Figure, flight_png, "flight", PageFile::kPng)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Figure, flight_svg, "flight", PageFile::kSvg)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Figure, consistency_pdf, "consistency", PageFile::kPdf)
    ->Unit(benchmark::kMillisecond);

/// Frames of a 720p film a second, encoding included.
void BM_Film(benchmark::State& state, const std::string& figure) {
  const Recorded recorded(100);
  const FigureRecipe recipe = recorded.recipe(figure);
  const auto drawn = demand(make_figure(recipe));
  PageFormat format;
  format.width = kWidth;
  format.height = kHeight;
  format.dpi = 120.0;
  FigureContext context(format);
  context.supersampling = 1;
  std::int64_t frames = 0;
  for (auto _ : state) {
    frames += demand(write_film(*drawn, context, {.fps = 25.0, .speed = 25.0},
                                recorded.folder.path() / "film.mp4", {}))
                  .frames;
  }
  state.SetItemsProcessed(frames);
}
BENCHMARK_CAPTURE(BM_Film, trajectories, "trajectories")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Film, moment, "moment")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nadir
