// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/session/map_parts.h"
#include "core/session/view_state.h"
#include "widgets/views/map_scene.h"

namespace nadir {

// What a map's look means for its scene, in the window and in figures alike. In the place of a picture that there is not
// lie the labels, unless they are shown in their own.

/// Layers of a look as those of the scene, in their order; lines are passed over.
[[nodiscard]] std::vector<MapLayer> scene_layers(std::span<const Layer> layers,
                                                 const MapLook& look,
                                                 bool has_picture);
[[nodiscard]] bool shows_labels(const MapLook& look, bool has_picture);
[[nodiscard]] double labels_opacity(const MapLook& look, bool has_picture);

}  // namespace nadir
