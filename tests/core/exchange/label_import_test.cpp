// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/label_import.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "core/edit/polygon_algebra.h"
#include "core/label/label_raster.h"
#include "core/label/label_store.h"
#include "tests/core/exchange/import_sources.h"
#include "tests/core/label/drawn_labels.h"
#include "tests/support/drawn_map.h"

namespace nadir {
namespace label_import_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

/// One feature of a GeoJSON file. @param geometry  Its type and coordinates as JSON has them.
std::string feature(const std::string& type,
                    const std::string& coordinates,
                    const std::string& properties) {
  return fmt::format(
      R"({{"type":"Feature","properties":{{{}}},"geometry":{{"type":"{}","coordinates":{}}}}})",
      properties, type, coordinates);
}
std::string collection(const std::vector<std::string>& features) {
  std::string text;
  for (const std::string& one : features) text += (text.empty() ? "" : ",") + one;
  return R"({"type":"FeatureCollection","features":[)" + text + "]}";
}
const std::string kSquare = "[[[8,49],[8.001,49],[8.001,49.001],[8,49.001],[8,49]]]";

TEST(LabelImport, TakesTheClassThatGeoJsonNames) {
  const ScratchFolder folder;
  const Imported found = import_all(folder.file(
      "map.geojson",
      collection({feature("Polygon", kSquare, R"("class":"terrain")"),
                  feature("LineString", "[[8,49],[8.001,49.001]]", R"("class":"road","width_m":4)"),
                  feature("MultiPolygon", "[" + kSquare + "," + kSquare + "]",
                          R"("class":"building","kind":"outline","width_m":0.5)"),
                  feature("Point", "[8.0005,49.0005]", R"("class":"pole")"),
                  feature("Polygon", kSquare, R"("class":"lava")"),
                  feature("Polygon", "[]", R"("class":"road")")})));
  ASSERT_EQ(found.labels.taken, 5U);
  EXPECT_EQ(found.object(0).kind, ObjectKind::kArea);
  EXPECT_NEAR(area_of_ring(found.object(0).rings[0]), 111.2 * 73.1, 30.0);
  EXPECT_EQ(found.object(1).width_m, 4.0);
  EXPECT_EQ(found.object(3).kind, ObjectKind::kOutline);
  EXPECT_EQ(found.object(4).class_id, kPole);
  for (std::size_t i = 0; i < 4; ++i) {
    for (const Eigen::Vector2d& place : found.object(i).rings[0]) {
      EXPECT_EQ(place, on_lattice(place)) << "what snaps to it shares it";
    }
  }
  EXPECT_THAT(found.notices(), HasSubstr("1 thing fits no rule"));
  EXPECT_THAT(found.notices(), HasSubstr("1 feature has no geometry"));
}

TEST(LabelImport, CountsWhatHasTooFewPlacesOrLiesNowhere) {
  const ScratchFolder folder;
  const Imported found = import_all(folder.file(
      "map.geojson",
      collection({feature("Polygon", kSquare, R"("class":"terrain")"),
                  feature("Polygon", "[[[8,49],[8.001,49],[8,49]]]", R"("class":"road")"),
                  feature("Polygon", "[[[8,49],[8,49],[8,49],[8,49]]]", R"("class":"road")"),
                  feature("LineString", "[[8,49],[8,99]]", R"("class":"road","width_m":3)")})));
  EXPECT_EQ(found.labels.taken, 1U);
  EXPECT_THAT(found.notices(), HasSubstr("2 geometries have too few places"));
  EXPECT_THAT(found.notices(), HasSubstr("1 thing has coordinates that lie nowhere"));
}

TEST(LabelImport, ReprojectsOnceFromAnyReferenceSystem) {
  // The same square in UTM 32 N: 500 m east of its central meridian's 500,000 m at 49 N.
  const ScratchFolder folder;
  const std::string utm = "[[[500000,5427000],[500100,5427000],[500100,5427100],[500000,5427100]]]";
  const std::string text = collection({feature("Polygon", utm, R"("class":"terrain")")});
  const std::string named = R"({"type":"FeatureCollection","crs":{"type":"name","properties":)"
                            R"({"name":"urn:ogc:def:crs:EPSG::32632"}},)" +
                            text.substr(text.find("\"features\""));
  const Imported found = import_all(folder.file("utm.geojson", named));
  ASSERT_EQ(found.labels.taken, 1U);
  const double side_m = 100.0 / 0.9996;  // UTM's own scale on its central meridian.
  EXPECT_NEAR(area_of_ring(found.object(0).rings[0]), side_m * side_m, 0.01);
  const Geodetic corner = found.document.plane().geodetic_from_enu(found.object(0).rings[0][0]);
  EXPECT_NEAR(corner.longitude_deg, 9.0, 1e-9);
}

TEST(LabelImport, RefusesAFileWithoutReferenceSystemUnlessOneIsNamed) {
  const ScratchFolder folder;
  const LabelDocument document = document_of({area(kRoad, {box(1, 1, 9, 9)})});
  const fs::path labels = folder.path() / "labels.gpkg";
  ASSERT_TRUE(LabelStore::create(labels, document, "ada"));
  const Imported own = import_all(labels);
  EXPECT_EQ(own.labels.taken, 1U) << "a document's own layers can be read like any";

  folder.file("map.csv", "x,y\n1,2\n");
  EXPECT_FALSE(ImportSource::holds_vectors(folder.path() / "map.csv"));
  EXPECT_THAT(error_text(ImportSource::read(folder.file("bad.geojson", "{\"type\":"))),
              HasSubstr("bad.geojson: is no file of vectors that can be read"));
  EXPECT_THAT(error_text(ImportSource::read(folder.file("bad.gpkg", "SQLite format 3"))),
              HasSubstr("bad.gpkg: is no file of vectors that can be read"));
}

/// A PBF's parts: fields of a message, numbers with seven bits a byte.
void put_number(std::string& out, std::uint64_t value) {
  for (; value >= 128; value >>= 7U) out += static_cast<char>(value % 128 + 128);
  out += static_cast<char>(value);
}
std::string number_field(int field, std::uint64_t value) {
  std::string out;
  put_number(out, static_cast<std::uint64_t>(field) << 3U);
  put_number(out, value);
  return out;
}
std::string text_field(int field, const std::string& value) {
  std::string out;
  put_number(out, (static_cast<std::uint64_t>(field) << 3U) + 2);
  put_number(out, value.size());
  return out + value;
}
std::uint64_t zigzag(std::int64_t value) {
  return value >= 0 ? 2 * static_cast<std::uint64_t>(value)
                    : 2 * static_cast<std::uint64_t>(-(value + 1)) + 1;
}
std::string packed(const std::vector<std::uint64_t>& values) {
  std::string out;
  for (const std::uint64_t value : values) put_number(out, value);
  return out;
}
std::string blob(const std::string& type, const std::string& data) {
  const std::string body = text_field(1, data);
  const std::string head =
      text_field(1, type) + number_field(3, static_cast<std::uint64_t>(body.size()));
  std::string out{0, 0, 0, static_cast<char>(head.size())};
  return out + head + body;
}

TEST(LabelImport, ReadsOpenStreetMapInPbf) {
  // Nodes 1 to 4 on the corners of a square, a wood around them and a street along two.
  const std::string strings = text_field(1, "") + text_field(1, "natural") + text_field(1, "wood") +
                              text_field(1, "highway") + text_field(1, "residential");
  const auto place = [](double degrees) {
    return zigzag(static_cast<std::int64_t>(degrees * 1e7));
  };
  std::string nodes;
  const double corners[4][2] = {{49.0, 8.0}, {49.001, 8.0}, {49.001, 8.001}, {49.0, 8.001}};
  for (int i = 0; i < 4; ++i) {
    nodes += text_field(1, number_field(1, zigzag(i + 1)) + number_field(8, place(corners[i][0])) +
                               number_field(9, place(corners[i][1])));
  }
  const auto made_way = [](std::uint64_t id, std::uint64_t key,
                           const std::vector<std::uint64_t>& refs) {
    return text_field(3, number_field(1, id) + text_field(2, packed({key})) +
                             text_field(3, packed({key + 1})) + text_field(8, packed(refs)));
  };
  const std::string ways =
      made_way(1, 1, {zigzag(1), zigzag(1), zigzag(1), zigzag(1), zigzag(-3)}) +
      made_way(2, 3, {zigzag(1), zigzag(1)});
  const std::string file =
      blob("OSMHeader", text_field(4, "OsmSchema-V0.6")) +
      blob("OSMData", text_field(1, strings) + text_field(2, nodes) + text_field(2, ways));
  const ScratchFolder folder;
  const Imported found = import_all(folder.file("map.osm.pbf", file));
  ASSERT_EQ(found.labels.taken, 2U) << found.notices();
  const bool wood_first = found.object(0).class_id == kVegetation;
  const LabelObject& wood = found.object(wood_first ? 0 : 1);
  const LabelObject& street = found.object(wood_first ? 1 : 0);
  EXPECT_EQ(wood.kind, ObjectKind::kArea);
  EXPECT_NEAR(area_of_ring(wood.rings[0]), 111.2 * 73.1, 30.0);
  EXPECT_EQ(street.class_id, kRoad);
  EXPECT_EQ(street.width_m, 6.5);
}

TEST(LabelImport, DrawsWhatIsAboveAClassOnTopOfIt) {
  const auto rules = ImportRules::parse(
                         "[[rule]]\nwhere={class=\"terrain\"}\nkind=\"area\"\nclass=\"terrain\"\n"
                         "above=\"road\"\n[[rule]]\nwhere={class=true}\nkind=\"area\"\n"
                         "class={tag=\"class\"}\n",
                         "rules")
                         .value();
  const ScratchFolder folder;
  const auto source = ImportSource::read(folder.file(
      "map.geojson", collection({feature("Polygon", kSquare, R"("class":"road")"),
                                 feature("Polygon", kSquare, R"("class":"terrain")")})));
  ASSERT_TRUE(source) << error_text(source);
  auto document = source->plan_document(rules, 1.0).value();
  document.apply(source->objects(rules, document).value().edit);
  const Raster<ClassId> labels = rasterise(document);
  EXPECT_EQ(std::count(labels.values().begin(), labels.values().end(), kRoad), 0);
  EXPECT_GT(std::count(labels.values().begin(), labels.values().end(), kTerrain), 8000);
}

TEST(LabelImport, IsOneStepThatCanBeUndone) {
  const ScratchFolder folder;
  const auto source = ImportSource::read(folder.file(
      "map.geojson", collection({feature("Polygon", kSquare, R"("class":"terrain")")})));
  ASSERT_TRUE(source) << error_text(source);
  const ImportRules rules = bundled_rules("classes.toml");
  const auto document = source->plan_document(rules, 1.0).value();
  auto store =
      LabelStore::create(folder.path() / "l.gpkg", document.plane(), document.grid(), "ada")
          .value();
  ASSERT_TRUE(store.commit(source->objects(rules, store.document()).value().edit));
  EXPECT_EQ(store.document().objects().size(), 1U);
  ASSERT_TRUE(store.undo());
  EXPECT_THAT(store.document().objects(), IsEmpty());
}

TEST(LabelImport, ReadsALabelRasterAsPaintAndAsAreas) {
  const OverheadMap map = drawn_map(2.0, {"RRT.", "RBT.", "..TT"});
  const LabelGrid grid{map.metres_per_cell, map.top_left_in_enu_m, 4, 3};
  for (const RasterAs as : {RasterAs::kPaint, RasterAs::kAreas}) {
    LabelDocument document(map.plane, grid);
    const auto labels = import_raster(map, as, document);
    ASSERT_TRUE(labels) << error_text(labels);
    document.apply(labels->edit);
    EXPECT_EQ(rasterise(document), map.labels);
    EXPECT_EQ(document.paint().empty(), as == RasterAs::kAreas);
    EXPECT_EQ(document.objects().size(), as == RasterAs::kAreas ? 3U : 0U);
  }
}

TEST(LabelImport, TakesARasterOfAnotherPlaneToItsPlace) {
  const OverheadMap map = drawn_map(2.0, {"RRRR", "RBBR", "RBBR", "RRRR"});
  // A plane 300 m away, and cells of a quarter of the size.
  const auto plane = ProjectPlane::create({33.4527, -83.9}).value();
  const Eigen::Vector2d corner =
      plane.enu_from_geodetic(map.plane.geodetic_from_enu(map.top_left_in_enu_m));
  const LabelGrid grid{0.5, corner + Eigen::Vector2d(0.01, -0.01), 16, 16};
  for (const RasterAs as : {RasterAs::kPaint, RasterAs::kAreas}) {
    LabelDocument document(plane, grid);
    document.apply(import_raster(map, as, document).value().edit);
    const Raster<ClassId> labels = rasterise(document);
    EXPECT_EQ(std::count(labels.values().begin(), labels.values().end(), kBuilding), 64);
    EXPECT_EQ(std::count(labels.values().begin(), labels.values().end(), kRoad), 192);
    EXPECT_EQ(labels.at(4, 4), kBuilding);
    EXPECT_EQ(labels.at(3, 4), kRoad);
  }
}

}  // namespace label_import_test
}  // namespace nadir
