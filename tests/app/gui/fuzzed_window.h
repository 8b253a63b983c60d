// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "app/gui/gui_shell.h"
#include "tests/app/gui/fuzz_words.h"
#include "widgets/kit/ui_context.h"
#include "widgets/kit/ui_renderer.h"

namespace nadir {

/// The whole window, unseen, in the hands of somebody without a plan. The OpenGL context that it is made with must be current
/// for all of its life.
class FuzzedWindow {
 public:
  /// @param trail  File that what was done is written into at once, so that it is known also after a crash: lines of a
  /// script as far as a script can do them.
  /// @errors what the window throws; std::runtime_error where OpenGL cannot draw it.
  FuzzedWindow(GuiRequest request, std::filesystem::path trail);
  ~FuzzedWindow();
  FuzzedWindow(const FuzzedWindow&) = delete;
  FuzzedWindow& operator=(const FuzzedWindow&) = delete;

  /// Does one thing and draws what comes of it. @returns what is wrong afterwards; empty: nothing.
  [[nodiscard]] std::string do_something(FuzzWords& words);
  /// Does an action, as a script's line has it, and draws a frame.
  void act(const std::string& line);
  /// Does several without a frame between.
  void act_at_once(const std::vector<std::string>& lines);
  void draw(int frames);
  /// Draws until nothing is being read or computed any more. @returns whether that came about.
  bool settle(double most_s);

  [[nodiscard]] Session& session() { return shell_->session(); }
  /// Names of actions that were asked for by their words.
  [[nodiscard]] const std::vector<std::string>& asked() const { return asked_; }
  /// Names of those that were done and did not fail.
  [[nodiscard]] const std::vector<std::string>& done() const { return done_; }
  /// Why the last action that failed did; empty: none has.
  [[nodiscard]] const std::string& last_refusal() const { return last_refusal_; }
  [[nodiscard]] double longest_frame_s() const { return longest_frame_s_; }

 private:
  void frame();
  void note(const std::string& line);
  /// Whether a button, or Enter, writes into a folder that was gone to by hand: that may be any of the disk's.
  [[nodiscard]] bool would_write(const std::string& path);
  [[nodiscard]] kit::Control some_control(FuzzWords& words) const;
  void use_mouse(FuzzWords& words);
  void use_keys(FuzzWords& words);
  void resize(FuzzWords& words);
  [[nodiscard]] std::string fault_of_controls() const;
  [[nodiscard]] std::string leave_and_come_back();

  GuiRequest request_;
  std::ofstream trail_;
  kit::UiContext context_;
  kit::FrameInput input_;
  std::unique_ptr<kit::UiRenderer> renderer_;
  std::unique_ptr<GuiShell> shell_;
  std::vector<std::string> asked_, done_;
  std::string last_refusal_;
  double longest_frame_s_ = 0.0;
  int frames_ = 0;
};

}  // namespace nadir
