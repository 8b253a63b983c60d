// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>

#include "tests/widgets/panels/panel_scenes.h"

/// What the scenes are put together from.
namespace nadir::scenes {

/// How a panel stands in its region.
enum class Room {
  kScrolled,  ///< As long as it wants to be.
  kFilled,    ///< As large as the region: pictures, bars.
  kBare,      ///< The same to the region's edges: the map.
};

/// A panel in a region that fills the window. @param draw  Takes Ui&, model and state.
template <typename Model, typename State, typename Draw>
[[nodiscard]] PanelScene panel(const std::string& name,
                               const std::string& header,
                               const Eigen::Vector2d& size_pt,
                               Room room,
                               Model model,
                               State state,
                               Draw draw) {
  // Some states can only be moved, and std::function wants copies.
  const auto kept = std::make_shared<State>(std::move(state));
  PanelScene scene;
  scene.name = name;
  scene.panels = {header};
  scene.size_pt = size_pt;
  scene.draw = [model = std::move(model), kept, draw, room](kit::Ui& ui) {
    kit::RegionStyle style;
    if (room == Room::kBare) style.padding = 0.0;
    const auto region = ui.region("Panel", ui.screen(), style);
    if (room != Room::kScrolled) {
      (void)draw(ui, model, *kept);
      return;
    }
    const auto content = ui.scroll_area("Content");
    (void)draw(ui, model, *kept);
  };
  return scene;
}

/// What lies over a window in which nothing else is.
template <typename Model, typename State, typename Draw>
[[nodiscard]] PanelScene overlay(const std::string& name,
                                 const std::string& header,
                                 const Eigen::Vector2d& window_pt,
                                 Model model,
                                 State state,
                                 Draw draw) {
  const auto kept = std::make_shared<State>(std::move(state));
  PanelScene scene;
  scene.name = name;
  scene.panels = {header};
  scene.size_pt = window_pt;
  scene.is_over_window = true;
  scene.draw = [model = std::move(model), kept, draw](kit::Ui& ui) {
    (void)draw(ui, model, *kept);
  };
  return scene;
}

/// For panels that keep nothing.
struct Nothing {};

/// Another state of a panel that has a scene already.
[[nodiscard]] inline PanelScene variant(PanelScene scene) {
  scene.is_variant = true;
  return scene;
}
/// A scene that says what is missing.
[[nodiscard]] inline PanelScene without_data(PanelScene scene) {
  scene.is_without_data = true;
  return scene;
}

/// What surrounds the map, and what lies over the window.
void add_window_scenes(std::vector<PanelScene>& scenes);
void add_label_scenes(std::vector<PanelScene>& scenes);
/// What asks for files.
void add_file_scenes(std::vector<PanelScene>& scenes);
/// What is seen of a flight.
void add_flight_scenes(std::vector<PanelScene>& scenes);
/// Both without what they are for.
void add_empty_scenes(std::vector<PanelScene>& scenes);

}  // namespace nadir::scenes
