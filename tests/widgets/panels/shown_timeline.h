// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "tests/widgets/panels/timeline_run.h"
#include "widgets/kit/headless_ui.h"
#include "widgets/panels/time_axis.h"
#include "widgets/panels/timeline.h"

namespace nadir {

/// A timeline on a screen, driven by hand; the model is the test's.
struct ShownTimeline {
  explicit ShownTimeline(TimelineModel shown, double scale = 1.0)
      : model(std::move(shown)), screen(ThemeName::kDark, scale, {1280.0, 700.0}) {
    asked = screen.wait(3, draw());
  }
  [[nodiscard]] std::function<Actions(kit::Ui&)> draw() {
    return [this](kit::Ui& ui) { return draw_timeline(ui, model, state); };
  }
  /// The axis as its own drawing has it: the ruler's area without the names and the margin.
  [[nodiscard]] TimeAxis axis() const {
    const kit::Rect ruler = screen.at("Timeline/Ruler").rect;
    TimeAxis found;
    const auto extent = model.extent();
    found.from_s = state.zoomed_to ? state.zoomed_to->from_s : extent.from_s;
    found.to_s = state.zoomed_to ? state.zoomed_to->to_s : extent.to_s;
    found.last_s = extent.last_s;
    const double scale = screen_scale;
    found.left_px = std::floor(ruler.left + std::floor(192.0 * scale + 0.5));
    found.width_px = std::floor(ruler.right() - std::floor(16.0 * scale + 0.5)) - found.left_px;
    return found;
  }
  /// Clicks at a pixel of the window's x in an area.
  Actions click_x(const std::string& path, double window_x) {
    const kit::Rect rect = screen.at(path).rect;
    return screen.click_at(path, window_x - rect.left, rect.height / 2.0, draw());
  }

  TimelineModel model;
  TimelineState state;
  kit::HeadlessUi screen;
  Actions asked;
  double screen_scale = 1.0;
};

}  // namespace nadir
