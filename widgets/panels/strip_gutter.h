// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "widgets/panels/strip_lines.h"

namespace nadir {

/// The values at the cursor that stand left of a strip, one a run, the active run's first.
struct GutterValues {
  struct Value {
    std::string text;
    int colour = 0;  ///< Of run_colour().
  };
  std::vector<Value> values;
  bool is_small = false;     ///< In small letters, for there is little room.
  std::size_t left_out = 0;  ///< Runs for which there was none.
};

/// What is measured and how far apart things stand; all in one unit.
struct GutterRoom {
  double width = 0.0;
  double swatch =
      0.0;  ///< Of the mark in the run's colour before a value, where there are several runs; its gap included.
  double gap = 0.0;  ///< Between two values.
  std::function<double(const std::string& text, bool is_small)> width_of;
};

/// As much as fits: whole values, else the main ones alone, else those in small letters, else those of the first runs.
/// @param runs  The active one is the last.
[[nodiscard]] GutterValues gutter_values(Strip strip,
                                         std::span<const TimelineRun> runs,
                                         double moment_s,
                                         const GutterRoom& room);

}  // namespace nadir
