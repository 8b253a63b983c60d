// SPDX-License-Identifier: Apache-2.0
// The window on the desktop.
#include <chrono>
#include <string>
#include <utility>

#include "app/gui/frame_pace.h"
#include "app/gui/gui_shell.h"
#include "widgets/canvas/printable.h"
#include "widgets/gl/desktop_window.h"
#include "widgets/kit/desktop_input.h"
#include "widgets/kit/ui_context.h"
#include "widgets/kit/ui_renderer.h"

namespace nadir {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point moment) {
  return std::chrono::duration<double>(Clock::now() - moment).count();
}

/// Waits for input as long as the pace allows, or takes what has come.
void take_events(DesktopWindow& window, FramePace& pace, double sleep_s) {
  const Eigen::Vector2i before = window.framebuffer_size();
  bool has_woken = false;
  if (sleep_s > 0.0) {
    const auto slept = Clock::now();
    DesktopWindow::wait_events(sleep_s);
    has_woken = seconds_since(slept) < sleep_s;
  } else {
    DesktopWindow::poll_events();
  }
  if (has_woken || window.has_events() || window.framebuffer_size() != before) pace.hear();
}

std::string title_of(const Session& session) {
  const OpenRun* const run = session.active_run();
  return run != nullptr ? run->name + " - Nadir" : "Nadir";
}

}  // namespace

Result<void> run_desktop_gui(const GuiRequest& request) {
  auto window = DesktopWindow::create("Nadir", request.width, request.height);
  if (!window) return forward_error(window);
  kit::UiContext context;
  kit::DesktopInput input(context, **window);
  auto renderer = kit::UiRenderer::create(context);
  if (!renderer) return forward_error(renderer);
  GuiShell shell(request, [&context](const std::string& text) { context.set_clipboard(text); });
  std::string title;
  auto last = Clock::now();
  FramePace pace;
  while (!shell.wants_to_quit()) {
    const FramePace::Doings doings{shell.is_moving(), shell.is_busy(), input.is_waiting(),
                                   !(*window)->is_minimised(), context.next_frame_within_s()};
    take_events(**window, pace, pace.sleep_s(doings));
    for (const auto& file : (*window)->take_dropped_files()) {
      shell.session().apply(actions::OpenFile{file.string()});
      pace.hear();
    }
    if ((*window)->should_close()) {
      (*window)->set_should_close(false);
      shell.session().apply(actions::Quit{});
    }
    const double elapsed_s = seconds_since(std::exchange(last, Clock::now()));
    if ((*window)->is_minimised()) {
      shell.poll(elapsed_s);
      continue;
    }
    const kit::FrameInput taken = input.take();
    if (input.is_waiting()) pace.hear();
    const double own_scale = interface_scale((*window)->content_scale(), taken.framebuffer_scale);
    context.set_look(shell.theme_name(), shell.scale(own_scale));
    context.set_motion_reduced(shell.session().view().appearance.is_motion_reduced);
    kit::Ui& ui = context.begin_frame(taken);
    shell.frame(ui, elapsed_s);
    context.end_frame();
    pace.draw();
    (*window)->clear(theme(shell.theme_name()).window);
    (*renderer)->draw();
    (*window)->swap();
    if (const std::string wanted = title_of(shell.session()); wanted != title) {
      title = wanted;
      (*window)->set_title(printable(title));
    }
  }
  return {};
}

}  // namespace nadir
