// SPDX-License-Identifier: Apache-2.0
// The window on the desktop.
#include <algorithm>
#include <chrono>
#include <string>

#include "app/gui/gui_shell.h"
#include "widgets/gl/desktop_window.h"
#include "widgets/kit/desktop_input.h"
#include "widgets/kit/ui_context.h"
#include "widgets/kit/ui_renderer.h"

namespace nadir {
namespace {

using Clock = std::chrono::steady_clock;

/// While nothing moves the window sleeps until there is input; this often it looks at files that grow.
constexpr double kLongestSleepS = 0.5;
/// While work goes on in the background: often enough for its progress, seldom enough to leave it the processor.
constexpr double kSleepWhileWorkingS = 0.05;
/// After input a few frames follow each other, for what opens and settles.
constexpr int kFramesAfterInput = 3;

std::string title_of(const Session& session) {
  const OpenRun* const run = session.active_run();
  return run != nullptr ? run->name + " - Nadir" : "Nadir";
}

}  // namespace

Result<void> run_desktop_gui(const GuiRequest& request) {
  auto window = DesktopWindow::create("Nadir", request.width, request.height);
  if (!window) return forward_error(window);
  kit::UiContext context;
  kit::DesktopInput input(context, (*window)->handle());
  auto renderer = kit::UiRenderer::create(context);
  if (!renderer) return forward_error(renderer);
  GuiShell shell(request, [&context](const std::string& text) { context.set_clipboard(text); });
  std::string title;
  auto last = Clock::now();
  int frames_to_draw = kFramesAfterInput;
  while (!shell.wants_to_quit()) {
    double sleep_s = std::min(kLongestSleepS, context.next_frame_within_s());
    if (shell.is_busy()) sleep_s = std::min(sleep_s, kSleepWhileWorkingS);
    if (shell.is_moving() || frames_to_draw > 0) sleep_s = 0.0;
    if (sleep_s > 0.0) {
      const auto slept = Clock::now();
      DesktopWindow::wait_events(sleep_s);
      const double waited_s = std::chrono::duration<double>(Clock::now() - slept).count();
      if (waited_s < sleep_s) frames_to_draw = kFramesAfterInput;
    } else {
      DesktopWindow::poll_events();
      frames_to_draw = std::max(0, frames_to_draw - 1);
    }
    for (const auto& file : (*window)->take_dropped_files()) {
      shell.session().apply(actions::OpenFile{file.string()});
      frames_to_draw = kFramesAfterInput;
    }
    if ((*window)->should_close()) {
      (*window)->set_should_close(false);
      shell.session().apply(actions::Quit{});
    }
    context.set_look(shell.theme_name(), shell.scale((*window)->content_scale()));
    context.set_motion_reduced(shell.session().view().appearance.is_motion_reduced);
    const auto now = Clock::now();
    const kit::FrameInput taken = input.take();
    const bool is_minimised = (*window)->framebuffer_size().minCoeff() <= 0;
    if (is_minimised) {
      DesktopWindow::wait_events(kLongestSleepS);
      continue;
    }
    kit::Ui& ui = context.begin_frame(taken);
    shell.frame(ui, std::chrono::duration<double>(now - last).count());
    last = now;
    context.end_frame();
    (*window)->clear(theme(shell.theme_name()).window);
    (*renderer)->draw();
    (*window)->swap();
    if (const std::string wanted = title_of(shell.session()); wanted != title) {
      title = wanted;
      (*window)->set_title(title);
    }
  }
  return {};
}

}  // namespace nadir
