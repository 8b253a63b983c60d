// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>

#include <cmath>
#include <vector>

#include "core/base/angle.h"
#include "tests/widgets/panels/made_moment.h"
#include "widgets/kit/headless_ui.h"
#include "widgets/panels/map_view.h"

namespace nadir {

/// The view with somebody who does what it asks for, as Session would.
class ShownMap : public ::testing::Test {
 protected:
  static constexpr const char* kGround = "Map/Ground";

  ShownMap() { model.look.layer(Layer::kLegend).is_visible = false; }

  auto drawing() {
    return [this](kit::Ui& ui) {
      Actions asked = draw_map_view(ui, model, state);
      for (const Action& action : asked) apply(action);
      return asked;
    };
  }
  void apply(const Action& action) {
    MapLook& look = model.look;
    if (const auto* at = std::get_if<actions::LookAt>(&action)) {
      look.centre_in_enu_m = {at->east_m, at->north_m};
      if (at->width_m) look.width_m = *at->width_m;
      look.is_following = false;
    } else if (const auto* zoom = std::get_if<actions::Zoom>(&action)) {
      if (zoom->east_m) {
        const Eigen::Vector2d stays(*zoom->east_m, *zoom->north_m);
        look.centre_in_enu_m = stays + (look.centre_in_enu_m - stays) / zoom->factor;
      }
      look.width_m /= zoom->factor;
    } else if (const auto* turn = std::get_if<actions::Rotate>(&action)) {
      look.up_rad = wrap_rad(look.up_rad - Angle::degrees(turn->angle_deg).radians());
      look.up = MapUp::kFree;
    } else if (const auto* point = std::get_if<actions::MeasurePoint>(&action)) {
      if (point->east_m) {
        look.measured_in_enu_m.emplace_back(*point->east_m, *point->north_m);
      } else {
        look.measured_in_enu_m.clear();
      }
    } else if (const auto* tool = std::get_if<actions::UseTool>(&action)) {
      look.tool = tool->tool;
    } else if (const auto* particle = std::get_if<actions::SelectParticle>(&action)) {
      model.selected_particle = particle->index;
    }
  }
  /// Place of the ground at a point of the area, counted from its upper left corner.
  Eigen::Vector2d ground_at(double x, double y) {
    return state.camera.enu_from_page({x, screen.at(kGround).rect.height - y}, state.where);
  }
  /// Place of the ground in the middle of the pixel of the window that the mouse is on.
  Eigen::Vector2d ground_below(const Eigen::Vector2d& mouse_px) {
    const kit::Rect area = screen.at(kGround).rect;
    return ground_at(std::floor(mouse_px.x()) + 0.5 - area.left,
                     std::floor(mouse_px.y()) + 0.5 - area.top);
  }
  void show() { screen.wait(2, drawing()); }

  MadeMoment made;
  MapViewModel model = made.map_view();
  MapViewState state;
  kit::HeadlessUi screen;
};

}  // namespace nadir
