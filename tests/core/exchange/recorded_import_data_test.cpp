// SPDX-License-Identifier: Apache-2.0
// Maps of other makers that are not part of the project; see the folder that NADIR_TEST_DATA names.
#include <gmock/gmock.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <tuple>

#include "core/exchange/label_export.h"
#include "core/label/label_raster.h"
#include "tests/core/exchange/import_sources.h"

namespace nadir {
namespace recorded_import_data_test {

namespace fs = std::filesystem;

class RecordedImport : public testing::Test {
 protected:
  void SetUp() override {
    // Read before any thread is started.
    const char* const root = std::getenv("NADIR_TEST_DATA");  // NOLINT(concurrency-mt-unsafe)
    if (root == nullptr) {
      GTEST_SKIP() << "NADIR_TEST_DATA is not set: maps of other makers are left out";
    }
    folder = root;
  }

  /// The positions that a GPS saw: the first two numbers of each line.
  [[nodiscard]] static std::vector<Geodetic> positions(std::istream& lines) {
    std::vector<Geodetic> found;
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      Geodetic at;
      if (words >> at.latitude_deg >> at.longitude_deg) found.push_back(at);
    }
    return found;
  }

  [[nodiscard]] static int objects_of(const Imported& found, ClassId id, ObjectKind kind) {
    int count = 0;
    for (const auto& [ignored, placed] : found.document.objects()) {
      count += placed.object->class_id == id && placed.object->kind == kind ? 1 : 0;
    }
    return count;
  }

  /// Draws a class only where somebody stands, which is quicker than a map of square kilometres.
  [[nodiscard]] static ClassId class_at(const Imported& found, const Geodetic& at) {
    const LabelGrid& grid = found.document.grid();
    const Eigen::Vector2d cell = grid.cells_from_enu(found.document.plane().enu_from_geodetic(at));
    const auto column = static_cast<std::int64_t>(std::floor(cell.x()));
    const auto row = static_cast<std::int64_t>(std::floor(cell.y()));
    return rasterise(found.document, grid, {column, row, column + 1, row + 1}).at(0, 0);
  }

