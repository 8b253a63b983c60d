// SPDX-License-Identifier: Apache-2.0
// What a frame of the labelling editor costs at 1280 x 800, drawn without a display and read back: from the edit of a document
// of 20,000 objects to the pixels that show it, and panning and zooming over the borders of all.
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "core/base/random.h"
#include "core/label/edit_paint.h"
#include "core/label/label_raster.h"
#include "widgets/gl/offscreen_renderer.h"
#include "widgets/views/label_borders_view.h"
#include "widgets/views/label_pictures.h"
#include "widgets/views/tile_pyramid_view.h"

namespace nadir {
namespace {

constexpr int kWidth = 1280;
constexpr int kHeight = 800;
constexpr double kCellM = 0.1;
constexpr int kColumns = 200;
constexpr int kRows = 100;
constexpr double kLotM = 10.0;

/// 20,000 lots with six corners each beside each other, on 20,000 x 10,000 cells.
LabelDocument lots() {
  LabelDocument document(*ProjectPlane::create({48.9877, 8.3877}),
                         LabelGrid{kCellM, {0.0, 0.0}, 20'000, 10'000});
  LabelEdit edit;
  for (int i = 0; i < kColumns * kRows; ++i) {
    const auto [u, v] = uniforms({.seed = 5, .particle = static_cast<std::uint32_t>(i)});
    const Eigen::Vector2d middle((i % kColumns + 0.5) * kLotM,
                                 -(static_cast<int>(i / kColumns) + 0.5) * kLotM);
    auto lot = std::make_shared<LabelObject>();
    lot->id = i + 1;
    lot->class_id = u < 0.5 ? kTerrain : kBuilding;
    lot->order = i;
    Ring ring;
    for (int corner = 0; corner < 6; ++corner) {
      const double angle = 1.0472 * corner + v;
      ring.emplace_back(middle +
                        (2.0 + 3.0 * u) * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    lot->rings = {ring};
    edit.objects.push_back({nullptr, std::move(lot)});
  }
  document.apply(edit);
  return document;
}

class EditorPage {
 public:
  EditorPage() : document(lots()), scene({1000.0, -500.0}) {
    auto made = OffscreenRenderer::create();
    if (!made) throw std::runtime_error(made.error().message);
    renderer_ = std::move(*made);
  }
  [[nodiscard]] std::shared_ptr<const LabelPictures> pictures() const {
    return std::make_shared<const LabelPictures>(std::make_shared<const LabelDocument>(document));
  }
  void draw(const MapCamera& camera) {
    scene.look({camera, 1.0 * kWidth, 1.0 * kHeight, 96.0 / 72.0});
    benchmark::DoNotOptimize(renderer_->render(scene.renderer(), kWidth, kHeight));
  }

  LabelDocument document;
  MapScene scene;

 private:
  std::unique_ptr<OffscreenRenderer> renderer_;
};

/// A stroke's edit, the document of the frame, its tiles and its pixels. Argument: radius of the brush in cells; cells a pixel.
void BM_FrameOfAStroke(benchmark::State& state) {
  EditorPage page;
  TilePyramidView view(page.scene, MapLayer::kLabels, page.pictures(), nullptr,
                       TileMaking::kInThread);
  const double radius_m = kCellM * static_cast<double>(state.range(0));
  const MapCamera camera{{1000.0, -500.0}, kCellM * static_cast<double>(state.range(1))};
  while (!view.update(camera, kWidth, kHeight, 100).value()) view.wait();
  page.draw(camera);
  std::uint32_t frame = 0;
  const LabelGrid& grid = page.document.grid();
  for (auto _ : state) {
    const double along_m = 20.0 * std::sin(0.1 * ++frame);
    const Ring path = {{1000.0 + along_m, -500.0}, {1001.0 + along_m, -501.0}};
    const LabelEdit edit = paint_stroke(
        page.document, path, radius_m, static_cast<PaintValue>(frame % 2 == 0 ? kRoad : kCurb), "");
    page.document.apply(edit);
    PlaneBounds bounds;
    for (const Eigen::Vector2d& place : path) bounds.include(place);
    bounds.grow(radius_m + grid.metres_per_cell);
    view.show(page.pictures());
    view.forget(bounds);
    if (!view.update(camera, kWidth, kHeight, 3).value()) state.SkipWithError("it comes later");
    page.draw(camera);
  }
}

/// The same frame where nothing has changed.
void BM_FrameOfLabels(benchmark::State& state) {
  EditorPage page;
  TilePyramidView view(page.scene, MapLayer::kLabels, page.pictures());
  const MapCamera camera{{1000.0, -500.0}, kCellM};
  (void)view.update(camera, kWidth, kHeight, 100).value();
  for (auto _ : state) {
    (void)view.update(camera, kWidth, kHeight, 3).value();
    page.draw(camera);
  }
}

/// All 20,000 are in sight, and the camera moves by some pixels a frame. Argument: percent of that width that is seen.
void BM_PanOverAllBorders(benchmark::State& state) {
  EditorPage page;
  LabelBordersView borders(page.scene);
  borders.show(std::make_shared<const LabelDocument>(page.document));
  const double seen_m = 2000.0 * static_cast<double>(state.range(0)) / 100.0;
  std::uint32_t frame = 0;
  for (auto _ : state) {
    const double angle = 0.05 * ++frame;
    page.draw({{1000.0 + 0.05 * seen_m * std::cos(angle), -500.0 + 0.05 * seen_m * std::sin(angle)},
               seen_m / kWidth});
  }
  state.counters["drawn"] = static_cast<double>(borders.times_drawn());
}

/// From all to a tenth and back, four percent a frame.
void BM_ZoomOverAllBorders(benchmark::State& state) {
  EditorPage page;
  LabelBordersView borders(page.scene);
  borders.show(std::make_shared<const LabelDocument>(page.document));
  std::uint32_t frame = 0;
  for (auto _ : state) {
    const int step = std::abs(static_cast<int>(++frame % 118) - 59);
    page.draw({{1000.0, -500.0}, 2000.0 / kWidth * std::pow(0.96, step)});
  }
  state.counters["drawn"] = static_cast<double>(borders.times_drawn());
}

BENCHMARK(BM_FrameOfLabels)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_FrameOfAStroke)
    ->Args({10, 1})
    ->Args({100, 1})
    ->Args({1000, 1})
    ->Args({1000, 3})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(BM_PanOverAllBorders)->Arg(100)->Arg(30)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ZoomOverAllBorders)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nadir
