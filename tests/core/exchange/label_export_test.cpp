// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/label_export.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "core/label/label_raster.h"
#include "core/label/label_store.h"
#include "core/map/map_import.h"
#include "tests/core/exchange/import_sources.h"
#include "tests/core/label/drawn_labels.h"

namespace nadir {
namespace label_export_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

class LabelExport : public testing::Test {
 protected:
  /// Everything that a document may hold: areas with a hole, a line, an outline, paint.
  static LabelDocument town() {
    LabelDocument document =
        document_of({area(kTerrain, {box(0, 0, 40, 30)}, 1),
                     area(kVegetation, {box(2, 2, 12, 12), box(5, 5, 8, 8)}, 2),
                     line(kRoad, ring({{0, 20}, {40, 22}}), 5.0, 3),
                     outline(kBuilding, {box(20, 3, 34, 13)}, 2.0, 4)});
    document.apply(painting(document, {30, 24, 36, 28}, kSidewalk));
    return document;
  }

  void write(const LabelDocument& document, LabelFormat format, const std::string& name) {
    const auto done = export_labels(document, document.grid(), provenance, format, at(name));
    ASSERT_TRUE(done) << error_text(done);
  }
  [[nodiscard]] fs::path at(const std::string& name) const { return folder.path() / name; }
  [[nodiscard]] std::string text_of(const fs::path& path) const {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }

  ScratchFolder folder;
  MapProvenance provenance{"town", "drawn", "CC0-1.0", "2024-05-01"};
};

TEST_F(LabelExport, AsAPackageIsTheRasterOfTheDocument) {
  write(town(), LabelFormat::kMapPackage, "town");
  const auto map = read_overhead_map(at("town"));
  ASSERT_TRUE(map) << error_text(map);
  EXPECT_EQ(map->labels, rasterise(town()));
  EXPECT_EQ(map->plane, town().plane());
  EXPECT_EQ(map->top_left_in_enu_m, town().grid().top_left_in_enu_m);
  EXPECT_EQ(read_map_provenance(at("town"))->licence, "CC0-1.0");
}

TEST_F(LabelExport, IntoAPackageLeavesTheOpenDocumentAndOtherFilesAlone) {
  write(document_of({area(kRoad, {box(0, 0, 4, 4)})}), LabelFormat::kMapPackage, "town");
  folder.file("town/notes.txt", "mine");
  auto store = LabelStore::create(at("town") / "labels.gpkg", town(), "ada").value();
  write(store.document(), LabelFormat::kMapPackage, "town");
  EXPECT_EQ(read_overhead_map(at("town"))->labels, rasterise(town()));
  EXPECT_EQ(text_of(at("town") / "notes.txt"), "mine");
  // What is drawn after the export is in the file that stands there, not in one that was taken away.
  ASSERT_TRUE(store.commit(adding({area(kRoad, {box(1, 1, 5, 5)}, store.document().next_id())})));
  ASSERT_TRUE(store.close());
  const auto reopened = LabelStore::open(at("town") / "labels.gpkg", "ada");
  ASSERT_TRUE(reopened) << error_text(reopened);
  EXPECT_EQ(reopened->document(), store.document());
}

TEST_F(LabelExport, LeavesAMapOfAnotherPlaceAlone) {
  write(town(), LabelFormat::kMapPackage, "town");
  const auto before = read_overhead_map(at("town"));
  const LabelDocument elsewhere(ProjectPlane::create({10.0, 20.0}).value(), test_grid(4, 4));
  const auto done =
      export_labels(elsewhere, elsewhere.grid(), provenance, LabelFormat::kMapPackage, at("town"));
  EXPECT_THAT(error_text(done), HasSubstr("town: is a map on another plane"));
  folder.file("full/mine.txt", "mine");
  const auto full =
      export_labels(town(), town().grid(), provenance, LabelFormat::kMapPackage, at("full"));
  EXPECT_THAT(error_text(full), HasSubstr("full"));
  EXPECT_EQ(read_overhead_map(at("town"))->labels, before->labels);
  EXPECT_EQ(text_of(at("full") / "mine.txt"), "mine");
}

TEST_F(LabelExport, RefusesAPackageWhosePictureHasOtherCells) {
  const OverheadMap map{"town", test_plane(), 1.0, {0.0, 0.0}, Raster<ClassId>(40, 30, kRoad)};
  ASSERT_TRUE(write_overhead_map(map, provenance, ColourRaster(40, 30), at("town")));
  const LabelDocument document = town();
  const auto finer = export_labels(document, export_grid(document, 0.5), provenance,
                                   LabelFormat::kMapPackage, at("town"));
  EXPECT_THAT(error_text(finer), HasSubstr("its picture of 40 x 30 cells of 1 m is not where"));
  write(document, LabelFormat::kMapPackage, "town");
  EXPECT_TRUE(read_overhead_image(at("town"))->has_value()) << "a picture of the same cells stays";
}

TEST_F(LabelExport, NoOverviewHoldsAClassThatNobodyDrew) {
  std::vector<LabelObject> objects;
  for (int i = 0; i < 300; ++i) {
    objects.push_back(line(i % 2 == 0 ? kRoad : kLaneMarking,
                           ring({{3.0 * i, 0}, {900.0 - 3.0 * i, 700}}), 2.0, i + 1));
  }
  write(document_of(std::move(objects), 900, 700), LabelFormat::kMapPackage, "stripes");
  const std::unique_ptr<GDALDataset> dataset(
      GDALDataset::Open((at("stripes") / "labels.tif").c_str()));
  ASSERT_NE(dataset, nullptr);
  GDALRasterBand& band = *dataset->GetRasterBand(1);
  ASSERT_GE(band.GetOverviewCount(), 2);
  for (int level = 0; level < band.GetOverviewCount(); ++level) {
    GDALRasterBand& overview = *band.GetOverview(level);
    std::vector<std::uint8_t> cells(static_cast<std::size_t>(overview.GetXSize()) *
                                    static_cast<std::size_t>(overview.GetYSize()));
    ASSERT_EQ(
        overview.RasterIO(GF_Read, 0, 0, overview.GetXSize(), overview.GetYSize(), cells.data(),
                          overview.GetXSize(), overview.GetYSize(), GDT_Byte, 0, 0, nullptr),
        CE_None);
    const std::set<int> found(cells.begin(), cells.end());
    for (const int id : found) {
      EXPECT_TRUE(id == kRoad || id == kLaneMarking || id == kUnclassified) << id;
    }
  }
}

TEST_F(LabelExport, KeepsTheUpperLeftCornerAtAnyResolution) {
  const LabelDocument document = town();
  const LabelGrid grid = export_grid(document, 0.3);
  EXPECT_EQ(grid.top_left_in_enu_m, document.grid().top_left_in_enu_m);
  EXPECT_EQ(grid.width, 134) << "40 m are 133.3 cells, and all of it is covered";
  EXPECT_EQ(grid.height, 100);
  EXPECT_EQ(export_grid(document, {}), document.grid());
}

TEST_F(LabelExport, AsGeoJsonHasTwelveDigitsAndComesBack) {
  write(town(), LabelFormat::kGeoJson, "town.geojson");
  const auto json = nlohmann::json::parse(text_of(at("town.geojson")));
  ASSERT_EQ(json["features"].size(), 5U) << "four objects, and the paint as an area";
  const Imported back = import_all(at("town.geojson"), 1.0);
  ASSERT_EQ(back.labels.taken, 5U);
  const LabelDocument original = town();
  for (std::size_t i = 0; i < 4; ++i) {
    const LabelObject& drawn = *original.object(static_cast<ObjectId>(i + 1));
    const LabelObject& found = back.object(i);
    EXPECT_EQ(found.kind, drawn.kind);
    EXPECT_EQ(found.class_id, drawn.class_id);
    EXPECT_EQ(found.width_m, drawn.width_m);
    ASSERT_EQ(found.rings.size(), drawn.rings.size());
    const Eigen::Vector2d place = original.plane().enu_from_geodetic(
        back.document.plane().geodetic_from_enu(found.rings[0][0]));
    double nearest_m = 1e9;
    for (const Eigen::Vector2d& point : drawn.rings[0]) {
      nearest_m = std::min(nearest_m, (point - place).norm());
    }
    EXPECT_LT(nearest_m, 1e-6);
  }
}

TEST_F(LabelExport, AsShapefileComesBackToTheSameCells) {
  write(town(), LabelFormat::kShapefile, "shapes");
  LabelDocument back(town().plane(), town().grid());
  const ImportRules rules = bundled_rules("classes.toml");
  for (const char* name : {"area", "line", "outline"}) {
    const auto source = ImportSource::read(at("shapes") / (std::string(name) + ".shp"));
    ASSERT_TRUE(source) << error_text(source);
    const auto labels = source->objects(rules, back);
    ASSERT_TRUE(labels) << error_text(labels);
    back.apply(labels->edit);
  }
  EXPECT_EQ(back.objects().size(), 5U);
  EXPECT_EQ(rasterise(back), rasterise(town()));

  fs::remove(at("shapes") / "line.prj");
  EXPECT_THAT(
      error_text(ImportSource::read(at("shapes") / "line.shp")),
      HasSubstr("does not say which coordinate reference system it has; name it with --crs"));
  EXPECT_TRUE(ImportSource::read(at("shapes") / "line.shp", "EPSG:25832"));
  EXPECT_THAT(error_text(ImportSource::read(at("shapes") / "line.shp", "EPSG:nowhere")),
              HasSubstr("--crs: EPSG:nowhere is no coordinate reference system"));
}

TEST_F(LabelExport, AsClassImagesSaysItsScaleAndIsImportedAgain) {
  write(town(), LabelFormat::kClassImages, "masks");
  EXPECT_THAT(text_of(at("masks") / "scale.toml"), HasSubstr("metres_per_cell = 1\n"));
  const auto back = import_map(at("masks"), {});
  ASSERT_TRUE(back) << error_text(back);
  EXPECT_EQ(back->map.labels, rasterise(town()));
  EXPECT_THAT(back->notices, IsEmpty());
}

TEST_F(LabelExport, AsIndexedPngNamesTheCentreOfItsFirstPixel) {
  LabelDocument document(test_plane(), {0.5, {100.0, 50.0}, 8, 6});
  document.apply(adding({area(kRoad, {{{100, 50}, {102, 50}, {102, 48}, {100, 48}}})}));
  write(document, LabelFormat::kIndexedPng, "town.png");
  std::istringstream lines(text_of(at("town.pgw")));
  const std::vector<double> numbers((std::istream_iterator<double>(lines)), {});
  EXPECT_THAT(numbers, testing::ElementsAre(0.5, 0, 0, -0.5, 100.25, 49.75));
  const std::unique_ptr<GDALDataset> dataset(GDALDataset::Open(at("town.png").c_str()));
  ASSERT_NE(dataset, nullptr);
  const GDALColorTable* const table = dataset->GetRasterBand(1)->GetColorTable();
  ASSERT_NE(table, nullptr);
  EXPECT_EQ(table->GetColorEntry(kRoad)->c1, class_info(kRoad).colour.red);
  const auto back = import_map(at("town.png"), {});
  ASSERT_TRUE(back) << error_text(back);
  EXPECT_EQ(back->map.labels, rasterise(document));
}

TEST_F(LabelExport, AsCocoCountsEachCellOnce) {
  write(town(), LabelFormat::kCoco, "town.json");
  const auto json = nlohmann::json::parse(text_of(at("town.json")));
  EXPECT_EQ(json["images"][0]["width"], 40);
  EXPECT_EQ(json["categories"].size(), 15U) << "the sky lies in no overhead";
  const Raster<ClassId> labels = rasterise(town());
  std::map<int, double> areas;
  for (const auto& annotation : json["annotations"]) {
    areas[annotation["category_id"].get<int>() - 1] += annotation["area"].get<double>();
    const auto& segmentation = annotation["segmentation"];
    if (!segmentation.is_object()) continue;
    // Runs by columns, outside first.
    const auto id = static_cast<ClassId>(annotation["category_id"].get<int>() - 1);
    std::int64_t at_cell = 0;
    std::int64_t inside = 0;
    bool is_inside = false;
    for (const auto& count : segmentation["counts"]) {
      for (int i = 0; i < count.get<int>(); ++i, ++at_cell) {
        if (!is_inside) continue;
        ++inside;
        EXPECT_EQ(labels.at(static_cast<int>(at_cell / 30), static_cast<int>(at_cell % 30)), id);
      }
      is_inside = !is_inside;
    }
    EXPECT_EQ(at_cell, 40 * 30);
    EXPECT_EQ(static_cast<double>(inside), annotation["area"].get<double>());
  }
  for (int id = 0; id < kClassCount; ++id) {
    EXPECT_EQ(areas[id], std::count(labels.values().begin(), labels.values().end(), id)) << id;
  }
}

TEST_F(LabelExport, AsCocoNamesThePictureWhosePixelsAreTheCells) {
  const auto named = [&](const std::string& name, const fs::path& picture, double resolution) {
    const LabelDocument document = town();
    const auto done = export_labels(document, export_grid(document, resolution), provenance,
                                    LabelFormat::kCoco, at(name), {}, picture);
    EXPECT_TRUE(done) << error_text(done);
    return nlohmann::json::parse(text_of(at(name)))["images"][0]["file_name"].get<std::string>();
  };
  const OverheadMap map{"town", test_plane(), 1.0, {0.0, 0.0}, Raster<ClassId>(40, 30, kRoad)};
  ASSERT_TRUE(write_overhead_map(map, provenance, ColourRaster(40, 30), at("town")));
  fs::copy_file(at("town") / "image.tif", at("from above.tif"));
  EXPECT_EQ(named("a.json", at("from above.tif"), 1.0), "from above.tif");
  EXPECT_EQ(named("b.json", at("from above.tif"), 0.5), "labels.tif") << "has other cells";
  EXPECT_EQ(named("c.json", {}, 1.0), "labels.tif");
  EXPECT_EQ(named("d.json", at("gone.tif"), 1.0), "labels.tif");
}

TEST_F(LabelExport, AsIndexedPngIsThereWithAllThatTellsWhereItLiesOrNotAtAll) {
  const auto exported = [&] {
    return export_labels(town(), town().grid(), provenance, LabelFormat::kIndexedPng,
                         at("town.png"));
  };
  // Where the world file cannot be written there is no picture either, and the other way round.
  fs::create_directory(at("town.pgw"));
  EXPECT_THAT(error_text(exported()), HasSubstr("town.pgw: is a folder"));
  EXPECT_EQ(folder.entries(), 1);
  fs::remove(at("town.pgw"));
  fs::create_directory(at("town.png"));
  EXPECT_THAT(error_text(exported()), HasSubstr("town.png: is a folder"));
  EXPECT_EQ(folder.entries(), 1);
  fs::remove(at("town.png"));
  ASSERT_TRUE(exported());
  EXPECT_EQ(folder.entries(), 3) << "picture, world file and notes";
  // One that is stopped half-way leaves all three of before as they were.
  const std::string before = text_of(at("town.png")) + text_of(at("town.pgw"));
  std::stop_source stop;
  WorkContext context;
  context.stop = stop.get_token();
  context.progress = [&](double, const std::string&) { stop.request_stop(); };
  LabelDocument taller(test_plane(), test_grid(40, 900));
  EXPECT_FALSE(export_labels(taller, taller.grid(), provenance, LabelFormat::kIndexedPng,
                             at("town.png"), context));
  EXPECT_EQ(text_of(at("town.png")) + text_of(at("town.pgw")), before);
  EXPECT_EQ(folder.entries(), 3);
}

TEST_F(LabelExport, LeavesNothingBehindWhereItIsStopped) {
  std::stop_source stop;
  stop.request_stop();
  WorkContext context;
  context.stop = stop.get_token();
  for (const auto& [format, name] :
       {std::pair(LabelFormat::kMapPackage, "a"), std::pair(LabelFormat::kGeoJson, "b.geojson"),
        std::pair(LabelFormat::kShapefile, "c"), std::pair(LabelFormat::kClassImages, "d"),
        std::pair(LabelFormat::kIndexedPng, "e.png"), std::pair(LabelFormat::kCoco, "f.json")}) {
    const auto done = export_labels(town(), town().grid(), provenance, format, at(name), context);
    ASSERT_FALSE(done) << name;
    EXPECT_EQ(error_code(done), ErrorCode::kCancelled) << name << ": " << error_text(done);
  }
  EXPECT_EQ(folder.entries(), 0);
  const auto nowhere = export_labels(town(), town().grid(), provenance, LabelFormat::kGeoJson,
                                     at("no/such/folder.geojson"));
  EXPECT_THAT(error_text(nowhere), HasSubstr("folder.geojson"));
}

}  // namespace label_export_test
}  // namespace nadir