  fs::path folder;
};

TEST_F(RecordedImport, OfKirchbergHasItsHousesStreetsAndWoods) {
  const Imported found = import_all(folder / "maps" / "osm" / "kirchberg.osm");
  // Of 33 houses and 19 streets 1 and 5 were cut to a single node when the extract was made.
  EXPECT_EQ(objects_of(found, kBuilding, ObjectKind::kOutline), 32);
  EXPECT_EQ(objects_of(found, kRoad, ObjectKind::kLine), 14);
  EXPECT_THAT(found.notices(), testing::HasSubstr("7 ways have fewer than two places"));
  EXPECT_THAT(found.notices(), testing::HasSubstr("2 multipolygons have open rings"));
  // 0.002 degrees north and 0.003 east at 48.136 N, as the file says.
  EXPECT_NEAR(found.document.grid().height * 0.5, 222.4, 2.1);
  EXPECT_NEAR(found.document.grid().width * 0.5, 223.3, 2.1);
}

TEST_F(RecordedImport, OfTheTownOfKittiTakesUnderFiveSecondsAndTheDriveLiesOnItsRoads) {
  const ScratchFolder scratch;
  const fs::path source = scratch.path() / "kitti00.osm";
  const std::string unpack =
      fmt::format("bunzip2 -c '{}' > '{}'", (folder / "maps" / "osm" / "kitti00.osm.bz2").string(),
                  source.string());
  ASSERT_EQ(std::system(unpack.c_str()), 0);  // NOLINT(concurrency-mt-unsafe,cert-env33-c)
  const auto began = std::chrono::steady_clock::now();
  const Imported found = import_all(source, 0.2);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  RecordProperty("seconds", fmt::format("{:.2f}", took.count()));
#ifdef NDEBUG
  EXPECT_LT(took.count(), 5.0);
#endif
  EXPECT_GT(objects_of(found, kBuilding, ObjectKind::kOutline), 3000);
  EXPECT_GT(objects_of(found, kRoad, ObjectKind::kLine), 250);

  std::ifstream lines(folder / "kitti_odometry_00" / "oxts_00.txt");
  const std::vector<Geodetic> drive = positions(lines);
  ASSERT_GT(drive.size(), 4000U);
  int on_road = 0;
  for (const Geodetic& at : drive) on_road += class_at(found, at) == kRoad ? 1 : 0;
  RecordProperty("on_road", fmt::format("{:.4f}", on_road / static_cast<double>(drive.size())));
  EXPECT_GT(on_road, 0.95 * static_cast<double>(drive.size()));
}

TEST_F(RecordedImport, OfTheLaneletsOfKarlsruheHoldsTheDriveThere) {
  const Imported found =
      import_all(folder / "maps" / "lanelet2_karlsruhe" / "mapping_example.osm", 0.1);
  // 337 road lanelets, 8 of a highway, 14 bicycle lanes and 8 crosswalks; 19 places to park, 3 exits, 2 to keep out of.
  EXPECT_EQ(objects_of(found, kRoad, ObjectKind::kArea), 337 + 8 + 14 + 8 + 19 + 3 + 2);
  EXPECT_EQ(objects_of(found, kCurb, ObjectKind::kLine), 325);
  EXPECT_EQ(objects_of(found, kVegetation, ObjectKind::kArea), 25);
  EXPECT_EQ(objects_of(found, kBuilding, ObjectKind::kLine), 36);
  EXPECT_EQ(objects_of(found, kBuilding, ObjectKind::kOutline), 3);
  EXPECT_EQ(objects_of(found, kSidewalk, ObjectKind::kArea), 19 + 2 + 5);

  int on_map = 0;
  int on_road = 0;
  for (const auto& entry : fs::directory_iterator(folder / "kitti_raw" / "2011_09_26")) {
    const fs::path packets = entry.path() / "oxts" / "data";
    if (!fs::is_directory(packets)) continue;
    for (const auto& packet : fs::directory_iterator(packets)) {
      std::ifstream lines(packet.path());
      for (const Geodetic& at : positions(lines)) {
        const ClassId id = class_at(found, at);
        on_map += id != kUnclassified ? 1 : 0;
        on_road += id == kRoad || id == kLaneMarking ? 1 : 0;
      }
    }
  }
  RecordProperty("on_map", on_map);
  ASSERT_GT(on_map, 80) << "the drive enters from off the map";
  EXPECT_GT(on_road, 0.95 * on_map);
}

TEST_F(RecordedImport, OfEachBecomesAPackageThatIsAsItsDocumentIs) {
  const ScratchFolder scratch;
  for (const auto& [name, source, metres_per_cell] :
       {std::tuple("kirchberg", folder / "maps" / "osm" / "kirchberg.osm", 0.1),
        std::tuple("karlsruhe", folder / "maps" / "lanelet2_karlsruhe" / "mapping_example.osm",
                   0.5)}) {
    const Imported found = import_all(source, metres_per_cell);
    const fs::path package = scratch.path() / name;
    const auto written = export_labels(found.document, found.document.grid(), {.name = name},
                                       LabelFormat::kMapPackage, package);
    ASSERT_TRUE(written) << error_text(written);
    const auto check = check_export(found.document, package);
    ASSERT_TRUE(check) << error_text(check);
    EXPECT_THAT(check->faults, testing::IsEmpty());
    if (metres_per_cell > 0.1) continue;  // Lane markings are 0.12 m wide.
    for (const ClassArea& area : check->areas) {
      EXPECT_NEAR(area.exported_m2, area.drawn_m2, 0.001 * area.drawn_m2)
          << name << " " << class_info(area.id).name;
    }
  }
}

}  // namespace recorded_import_data_test
}  // namespace nadir
