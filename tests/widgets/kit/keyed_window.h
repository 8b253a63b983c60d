// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "widgets/kit/headless_ui.h"

namespace nadir::kit {

/// Path of what has the keyboard; empty: the window.
[[nodiscard]] inline std::string focused(const HeadlessUi& screen) {
  for (const Control& control : screen.controls()) {
    if (control.is_focused) return control.path;
  }
  return {};
}

/// A screen, what it draws, and the shortcuts that came through to the window.
struct KeyedWindow {
  HeadlessUi screen;
  std::function<void(Ui&)> content;
  std::vector<std::string> shortcuts;
  void operator()(Ui& ui) {
    for (const char* const chord :
         {"Space", "Enter", "Left", "Right", "Up", "Down", "Home", "End", "Escape", "Tab"}) {
      if (ui.is_pressed(chord, true)) shortcuts.emplace_back(chord);
    }
    content(ui);
  }
  void press(const std::string& chord) {
    screen.press(chord, *this);
    screen.wait(2, *this);
  }
  void press_all(const std::vector<std::string>& chords) {
    for (const std::string& chord : chords) press(chord);
  }
};

}  // namespace nadir::kit
