// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/ground_layers.h"

#include "core/session/map_parts.h"

namespace nadir {
namespace {

// Both count from the ground up, and begin with what is drawn as pictures.
static_assert(static_cast<int>(Layer::kPicture) == static_cast<int>(MapLayer::kPicture));
static_assert(static_cast<int>(Layer::kLabels) == static_cast<int>(MapLayer::kLabels));
static_assert(static_cast<int>(Layer::kReconstruction) ==
              static_cast<int>(MapLayer::kReconstruction));
static_assert(static_cast<int>(Layer::kErrorSurface) == static_cast<int>(MapLayer::kSurface));
static_assert(static_cast<int>(Layer::kTopview) == static_cast<int>(MapLayer::kTopview));
static_assert(static_cast<int>(Layer::kDisagreement) == static_cast<int>(MapLayer::kAgreement));
static_assert(static_cast<int>(Layer::kParticles) == static_cast<int>(MapLayer::kParticles));

}  // namespace

std::vector<MapLayer> scene_layers(std::span<const Layer> layers,
                                   const MapLook& look,
                                   bool has_picture) {
  const bool has_labels = is_in_sight(look, Layer::kLabels);
  std::vector<MapLayer> made;
  for (const Layer layer : layers) {
    if (!is_ground_layer(layer)) continue;
    if (layer == Layer::kLabels && !has_picture && !has_labels) continue;
    if (layer == Layer::kPicture && !has_picture) {
      if (!has_labels) made.push_back(MapLayer::kLabels);
    } else {
      made.push_back(static_cast<MapLayer>(layer));
    }
  }
  return made;
}

bool shows_labels(const MapLook& look, bool has_picture) {
  return is_in_sight(look, Layer::kLabels) || (!has_picture && is_in_sight(look, Layer::kPicture));
}

double labels_opacity(const MapLook& look, bool has_picture) {
  const bool are_in_their_own_place = has_picture || is_in_sight(look, Layer::kLabels);
  return look.layer(are_in_their_own_place ? Layer::kLabels : Layer::kPicture).opacity;
}

}  // namespace nadir
