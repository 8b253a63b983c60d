// SPDX-License-Identifier: Apache-2.0
// The window without a display: for scripts, screenshots and tests.
#include <fmt/format.h>

#include <chrono>
#include <fstream>
#include <iterator>

#include "app/gui/gui_script.h"
#include "app/gui/gui_shell.h"
#include "core/base/staged_output.h"
#include "widgets/canvas/png_file.h"
#include "widgets/gl/offscreen_context.h"
#include "widgets/kit/headless_ui.h"
#include "widgets/kit/ui_renderer.h"

namespace nadir {
namespace {

using Clock = std::chrono::steady_clock;

Result<std::string> read_script(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return fail(ErrorCode::kNotFound, "{}: cannot be read", path.string());
  return std::string(std::istreambuf_iterator<char>(file), {});
}

/// Screen, hand, and frame buffer.
class UnseenStage {
 public:
  explicit UnseenStage(const GuiRequest& request)
      : screen_(ThemeName::kDark, 1.0, {1.0 * request.width, 1.0 * request.height}),
        shell_(request, [this](const std::string& text) { screen_.context().set_clipboard(text); }),
        stage_{shell_.session(), screen_, [this](kit::Ui& ui) { draw(ui); },
               [this] { return !shell_.is_busy(); },
               [this](const std::filesystem::path& file) { return photograph(file); }} {
    screen_.leave_out_region();
    screen_.context().set_motion_reduced(true);  // pictures must not depend on when they are taken
    dress();
  }

  /// @errors kUnsupported: OpenGL cannot draw it.
  Result<void> begin() {
    auto renderer = kit::UiRenderer::create(screen_.context());
    if (!renderer) return forward_error(renderer);
    renderer_ = std::move(*renderer);
    return {};
  }

  ScriptStage& stage() { return stage_; }
  [[nodiscard]] std::vector<Error> failures() const { return shell_.failures(); }

 private:
  void dress() { screen_.context().set_look(shell_.theme_name(), shell_.scale(1.0)); }

  void draw(kit::Ui& ui) {
    const auto now = Clock::now();
    shell_.frame(ui, std::chrono::duration<double>(now - last_).count());
    last_ = now;
  }

  Result<void> photograph(const std::filesystem::path& file) {
    dress();
    // Fonts and sizes take a frame to settle, textures another.
    screen_.wait(2, stage_.draw);
    const auto pixels = renderer_->draw_to_pixels();
    if (!pixels) return forward_error(pixels, file.string());
    return write_text_file(file, encode_png(*pixels));
  }

  kit::HeadlessUi screen_;
  std::unique_ptr<kit::UiRenderer> renderer_;
  GuiShell shell_;
  ScriptStage stage_;
  Clock::time_point last_ = Clock::now();
};

}  // namespace

Result<void> run_gui_unseen(const GuiRequest& request,
                            const std::function<void(const Error&)>& not_opened) {
  std::string script;
  if (request.script) {
    auto read = read_script(*request.script);
    if (!read) return forward_error(read);
    script = std::move(*read);
  }
  auto context = OffscreenContext::create();
  if (!context) return forward_error(context);
  UnseenStage unseen(request);
  if (auto begun = unseen.begin(); !begun) return begun;
  ScriptStage& stage = unseen.stage();
  const ScriptLine rest{1, "wait", {"wait"}};
  if (auto opened = run_script_line(rest, stage); !opened) return opened;
  if (!request.files.empty() || !request.labels.empty()) {
    for (const Error& failure : unseen.failures()) not_opened(failure);
  }
  if (request.script) {
    if (auto done = run_gui_script(script, request.script->string(), stage); !done) return done;
    if (auto ended = run_script_line(rest, stage); !ended) return ended;
  }
  return request.screenshot ? stage.photograph(*request.screenshot) : Result<void>();
}

}  // namespace nadir
