// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/cli/command.h"
#include "core/base/staged_output.h"
#include "core/label/label_store.h"
#include "core/map/overhead_map_file.h"
#include "tests/support/drawn_map.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir::cli {
namespace map_labels_command_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

/// A street of 111 m along a meadow.
constexpr const char* kOsm = R"(<?xml version='1.0'?>
<osm version='0.6'>
<bounds minlat='49.0' minlon='8.0' maxlat='49.001' maxlon='8.001'/>
<node id='1' lat='49.0' lon='8.0'/><node id='2' lat='49.001' lon='8.0'/>
<node id='3' lat='49.001' lon='8.001'/><node id='4' lat='49.0' lon='8.001'/>
<node id='5' lat='49.0' lon='8.0005'/><node id='6' lat='49.001' lon='8.0005'/>
<way id='1'><nd ref='1'/><nd ref='2'/><nd ref='3'/><nd ref='4'/><nd ref='1'/><tag k='landuse' v='meadow'/></way>
<way id='2'><nd ref='5'/><nd ref='6'/><nd ref='99'/><tag k='highway' v='residential'/></way>
</osm>
)";

class MapLabelsCommand : public testing::Test {
 protected:
  int run(const std::vector<std::string>& arguments) {
    output.str("");
    errors.str("");
    return run_map(arguments, output, errors);
  }
  [[nodiscard]] std::string at(const std::string& name) const {
    return (folder.path() / name).string();
  }
  [[nodiscard]] std::string source() const { return folder.file("town.osm", kOsm).string(); }
  /// The package of the source, in cells of 0.5 m.
  [[nodiscard]] std::string town() {
    EXPECT_EQ(run({"import", source(), "--out", at("town"), "--resolution", "0.5"}), kDone)
        << err();
    return at("town");
  }
  [[nodiscard]] std::string out() const { return output.str(); }
  [[nodiscard]] std::string err() const { return errors.str(); }

  ScratchFolder folder;
  std::ostringstream output, errors;
};

TEST_F(MapLabelsCommand, ImportMakesAPackageWithItsDocument) {
  const std::string package = town();
  EXPECT_THAT(out(), HasSubstr("town: 148 x 224 cells of 0.5 m"));
  EXPECT_THAT(out(), HasSubstr("2 objects of 2 things"));
  EXPECT_EQ(err(), "notice: 1 way misses nodes and was taken without them\n");
  ASSERT_EQ(run({"info", package, "--json"}), kDone) << err();
  const auto json = nlohmann::json::parse(out());
  EXPECT_EQ(json["name"], "town");
  EXPECT_NEAR(json["classes"][0]["cells"].get<double>() * 0.25, 111.2 * 6.5, 8.0);
  const auto store = LabelStore::open(package + "/labels.gpkg", "ada");
  ASSERT_TRUE(store) << error_text(store);
  EXPECT_EQ(store->document().objects().size(), 2U);
  EXPECT_FALSE(fs::exists(package + "/labels.gpkg-wal")) << "a document at rest is one file";
}

TEST_F(MapLabelsCommand, ImportMakesADocumentAloneOrAddsToOne) {
  ASSERT_EQ(run({"import", source(), "--out", at("a.gpkg"), "--quiet"}), kDone) << err();
  EXPECT_THAT(err(), IsEmpty());
  ASSERT_EQ(run({"import", source(), "--into", at("a.gpkg"), "--rules", "osm.toml"}), kDone)
      << err();
  auto store = LabelStore::open(at("a.gpkg"), "ada").value();
  EXPECT_EQ(store.document().objects().size(), 4U);
  EXPECT_EQ(store.undo_step()->title, "Import town.osm");
  ASSERT_TRUE(store.undo());
  EXPECT_EQ(store.document().objects().size(), 2U);
}

TEST_F(MapLabelsCommand, ImportMakesADocumentOfALabelRaster) {
  ASSERT_TRUE(write_overhead_map(drawn_map(2.0, {"RRT", "RRB"}), {}, {}, at("drawn")));
  for (const std::string as : {"paint", "areas"}) {
    ASSERT_EQ(run({"import", at("drawn") + "/labels.tif", "--out", at(as), "--as", as}), kDone)
        << err();
    ASSERT_EQ(run({"check", at(as)}), kDone) << err();
    const auto store = LabelStore::open(at(as) + "/labels.gpkg", "ada", LabelAccess::kRead);
    EXPECT_EQ(store->document().objects().size(), as == "areas" ? 3U : 0U);
  }
}

TEST_F(MapLabelsCommand, ExportNeverReplacesWhatItReads) {
  const std::string package = town();
  EXPECT_NE(run({"export", package, "--format", "geojson", "--out", package + "/labels.gpkg"}),
            kDone);
  EXPECT_THAT(err(), HasSubstr("labels.gpkg: is the labelling document itself"));
  EXPECT_EQ(LabelStore::open(package + "/labels.gpkg", "ada")->document().objects().size(), 2U);
}

TEST_F(MapLabelsCommand, ExportReplacesNoOtherDocument) {
  const std::string package = town();
  const std::string other = at("other.gpkg");
  ASSERT_EQ(run({"import", source(), "--out", other}), kDone) << err();
  EXPECT_NE(run({"export", package, "--format", "geojson", "--out", other}), kDone);
  EXPECT_THAT(err(), HasSubstr("other.gpkg: is a GeoPackage, which no export replaces"));
  EXPECT_EQ(LabelStore::open(other, "ada")->document().objects().size(), 2U);
}

