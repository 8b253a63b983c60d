// SPDX-License-Identifier: Apache-2.0
#include "core/session/map_parts.h"

#include <gmock/gmock.h>

namespace nadir {
namespace map_parts_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

MapPart part(bool is_ground, std::vector<Layer> layers) {
  MapPart made;
  made.is_ground = is_ground;
  made.layers = std::move(layers);
  return made;
}

TEST(MapParts, OfANewWindowAreTheGroundAndTheLinesOnIt) {
  const MapLook look = default_map_look();
  EXPECT_THAT(map_parts(look),
              ElementsAre(part(true, {Layer::kPicture, Layer::kTopview, Layer::kParticles}),
                          part(false, {Layer::kOdometry, Layer::kTruth, Layer::kEstimate,
                                       Layer::kEllipses, Layer::kModes})));
}

TEST(MapParts, FollowTheOrderThatTheUserChose) {
  MapLook look = default_map_look();
  look.order = {Layer::kEstimate, Layer::kTopview, Layer::kPicture,
                Layer::kTruth,    Layer::kLegend,  Layer::kParticles};
  EXPECT_THAT(
      map_parts(look),
      ElementsAre(part(false, {Layer::kEstimate}), part(true, {Layer::kTopview, Layer::kPicture}),
                  part(false, {Layer::kTruth}), part(true, {Layer::kParticles})))
      << "the legend is none of them";
}

TEST(MapParts, LeaveOutWhatCannotBeSeen) {
  MapLook look = default_map_look();
  for (LayerLook& layer : look.layers) layer.is_visible = false;
  EXPECT_THAT(map_parts(look), IsEmpty());
  look.layer(Layer::kTruth).is_visible = true;
  look.layer(Layer::kEstimate).is_visible = true;
  look.layer(Layer::kTruth).opacity = 0.0;
  EXPECT_FALSE(is_in_sight(look, Layer::kTruth));
  EXPECT_THAT(map_parts(look), ElementsAre(part(false, {Layer::kEstimate})));
  // Lines that only a hidden ground lies between are one part.
  look.layer(Layer::kTruth).opacity = 0.1;
  look.order = {Layer::kTruth, Layer::kPicture, Layer::kEstimate};
  EXPECT_THAT(map_parts(look), ElementsAre(part(false, {Layer::kTruth, Layer::kEstimate})));
}

TEST(MapParts, AreEitherGroundOrLines) {
  for (const Layer layer :
       {Layer::kPicture, Layer::kLabels, Layer::kReconstruction, Layer::kErrorSurface,
        Layer::kTopview, Layer::kDisagreement, Layer::kParticles}) {
    EXPECT_TRUE(is_ground_layer(layer)) << enum_name(layer);
  }
  for (const Layer layer : {Layer::kOdometry, Layer::kTruth, Layer::kEstimate, Layer::kEllipses,
                            Layer::kModes, Layer::kGraticule}) {
    EXPECT_FALSE(is_ground_layer(layer)) << enum_name(layer);
  }
}

}  // namespace map_parts_test
}  // namespace nadir
