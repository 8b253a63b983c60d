// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "widgets/panels/map_view.h"

namespace nadir {

/// What lies over the map as controls: the quiet column of tools at the upper left, and cards at the upper right that say
/// what was measured and what the selected particle is. @param map  Their map's place in the window.
[[nodiscard]] Actions draw_map_tools(kit::Ui& ui, const MapViewModel& model, const kit::Rect& map);
[[nodiscard]] Actions draw_map_cards(kit::Ui& ui, const MapViewModel& model, const kit::Rect& map);
/// What the tools cover along the left border, pixels.
[[nodiscard]] double map_tools_width(const kit::Ui& ui);
/// The place of a map without what they cover; of a split one that is the whole of it, for only its left half has tools.
[[nodiscard]] kit::Rect beside_map_tools(const kit::Ui& ui, const kit::Rect& map);
/// What a click of the right button on the map opens. Call it after the area was made.
[[nodiscard]] Actions draw_map_menu(kit::Ui& ui,
                                    const std::string& name,
                                    const MapViewModel& model,
                                    const Eigen::Vector2d& point_in_enu_m);

/// The selected particle, where the step has it.
[[nodiscard]] std::optional<std::size_t> selected_particle(const MapViewModel& model);

}  // namespace nadir
