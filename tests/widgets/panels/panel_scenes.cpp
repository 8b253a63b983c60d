// SPDX-License-Identifier: Apache-2.0
#include "tests/widgets/panels/panel_scenes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <stdexcept>

#include "tests/widgets/panels/panel_scene_parts.h"

namespace nadir {
namespace {

/// Sizes and texts take a few frames to settle.
constexpr int kFramesToRest = 6;

/// What the controls that a picture is of cover together, a pixel more on each side.
kit::Rect covered(const std::vector<kit::Control>& controls, kit::ControlKind kind) {
  std::optional<kit::Rect> all;
  for (const kit::Control& control : controls) {
    if (control.kind != kind) continue;
    const kit::Rect& one = control.rect;
    if (!all) all = one;
    const double left = std::min(all->left, one.left), top = std::min(all->top, one.top);
    all = kit::Rect{left, top, std::max(all->right(), one.right()) - left,
                    std::max(all->bottom(), one.bottom()) - top};
  }
  if (!all) throw std::logic_error("nothing lies over the window");
  return {all->left - 1.0, all->top - 1.0, all->width + 2.0, all->height + 2.0};
}

Raster<Rgba> cut_out(const Raster<Rgba>& picture, const kit::Rect& rect) {
  const auto inside = [](double value, int most) {
    return std::clamp(static_cast<int>(std::lround(value)), 0, most);
  };
  const int left = inside(rect.left, picture.width()), top = inside(rect.top, picture.height());
  const int right = inside(rect.right(), picture.width());
  const int bottom = inside(rect.bottom(), picture.height());
  Raster<Rgba> part(right - left, bottom - top);
  for (int row = 0; row < part.height(); ++row) {
    for (int column = 0; column < part.width(); ++column) {
      part.at(column, row) = picture.at(left + column, top + row);
    }
  }
  return part;
}

}  // namespace

std::vector<PanelScene> panel_scenes() {
  ::setenv("TZ", "UTC", 1);  // files say when they were changed
  ::tzset();
  std::vector<PanelScene> all;
  scenes::add_window_scenes(all);
  scenes::add_file_scenes(all);
  scenes::add_flight_scenes(all);
  scenes::add_empty_scenes(all);
  scenes::add_label_scenes(all);
  return all;
}

std::vector<PanelLook> panel_looks() {
  return {{ThemeName::kDark, 1.0},
          {ThemeName::kDark, 1.5},
          {ThemeName::kLight, 1.0},
          {ThemeName::kLight, 1.5}};
}

SeenScene see(const PanelScene& scene, const PanelLook& look, UiCamera& camera) {
  kit::UiContext context(look.theme, look.scale);
  context.set_motion_reduced(true);
  kit::FrameInput input;
  input.size_px = (scene.size_pt * look.scale).array().floor();
  const auto draw = [&](int frames) {
    for (int i = 0; i < frames; ++i) {
      scene.draw(context.begin_frame(input));
      context.end_frame();
    }
  };
  draw(kFramesToRest);
  if (!scene.pressed.empty()) {
    const auto& controls = context.controls();
    const auto pressed =
        std::find_if(controls.begin(), controls.end(),
                     [&](const kit::Control& control) { return control.path == scene.pressed; });
    if (pressed == controls.end()) throw std::logic_error("nothing to press: " + scene.pressed);
    input.mouse_px = pressed->rect.centre();
    draw(1);
    input.buttons[0] = true;
    draw(1);
    input.buttons[0] = false;
    draw(kFramesToRest);
  }
  SeenScene seen;
  seen.picture = camera.picture_of(context);
  seen.controls = context.controls();
  if (!scene.is_over_window) {
    seen.cut_out = seen.picture;
  } else {
    const bool has_overlay =
        std::any_of(seen.controls.begin(), seen.controls.end(),
                    [](const kit::Control& one) { return one.kind == kit::ControlKind::kOverlay; });
    seen.cut_out =
        cut_out(seen.picture, covered(seen.controls, has_overlay ? kit::ControlKind::kOverlay
                                                                 : kit::ControlKind::kNotice));
  }
  return seen;
}

}  // namespace nadir
