// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/session/view_state.h"

namespace nadir {

/// The map from the ground up: which of its layers are pictures and which are lines, for either may lie on the other.

/// Whether a layer is a picture of the ground, made of pixels; the rest are lines.
[[nodiscard]] bool is_ground_layer(Layer layer);
/// Whether a layer is shown and can be seen at all.
[[nodiscard]] bool is_in_sight(const MapLook& look, Layer layer);

/// Whether lines lie on a picture or labels, strong enough to be drawn as over imagery.
[[nodiscard]] bool is_ground_below_lines(const MapLook& look);

/// Layers that follow each other in the map's order and are drawn the same way.
struct MapPart {
  bool is_ground = false;
  std::vector<Layer> layers;  ///< From below; at least one.
  friend bool operator==(const MapPart&, const MapPart&) = default;
};

/// What is in sight, from below, without the legend, which lies above all.
[[nodiscard]] std::vector<MapPart> map_parts(const MapLook& look);

}  // namespace nadir
