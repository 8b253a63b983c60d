// SPDX-License-Identifier: Apache-2.0
#include "core/map/overhead_map_file.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <algorithm>
#include <limits>
#include <set>

#include "core/base/settings.h"
#include "core/base/staged_output.h"
#include "core/map/overhead_tiles.h"
#include "tests/core/map/raster_files.h"
#include "tests/support/drawn_map.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace overhead_map_file_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const MapProvenance town_provenance{"town \"north\"", "drawn by hand\nover a photograph", "CC0-1.0",
                                    "2024-05-01"};

OverheadMap town(int width = 700, int height = 500) {
  OverheadMap map = drawn_map(0.1, {"."});
  map.plane = ProjectPlane::create({33.450112345678912, -83.901223456789123}).value();
  map.labels = patchwork(width, height);
  map.labels.at(0, 0) = kUnclassified;
  map.top_left_in_enu_m = {-35.123456789, 25.5};
  return map;
}

class MapPackage : public testing::Test {
 protected:
  [[nodiscard]] fs::path package() const { return folder.path() / "town"; }

  void write(const OverheadMap& map, const std::optional<ColourRaster>& image = {}) const {
    const auto written = write_overhead_map(map, town_provenance, image, package());
    ASSERT_TRUE(written) << error_text(written);
  }
  /// Puts another program's labels.tif into the package.
  void replace_labels(const RasterFile& file) const {
    fs::remove(package() / "labels.tif.aux.xml");
    write_raster(file, package() / "labels.tif");
  }
  [[nodiscard]] std::string fault() const { return error_text(read_overhead_map(package())); }
  [[nodiscard]] std::string labels_path() const { return (package() / "labels.tif").string(); }

  ScratchFolder folder;
};

/// One metre cells of `map`'s plane.
RasterFile labels_on(const OverheadMap& map, const Eigen::Matrix2d& linear) {
  RasterFile file{.ids = patchwork(20, 10), .crs = map.plane.wkt()};
  file.crs_from_pixel = Affine2{linear, {0.0, 0.0}};
  return file;
}

Eigen::Matrix2d matrix(double a, double b, double c, double d) {
  Eigen::Matrix2d linear;
  linear << a, b, c, d;
  return linear;
}

TEST_F(MapPackage, ComesBackAsItWasWritten) {
  const OverheadMap map = town();
  write(map);
  const auto read = read_overhead_map(package());
  ASSERT_TRUE(read) << error_text(read);
  EXPECT_EQ(read->labels, map.labels);
  EXPECT_TRUE(read->plane == map.plane);  // to the last bit
  EXPECT_EQ(read->metres_per_cell, map.metres_per_cell);
  EXPECT_EQ(read->top_left_in_enu_m, map.top_left_in_enu_m);
  EXPECT_EQ(read->name, town_provenance.name);
}

TEST_F(MapPackage, KeepsItsProvenance) {
  write(town(20, 20));
  const auto provenance = read_map_provenance(package());
  ASSERT_TRUE(provenance) << error_text(provenance);
  EXPECT_EQ(provenance->name, town_provenance.name);
  EXPECT_EQ(provenance->source, town_provenance.source);
  EXPECT_EQ(provenance->licence, town_provenance.licence);
  EXPECT_EQ(provenance->date, town_provenance.date);
}

TEST_F(MapPackage, WritesDegreesWithTwelveDigitsAndMore) {
  write(town(20, 20));
  const auto text = read_text_file(package() / "map.toml");
  ASSERT_TRUE(text);
  EXPECT_THAT(*text, HasSubstr("latitude_deg = 33.4501123456789"));
  EXPECT_THAT(*text, HasSubstr("longitude_deg = -83.9012234567891"));
}

TEST_F(MapPackage, WritesAWholeNumberOfDegreesAsANumber) {
  OverheadMap map = town(20, 20);
  map.plane = ProjectPlane::create({48.0, 0.0}).value();
  write(map);
  const auto read = read_overhead_map(package());
  ASSERT_TRUE(read) << error_text(read);
  EXPECT_TRUE(read->plane == map.plane);
}

