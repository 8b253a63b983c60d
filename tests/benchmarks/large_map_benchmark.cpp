// SPDX-License-Identifier: Apache-2.0
// How long a very large map takes to open, and what a frame costs while it is moved: 1280 x 720 pixels, read back.
// NADIR_BENCHMARK_MAP_SIDE is its side in cells; CTest's run takes a small one.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <vector>

#include "tests/support/scratch_folder.h"
#include "widgets/gl/offscreen_renderer.h"
#include "widgets/views/overhead_view.h"

namespace nadir {
namespace {

constexpr int kWidth = 1280;
constexpr int kHeight = 720;
constexpr double kMetresPerCell = 0.1;
/// A window reads no more per frame and layer.
constexpr int kNewTilesPerFrame = 1;

template <typename T>
T demand(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().message);
  return std::move(*result);
}

int map_side() {
  const char* const asked =
      std::getenv("NADIR_BENCHMARK_MAP_SIDE");  // NOLINT(concurrency-mt-unsafe)
  return asked == nullptr ? 20'000 : std::max(600, std::atoi(asked));
}

/// A map package without repetition, as our own import writes it: compressed, tiled, with overviews.
class LargeMap {
 public:
  LargeMap() {
    const int side = map_side();
    OverheadMap map{
        .name = "large",
        .plane = demand(ProjectPlane::create({33.45, -83.9})),
        .metres_per_cell = kMetresPerCell,
        .top_left_in_enu_m = {-side * kMetresPerCell / 2.0, side * kMetresPerCell / 2.0},
        .labels = Raster<ClassId>(side, side)};
    ColourRaster picture(side, side);
    for (int row = 0; row < side; ++row) {
      for (int column = 0; column < side; ++column) paint(map.labels, picture, column, row);
    }
    const auto written = write_overhead_map(map, {}, picture, path());
    if (!written) throw std::runtime_error(written.error().message);
  }
  [[nodiscard]] std::filesystem::path path() const { return folder_.path() / "large"; }

 private:
  /// Fields of 48 cells, each of one class and colour, under a grain as a camera has it.
  static void paint(Raster<ClassId>& labels, ColourRaster& picture, int column, int row) {
    const auto x = static_cast<std::uint32_t>(column);
    const auto y = static_cast<std::uint32_t>(row);
    const std::uint32_t field = x / 48U * 7919U + y / 48U * 104'729U;
    const std::uint32_t mixed = (field ^ (field >> 13U)) * 2'654'435'761U;
    const std::uint32_t grain = (x * 73'856'093U) ^ (y * 19'349'663U);
    const std::uint32_t noise = (grain * 2'654'435'761U) >> 28U;
    labels.at(column, row) = static_cast<ClassId>((mixed >> 8U) % 5U);
    picture.at(column, row) = {static_cast<std::uint8_t>(40 + (mixed >> 24U) / 2 + noise),
                               static_cast<std::uint8_t>(60 + (mixed >> 16U) % 128 + noise),
                               static_cast<std::uint8_t>(30 + noise)};
  }
  ScratchFolder folder_;
};

/// Written once: that takes longer than all that is measured.
const LargeMap& large_map() {
  static const LargeMap map;
  return map;
}

/// What a window holds of a map: the picture, and where asked its labels half transparent above.
struct ShownMap {
  explicit ShownMap(bool with_labels) {
    for (const auto layer : {OverheadTiles::Layer::kPicture, OverheadTiles::Layer::kLabels}) {
      if (layer == OverheadTiles::Layer::kLabels && !with_labels) continue;
      views.push_back(std::make_unique<OverheadView>(
          scene, demand(OverheadTiles::open(large_map().path(), layer)), layer));
      if (layer == OverheadTiles::Layer::kLabels) views.back()->set_opacity(0.5);
    }
  }
  /// @returns whether nothing is missing any more.
  bool draw(OffscreenRenderer& renderer, const MapCamera& camera, int most_new_tiles) {
    bool is_complete = true;
    for (const auto& view : views) {
      is_complete = demand(view->update(camera, kWidth, kHeight, most_new_tiles)) && is_complete;
    }
    scene.look({camera, kWidth, kHeight, 1.5});
    benchmark::DoNotOptimize(demand(renderer.render(scene.renderer(), kWidth, kHeight)));
    return is_complete;
  }
  MapScene scene{{0.0, 0.0}};
  std::vector<std::unique_ptr<OverheadView>> views;
};

/// From nothing, OpenGL's start included, to the first whole frame: the whole map (0) or its middle, cell by pixel (1).
void BM_OpenToFirstFrame(benchmark::State& state) {
  (void)large_map();
  MapCamera camera;
  camera.metres_per_px =
      state.range(0) == 0 ? map_side() * kMetresPerCell / kHeight : kMetresPerCell;
  for (auto _ : state) {
    const auto renderer = demand(OffscreenRenderer::create());
    ShownMap shown(true);
    if (!shown.draw(*renderer, camera, 1000)) throw std::runtime_error("tiles are missing");
  }
}
BENCHMARK(BM_OpenToFirstFrame)
    ->Arg(0)
    ->Arg(1)
    ->ArgName("close")
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// 20 pixels a frame over ground that was not shown before, at so many hundredths of a cell a pixel. One iteration is
/// 120 frames, of which the counters speak.
void BM_Pan(benchmark::State& state) {
  constexpr int kFrames = 120;
  constexpr double kStepPx = 20.0;
  const auto renderer = demand(OffscreenRenderer::create());
  const double cells_per_px = static_cast<double>(state.range(0)) / 100.0;
  std::vector<double> frames_ms;
  int incomplete = 0;
  for (auto _ : state) {
    state.PauseTiming();
    ShownMap shown(state.range(1) != 0);
    MapCamera camera;
    camera.metres_per_px = cells_per_px * kMetresPerCell;
    camera.centre_in_enu_m =
        -0.5 * kFrames * kStepPx * camera.metres_per_px * Eigen::Vector2d(1.0, 0.3).normalized();
    while (!shown.draw(*renderer, camera, 1000)) {
    }
    state.ResumeTiming();
    for (int frame = 0; frame < kFrames; ++frame) {
      const auto start = std::chrono::steady_clock::now();
      camera.centre_in_enu_m +=
          kStepPx * camera.metres_per_px * Eigen::Vector2d(1.0, 0.3).normalized();
      if (!shown.draw(*renderer, camera, kNewTilesPerFrame)) ++incomplete;
      const std::chrono::duration<double, std::milli> passed =
          std::chrono::steady_clock::now() - start;
      frames_ms.push_back(passed.count());
    }
  }
  std::sort(frames_ms.begin(), frames_ms.end());
  state.counters["median_ms"] = frames_ms[frames_ms.size() / 2];
  state.counters["p95_ms"] = frames_ms[frames_ms.size() * 95 / 100];
  state.counters["worst_ms"] = frames_ms.back();
  state.counters["with_stand_ins"] =
      static_cast<double>(incomplete) / static_cast<double>(frames_ms.size());
}
BENCHMARK(BM_Pan)
    ->ArgsProduct({{50, 100, 199, 400, 2800}, {0, 1}})
    ->ArgNames({"hundredths", "labels"})
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nadir
