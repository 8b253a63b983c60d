// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "tests/widgets/panels/asked.h"
#include "widgets/kit/headless_ui.h"

namespace nadir {

/// A panel on a screen that nobody sees: its model, what its caller keeps for it, and a hand. `kDraw` is its draw function.
template <typename Model, typename State, auto kDraw>
struct Shown {
  explicit Shown(const Eigen::Vector2d& size_px = {1280.0, 800.0})
      : screen(ThemeName::kDark, 1.0, size_px) {}
  kit::HeadlessUi screen;
  Model model = {};
  State state = {};

  Actions operator()(kit::Ui& ui) { return kDraw(ui, model, state); }

  /// What a gesture asks for, by its words.
  std::vector<std::string> click(const std::string& path) {
    return texts(screen.click(path, *this));
  }
  std::vector<std::string> double_click(const std::string& path) {
    return texts(screen.double_click(path, *this));
  }
  std::vector<std::string> press(const std::string& chord) {
    return texts(screen.press(chord, *this));
  }
  /// @param with_enter  At the end.
  std::vector<std::string> type(const std::string& path,
                                const std::string& text,
                                bool with_enter = true) {
    return texts(screen.type(path, text, *this, with_enter));
  }
  std::vector<std::string> type_here(const std::string& text) {
    return texts(screen.type_here(text, *this));
  }
  std::vector<std::string> wait(int frames = 3) { return texts(screen.wait(frames, *this)); }

  /// Nothing lies outside of the window, or of the overlay of this path.
  [[nodiscard]] bool fits(const std::string& overlay = {}) {
    const Eigen::Vector2d size = screen.input().size_px;
    const kit::Rect frame =
        overlay.empty() ? kit::Rect{0.0, 0.0, size.x(), size.y()} : screen.at(overlay).rect;
    return std::all_of(
        screen.controls().begin(), screen.controls().end(), [&](const kit::Control& control) {
          return !control.is_visible || (control.rect.left >= frame.left - 1.0 &&
                                         control.rect.right() <= frame.right() + 1.0);
        });
  }
};

}  // namespace nadir
