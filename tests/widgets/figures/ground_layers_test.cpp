// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/ground_layers.h"

#include <gmock/gmock.h>

namespace nadir {
namespace ground_layers_test {

using ::testing::ElementsAre;

MapLook look_of(double picture, double labels) {
  MapLook look = default_map_look();
  look.layer(Layer::kPicture) = {picture > 0.0, picture, std::nullopt};
  look.layer(Layer::kLabels) = {labels > 0.0, labels, std::nullopt};
  return look;
}

TEST(GroundLayers, HaveLabelsInThePlaceOfAPictureThatThereIsNot) {
  const std::array both = {Layer::kPicture, Layer::kTruth, Layer::kLabels, Layer::kTopview};
  EXPECT_THAT(scene_layers(both, look_of(1.0, 1.0), true),
              ElementsAre(MapLayer::kPicture, MapLayer::kLabels, MapLayer::kTopview));
  EXPECT_THAT(scene_layers(both, look_of(1.0, 1.0), false),
              ElementsAre(MapLayer::kLabels, MapLayer::kTopview));
  EXPECT_THAT(scene_layers(both, look_of(1.0, 0.0), false),
              ElementsAre(MapLayer::kLabels, MapLayer::kTopview));
  EXPECT_TRUE(shows_labels(look_of(1.0, 0.0), false));
  EXPECT_FALSE(shows_labels(look_of(1.0, 0.0), true));
  EXPECT_FALSE(shows_labels(look_of(0.0, 0.0), false));
}

TEST(GroundLayers, HaveLabelsAsPaleAsTheLayerThatTheyAreShownAs) {
  EXPECT_EQ(labels_opacity(look_of(1.0, 0.4), true), 0.4);
  EXPECT_EQ(labels_opacity(look_of(1.0, 0.4), false), 0.4) << "they are shown in their own place";
  EXPECT_EQ(labels_opacity(look_of(0.6, 0.0), false), 0.6);
  MapLook hidden = look_of(0.0, 0.4);
  hidden.layer(Layer::kPicture).opacity = 1.0;
  EXPECT_EQ(labels_opacity(hidden, false), 0.4) << "what is hidden does not count";
}

TEST(GroundLayers, AreBelowLinesWhereAPictureOrLabelsCanBeSeenWell) {
  EXPECT_TRUE(is_ground_below_lines(look_of(1.0, 0.0)));
  EXPECT_TRUE(is_ground_below_lines(look_of(0.1, 0.5)));
  EXPECT_FALSE(is_ground_below_lines(look_of(0.3, 0.3)));
  EXPECT_FALSE(is_ground_below_lines(look_of(0.0, 0.0)));
}

}  // namespace ground_layers_test
}  // namespace nadir
