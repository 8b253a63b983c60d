// SPDX-License-Identifier: Apache-2.0
#include "core/map/semantic_classes.h"

#include <gmock/gmock.h>

#include <set>

namespace nadir {
namespace semantic_classes_test {

TEST(SemanticClasses, HaveTheNamesAndColoursOfThePalette) {
  EXPECT_EQ(class_info(kRoad).name, "road");
  EXPECT_EQ(class_info(kRoad).colour, (Colour{128, 64, 128}));
  EXPECT_EQ(class_info(kLaneMarking).name, "lane marking");
  EXPECT_EQ(class_info(kStreetLight).colour, (Colour{190, 140, 220}));
}

TEST(SemanticClasses, HaveSixteenDifferentNamesAndColours) {
  std::set<std::string_view> names;
  std::set<int> colours;
  for (int id = 0; id < kClassCount; ++id) {
    const ClassInfo& info = class_info(static_cast<ClassId>(id));
    names.insert(info.name);
    colours.insert(info.colour.red * 65536 + info.colour.green * 256 + info.colour.blue);
  }
  EXPECT_EQ(names.size(), 16U);
  EXPECT_EQ(colours.size(), 16U);
}

TEST(SemanticClasses, CallEveryOtherIdUnclassifiedAndBlack) {
  for (const int id : {16, 100, 254, 255}) {
    EXPECT_EQ(class_info(static_cast<ClassId>(id)).name, "unclassified");
    EXPECT_EQ(class_info(static_cast<ClassId>(id)).colour, Colour{});
  }
}

TEST(SemanticClasses, AreFoundByTheirOwnName) {
  for (int id = 0; id < kClassCount; ++id) {
    EXPECT_EQ(class_from_name(class_info(static_cast<ClassId>(id)).name), id);
  }
  EXPECT_EQ(class_from_name("unclassified"), kUnclassified);
  EXPECT_EQ(class_from_name("Void"), kUnclassified);
}

TEST(SemanticClasses, AreFoundWhateverTheCaseTheSeparatorsAndThePlural) {
  for (const char* name :
       {"Lane Markings", "lane-marking", "LANE_MARKING", "lanemarking", "LaneMarkings"}) {
    EXPECT_EQ(class_from_name(name), kLaneMarking) << name;
  }
  EXPECT_EQ(class_from_name("buildings"), kBuilding);
}

TEST(SemanticClasses, AreNotFoundByAnyOtherName) {
  for (const char* name : {"", "s", "sea", "road1", "class0", "roads and more"}) {
    EXPECT_EQ(class_from_name(name), std::nullopt) << name;
  }
}

TEST(SemanticClasses, SkyLiesInNoOverheadAndNeitherDoesWhatIsNoClass) {
  EXPECT_FALSE(can_lie_in_overhead(kSky));
  EXPECT_FALSE(can_lie_in_overhead(kUnclassified));
  EXPECT_TRUE(can_lie_in_overhead(kCurb));
  EXPECT_TRUE(is_movable(kCar) && is_movable(kPedestrian));
  EXPECT_FALSE(is_movable(kPole));
}

TEST(DrawingLevel, PutsMarkingsOnRoadsOnTerrainAndNoClassAboveAll) {
  EXPECT_LT(drawing_level(kTerrain), drawing_level(kRoad));
  EXPECT_LT(drawing_level(kRoad), drawing_level(kCurb));
  EXPECT_LT(drawing_level(kCurb), drawing_level(kLaneMarking));
  EXPECT_LT(drawing_level(kLaneMarking), drawing_level(kPole));
  EXPECT_EQ(drawing_level(kUnclassified), kClassCount);
}

TEST(DrawingLevel, IsAnotherForEveryClass) {
  std::set<int> levels;
  for (int id = 0; id < kClassCount; ++id) levels.insert(drawing_level(static_cast<ClassId>(id)));
  EXPECT_EQ(levels.size(), 16U);
  EXPECT_EQ(*levels.begin(), 0);
  EXPECT_EQ(*levels.rbegin(), 15);
}

}  // namespace semantic_classes_test
}  // namespace nadir