TEST_F(MapLabelsCommand, NothingIsMadeOfWhatIsLeftOfADamagedDocument) {
  const std::string package = town();
  const auto bytes = read_text_file(package + "/labels.tif").value();
  const auto size = static_cast<std::streamoff>(fs::file_size(package + "/labels.gpkg"));
  {
    std::fstream file(package + "/labels.gpkg", std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(size / 2);
    for (std::streamoff i = 0; i < size / 2; ++i) file.put('\x55');
  }
  EXPECT_NE(run({"export", package, "--out", package}), kDone);
  EXPECT_THAT(err(), HasSubstr("labels.gpkg: "));
  EXPECT_EQ(read_text_file(package + "/labels.tif").value(), bytes);
  EXPECT_NE(run({"check", package}), kDone);
}

TEST_F(MapLabelsCommand, ImportReplacesNoDocument) {
  const std::string package = town();
  EXPECT_EQ(run({"import", source(), "--out", package}), kFailed);
  EXPECT_THAT(err(),
              HasSubstr("town: is there already; import into another folder, or with --into"));
  ASSERT_TRUE(write_overhead_map(drawn_map(2.0, {"RRT", "RRB"}), {}, {}, at("drawn")));
  EXPECT_EQ(run({"import", at("drawn") + "/labels.tif", "--out", package, "--as", "paint"}),
            kFailed);
  EXPECT_THAT(err(), HasSubstr("labels.gpkg: is there already"));
}

TEST_F(MapLabelsCommand, ImportRefusesFlagsOfTheOtherKindOfSource) {
  EXPECT_EQ(run({"import", source(), "--out", at("x"), "--flip"}), kFailed);
  EXPECT_THAT(err(), HasSubstr("nadir map import: --flip: goes with a label raster"));
  EXPECT_EQ(run({"import", "labels.tif", "--out", at("x"), "--rules", "osm.toml"}), kFailed);
  EXPECT_THAT(err(), HasSubstr("--rules: goes with vectors"));
  EXPECT_EQ(run({"import", source()}), kMisused);
  EXPECT_THAT(err(), HasSubstr("one of --out and --into"));
  EXPECT_EQ(run({"import", source(), "--out", at("x"), "--into", at("y")}), kMisused);
  EXPECT_EQ(run({"import", source(), "--out", at("x"), "--resolution", "0"}), kFailed);
  EXPECT_THAT(err(), HasSubstr("--resolution: 0 is not in [0.001, 100000] m"));
  EXPECT_EQ(run({"import", source(), "--out", at("x"), "--rules", "no.toml"}), kFailed);
  EXPECT_THAT(err(), HasSubstr("no.toml"));
  EXPECT_EQ(run({"import", at("none.osm"), "--out", at("x")}), kFailed);
  EXPECT_THAT(err(), HasSubstr("none.osm: no such file"));
  EXPECT_FALSE(fs::exists(at("x")));
}

TEST_F(MapLabelsCommand, ExportWritesEveryFormat) {
  const std::string package = town();
  for (const auto& [format, name] :
       {std::pair("package", "p"), std::pair("geojson", "g.geojson"), std::pair("shapefile", "s"),
        std::pair("class-images", "c"), std::pair("indexed-png", "i.png"),
        std::pair("coco", "k.json")}) {
    ASSERT_EQ(run({"export", package, "--format", format, "--out", at(name)}), kDone) << err();
    EXPECT_THAT(out(), HasSubstr(name));
    EXPECT_TRUE(fs::exists(at(name)));
  }
  ASSERT_EQ(run({"export", package + "/labels.gpkg", "--out", at("again.geojson")}), kDone)
      << err();
  EXPECT_THAT(out(), HasSubstr("again.geojson: 2 objects"));
  ASSERT_EQ(run({"export", package, "--out", at("fine"), "--resolution", "0.25"}), kDone) << err();
  EXPECT_THAT(out(), HasSubstr("fine: 296 x 448 cells of 0.25 m"));
  EXPECT_EQ(read_map_provenance(at("fine"))->name, "town") << "as the package around the document";
}

TEST_F(MapLabelsCommand, CheckComparesAPackageWithItsDocument) {
  const std::string package = town();
  ASSERT_EQ(run({"check", package}), kDone) << err();
  EXPECT_THAT(out(), HasSubstr("road"));
  EXPECT_THAT(out(), HasSubstr("town: is as its document is"));
  {
    auto store = LabelStore::open(package + "/labels.gpkg", "ada").value();
    ASSERT_TRUE(store.undo());
  }
  EXPECT_EQ(run({"check", package, "--json"}), kFailed);
  EXPECT_THAT(err(), HasSubstr("cells are not as they are drawn"));
  const auto json = nlohmann::json::parse(out());
  EXPECT_GT(json["faults"].size(), 0U);
  EXPECT_GT(json["classes"][0]["exported_m2"].get<double>(), 700.0);
  EXPECT_EQ(json["classes"][0]["drawn_m2"], 0.0);
  ASSERT_EQ(run({"export", package, "--out", package}), kDone) << err();
  EXPECT_EQ(run({"check", package, "--quiet"}), kDone) << err();
  EXPECT_THAT(out(), IsEmpty());
}

TEST_F(MapLabelsCommand, HelpNamesWhatGoesInAndOut) {
  ASSERT_EQ(run({"import", "--help"}), kDone);
  for (const char* word : {"OpenStreetMap", "Lanelet2", "GeoJSON", "--rules", "--into", "--as"}) {
    EXPECT_THAT(out(), HasSubstr(word));
  }
  ASSERT_EQ(run({"export", "--help"}), kDone);
  for (const char* word : {"geojson", "shapefile", "class-images", "indexed-png", "coco"}) {
    EXPECT_THAT(out(), HasSubstr(word));
  }
  ASSERT_EQ(run({"check", "--help"}), kDone);
  EXPECT_THAT(out(), HasSubstr("--labels"));
}

}  // namespace map_labels_command_test
}  // namespace nadir::cli
