// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "core/map/map_import.h"
#include "tests/core/map/raster_files.h"
#include "tests/support/drawn_map.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace class_images_test {

using testing::Contains;
using testing::HasSubstr;

/// X is `inside`, anything else its opposite.
Raster<std::uint8_t> mask(const std::vector<std::string>& rows, int inside = 255) {
  Raster<std::uint8_t> values(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
  for (int row = 0; row < values.height(); ++row) {
    for (int column = 0; column < values.width(); ++column) {
      const char letter = rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
      values.at(column, row) = static_cast<std::uint8_t>(letter == 'X' ? inside : 255 - inside);
    }
  }
  return values;
}

class ClassImages : public testing::Test {
 protected:
  void add(const std::string& name, const Raster<std::uint8_t>& values) const {
    write_raster({.ids = values, .driver = "PNG"}, folder.path() / name);
  }
  [[nodiscard]] Result<ImportedMap> import() const { return import_map(folder.path(), options); }
  [[nodiscard]] Raster<ClassId> labels() const {
    const auto result = import();
    if (!result) throw std::runtime_error(error_text(result));
    return result->map.labels;
  }
  void remap(std::string_view text) { options.remap = ClassRemap::parse(text, "r.toml").value(); }

  ScratchFolder folder;
  ImportOptions options{.anchor = Geodetic{33.45, -83.9}, .metres_per_pixel = 0.5};
};

Raster<ClassId> drawn(const std::vector<std::string>& rows) { return drawn_map(1.0, rows).labels; }

TEST_F(ClassImages, AreFoundByNumberAndByName) {
  add("class0.png", mask({"XX....", "......"}));
  add("class_2.png", mask({"..X...", "......"}));
  add("Lane Markings.png", mask({"...X..", "......"}));
  add("terrain.PNG", mask({"....X.", "X....."}));
  EXPECT_EQ(labels(), drawn({"RRBLT.", "T....."}));
}

TEST_F(ClassImages, MayMeanInsideByZero) {
  add("road.png", mask({"X..", "..X"}, 0));
  options.inside_value = 0;
  EXPECT_EQ(labels(), drawn({"R..", "..R"}));
}

TEST_F(ClassImages, AreRemappedByNumberAndByName) {
  add("class0.png", mask({"X..."}));
  add("class1.png", mask({".X.."}));
  add("class5.png", mask({"..X."}));
  add("Gras.png", mask({"...X"}));
  remap("[ids]\n0 = \"terrain\"\n1 = \"road\"\n[classes]\nGras = \"vegetation\"\n");
  EXPECT_EQ(labels(), drawn({"TR.V"}));
}

TEST_F(ClassImages, ThatOverlapAreWonByWhatIsThinner) {
  add("terrain.png", mask({"XXXXXX"}));
  add("vegetation.png", mask({".XXXXX"}));
  add("road.png", mask({"..XXXX"}));
  add("building.png", mask({"...X.."}));
  add("curb.png", mask({"....XX"}));
  add("lane marking.png", mask({".....X"}));
  EXPECT_EQ(labels(), drawn({"TVRBCL"}));
}

TEST_F(ClassImages, WithSmoothedEdgesInventNoClassAndLeaveNoGap) {
  Raster<std::uint8_t> smooth(4, 1, {255, 200, 60, 0});
  add("road.png", smooth);
  EXPECT_EQ(labels(), drawn({"RR.."}));
  options.inside_value = 0;
  EXPECT_EQ(labels(), drawn({"..RR"}));
}

TEST_F(ClassImages, AreFlippedBeforeTheyAreAnchored) {
  add("road.png", mask({"XX", "..", ".."}));
  options.flip_vertically = true;
  const auto result = import();
  ASSERT_TRUE(result) << error_text(result);
  EXPECT_EQ(result->map.labels, drawn({"..", "..", "RR"}));
  const Geodetic corner = result->map.plane.geodetic_from_enu(result->map.top_left_in_enu_m);
  EXPECT_NEAR(corner.latitude_deg, 33.45, 1e-11);
}

TEST_F(ClassImages, MustBeOfOneSize) {
  add("road.png", mask({"XX", ".."}));
  add("terrain.png", mask({"XXX", "..."}));
  EXPECT_THAT(error_text(import()), HasSubstr("road.png: is 2 x 2 pixels, but"));
  EXPECT_THAT(error_text(import()), HasSubstr("terrain.png is 3 x 2"));
}

TEST_F(ClassImages, ThatStandForNoClassAreLeftOutAloud) {
  add("road.png", mask({"X."}));
  add("overview.png", mask({"XX"}));
  add("curb.png", mask({".."}));
  const auto result = import();
  ASSERT_TRUE(result) << error_text(result);
  EXPECT_THAT(result->notices, Contains("overview.png stands for no class and is left out"));
  EXPECT_THAT(result->notices, Contains("curb.png holds no cell of its class"));
}

TEST_F(ClassImages, WithNumbersForNamesSayWhatTheyWereTakenFor) {
  add("class0.png", mask({"X."}));
  add("Class_3.png", mask({".X"}));
  add("terrain.png", mask({"XX"}));
  const auto result = import();
  ASSERT_TRUE(result) << error_text(result);
  EXPECT_THAT(result->notices,
              testing::ElementsAre("without --remap numbers were taken as this program's classes: "
                                   "Class_3.png as fence, class0.png as road"));
  options.remap = ClassRemap::parse("[ids]\n0 = \"curb\"\n3 = \"pole\"\n", "r.toml").value();
  const auto remapped = import();
  ASSERT_TRUE(remapped) << error_text(remapped);
  EXPECT_THAT(remapped->notices, testing::IsEmpty());
}

TEST_F(ClassImages, MustBeThere) {
  EXPECT_THAT(error_text(import()), HasSubstr("holds no class image"));
  add("class99.png", mask({"X"}));
  EXPECT_THAT(error_text(import()), HasSubstr("holds no class image"));
}

TEST_F(ClassImages, NeedAPlace) {
  add("road.png", mask({"X."}));
  options.anchor.reset();
  options.metres_per_pixel.reset();
  EXPECT_THAT(error_text(import()), HasSubstr("place it with --anchor and --metres-per-pixel"));
}

TEST_F(ClassImages, NeedOneChannel) {
  write_picture(ColourRaster(2, 2), folder.path() / "road.png");
  EXPECT_THAT(error_text(import()),
              HasSubstr("road.png: a class image needs one channel, bright or dark, this has 3"));
}

TEST_F(ClassImages, MayHaveAnyNumberOfBits) {
  for (const int bits : {1, 2, 4}) {
    const int brightest = (1 << bits) - 1;
    Raster<std::uint8_t> values = mask({"X..X", ".XX."});
    for (std::uint8_t& value : values.values())
      value = value == 0 ? 0 : static_cast<std::uint8_t>(brightest);
    write_raster({.ids = values, .driver = "PNG", .bits = bits}, folder.path() / "road.png");
    options.inside_value.reset();
    EXPECT_EQ(labels(), drawn({"R..R", ".RR."})) << bits;
    options.inside_value = 0;
    EXPECT_EQ(labels(), drawn({".RR.", "R..R"})) << bits;
  }
  write_raster({.ids = mask({"X..X", ".XX."}), .driver = "PNG", .bits = 16},
               folder.path() / "road.png");
  EXPECT_EQ(labels(), drawn({".RR.", "R..R"}));
  options.inside_value.reset();
  EXPECT_EQ(labels(), drawn({"R..R", ".RR."}));
}

TEST_F(ClassImages, WithAPaletteGoByTheColourAndNotByItsNumber) {
  // 0 is white and 1 black, the other way round than grey would be.
  write_raster({.ids = Raster<std::uint8_t>(4, 1, {0, 1, 1, 2}),
                .driver = "PNG",
                .palette = {{255, 255, 255}, {0, 0, 0}, {250, 240, 255}}},
               folder.path() / "road.png");
  EXPECT_EQ(labels(), drawn({"R..R"}));
}

TEST_F(ClassImages, AreOutsideWhereTheyAreTransparent) {
  write_raster({.ids = mask({"X..", "..."}), .no_data = 0, .driver = "PNG"},
               folder.path() / "road.png");
  write_raster({.ids = Raster<std::uint8_t>(3, 2, {0, 1, 0, 0, 0, 0}),
                .no_data = 0,
                .driver = "PNG",
                .palette = {{0, 0, 0}, {255, 255, 255}}},
               folder.path() / "curb.png");
  EXPECT_EQ(labels(), drawn({"RC.", "..."}));
}

class PlacedClassImages : public ClassImages {
 protected:
  void SetUp() override { options = {.crs = "EPSG:32617"}; }
  void place(const std::string& name, const Eigen::Vector2d& top_left, double pixel = 1.0) const {
    Affine2 crs_from_pixel;
    crs_from_pixel.linear << pixel, 0.0, 0.0, -pixel;
    crs_from_pixel.offset = top_left;
    static_cast<void>(folder.file(name, world_file(crs_from_pixel)));
  }

  const Eigen::Vector2d corner{500000.0, 3705000.0};
};

TEST_F(PlacedClassImages, LieWhereTheirWorldFilesSay) {
  add("road.png", mask({"X....", ".....", "....."}));
  add("curb.png", mask({".....", "...X.", "....."}));
  place("road.pgw", corner);
  place("curb.pgw", corner);
  const auto result = import();
  ASSERT_TRUE(result) << error_text(result);
  EXPECT_EQ(result->map.labels, drawn({"R....", "...C.", "....."}));
  const Eigen::Vector2d lon_lat =
      lon_lat_from_crs("EPSG:32617", corner + Eigen::Vector2d(0.5, -0.5));
  EXPECT_EQ(result->map.class_at(result->map.plane.enu_from_geodetic({lon_lat.y(), lon_lat.x()})),
            kRoad);
}

TEST_F(PlacedClassImages, MayTakeTheirPlaceFromAnyOfThem) {
  add("road.png", mask({"X....", ".....", "....."}));
  add("curb.png", mask({".....", "...X.", "....."}));
  place("curb.pgw", corner);  // Painted last.
  EXPECT_EQ(labels(), drawn({"R....", "...C.", "....."}));
}

TEST_F(PlacedClassImages, MustAllLieAtOnePlace) {
  add("road.png", mask({"X....", ".....", "....."}));
  add("curb.png", mask({".....", "...X.", "....."}));
  place("road.pgw", corner);
  for (const Eigen::Vector2d& offset : {Eigen::Vector2d(1.0, 0.0), Eigen::Vector2d(0.0, 0.05)}) {
    place("curb.pgw", corner + offset);
    EXPECT_THAT(error_text(import()), HasSubstr("curb.png: does not lie where "));
  }
  place("curb.pgw", corner, 1.1);
  EXPECT_THAT(error_text(import()), HasSubstr("road.png lies"));
}

}  // namespace class_images_test
}  // namespace nadir
