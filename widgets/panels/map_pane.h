// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "widgets/panels/map_view.h"
#include "widgets/panels/picture_area.h"
#include "widgets/views/map_overlays.h"

namespace nadir {

/// One map: the only one, or one of two beside each other.
struct MapPane {
  std::string name;  ///< Of its area.
  std::vector<int>
      shown;  ///< Numbers of the runs on it; the last one's particles lie on the ground.
  Eigen::Vector2d size;
  bool is_main = true;   ///< False: the second of two.
  bool is_half = false;  ///< One of two, which say what they show.
};

/// Draws a pane and understands what the mouse does on it, for one frame.
class MapPaneView {
 public:
  MapPaneView(kit::Ui& ui, const MapViewModel& model, MapViewState& state, MapPane pane)
      : ui_(ui), model_(model), state_(state), pane_(std::move(pane)) {}

  [[nodiscard]] Actions draw();

 private:
  void look_at(const Eigen::Vector2d& centre_in_enu_m, std::optional<double> metres_per_px = {});
  [[nodiscard]] Eigen::Vector2d under_mouse() const {
    return camera_.enu_from_page(middle_of_pixel(area_.mouse), where_);
  }
  /// Whether the particles that can be picked are those of this pane.
  [[nodiscard]] bool shows_active_run() const;
  [[nodiscard]] std::optional<int> particle_under_mouse() const;

  // map_gestures.cpp
  void handle_gestures();
  void zoom(double factor);
  void zoom_by_wheel();
  void drag();
  void click();

  // label_pane.cpp
  void handle_label_gestures();
  void draw_label_content();

  void draw_content();
  void draw_ground(const MapGround& ground);
  void draw_doings(const MapFrame& frame);
  void draw_furniture(const MapFrame& frame);
  void point_to_vehicle(const MapFrame& frame);
  void name_bookmark();

  kit::Ui& ui_;
  const MapViewModel& model_;
  MapViewState& state_;
  MapPane pane_;
  kit::AreaInput area_;
  PageRect where_;
  MapCamera camera_;
  Actions asked_;
};

}  // namespace nadir
