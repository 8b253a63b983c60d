// SPDX-License-Identifier: Apache-2.0
// What the mouse does on a map.
#include <algorithm>
#include <cmath>

#include "widgets/panels/map_pane.h"

namespace nadir {
namespace {

constexpr double kMapZoomPerNotch = 1.25;
constexpr double kTurnDeg = 15.0;  ///< Of one press of R.
constexpr double kLeastMetresPerPx = 1e-3, kMostMetresPerPx = 1e4;
constexpr double kPickParticlePx = 14.0;  ///< Of the design: how near a click must be.

}  // namespace

void MapPaneView::look_at(const Eigen::Vector2d& centre_in_enu_m,
                          std::optional<double> metres_per_px) {
  std::optional<double> width_m;
  if (metres_per_px || model_.look.width_m <= 0.0) {
    width_m = metres_per_px.value_or(camera_.metres_per_px) * where_.width;
  }
  asked_.emplace_back(actions::LookAt{centre_in_enu_m.x(), centre_in_enu_m.y(), width_m});
}

bool MapPaneView::shows_active_run() const {
  return std::any_of(model_.runs.begin(), model_.runs.end(), [this](const MapRun& run) {
    return run.is_active &&
           std::find(pane_.shown.begin(), pane_.shown.end(), run.number) != pane_.shown.end();
  });
}

std::optional<int> MapPaneView::particle_under_mouse() const {
  if (!model_.step || !model_.step->particles || !shows_active_run()) return std::nullopt;
  return nearest_particle(*model_.step->particles, camera_, where_, middle_of_pixel(area_.mouse),
                          ui_.px(kPickParticlePx));
}

void MapPaneView::handle_gestures() {
  if (area_.is_hovered) {
    state_.readout = map_readout(under_mouse(), model_.map ? &model_.map->map() : nullptr,
                                 model_.plane ? &*model_.plane : nullptr);
    if (area_.wheel.y() != 0.0) zoom_by_wheel();
    if (ui_.is_pressed("R", true)) asked_.emplace_back(actions::Rotate{kTurnDeg});
    if (ui_.is_pressed("Shift+R", true)) asked_.emplace_back(actions::Rotate{-kTurnDeg});
  }
  drag();
  if (area_.clicked == kit::MouseButton::kRight) state_.menu_in_enu_m = under_mouse();
  if (area_.double_clicked == kit::MouseButton::kLeft) {
    if (model_.look.tool == MapTool::kMeasure) {
      asked_.emplace_back(
          actions::UseTool{MapTool::kPan});  // its first click has set the last place
    } else {
      look_at(under_mouse());
    }
  } else if (area_.clicked == kit::MouseButton::kLeft) {
    click();
  }
}

void MapPaneView::zoom_by_wheel() { zoom(std::pow(kMapZoomPerNotch, area_.wheel.y())); }

void MapPaneView::zoom(double factor) {
  const double metres_per_px = camera_.metres_per_px / factor;
  if (metres_per_px < kLeastMetresPerPx || metres_per_px > kMostMetresPerPx) return;
  if (model_.look.width_m <= 0.0) {  // nobody has chosen one yet that could be multiplied
    look_at(zoomed_at(camera_, factor, middle_of_pixel(area_.mouse), where_).centre_in_enu_m,
            metres_per_px);
    return;
  }
  if (model_.look.is_following) {  // the estimate stays in the middle
    asked_.emplace_back(actions::Zoom{factor, {}, {}});
    return;
  }
  const Eigen::Vector2d stays = under_mouse();
  asked_.emplace_back(actions::Zoom{factor, stays.x(), stays.y()});
}

void MapPaneView::drag() {
  const bool pans = area_.drag && area_.drag->button != kit::MouseButton::kRight;
  if (!pans && state_.grabbing_pane == pane_.name) state_.grabbing_pane.clear();
  if (!area_.drag || area_.drag->delta.isZero()) return;
  if (!pans) {
    const double angle_deg = turned_deg(area_.mouse - area_.drag->delta, area_.mouse, where_);
    if (angle_deg != 0.0) asked_.emplace_back(actions::Rotate{angle_deg});
    return;
  }
  // What was under the mouse stays under it, however long the way.
  if (area_.drag->was_started || state_.grabbing_pane != pane_.name) {
    state_.grabbing_pane = pane_.name;
    state_.grabbed_in_enu_m = camera_.enu_from_page(middle_of_pixel(area_.drag->start), where_);
  }
  look_at(with_ground_at(camera_, state_.grabbed_in_enu_m, middle_of_pixel(area_.mouse), where_)
              .centre_in_enu_m);
}

void MapPaneView::click() {
  if (model_.look.tool == MapTool::kMeasure) {
    const Eigen::Vector2d place = under_mouse();
    asked_.emplace_back(actions::MeasurePoint{place.x(), place.y()});
  }
  if (model_.look.tool == MapTool::kPick) {
    const auto picked = particle_under_mouse();
    if (picked != model_.selected_particle) asked_.emplace_back(actions::SelectParticle{picked});
  }
}

}  // namespace nadir
