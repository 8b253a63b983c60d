// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace nadir {

/// One thing that a hand did to a window.
struct WindowEvent {
  enum class Kind {
    kMouse,      ///< Moved to `at`, or (not `is_down`) left the window.
    kButton,     ///< Of the mouse, went down or up.
    kWheel,      ///< Turned by `at` notches.
    kKey,        ///< Went down or up; what is held repeats nothing.
    kCharacter,  ///< Was typed.
  };
  Kind kind = Kind::kMouse;
  /// Key as GLFW names it, which is ASCII for what can be printed; button: 0 left, 1 right, 2 middle; Unicode of a character.
  int code = 0;
  bool is_down = false;
  /// Place in the window's points, x right, y down from the upper left corner; notches to the right and away from the user.
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
};

}  // namespace nadir
