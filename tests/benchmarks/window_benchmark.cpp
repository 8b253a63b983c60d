// SPDX-License-Identifier: Apache-2.0
// What a frame of the window costs, drawn without a display at 1280 x 800: everything from the models to the pixels.
// NADIR_BENCHMARK_RUN names a recorded run; without it one is made on the bundled map.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>

#include "app/gui/gui_shell.h"
#include "tests/support/scratch_folder.h"
#include "tests/widgets/figures/recorded_flight.h"
#include "widgets/gl/offscreen_context.h"
#include "widgets/kit/ui_context.h"
#include "widgets/kit/ui_renderer.h"

namespace nadir {
namespace {

constexpr double kFrameS = 1.0 / 60.0;

/// A window that nobody sees, with a run open.
class BenchedWindow {
 public:
  BenchedWindow() {
    context_ = std::move(*OffscreenContext::create());
    ui_ = std::make_unique<kit::UiContext>();
    renderer_ = std::move(*kit::UiRenderer::create(*ui_));
    GuiRequest request;
    request.places = {folder_.path() / "config", folder_.path() / "data", {}};
    const char* const named = std::getenv("NADIR_BENCHMARK_RUN");
    if (named != nullptr) {
      request.files = {std::filesystem::absolute(named).string()};
    } else {
      write_street(folder_.path() / "map");
      write_drive(folder_.path() / "run.nadir", folder_.path() / "map", 60);
      request.files = {(folder_.path() / "run.nadir").string()};
    }
    shell_ = std::make_unique<GuiShell>(request, [](const std::string&) {});
    for (int i = 0; i < 20'000 && (shell_->is_busy() || shell_->session().step() == nullptr); ++i) {
      draw();
    }
  }
  ~BenchedWindow() {
    shell_.reset();
    renderer_.reset();
  }

  Session& session() { return shell_->session(); }
  void draw() {
    kit::FrameInput input;
    input.size_px = {1280.0, 800.0};
    kit::Ui& ui = ui_->begin_frame(input);
    shell_->frame(ui, kFrameS);
    ui_->end_frame();
    benchmark::DoNotOptimize(renderer_->draw_to_pixels());
  }
  [[nodiscard]] double duration_s() {
    const OpenRun* const run = session().active_run();
    return run != nullptr && run->document ? run->document->duration_s() : 0.0;
  }

 private:
  ScratchFolder folder_;
  std::unique_ptr<OffscreenContext> context_;  // before what is drawn in it
  std::unique_ptr<kit::UiContext> ui_;
  std::unique_ptr<kit::UiRenderer> renderer_;
  std::unique_ptr<GuiShell> shell_;
};

/// Every frame shows another moment, as when somebody drags on the timeline from end to end and back.
void BM_Scrub(benchmark::State& state) {
  BenchedWindow window;
  const double length_s = window.duration_s();
  constexpr int kFramesAcross = 240;
  int frame = 0;
  std::int64_t shown = 0;
  for (auto _ : state) {
    const int place = std::abs((++frame % (2 * kFramesAcross)) - kFramesAcross);
    window.session().apply(actions::Seek{length_s * place / kFramesAcross});
    window.draw();
    shown += window.session().step() != nullptr ? 1 : 0;
  }
  state.SetItemsProcessed(frame);
  state.counters["decoded share"] = static_cast<double>(shown) / frame;
}
BENCHMARK(BM_Scrub)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The map is dragged; the moment stays.
void BM_Pan(benchmark::State& state) {
  BenchedWindow window;
  int frame = 0;
  for (auto _ : state) {
    window.session().apply(actions::Zoom{++frame % 2 == 0 ? 1.02 : 1.0 / 1.02, {}, {}});
    window.draw();
  }
  state.SetItemsProcessed(frame);
}
BENCHMARK(BM_Pan)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Nothing changes: what a tooltip that appears costs.
void BM_Still(benchmark::State& state) {
  BenchedWindow window;
  for (auto _ : state) window.draw();
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(BM_Still)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace nadir