TEST_F(MapPackage, HasPaletteAndClassNamesInside) {
  write(town(20, 20));
  const fs::path labels = package() / "labels.tif";
  EXPECT_EQ(palette_entry(labels, kRoad), (std::array{128, 64, 128}));
  EXPECT_EQ(palette_entry(labels, kLaneMarking), (std::array{250, 225, 60}));
  EXPECT_EQ(category_names(labels).at(kLaneMarking), "lane marking");
  fs::remove(package() / "labels.tif.aux.xml");
  EXPECT_EQ(band_metadata(labels, "CLASS_14"), "lane marking");
}

TEST_F(MapPackage, InventsNoClassInItsOverviews) {
  OverheadMap map = town();
  for (ClassId& id : map.labels.values()) id = id == kRoad ? kRoad : kLaneMarking;  // 0 and 14
  write(map);
  ASSERT_GE(overview_count(package() / "labels.tif"), 2);
  for (int level = 0; level < overview_count(package() / "labels.tif"); ++level) {
    const Raster<std::uint8_t> overview = read_overview(package() / "labels.tif", level);
    EXPECT_THAT(std::set<int>(overview.values().begin(), overview.values().end()),
                testing::ElementsAre(kRoad, kLaneMarking));
  }
}

TEST_F(MapPackage, GivesTheSameBytesTwice) {
  const OverheadMap map = town();
  write(map);
  const auto first = read_text_file(package() / "labels.tif");
  write(map);
  EXPECT_EQ(first.value(), read_text_file(package() / "labels.tif").value());
}

TEST_F(MapPackage, KeepsItsPictureNearlyAsItWas) {
  const OverheadMap map = town(300, 200);
  write(map, ColourRaster(300, 200, Colour{200, 100, 50}));
  const auto image = read_overhead_image(package());
  ASSERT_TRUE(image) << error_text(image);
  ASSERT_TRUE(image->has_value());
  EXPECT_EQ((*image)->width(), 300);
  EXPECT_EQ((*image)->height(), 200);
  const Colour colour = (*image)->at(150, 100);
  EXPECT_NEAR(colour.red, 200, 4);  // JPEG
  EXPECT_NEAR(colour.green, 100, 4);
  EXPECT_NEAR(colour.blue, 50, 4);
}

TEST_F(MapPackage, MayHaveNoPicture) {
  write(town(20, 20));
  const auto image = read_overhead_image(package());
  ASSERT_TRUE(image) << error_text(image);
  EXPECT_FALSE(image->has_value());
}

TEST_F(MapPackage, RefusesAPictureOfAnotherSize) {
  write(town(300, 200), ColourRaster(300, 200));
  fs::copy_file(package() / "image.tif", folder.path() / "other.tif");
  write(town(310, 200), ColourRaster(310, 200));
  fs::copy_file(folder.path() / "other.tif", package() / "image.tif",
                fs::copy_options::overwrite_existing);
  EXPECT_THAT(error_text(read_overhead_image(package())),
              HasSubstr("image.tif: is 300 x 200 pixels, but the labels are 310 x 200"));
}

TEST_F(MapPackage, KeepsWhatOthersPutIntoIt) {
  write(town(20, 20));
  ASSERT_TRUE(write_text_file(package() / "labels.gpkg", "an afternoon of work"));
  write(town(30, 20));
  EXPECT_EQ(read_text_file(package() / "labels.gpkg").value(), "an afternoon of work");
  EXPECT_EQ(read_overhead_map(package())->labels.width(), 30);
}

/// Which file a name stands for: that of somebody who has it open, or another.
ino_t number_of(const fs::path& path) {
  struct stat found {};
  return ::stat(path.c_str(), &found) == 0 ? found.st_ino : 0;
}

TEST_F(MapPackage, WhatOthersHaveOpenInItStaysTheSameFile) {
  write(town(20, 20), ColourRaster(20, 20, Colour{90, 120, 60}));
  ASSERT_TRUE(write_text_file(package() / "labels.gpkg", "an afternoon of work"));
  const ino_t before = number_of(package() / "labels.gpkg");
  const ino_t folder_before = number_of(package());
  std::ofstream changes(package() / "labels.gpkg-wal");
  const OverheadMap wide = town(30, 20);
  write(wide);
  changes << "the last stroke" << std::flush;
  EXPECT_EQ(number_of(package() / "labels.gpkg"), before);
  EXPECT_EQ(number_of(package()), folder_before);
  EXPECT_EQ(read_text_file(package() / "labels.gpkg-wal").value(), "the last stroke");
  EXPECT_EQ(read_overhead_map(package())->labels, wide.labels);
  EXPECT_FALSE(fs::exists(package() / "image.tif")) << "the picture of another map";
  EXPECT_EQ(folder.entries(), 1);
}

