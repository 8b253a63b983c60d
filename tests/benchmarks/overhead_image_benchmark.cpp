// SPDX-License-Identifier: Apache-2.0
// What an image of 40,000 x 40,000 pixels costs to open and to look at, on another system than the map's.
// NADIR_BENCHMARK_IMAGE_SIDE is its side; CTest's run takes a smaller one.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "core/map/overhead_image.h"
#include "tests/core/map/image_files.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace {

template <typename T>
T demand_image(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().message);
  return std::move(*result);
}

/// Tiled and sparse, so that reading costs what opening and warping cost.
class HugeImage {
 public:
  HugeImage() {
    const char* const asked =
        std::getenv("NADIR_BENCHMARK_IMAGE_SIDE");  // NOLINT(concurrency-mt-unsafe)
    write_sparse_image(asked == nullptr ? 40'000 : std::max(3000, std::atoi(asked)), path());
  }
  [[nodiscard]] std::filesystem::path path() const { return folder_.path() / "huge.tif"; }
  [[nodiscard]] std::filesystem::path cache() const { return folder_.path() / "cache"; }

 private:
  ScratchFolder folder_;
};

const HugeImage& huge_image() {
  static const HugeImage image;
  return image;
}

double peak_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// To the tile that shows the whole of it; without overviews (0) and with them (1).
void BM_OpenHugeImage(benchmark::State& state) {
  const HugeImage& image = huge_image();
  if (state.range(0) == 1) {
    const auto prepared = prepare_image(image.path(), image.cache());
    if (!prepared) throw std::runtime_error(prepared.error().message);
  }
  for (auto _ : state) {
    const OpenedImage opened = demand_image(open_overhead_image(
        image.path(), {.cache = state.range(0) == 1 ? image.cache() : std::filesystem::path()}));
    benchmark::DoNotOptimize(
        demand_image(opened.tiles.picture({opened.tiles.level_count() - 1, 0, 0})));
  }
  state.counters["peak_mb"] = peak_mb();
}
BENCHMARK(BM_OpenHugeImage)
    ->Arg(0)
    ->Arg(1)
    ->ArgName("overviews")
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// Tiles side by side, each for the first time.
void BM_ReadTiles(benchmark::State& state) {
  const HugeImage& image = huge_image();
  const OpenedImage opened =
      demand_image(open_overhead_image(image.path(), {.cache = image.cache()}));
  const int level = std::min(static_cast<int>(state.range(0)), opened.tiles.level_count() - 1);
  int next = 0;
  for (auto _ : state) {
    const int columns = opened.tiles.columns(level);
    benchmark::DoNotOptimize(demand_image(
        opened.tiles.picture({level, next % columns, next / columns % opened.tiles.rows(level)})));
    ++next;
  }
  state.counters["peak_mb"] = peak_mb();
}
BENCHMARK(BM_ReadTiles)
    ->Arg(0)
    ->Arg(2)
    ->ArgName("level")
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nadir
