// SPDX-License-Identifier: Apache-2.0
#include "core/session/map_stack.h"

#include <gmock/gmock.h>

#include "core/session/map_parts.h"
#include "tests/support/error_text.h"

namespace nadir {
namespace map_stack_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Hidden, turned around, half clear and coloured.
MapLook made_look() {
  MapLook look = default_map_look();
  look.layer(Layer::kOdometry).is_visible = false;
  look.layer(Layer::kParticles).opacity = 0.0;
  look.layer(Layer::kLabels) = {true, 0.35, std::nullopt};
  look.layer(Layer::kTruth) = {true, 0.5, "#FF8800"};
  look.order = {Layer::kTruth,    Layer::kPicture,       Layer::kTopview,      Layer::kLabels,
                Layer::kEstimate, Layer::kEllipses,      Layer::kModes,        Layer::kParticles,
                Layer::kOdometry, Layer::kDisagreement,  Layer::kErrorSurface, Layer::kGraticule,
                Layer::kLegend,   Layer::kReconstruction};
  return look;
}

TEST(MapStack, IsWhatALookHasInSightFromTheGroundUp) {
  EXPECT_EQ(MapStack::of(made_look()).text(),
            "truth:0.5#FF8800,picture,topview:0.8,labels:0.35,estimate,ellipses,modes");
}

TEST(MapStack, IsTheSameAfterItsText) {
  MapLook none = default_map_look();
  for (LayerLook& layer : none.layers) layer.is_visible = false;
  MapLook fine = made_look();
  fine.layer(Layer::kTopview).opacity = 1.0 / 3.0;
  for (const MapStack& stack :
       {MapStack{}, MapStack::of(made_look()), MapStack::of(default_map_look()), MapStack::of(none),
        MapStack::of(fine)}) {
    const auto again = MapStack::from_text(stack.text());
    ASSERT_TRUE(again) << error_text(again);
    EXPECT_EQ(*again, stack) << stack.text();
  }
  EXPECT_EQ(MapStack{}.text(), "own");
  EXPECT_EQ(MapStack::of(none).text(), "none");
}

TEST(MapStack, LaidOnALookGivesTheSameSight) {
  const MapLook look = MapStack::of(made_look()).laid_on(default_map_look());
  EXPECT_EQ(MapStack::of(look), MapStack::of(made_look()));
  EXPECT_EQ(map_parts(look), map_parts(made_look()));
  EXPECT_EQ(look.order.size(), kLayerCount);
  EXPECT_EQ(look.order.back(), Layer::kLegend);
}

TEST(MapStack, HasEllipsesAndModesInTheLookOfAHiddenEstimate) {
  const auto told = [](const MapLook& look) { return MapStack::of(look).text(); };
  MapLook look = default_map_look();
  for (LayerLook& layer : look.layers) layer.is_visible = false;
  look.layer(Layer::kEllipses) = {true, 0.5, std::nullopt};
  look.layer(Layer::kModes) = {true, 1.0, "#00FF00"};
  look.layer(Layer::kEstimate) = {false, 0.5, "#FF8800"};
  EXPECT_EQ(told(look), "ellipses:0.25#FF8800,modes#00FF00");
  EXPECT_EQ(told(MapStack::of(look).laid_on(look)), told(look)) << "not twice as pale";
  look.layer(Layer::kEstimate).is_visible = true;
  EXPECT_EQ(told(look), "estimate:0.5#FF8800,ellipses:0.5,modes#00FF00") << "who draws them knows";
  look.layer(Layer::kEstimate).opacity = 0.0;
  EXPECT_EQ(told(look), "modes#00FF00") << "they cannot be seen either";
}

TEST(MapStack, HasColoursOfLinesOnly) {
  MapLook look = default_map_look();
  for (LayerLook& layer : look.layers) layer.colour = "#FF8800";
  look.layer(Layer::kGraticule).is_visible = true;
  EXPECT_EQ(MapStack::of(look).text(),
            "picture,topview:0.8,particles,odometry#FF8800,truth#FF8800,estimate#FF8800,"
            "ellipses#FF8800,modes#FF8800,graticule#FF8800");
  for (const char* layer : {"picture", "labels", "topview", "disagreement", "particles"}) {
    const auto refused = MapStack::from_text(std::string(layer) + "#FF8800");
    ASSERT_FALSE(refused) << layer;
    EXPECT_EQ(refused.error().message, std::string(layer) + " is no line and takes no colour");
  }
}

TEST(MapStack, LeavesALookAsItIsWhereNobodyHasChosen) {
  EXPECT_EQ(MapStack{}.laid_on(made_look()), made_look());
  EXPECT_FALSE(MapStack{}.has(Layer::kPicture));
}

TEST(MapStack, PutsWhatIsHiddenWhereItWillBeSeenOnceItIsShown) {
  const auto stack = MapStack::from_text("particles,picture,truth");
  ASSERT_TRUE(stack) << error_text(stack);
  const std::vector<Layer> order = stack->laid_on(default_map_look()).order;
  const auto place = [&order](Layer layer) {
    return std::find(order.begin(), order.end(), layer) - order.begin();
  };
  EXPECT_EQ(place(Layer::kLabels), place(Layer::kPicture) + 1) << "as it does by default";
  EXPECT_EQ(place(Layer::kEstimate), place(Layer::kTruth) + 1);
  EXPECT_LT(place(Layer::kParticles), place(Layer::kPicture));
}

TEST(MapStack, SaysWhatIsWrongWithItsText) {
  const auto fault = [](std::string_view text) {
    const auto refused = MapStack::from_text(text);
    return refused ? std::string("nothing") : refused.error().message;
  };
  EXPECT_EQ(fault("picture,partikles"),
            "'partikles' is no layer of a map (did you mean particles?)");
  EXPECT_THAT(fault("legend"), HasSubstr("'legend' is no layer of a map"));
  EXPECT_THAT(fault(""), HasSubstr("'' is no layer"));
  EXPECT_THAT(fault("picture,"), HasSubstr("'' is no layer"));
  for (const char* opacity : {"2", "-0.1", "nan", "", "half", "0.5x"}) {
    EXPECT_EQ(fault(std::string("truth:") + opacity),
              "'" + std::string(opacity) + "' is no opacity in [0, 1]");
  }
  EXPECT_EQ(fault("truth#12"), "'#12' is no colour: write #RRGGBB");
  EXPECT_EQ(fault("truth:1#GGGGGG"), "'#GGGGGG' is no colour: write #RRGGBB");
  EXPECT_EQ(fault("topview,truth,topview:0.5"), "topview is named twice");
}

}  // namespace map_stack_test
}  // namespace nadir
