// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <set>
#include <vector>

#include "app/gui/effect_runner.h"
#include "app/gui/gui_window.h"
#include "app/gui/run_gui.h"
#include "core/session/session.h"

namespace nadir {

/// What a window on the desktop and one that nobody sees have in common: a session, what is drawn of it, and the work that
/// it asks for. The OpenGL context that is drawn with must be current for all of its life.
class GuiShell {
 public:
  GuiShell(const GuiRequest& request, std::function<void(const std::string&)> clipboard);
  ~GuiShell();
  GuiShell(const GuiShell&) = delete;
  GuiShell& operator=(const GuiShell&) = delete;

  [[nodiscard]] Session& session() { return session_; }
  /// What has failed since the window was opened, as notices of errors tell it: of a window that nobody has touched yet, why
  /// files could not be opened. What libraries said beside is not among it.
  [[nodiscard]] std::vector<Error> failures() const;
  /// Goes on with all that goes on, without drawing: of a window that nobody can see. @param elapsed_s  Since the last one, or
  /// frame.
  void poll(double elapsed_s);
  /// The same, and draws one frame.
  void frame(kit::Ui& ui, double elapsed_s);
  [[nodiscard]] bool wants_to_quit() const { return effects_.wants_to_quit(); }
  /// Whether something moves or grows by itself, so that the next frame must follow soon.
  [[nodiscard]] bool is_busy() const;
  /// Whether the very next frame shows something else: playing, tiles that come in.
  [[nodiscard]] bool is_moving() const;
  [[nodiscard]] ThemeName theme_name() const;
  /// @param screen_scale  The screen's own, for those who have chosen none.
  [[nodiscard]] double scale(double screen_scale) const;

 private:
  class LogTap;
  double asked_scale_;
  bool is_first_frame_ = true;
  Session session_;
  std::set<int> said_by_libraries_;  ///< Numbers of those notices.
  EffectRunner effects_;
  GuiWindow window_;
  std::unique_ptr<LogTap> log_;  ///< VTK's and other libraries' complaints become notices.
};

}  // namespace nadir
