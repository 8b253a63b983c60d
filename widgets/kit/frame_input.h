// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "widgets/kit/chord.h"

namespace nadir::kit {

enum class MouseButton { kLeft, kRight, kMiddle };

/// All that one frame is told from outside: by a window's events, by a script, by a test. State, not events: a button that
/// is held down is `true` in every frame.
struct FrameInput {
  Eigen::Vector2d size_px = {
      1280.0, 800.0};  ///< Of the window, in the pixels that rectangles and the mouse count.
  double framebuffer_scale =
      1.0;  ///< Pixels of the frame buffer for one of those; not 1 on some Wayland and Mac screens.
  double delta_s = 1.0 / 60.0;              ///< Since the last frame; more than 0.
  std::optional<Eigen::Vector2d> mouse_px;  ///< None: outside of the window.
  std::array<bool, 3> buttons = {};         ///< Held down, by MouseButton.
  Eigen::Vector2d wheel =
      Eigen::Vector2d::Zero();  ///< Notches since the last frame: right, away from the user.
  std::vector<Key> keys;        ///< Held down; of the modifiers only `modifiers` speaks.
  std::string characters;       ///< Typed since the last frame, UTF-8.
  Modifiers modifiers;
  [[nodiscard]] bool is_down(MouseButton button) const {
    return buttons.at(static_cast<std::size_t>(button));
  }
};

}  // namespace nadir::kit
