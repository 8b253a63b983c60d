// SPDX-License-Identifier: Apache-2.0
#include "core/session/map_parts.h"

namespace nadir {

bool is_ground_layer(Layer layer) {
  switch (layer) {
    case Layer::kPicture:
    case Layer::kLabels:
    case Layer::kReconstruction:
    case Layer::kErrorSurface:
    case Layer::kTopview:
    case Layer::kDisagreement:
    case Layer::kParticles:
      return true;
    case Layer::kOdometry:
    case Layer::kTruth:
    case Layer::kEstimate:
    case Layer::kEllipses:
    case Layer::kModes:
    case Layer::kGraticule:
    case Layer::kLegend:
      break;
  }
  return false;
}

bool is_in_sight(const MapLook& look, Layer layer) {
  return look.layer(layer).is_visible && look.layer(layer).opacity > 0.0;
}

std::vector<MapPart> map_parts(const MapLook& look) {
  std::vector<MapPart> parts;
  for (const Layer layer : look.order) {
    if (layer == Layer::kLegend || !is_in_sight(look, layer)) continue;
    const bool is_ground = is_ground_layer(layer);
    if (parts.empty() || parts.back().is_ground != is_ground) {
      MapPart part;
      part.is_ground = is_ground;
      parts.push_back(part);
    }
    parts.back().layers.push_back(layer);
  }
  return parts;
}

bool is_ground_below_lines(const MapLook& look) {
  const auto shows = [&look](Layer layer) {
    return look.layer(layer).is_visible && look.layer(layer).opacity > 0.3;
  };
  return shows(Layer::kPicture) || shows(Layer::kLabels);
}

}  // namespace nadir