TEST_F(MapPackage, ADocumentThatIsBegunWhileLabelsAreWrittenStays) {
  const OverheadMap map = town(20, 20);
  const fs::path elsewhere = folder.path() / "elsewhere";
  ASSERT_TRUE(write_overhead_map(map, town_provenance, {}, elsewhere));
  const auto rows = [&](int first, int count) -> Result<Raster<ClassId>> {
    // There is no package when the export begins, and one when it ends.
    if (!fs::exists(package())) {
      fs::copy(elsewhere, package());
      folder.file("town/labels.gpkg", "an afternoon of work");
    }
    Raster<ClassId> strip(20, count);
    for (int row = 0; row < count; ++row) {
      std::ranges::copy(map.labels.row(first + row), strip.row(row).begin());
    }
    return strip;
  };
  const LabelStrips strips{"town", map.plane, map.metres_per_cell, map.top_left_in_enu_m, 20,
                           20,     rows};
  const auto written = write_labels_of_map(strips, {}, package());
  EXPECT_TRUE(written) << error_text(written);
  EXPECT_EQ(read_text_file(package() / "labels.gpkg").value(), "an afternoon of work");
  EXPECT_EQ(read_overhead_map(package())->labels, map.labels);
}

TEST_F(MapPackage, IsNotWrittenOverAFolderOfSomethingElse) {
  const fs::path file = folder.file("town/letters.txt", "dear");
  const auto written = write_overhead_map(town(20, 20), town_provenance, {}, package());
  ASSERT_FALSE(written);
  EXPECT_THAT(error_text(written), StartsWith(package().string()));
  EXPECT_EQ(read_text_file(file).value(), "dear");
  EXPECT_EQ(folder.entries(), 1);
}

TEST_F(MapPackage, LeavesNothingWhereItsFolderIsMissing) {
  const auto written =
      write_overhead_map(town(20, 20), town_provenance, {}, folder.path() / "no" / "town");
  ASSERT_FALSE(written);
  EXPECT_EQ(error_code(written), ErrorCode::kIo);
  EXPECT_EQ(folder.entries(), 0);
}

TEST_F(MapPackage, MustBeThere) {
  const auto read = read_overhead_map(package());
  ASSERT_FALSE(read);
  EXPECT_EQ(error_code(read), ErrorCode::kNotFound);
  EXPECT_EQ(error_text(read), package().string() + ": no such map package");
}

TEST_F(MapPackage, MustBeAFolderWithSettings) {
  const fs::path file = folder.file("town.tif", "x");
  EXPECT_THAT(error_text(read_overhead_map(file)), HasSubstr("town.tif: is no map package"));
  fs::create_directory(package());
  EXPECT_THAT(fault(), HasSubstr("map.toml"));
}

TEST_F(MapPackage, MustHaveLabels) {
  write(town(20, 20));
  fs::remove(package() / "labels.tif");
  EXPECT_EQ(fault(), labels_path() + ": no such file");
}

TEST_F(MapPackage, OfANewerFormatIsRefused) {
  write(town(20, 20));
  static_cast<void>(write_text_file(package() / "map.toml", "format = 2\n"));
  const auto read = read_overhead_map(package());
  EXPECT_THAT(error_text(read), HasSubstr("map.toml: is of map format 2, this program knows 1"));
  EXPECT_EQ(error_code(read), ErrorCode::kUnsupported);
}

TEST_F(MapPackage, WithOtherClassesIsRefused) {
  write(town(20, 20));
  static_cast<void>(write_text_file(package() / "map.toml",
                                    "format = 1\nclasses = [\"road\", \"canal\"]\n"
                                    "[plane]\nlatitude_deg = 33.0\nlongitude_deg = 2.0\n"));
  EXPECT_THAT(fault(), HasSubstr("class 1 is \"canal\" there but \"sidewalk\" here"));
}

