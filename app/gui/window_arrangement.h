// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "widgets/kit/control.h"

namespace nadir {

enum class WindowSide { kLeft, kRight };

/// What is to be shown in a window, and how large. Lengths are those of the design, but for the window's own.
struct WindowWishes {
  double width_px = 0.0, height_px = 0.0;
  double scale = 1.0;     ///< Pixels for one of the design.
  bool has_frame = true;  ///< Menu and rail.
  bool has_left = false, has_right = false, has_timeline = false, has_status = false;
  double left_pt = 0.0, right_pt = 0.0, timeline_pt = 0.0;
  WindowSide front = WindowSide::kRight;  ///< Column that stays where there is no room for both.
};

/// Where everything is, in whole pixels. A rectangle without width or height is not shown. Nothing overlaps, and all but the
/// columns' strips and what is not shown fills the window.
struct WindowPlaces {
  kit::Rect menu, rail, left, map, right, timeline, status;
  /// In place of a column that there is no room for: narrow, with a button for each of its panels.
  kit::Rect left_strip, right_strip;
  double most_left_px = 0.0, most_right_px = 0.0, most_timeline_px = 0.0;  ///< For splitters.
};

/// A column is not made narrower by hand, nor the timeline lower.
inline constexpr double kLeastColumn = 180.0, kLeastTimeline = 64.0;
inline constexpr double kColumnStrip = 36.0;

/// Where the window is too small for all that is wished, columns and timeline give way down to what is still useful, then the
/// map, then one column becomes a strip, in the end both, and in a window of a hand's size there is only the map.
[[nodiscard]] WindowPlaces arrange_window(const WindowWishes& wishes);

}  // namespace nadir
