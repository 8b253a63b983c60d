// SPDX-License-Identifier: Apache-2.0
// The bundled town, 250 x 200 m, at 2 m and 8 headings: 100,000 views.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <limits>

#include "core/insight/localisability.h"
#include "core/map/overhead_map_file.h"

namespace nadir {
namespace {

constexpr std::int64_t kAllViews = std::numeric_limits<std::int64_t>::max();

const OverheadMap& town() {
  static const OverheadMap map = read_overhead_map(NADIR_MAP).value();
  return map;
}

/// CTest, which only looks whether it runs, sets another spacing.
LocalisabilityMap town_localisability() {
  LocalisabilityOptions options;
  // NOLINTNEXTLINE(concurrency-mt-unsafe): benchmarks set no variables
  if (const char* spacing = std::getenv("NADIR_BENCHMARK_SPACING_M")) {
    options.spacing_m = std::strtod(spacing, nullptr);
  }
  return LocalisabilityMap::create(town(), {}, options).value();
}

void BM_Create(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(town_localisability());
}
BENCHMARK(BM_Create)->Unit(benchmark::kMillisecond)->UseRealTime();

/// A thousand views in the middle of the town.
void BM_ThousandViews(benchmark::State& state) {
  std::int64_t views = 0;
  for (auto _ : state) {
    state.PauseTiming();
    LocalisabilityMap map = town_localisability();
    state.ResumeTiming();
    const std::int64_t before = map.missing_views();
    benchmark::DoNotOptimize(map.compute_more(1'000, {0.0, 0.0}));
    views += before - map.missing_views();
  }
  state.SetItemsProcessed(views);
}
BENCHMARK(BM_ThousandViews)->Unit(benchmark::kMillisecond)->UseRealTime();

void BM_WholeTown(benchmark::State& state) {
  for (auto _ : state) {
    state.PauseTiming();
    LocalisabilityMap map = town_localisability();
    state.ResumeTiming();
    benchmark::DoNotOptimize(map.compute_more(kAllViews, {0.0, 0.0}));
  }
}
BENCHMARK(BM_WholeTown)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

/// 40 x 40 m drawn anew: taking it over, and then all views that it may have changed.
void BM_Edit(benchmark::State& state) {
  static LocalisabilityMap map = [] {
    LocalisabilityMap whole = town_localisability();
    benchmark::DoNotOptimize(whole.compute_more(kAllViews, {0.0, 0.0}));
    return whole;
  }();
  const CellRect cells{1050, 800, 1450, 1200};
  Raster<ClassId> labels(400, 400);
  for (int row = 0; row < 400; ++row) {
    for (int column = 0; column < 400; ++column) {
      labels.at(column, row) = town().labels.at(1050 + column, 800 + row);
    }
  }
  double views = 0.0;
  for (auto _ : state) {
    map.redraw(cells, labels);
    views = static_cast<double>(map.missing_views());
    benchmark::DoNotOptimize(map.compute_more(kAllViews, {0.0, 0.0}));
  }
  state.counters["views"] = views;
}
BENCHMARK(BM_Edit)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace nadir