TEST_F(MapPackage, WithABadPlaneIsRefused) {
  write(town(20, 20));
  static_cast<void>(write_text_file(package() / "map.toml",
                                    "format = 1\n[plane]\nlatitude_deg = 91\nlongitude_deg = 2\n"));
  EXPECT_THAT(fault(), HasSubstr("map.toml: map origin: latitude 91"));
  static_cast<void>(write_text_file(
      package() / "map.toml", "format = 1\n[plane]\nlatitude_deg = nan\nlongitude_deg = 2\n"));
  EXPECT_THAT(fault(), HasSubstr("not a finite number"));
}

TEST_F(MapPackage, RefusesATruncatedLabelFileInOneSentence) {
  write(town());
  const std::string bytes = read_text_file(package() / "labels.tif").value();
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{7}, bytes.size() / 4, bytes.size() / 2, bytes.size() - 200}) {
    static_cast<void>(write_text_file(package() / "labels.tif", bytes.substr(0, length)));
    const std::string text = fault();
    EXPECT_THAT(text, StartsWith(labels_path() + ": ")) << length;
    EXPECT_THAT(text, testing::Not(HasSubstr("\n"))) << length;
  }
  EXPECT_THAT(testing::internal::GetCapturedStderr(), IsEmpty());
  EXPECT_THAT(testing::internal::GetCapturedStdout(), IsEmpty());
}

TEST_F(MapPackage, RefusesLabelsWithoutGeoreference) {
  write(town(20, 20));
  replace_labels({.ids = patchwork(20, 20)});
  EXPECT_EQ(fault(), labels_path() + ": has no georeference");
}

TEST_F(MapPackage, RefusesLabelsWithoutReferenceSystem) {
  write(town(20, 20));
  RasterFile file = labels_on(town(), matrix(1, 0, 0, -1));
  file.crs.clear();
  replace_labels(file);
  EXPECT_THAT(fault(), HasSubstr("without a coordinate reference system"));
}

TEST_F(MapPackage, RefusesLabelsOnAnotherPlane) {
  write(town(20, 20));
  RasterFile file = labels_on(town(), matrix(1, 0, 0, -1));
  file.crs = "EPSG:32617";
  replace_labels(file);
  EXPECT_THAT(fault(), HasSubstr("is not the plane of map.toml"));
  file.crs = ProjectPlane::create({33.450113, -83.901223456789123}).value().wkt();  // 7 cm away
  replace_labels(file);
  EXPECT_THAT(fault(), HasSubstr("is not the plane of map.toml"));
}

TEST_F(MapPackage, RefusesRotatedFlippedAndStretchedCells) {
  write(town(20, 20));
  replace_labels(labels_on(town(), matrix(0.8, 0.6, 0.6, -0.8)));
  EXPECT_THAT(fault(), HasSubstr("labels.tif: is not north-up"));
  replace_labels(labels_on(town(), matrix(1.0, 0.0, 0.0, 1.0)));
  EXPECT_THAT(fault(), HasSubstr("labels.tif: is not north-up"));
  replace_labels(labels_on(town(), matrix(1.0, 0.0, 0.0, -1.1)));
  EXPECT_THAT(fault(), HasSubstr("cells of 1 x 1.1 m are not square"));
}

TEST_F(MapPackage, RefusesIdsThatAreNoClassAndSaysWhere) {
  write(town(20, 20));
  RasterFile file = labels_on(town(), matrix(1, 0, 0, -1));
  file.ids.at(3, 7) = 77;
  replace_labels(file);
  EXPECT_EQ(fault(), labels_path() + ": id 77 at column 3, row 7 is no class");
}

TEST_F(MapPackage, RefusesLabelsOfSeveralBands) {
  write(town(20, 20));
  RasterFile file = labels_on(town(), matrix(1, 0, 0, -1));
  file.copies = 3;
  replace_labels(file);
  EXPECT_THAT(fault(), HasSubstr("labels need one band of class ids, this has 3"));
}

