// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <cmath>
#include <stdexcept>

#include "core/assist/grab_cut.h"
#include "core/assist/magic_wand.h"
#include "core/assist/scissors.h"
#include "core/assist/superpixels.h"
#include "core/map/overhead_tiles.h"

namespace {

using nadir::AssistWindow;

const Eigen::Vector2d kMiddle(-20.0, 15.0);

const nadir::OverheadTiles& town() {
  static const auto tiles =
      nadir::OverheadTiles::open(NADIR_MAP, nadir::OverheadTiles::Layer::kPicture);
  if (!tiles) throw std::runtime_error(tiles.error().message);
  return *tiles;
}

/// Around the middle of the bundled town, so many pixels on a side.
AssistWindow window_of_side(int side) {
  auto window =
      nadir::read_assist_window(town(), kMiddle, {side / 2.0 * town().metres_per_cell(), side});
  if (!window) throw std::runtime_error(window.error().message);
  return std::move(*window);
}

/// The inner three fifths.
nadir::Ring inner(const AssistWindow& window) {
  nadir::Ring ring;
  for (const auto& [x, y] : {std::pair(0.2, 0.2), {0.8, 0.2}, {0.8, 0.8}, {0.2, 0.8}}) {
    ring.push_back(window.enu_from_pixels() *
                   Eigen::Vector2d(x * window.width(), y * window.height()));
  }
  return ring;
}

void BM_ReadAssistWindow(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(window_of_side(static_cast<int>(state.range(0))));
}

void BM_MagicWand(benchmark::State& state) {
  const AssistWindow window = window_of_side(static_cast<int>(state.range(0)));
  const nadir::WandOptions options{.tolerance = 40.0, .fill_holes_m2 = 10.0};
  for (auto _ : state) benchmark::DoNotOptimize(magic_wand(window, kMiddle, options));
}

void BM_FindSuperpixels(benchmark::State& state) {
  const AssistWindow window = window_of_side(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(find_superpixels(window));
}

void BM_GrabCut(benchmark::State& state) {
  const AssistWindow window = window_of_side(static_cast<int>(state.range(0)));
  const nadir::GrabCutMarks marks{.around = inner(window)};
  for (auto _ : state) benchmark::DoNotOptimize(grab_cut(window, marks));
}

void BM_ScissorsBeginAtAPlace(benchmark::State& state) {
  const AssistWindow window = window_of_side(static_cast<int>(state.range(0)));
  auto scissors = nadir::Scissors::create(window);
  for (auto _ : state) benchmark::DoNotOptimize(scissors->begin_at(kMiddle));
}

/// What a hand that moves asks for once a frame.
void BM_ScissorsLineTo(benchmark::State& state) {
  const AssistWindow window = window_of_side(static_cast<int>(state.range(0)));
  auto scissors = nadir::Scissors::create(window);
  const auto begun = scissors->begin_at(kMiddle);
  if (!begun) return state.SkipWithError(begun.error().message.c_str());
  const nadir::Ring ring = inner(window);
  for (auto _ : state) benchmark::DoNotOptimize(scissors->line_to(ring[2]));
}

void BM_CellsOfAMask(benchmark::State& state) {
  const AssistWindow window = window_of_side(static_cast<int>(state.range(0)));
  const nadir::PixelMask mask(window.width(), window.height(), 1);
  const nadir::LabelGrid grid{town().metres_per_cell(), town().top_left_in_enu_m(), town().width(),
                              town().height()};
  for (auto _ : state) benchmark::DoNotOptimize(cells_of(window, mask, grid));
}

BENCHMARK(BM_ReadAssistWindow)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_MagicWand)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_FindSuperpixels)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_GrabCut)->Arg(256)->Arg(512)->Arg(1024)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ScissorsBeginAtAPlace)->Arg(256)->Arg(512)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ScissorsLineTo)->Arg(512)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_CellsOfAMask)->Arg(512)->Unit(benchmark::kMillisecond);

}  // namespace
