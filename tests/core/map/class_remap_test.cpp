// SPDX-License-Identifier: Apache-2.0
#include "core/map/class_remap.h"

#include <gmock/gmock.h>

#include "tests/support/error_text.h"

namespace nadir {
namespace class_remap_test {

using testing::ElementsAre;
using testing::HasSubstr;

ClassRemap remap_of(std::string_view text) {
  auto remap = ClassRemap::parse(text, "r.toml");
  EXPECT_TRUE(remap) << error_text(remap);
  return std::move(remap).value();
}

std::string fault_in(std::string_view text) {
  return error_text(ClassRemap::parse(text, "r.toml"));
}

TEST(ClassRemap, TakesListedIdsAndSendsTheRestToUnclassified) {
  const ClassRemap remap = remap_of("[ids]\n0 = \"terrain\"\n3 = \"Buildings\"\n");
  const Raster<std::uint8_t> source(5, 1, {0, 3, 1, 255, 3});
  EXPECT_THAT(remap.apply(source).values(),
              ElementsAre(kTerrain, kBuilding, kUnclassified, kUnclassified, kBuilding));
  EXPECT_EQ(remap.find_id(1), std::nullopt);
}

TEST(ClassRemap, HasADefaultForWhatIsNotListed) {
  const ClassRemap remap = remap_of("unknown = \"terrain\"\n[ids]\n7 = \"road\"\n");
  const Raster<std::uint8_t> source(3, 1, {7, 8, 255});
  EXPECT_THAT(remap.apply(source).values(), ElementsAre(kRoad, kTerrain, kTerrain));
}

TEST(ClassRemap, FindsNamesWhateverTheirSpelling) {
  const ClassRemap remap = remap_of("[classes]\n\"Guard Rail\" = \"railing\"\n");
  EXPECT_EQ(remap.find_name("guard-rails"), kRailing);
  EXPECT_EQ(remap.find_name("guard"), std::nullopt);
}

TEST(ClassRemap, TurnsNamesIntoTheIdsOfASource) {
  const ClassRemap remap = remap_of("[classes]\nCurb = \"curb\"\n[ids]\n2 = \"fence\"\n");
  const std::vector<std::string> names{"Bird", "Curb", "Curb"};
  const Raster<std::uint8_t> source(4, 1, {0, 1, 2, 3});
  EXPECT_THAT(remap.with_names(names).apply(source).values(),
              ElementsAre(kUnclassified, kCurb, kFence, kUnclassified));
}

TEST(ClassRemap, RefusesATargetThatIsNoClassAndNamesTheNearest) {
  EXPECT_EQ(fault_in("[classes]\nBarrier = \"raling\"\n"),
            "r.toml: classes: \"Barrier\" becomes \"raling\", which is no class (did you mean "
            "railing?)");
  EXPECT_THAT(fault_in("unknown = \"qqqqqqqq\"\n[ids]\n1 = \"road\"\n"), HasSubstr("no class"));
}

TEST(ClassRemap, RefusesIdsThatNoByteHolds) {
  for (const char* id : {"256", "-1", "one", "1x"}) {
    EXPECT_THAT(fault_in(fmt::format("[ids]\n{} = \"road\"\n", id)), HasSubstr("is no id")) << id;
  }
}

TEST(ClassRemap, RefusesAFileThatListsNothingOrSomethingElse) {
  EXPECT_THAT(fault_in(""), HasSubstr("r.toml: lists no class"));
  EXPECT_THAT(fault_in("[clases]\nx = \"road\"\n"),
              HasSubstr("clases is no known key (did you mean classes?)"));
  EXPECT_THAT(fault_in("[ids]\n3 = 4\n"), HasSubstr("3 is not a text"));
  EXPECT_THAT(fault_in("ids = 3\n"), HasSubstr("is not a table"));
}

TEST(ClassRemap, SaysThatAFileIsMissing) {
  const auto remap = ClassRemap::read("no/such/remap.toml");
  ASSERT_FALSE(remap);
  EXPECT_EQ(error_code(remap), ErrorCode::kNotFound);
}

TEST(BundledRemaps, OfVistasMergeAsTheThesisDoes) {
  const auto remap = ClassRemap::read(NADIR_SOURCE_DIR "/resources/remaps/mapillary-vistas.toml");
  ASSERT_TRUE(remap) << error_text(remap);
  EXPECT_EQ(remap->find_name("Lane Marking - Crosswalk"), kLaneMarking);
  EXPECT_EQ(remap->find_name("Crosswalk - Plain"), kRoad);
  EXPECT_EQ(remap->find_name("Traffic Sign (Back)"), kTrafficSign);
  EXPECT_EQ(remap->find_name("Guard Rail"), kRailing);
  EXPECT_EQ(remap->find_name("Other Rider"), kPedestrian);
  EXPECT_EQ(remap->find_name("Ego Vehicle"), std::nullopt);
  EXPECT_EQ(remap->unknown(), kUnclassified);
}

TEST(BundledRemaps, OfTheDrawnTownKnowItsFourClasses) {
  const auto remap = ClassRemap::read(NADIR_SOURCE_DIR "/resources/remaps/kitti00-drawn.toml");
  ASSERT_TRUE(remap) << error_text(remap);
  EXPECT_EQ(remap->find_id(0), kTerrain);
  EXPECT_EQ(remap->find_id(1), kRoad);
  EXPECT_EQ(remap->find_id(2), std::nullopt);
  EXPECT_EQ(remap->find_id(3), kBuilding);
  EXPECT_EQ(remap->find_id(4), kVegetation);
}

}  // namespace class_remap_test
}  // namespace nadir