TEST_F(MapPackage, RefusesTheSameLabelsWhereTheyAreReadPieceByPiece) {
  write(town(20, 20));
  const auto fault_of_tiles = [&](const RasterFile& file) {
    replace_labels(file);
    const auto tiles = OverheadTiles::open(package(), OverheadTiles::Layer::kLabels);
    return tiles ? error_text(tiles->labels({0, 0, 0})) : error_text(tiles);
  };
  RasterFile file = labels_on(town(), matrix(1, 0, 0, -1));
  EXPECT_EQ(fault_of_tiles(file), "(no error)");
  file.ids.at(3, 7) = 77;
  EXPECT_EQ(fault_of_tiles(file),
            labels_path() + ": id 77 at column 3, row 7 of level 0 is no class");
  file = labels_on(town(), matrix(1, 0, 0, -1));
  file.ids = Raster<std::uint8_t>(20, 10, kRoad);
  file.ids.at(2, 1) = 2;
  file.bits = 16;  // Times 257, which cut to eight bits would become 255, unclassified.
  EXPECT_EQ(fault_of_tiles(file),
            labels_path() + ": id 514 at column 2, row 1 of level 0 is no class");
  file = labels_on(town(), matrix(1, 0, 0, -1));
  file.no_data = kRoad;
  EXPECT_THAT(fault_of_tiles(file), HasSubstr("its no-data value is 0 and not 255"));
  file = labels_on(town(), matrix(1, 0, 0, -1));
  file.copies = 3;
  EXPECT_THAT(fault_of_tiles(file), HasSubstr("labels need one band of whole numbers"));
}

TEST_F(MapPackage, SaysWhereAnIdThatIsNoClassLiesInATileFarFromTheCorner) {
  OverheadMap map = town(1100, 600);
  map.labels.at(1090, 555) = 99;
  write(map);
  const auto tiles = OverheadTiles::open(package(), OverheadTiles::Layer::kLabels);
  ASSERT_TRUE(tiles) << error_text(tiles);
  EXPECT_TRUE(tiles->labels({0, 1, 0}));
  EXPECT_EQ(error_text(tiles->labels({0, 2, 1})),
            labels_path() + ": id 99 at column 1090, row 555 of level 0 is no class");
}

TEST_F(MapPackage, AcceptsLabelsThatAnotherProgramWroteOnThePlane) {
  const OverheadMap map = town(20, 20);
  write(map);
  replace_labels(labels_on(map, matrix(2, 0, 0, -2)));
  const auto read = read_overhead_map(package());
  ASSERT_TRUE(read) << error_text(read);
  EXPECT_EQ(read->metres_per_cell, 2.0);
  EXPECT_EQ(read->labels, patchwork(20, 10));
}

TEST_F(MapPackage, RefusesLabelsThatTakeAClassForNoData) {
  write(town(20, 20));
  RasterFile file = labels_on(town(), matrix(1, 0, 0, -1));
  file.no_data = kRoad;
  replace_labels(file);
  EXPECT_EQ(fault(), labels_path() + ": its no-data value is 0 and not 255, import it anew");
  file.no_data = kUnclassified;
  replace_labels(file);
  EXPECT_EQ(fault(), "(no error)");
}

TEST_F(MapPackage, RefusesLabelsWithoutAPlaceThatIsANumber) {
  write(town(20, 20));
  for (const int element : {0, 1, 2, 3}) {
    RasterFile file = labels_on(town(), matrix(1, 0, 0, -1));
    file.crs_from_pixel->linear(element / 2, element % 2) =
        std::numeric_limits<double>::quiet_NaN();
    replace_labels(file);
    EXPECT_THAT(fault(), StartsWith(labels_path() + ": ")) << element;
  }
}

TEST_F(MapPackage, IsNotWrittenIntoAFile) {
  const fs::path file = folder.file("letter.txt", "dear");
  const auto written = write_overhead_map(town(20, 20), town_provenance, {}, file / "town");
  ASSERT_FALSE(written);
  EXPECT_EQ(error_code(written), ErrorCode::kIo);
  EXPECT_THAT(error_text(written), StartsWith((file / "town").string()));
  EXPECT_EQ(folder.entries(), 1);
}

TEST_F(MapPackage, IsNotWrittenFromAnEmptyRaster) {
  EXPECT_THROW(static_cast<void>(write_overhead_map(drawn_map(1.0, {}), {}, {}, package())),
               std::logic_error);
}

}  // namespace overhead_map_file_test
}  // namespace nadir
