// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "widgets/canvas/canvas.h"
#include "widgets/gl/window_event.h"

struct GLFWwindow;

namespace nadir {

/// A window of the desktop with an OpenGL 3.3 core context: where OffscreenContext draws unseen, this one shows. VTK scenes
/// are drawn by the same RenderWindow in both, and a window's own drawing goes to frame buffer 0.
/// Windows belong to the main thread, all of them, as the operating systems want it.
class DesktopWindow {
 public:
  /// Opens a window of `width` x `height` points; its context is current, and swap() waits for the screen.
  /// @param title  UTF-8.
  /// @errors kUnsupported: no display, or no OpenGL 3.3 on it, in one sentence.
  [[nodiscard]] static Result<std::unique_ptr<DesktopWindow>> create(const std::string& title,
                                                                     int width,
                                                                     int height);

  /// Closes it. What was drawn with its context has to go first.
  ~DesktopWindow();
  DesktopWindow(const DesktopWindow&) = delete;
  DesktopWindow& operator=(const DesktopWindow&) = delete;

  /// For whoever gives it the pointer's shape and the clipboard (Dear ImGui's backend does). Valid as long as this.
  [[nodiscard]] GLFWwindow* handle() const;

  void make_current();
  /// Begins a frame in the window's own frame buffer, over a ground of one colour.
  void clear(Rgba ground);
  /// Shows what was drawn into frame buffer 0.
  void swap();
  /// Takes the input that has come, or waits for some, at most so many seconds; a window that redraws only on change
  /// lets the machine rest. Of all windows.
  static void poll_events();
  static void wait_events(double at_most_s);

  /// UTF-8.
  void set_title(const std::string& title);

  [[nodiscard]] bool should_close() const;
  void set_should_close(bool should_close);
  /// Nobody can see it: drawing is in vain.
  [[nodiscard]] bool is_minimised() const;
  /// Pixels of frame buffer 0: width, height. 0 while the window is minimised.
  [[nodiscard]] Eigen::Vector2i framebuffer_size() const;
  /// Size of text and widgets that this screen asks for: 1 is 96 dpi, 2 a screen of twice as many pixels.
  [[nodiscard]] double content_scale() const;
  /// What mouse and keys did since the last call, in the order in which it came. Each key that went down comes up again, also
  /// where the window has lost the keyboard meanwhile.
  [[nodiscard]] std::vector<WindowEvent> take_events();
  [[nodiscard]] bool has_events() const { return !events_.empty(); }
  /// Files that were dropped on the window since the last call, in their order.
  [[nodiscard]] std::vector<std::filesystem::path> take_dropped_files();

 private:
  class Library;
  DesktopWindow(std::shared_ptr<Library> library, GLFWwindow* window);
  [[nodiscard]] static DesktopWindow& of(GLFWwindow* window);
  void listen();
  std::shared_ptr<Library> library_;  ///< Before the window, which needs it to the end.
  GLFWwindow* window_;
  std::vector<WindowEvent> events_;
  std::vector<std::filesystem::path> dropped_;
};

}  // namespace nadir
