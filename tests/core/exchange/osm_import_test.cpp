// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "core/exchange/source_features.h"
#include "core/label/label_raster.h"
#include "tests/core/exchange/import_sources.h"

namespace nadir {
namespace osm_import_test {

using testing::HasSubstr;
using testing::IsEmpty;

const std::string kCorners = node(1, 0, 0) + node(2, 1, 0) + node(3, 1, 1) + node(4, 0, 1);
const ImportTags kWood{{"natural", "wood"}};
const ImportTags kStreet{{"highway", "residential"}};

TEST(OsmImport, TakesStreetsHousesAndTrees) {
  const Imported found = import_osm(
      kCorners + way(1, {1, 2}, kStreet) + way(2, {1, 2, 3, 4, 1}, {{"building", "yes"}}) +
      "<node id='9' lat='49.0005' lon='8.0005'><tag k='natural' v='tree'/></node>\n");
  ASSERT_EQ(found.labels.taken, 3U);
  EXPECT_THAT(found.labels.notices, IsEmpty());
  EXPECT_EQ(found.object(0).kind, ObjectKind::kLine);
  EXPECT_EQ(found.object(0).width_m, 6.5);
  EXPECT_EQ(found.object(0).note, "way 1");
  EXPECT_NEAR((found.object(0).rings[0][1] - found.object(0).rings[0][0]).norm(), 111.2, 0.1);
  EXPECT_EQ(found.object(1).kind, ObjectKind::kOutline);
  EXPECT_EQ(found.object(1).rings[0].size(), 4U) << "its first place is not repeated";
  EXPECT_EQ(found.object(2).class_id, kVegetation);
  EXPECT_NEAR(area_of_ring(found.object(2).rings[0]), 3.14159 * 4.0, 0.01);
}

TEST(OsmImport, TakesWhatJosmHasNotUploadedAndLeavesWhatItDeleted) {
  const Imported found = import_osm(node(-1, 0, 0) + node(-2, 1, 0) + way(-7, {-1, -2}, kStreet) +
                                    "<way id='8' action='delete'><nd ref='-1'/><nd ref='-2'/>"
                                    "<tag k='highway' v='residential'/></way>\n");
  ASSERT_EQ(found.labels.taken, 1U);
  EXPECT_EQ(found.object(0).note, "way -7");
}

TEST(OsmImport, TakesAWayWithoutTheNodesThatItMisses) {
  const Imported found = import_osm(kCorners + way(1, {1, 77, 2, 78, 3}, kStreet) +
                                    way(2, {1, 79}, kStreet) + way(3, {1, 2, 3, 80, 4, 1}, kWood));
  ASSERT_EQ(found.labels.taken, 2U);
  EXPECT_EQ(found.object(0).rings[0].size(), 3U);
  EXPECT_EQ(found.object(1).rings[0].size(), 4U);
  EXPECT_THAT(found.notices(), HasSubstr("3 ways miss nodes and were taken without them"));
  EXPECT_THAT(found.notices(), HasSubstr("1 way has fewer than two places and was left out"));
}

TEST(OsmImport, ClosesARingWhoseGapIsUnderAMetre) {
  const Imported found =
      import_osm(kCorners + node(5, 0.001, 0) + node(6, 0.1, 0) + way(1, {1, 2, 3, 4, 5}, kWood) +
                 way(2, {1, 2, 3, 4, 6}, kWood));
  ASSERT_EQ(found.labels.taken, 1U);
  EXPECT_EQ(found.object(0).note, "way 1");
  EXPECT_THAT(found.notices(), HasSubstr("1 thing fits no rule")) << "11 m are no slip of a hand";
}

TEST(OsmImport, AssemblesAMultipolygonOfWaysInAnyDirection) {
  const std::string hole = node(5, 0.4, 0.4) + node(6, 0.6, 0.4) + node(7, 0.5, 0.6);
  const Imported found =
      import_osm(kCorners + hole + way(1, {1, 2, 3}) + way(2, {1, 4, 3}) + way(3, {5, 6, 7, 5}) +
                 relation(1, {{1, "outer"}, {2, "outer"}, {3, "inner"}},
                          {{"type", "multipolygon"}, {"landuse", "forest"}}));
  ASSERT_EQ(found.labels.taken, 1U);
  ASSERT_EQ(found.object(0).rings.size(), 2U);
  EXPECT_NEAR(area_of_ring(found.object(0).rings[0]), 111.2 * 73.1, 30.0);
  EXPECT_NEAR(area_of_ring(found.object(0).rings[1]), 111.2 * 73.1 * 0.02, 3.0);
}

TEST(OsmImport, TakesTagsOfTheOuterWayWhereTheMultipolygonHasNone) {
  const std::string hole = node(5, 0.4, 0.4) + node(6, 0.6, 0.4) + node(7, 0.5, 0.6);
  const Imported found =
      import_osm(kCorners + hole + way(1, {1, 2, 3, 4, 1}, kWood) + way(3, {5, 6, 7, 5}) +
                 relation(1, {{1, "outer"}, {3, "inner"}}, {{"type", "multipolygon"}}));
  ASSERT_EQ(found.labels.taken, 1U) << "the way by itself would fill the hole";
  EXPECT_EQ(found.object(0).rings.size(), 2U);
}

TEST(OsmImport, TakesAnIslandInAHoleAsAnAreaOfItsOwn) {
  std::string nodes;
  for (int i = 0; i < 3; ++i) {
    const double low = 0.2 * i;
    const double high = 1.0 - 0.2 * i;
    nodes += node(10 * i + 1, low, low) + node(10 * i + 2, high, low) +
             node(10 * i + 3, high, high) + node(10 * i + 4, low, high);
  }
  const Imported found = import_osm(nodes + way(1, {1, 2, 3, 4, 1}) + way(2, {11, 12, 13, 14, 11}) +
                                    way(3, {21, 22, 23, 24, 21}) +
                                    relation(1, {{1, "outer"}, {2, "inner"}, {3, "outer"}},
                                             {{"type", "multipolygon"}, {"natural", "wood"}}));
  ASSERT_EQ(found.labels.taken, 2U);
  EXPECT_EQ(found.object(0).rings.size(), 2U);
  EXPECT_EQ(found.object(1).rings.size(), 1U);
}

TEST(OsmImport, CountsMultipolygonsThatAreNotWhole) {
  const Imported found = import_osm(
      kCorners + way(1, {1, 2, 3}) + way(2, {1, 2, 3, 4, 1}) + way(9, {1, 2}, kStreet) +
      relation(1, {{1, "outer"}}, {{"type", "multipolygon"}, {"natural", "wood"}}) +
      relation(2, {{2, "outer"}, {99, "outer"}}, {{"type", "multipolygon"}, {"natural", "wood"}}));
  EXPECT_EQ(found.labels.taken, 2U) << "the street, and the ring that is whole";
  EXPECT_THAT(found.notices(),
              HasSubstr("2 multipolygons have open rings or lack members and were taken without"));
}

TEST(OsmImport, TakesLaneletsBetweenTheirBoundsHoweverTheyAreDrawn) {
  const ImportTags road{{"type", "lanelet"}, {"subtype", "road"}};
  for (const std::vector<int>& right : {std::vector<int>{4, 3}, std::vector<int>{3, 4}}) {
    const Imported found = import_osm(kCorners + way(1, {1, 2}, {{"type", "curbstone"}}) +
                                      way(2, right, {{"type", "virtual"}}) +
                                      relation(5, {{1, "left"}, {2, "right"}}, road));
    ASSERT_EQ(found.labels.taken, 2U);
    EXPECT_EQ(found.object(0).class_id, kRoad);
    EXPECT_NEAR(area_of_ring(found.object(0).rings[0]), 111.2 * 73.1, 30.0) << "it does not cross";
    EXPECT_EQ(found.object(1).class_id, kCurb);
  }
  const Imported torn = import_osm(kCorners + way(1, {1, 2}, {{"type", "curbstone"}}) +
                                   relation(5, {{1, "left"}, {2, "right"}}, road));
  EXPECT_THAT(torn.notices(), HasSubstr("1 lanelet lacks a bound and was left out"));
}

TEST(OsmImport, TakesSelfCrossingAreasByTheEvenOddRule) {
  const Imported found = import_osm(kCorners + way(1, {1, 3, 2, 4, 1}, kWood));
  ASSERT_EQ(found.labels.taken, 1U);
  EXPECT_THAT(found.notices(), HasSubstr("1 area crosses itself"));
  const Raster<ClassId> labels = rasterise(found.document);
  const auto cells = std::count(labels.values().begin(), labels.values().end(), kVegetation);
  EXPECT_NEAR(static_cast<double>(cells) * 0.25, 111.2 * 73.1 / 2.0, 40.0) << "two triangles";
}

TEST(OsmImport, UsesTheBoundsThatTheFileNames) {
  const ScratchFolder folder;
  const Imported found = import_all(folder.file(
      "map.osm",
      osm("<bounds minlat='49.0' minlon='8.0' maxlat='49.001' maxlon='8.002'/>\n" + kCorners +
          node(8, 5, 9) + node(9, 5, 10) + way(1, {1, 2, 8}, kStreet) + way(2, {8, 9}, kStreet))));
  EXPECT_NEAR(found.document.grid().width * 0.5, 146.2, 2.1);
  EXPECT_NEAR(found.document.grid().height * 0.5, 111.2, 2.1);
  EXPECT_EQ(found.labels.taken, 1U);
  EXPECT_THAT(found.notices(), HasSubstr("1 object lies outside of the map and was left out"));
}

TEST(OsmImport, RefusesInOneSentence) {
  const ScratchFolder folder;
  const auto complaint = [&](const std::string& name, const std::string& text) {
    const std::string said = error_text(ImportSource::read(folder.file(name, text)));
    EXPECT_THAT(said, testing::Not(HasSubstr("\n")));
    return said;
  };
  EXPECT_THAT(error_text(ImportSource::read(folder.path() / "none.osm")),
              HasSubstr("none.osm: no such file"));
  EXPECT_THAT(complaint("cut.osm", osm(kCorners).substr(0, 120)),
              HasSubstr("cut.osm: is no whole OpenStreetMap XML (line "));
  EXPECT_THAT(complaint("page.osm", "<html><body/></html>"), HasSubstr("which begins with <osm>"));
  EXPECT_THAT(complaint("empty.osm", ""), HasSubstr("empty.osm: is no whole OpenStreetMap XML"));
  EXPECT_THAT(complaint("laughs.osm",
                        "<!DOCTYPE osm [<!ENTITY a 'aaaa'><!ENTITY b '&a;&a;'>]><osm>&b;</osm>"),
              HasSubstr("laughs.osm: is no whole OpenStreetMap XML"));
  EXPECT_THAT(complaint("map.osm.bz2", "BZh91AY"), HasSubstr("unpack it first (bunzip2 -k)"));
  const auto nothing = ImportSource::read(folder.file("nothing.osm", osm(kCorners)));
  ASSERT_TRUE(nothing) << error_text(nothing);
  EXPECT_THAT(error_text(nothing->plan_document(bundled_rules("osm.toml"), {})),
              HasSubstr("nothing.osm: holds nothing that the rules take"));
}

TEST(OsmImport, RefusesWhatReachesAroundTheEarth) {
  const ScratchFolder folder;
  const auto source = ImportSource::read(
      folder.file("far.osm", osm(node(1, 0, 0) + node(2, 30000, 0) + way(1, {1, 2}, kStreet))));
  ASSERT_TRUE(source) << error_text(source);
  EXPECT_THAT(error_text(source->plan_document(bundled_rules("osm.toml"), {})),
              HasSubstr("km, which is no map"));
}

TEST(OsmImport, CanBeStoppedWhileWaysAreJoined) {
  const ScratchFolder folder;
  const std::filesystem::path path = folder.file(
      "map.osm", osm(node(1, 0, 0) + node(2, 0, 1) + way(1, {1, 2}, {{"highway", "service"}})));
  std::stop_source stop;
  std::vector<std::string> activities;
  WorkContext context;
  context.stop = stop.get_token();
  context.progress = [&](double, const std::string& activity) {
    if (activities.empty() || activities.back() != activity) activities.push_back(activity);
    if (activity == "reading") stop.request_stop();  // All has been read by then.
  };
  const auto stopped = ImportSource::read(path, {}, context);
  EXPECT_EQ(error_code(stopped), ErrorCode::kCancelled);
  EXPECT_THAT(error_text(stopped), HasSubstr("map.osm: cancelled"));
  stop = std::stop_source();
  context.stop = {};
  ASSERT_TRUE(ImportSource::read(path, {}, context));
  EXPECT_THAT(activities, testing::ElementsAre("reading", "joining"));
}

TEST(OsmImport, CountsNodesThatLieNowhere) {
  const Imported found = import_osm(
      kCorners + "<node id='7' lat='91' lon='8'/><node id='8' lat='x' lon='8'/><node id='9'/>\n" +
      way(1, {1, 7, 2}, kStreet));
  EXPECT_EQ(found.labels.taken, 1U);
  EXPECT_THAT(found.notices(),
              HasSubstr("3 elements have no number or no place on the Earth and were left out"));
  EXPECT_THAT(found.notices(), HasSubstr("1 way misses nodes"));
}

}  // namespace osm_import_test
}  // namespace nadir
