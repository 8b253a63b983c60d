// SPDX-License-Identifier: Apache-2.0
// What an image's bands become, and what is no image at all.
#include <gmock/gmock.h>

#include <fstream>
#include <thread>

#include "core/base/staged_output.h"
#include "core/map/overhead_image.h"
#include "tests/core/map/image_files.h"
#include "tests/core/map/raster_files.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace overhead_image_pixels_test {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

class PixelsOfAnImage : public testing::Test {
 protected:
  [[nodiscard]] OpenedImage opened(const DrawnImage& image,
                                   const std::string& name = "image.tif") const {
    write_image(image, scratch.path() / name);
    return read(name);
  }
  [[nodiscard]] OpenedImage read(const std::string& name) const {
    auto result = open_overhead_image(scratch.path() / name);
    if (!result) throw std::runtime_error(error_text(result));
    return std::move(*result);
  }
  [[nodiscard]] std::string refusal(const std::string& name,
                                    const ImageOptions& options = {}) const {
    return error_text(open_overhead_image(scratch.path() / name, options));
  }

  ScratchFolder scratch;
};

TEST_F(PixelsOfAnImage, AreTheSameInEveryLosslessKind) {
  const ImageRaster pixels = mosaic(600, 40);
  EXPECT_EQ(whole_picture(opened({.pixels = pixels}).tiles), pixels);
  EXPECT_EQ(
      whole_picture(opened({.pixels = pixels, .options = {"TILED=YES", "COMPRESS=LZW"}}).tiles),
      pixels);
  EXPECT_EQ(whole_picture(opened({.pixels = pixels, .driver = "COG"}).tiles), pixels);
  EXPECT_EQ(whole_picture(opened({.pixels = pixels, .driver = "PNG"}, "image.png").tiles), pixels);
}

TEST_F(PixelsOfAnImage, AreNearlyTheSameInAJpeg) {
  const ImageRaster pixels = mosaic(64, 64);
  const ImageRaster read = whole_picture(
      opened({.pixels = pixels, .driver = "JPEG", .options = {"QUALITY=95"}}, "image.jpg").tiles);
  for (int at = 8; at < 64; at += 16)
    EXPECT_NEAR(read.at(at, at).green, pixels.at(at, at).green, 12);
}

TEST_F(PixelsOfAnImage, LieInTheirPlaceInMbtiles) {
  Affine2 crs_from_pixel;
  crs_from_pixel.linear << 0.6, 0.0, 0.0, -0.6;
  crs_from_pixel.offset = {934'000.0, 6'271'000.0};
  const OpenedImage tiles = opened({.pixels = ImageRaster(256, 256, ImagePixel{200, 40, 90, 255}),
                                    .driver = "MBTiles",
                                    .crs_from_pixel = crs_from_pixel,
                                    .crs = "EPSG:3857"},
                                   "town.mbtiles");
  EXPECT_EQ(tiles.image.place, ImagePlace::kOwn);
  const auto at = [&](double column, double row) {
    const Eigen::Vector2d lon_lat =
        lon_lat_from_crs("EPSG:3857", crs_from_pixel * Eigen::Vector2d(column, row));
    return shown_at(tiles.tiles, tiles.image.plane->enu_from_geodetic({lon_lat.y(), lon_lat.x()}));
  };
  EXPECT_NEAR(at(128, 128).red, 200, 3);
  EXPECT_NEAR(at(128, 128).blue, 90, 3);
  EXPECT_EQ(at(128, 128).alpha, 255);
  EXPECT_EQ(at(-20, 128).alpha, 0);
}

TEST_F(PixelsOfAnImage, OfASinglePixelAreOneCell) {
  const OpenedImage one = opened({.pixels = ImageRaster(1, 1, ImagePixel{10, 20, 30, 255})});
  EXPECT_EQ(one.tiles.level_count(), 1);
  EXPECT_EQ(one.tiles.picture({0, 0, 0}).value().at(0, 0), (ImagePixel{10, 20, 30, 255}));
  Affine2 crs_from_pixel;
  crs_from_pixel.linear << 0.5, 0.0, 0.0, -0.5;
  crs_from_pixel.offset = {500'000.0, 5'300'000.0};
  const OpenedImage placed = opened({.pixels = ImageRaster(1, 1, ImagePixel{10, 20, 30, 255}),
                                     .crs_from_pixel = crs_from_pixel,
                                     .crs = "EPSG:32632"});
  EXPECT_EQ(shown_at(placed.tiles, Eigen::Vector2d::Zero()).green, 20);
}

TEST_F(PixelsOfAnImage, AreClearWhereAlphaOrNoDataSaysSo) {
  ImageRaster pixels = mosaic(32, 32);
  for (int row = 0; row < 16; ++row) {
    for (int column = 0; column < 32; ++column) pixels.at(column, row) = {7, 7, 7, 0};
  }
  pixels.at(20, 20) = {7, 90, 7, 255};  // one band alone is not nothing
  for (const DrawnImage& image : {DrawnImage{.pixels = pixels, .has_alpha = true},
                                  DrawnImage{.pixels = pixels, .no_data = 7}}) {
    const ImageRaster read = whole_picture(opened(image).tiles);
    EXPECT_EQ(read.at(5, 5).alpha, 0);
    EXPECT_EQ(read.at(5, 20), pixels.at(5, 20));
    EXPECT_EQ(read.at(20, 20), pixels.at(20, 20));
  }
}

TEST_F(PixelsOfAnImage, OfSixteenBitsAreStretchedBetweenTwoAndNinetyEightPerCent) {
  ImageRaster pixels(100, 100);
  for (int row = 0; row < 100; ++row) {
    for (int column = 0; column < 100; ++column) {
      pixels.at(column, row) = {static_cast<std::uint8_t>(column + 50), 0, 0, 255};
    }
  }
  const ImageRaster read =
      whole_picture(opened({.pixels = pixels, .is_grey = true, .value_factor = 40}).tiles);
  EXPECT_EQ(read.at(0, 5).red, 0);
  EXPECT_EQ(read.at(1, 5).red, 0);
  EXPECT_NEAR(read.at(50, 5).red, 128, 3);
  EXPECT_EQ(read.at(50, 5).green, read.at(50, 5).red);
  EXPECT_EQ(read.at(98, 5).red, 255);
  EXPECT_EQ(read.at(99, 5).red, 255);
}

TEST_F(PixelsOfAnImage, OfPalettesAndSingleBitsAreColours) {
  RasterFile paletted{.ids = Raster<std::uint8_t>(20, 20, std::uint8_t{2})};
  paletted.ids.at(3, 3) = 1;
  paletted.palette = {{1, 2, 3}, {250, 10, 20}, {30, 200, 40}};
  write_raster(paletted, scratch.path() / "palette.tif");
  const ImageRaster colours = whole_picture(read("palette.tif").tiles);
  EXPECT_EQ(colours.at(3, 3), (ImagePixel{250, 10, 20, 255}));
  EXPECT_EQ(colours.at(4, 3), (ImagePixel{30, 200, 40, 255}));
  RasterFile bits{.ids = Raster<std::uint8_t>(20, 20, std::uint8_t{0}), .bits = 1};
  bits.ids.at(3, 3) = 1;
  write_raster(bits, scratch.path() / "bits.tif");
  const ImageRaster black_and_white = whole_picture(read("bits.tif").tiles);
  EXPECT_EQ(black_and_white.at(3, 3), (ImagePixel{255, 255, 255, 255}));
  EXPECT_EQ(black_and_white.at(4, 3), (ImagePixel{0, 0, 0, 255}));
}

TEST_F(PixelsOfAnImage, AreTheSameFromEveryThread) {
  const OpenedImage image = opened({.pixels = mosaic(1500, 1100)});
  const ImageRaster alone = whole_picture(image.tiles);
  std::vector<ImageRaster> together(3);
  {
    std::vector<std::jthread> threads;
    threads.reserve(together.size());
    for (ImageRaster& read : together) {
      threads.emplace_back([&read, &image] { read = whole_picture(image.tiles); });
    }
  }
  for (const ImageRaster& read : together) EXPECT_EQ(read, alone);
}

TEST_F(PixelsOfAnImage, SayWhenTheyWereTaken) {
  const auto date = [&](const DrawnImage& image, const std::string& name) {
    return opened(image, name).image.date;
  };
  const ImageRaster pixels = mosaic(16, 16);
  EXPECT_EQ(date({.pixels = pixels}, "town.tif"), std::nullopt);
  EXPECT_EQ(date({.pixels = pixels}, "town_2019-05-01.tif"), (ImageDate{"2019-05-01", "its name"}));
  const DrawnImage dated{.pixels = pixels,
                         .metadata = {{"TIFFTAG_DATETIME", "2018:03:02 10:00:00", ""}}};
  EXPECT_EQ(date(dated, "town_2019-05-01.tif"), (ImageDate{"2018-03-02", "its TIFF date"}));
  DrawnImage acquired = dated;
  acquired.metadata.push_back({"ACQUISITIONDATETIME", "2017-02-01 09:00:00", ""});
  EXPECT_EQ(date(acquired, "town.tif"), (ImageDate{"2017-02-01", "its acquisition time"}));
}

TEST_F(PixelsOfAnImage, ThatAreNoneAreRefusedByName) {
  EXPECT_THAT(refusal("none.tif"), EndsWith("none.tif: no such file"));
  EXPECT_THAT(refusal(""), HasSubstr("is a folder, not an image"));
  scratch.file("words.png", "these are words");
  EXPECT_THAT(refusal("words.png"), HasSubstr("words.png: is no readable GeoTIFF, PNG, JPEG"));
  scratch.file("elsewhere.vrt", "<VRTDataset rasterXSize=\"1\" rasterYSize=\"1\"></VRTDataset>");
  EXPECT_THAT(refusal("elsewhere.vrt"), HasSubstr("elsewhere.vrt: is no readable GeoTIFF"));
}

TEST_F(PixelsOfAnImage, ThatAreCutShortAreRefused) {
  const auto path = scratch.path() / "cut.tif";
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{}, {"TILED=YES", "COMPRESS=DEFLATE"}, {"INTERLEAVE=BAND"}}) {
    write_image({.pixels = mosaic(600, 600), .options = options}, path);
    const auto whole = std::filesystem::file_size(path);
    int refused = 0, opened_whole = 0;
    for (const double share : {0.0, 0.01, 0.3, 0.7, 0.99}) {
      std::filesystem::remove(path);  // for GDAL looks at what it writes over
      write_image({.pixels = mosaic(600, 600), .options = options}, path);
      std::filesystem::resize_file(path,
                                   static_cast<std::uintmax_t>(share * static_cast<double>(whole)));
      const auto cut = open_overhead_image(path);
      cut ? ++opened_whole : ++refused;
      if (!cut) {
        EXPECT_THAT(error_text(cut), AllOf(HasSubstr("cut.tif: "), testing::Not(HasSubstr("\n"))));
      }
    }
    EXPECT_EQ(refused, 5);
    EXPECT_EQ(opened_whole, 0);
  }
}

TEST_F(PixelsOfAnImage, WithDamagedBytesAreReadOrRefusedInASentence) {
  const auto path = scratch.path() / "damaged.tif";
  Affine2 crs_from_pixel;
  crs_from_pixel.linear << 0.5, 0.0, 0.0, -0.5;
  crs_from_pixel.offset = {500'000.0, 5'300'000.0};
  int refused = 0, read = 0;
  for (const bool is_placed : {false, true}) {
    DrawnImage image{.pixels = mosaic(40, 30)};
    if (is_placed) {
      image.crs_from_pixel = crs_from_pixel;
      image.crs = "EPSG:32632";
    }
    write_image(image, path);
    const std::string whole = read_text_file(path).value();
    for (std::uint32_t i = 0; i < (is_placed ? 20U : 150U); ++i) {
      std::string damaged = whole;
      const std::uint32_t mixed = (i + 1) * 2'654'435'761U;
      damaged[(mixed >> 8U) % 400U] = static_cast<char>(mixed & 0xFFU);
      std::ofstream(path, std::ios::binary) << damaged;
      const auto opened = open_overhead_image(path);
      const auto tile = opened ? opened->tiles.picture({opened->tiles.level_count() - 1, 0, 0})
                               : Result<ImageRaster>(tl::unexpected(opened.error()));
      if (!tile) {
        EXPECT_THAT(error_text(tile), HasSubstr("damaged.tif: "));
      }
      tile ? ++read : ++refused;
    }
  }
  EXPECT_GT(refused, 5);
  EXPECT_GT(read, 5);
}

TEST_F(PixelsOfAnImage, WhoseCoordinatesAreNonsenseAreRefused) {
  const auto refused = [&](const Affine2& crs_from_pixel, const std::string& crs,
                           const ImageOptions& options = {}) {
    write_image({.pixels = mosaic(64, 64), .crs_from_pixel = crs_from_pixel, .crs = crs},
                scratch.path() / "odd.tif");
    return refusal("odd.tif", options);
  };
  const auto at = [](double x, double y, double size) {
    Affine2 affine;
    affine.linear << size, 0.0, 0.0, -size;
    affine.offset = {x, y};
    return affine;
  };
  EXPECT_THAT(refused(at(-92.8, 92.8, 0.18), "EPSG:4326"),
              HasSubstr("odd.tif: claims to be in degrees but reaches latitude 92.8"));
  EXPECT_THAT(refused(at(0.0, 0.0, 0.5), "EPSG:4326"),
              HasSubstr("odd.tif: spans more than the 1000 km"));
  EXPECT_THAT(refused(at(500'000, 5'300'000, 0.25), "EPSG:32632", {.crs = "EPSG:3857"}),
              HasSubstr("odd.tif: has a coordinate reference system of its own"));
  EXPECT_THAT(refused(at(500'000, 5'300'000, 0.25), "EPSG:32632",
                      {.plane = ProjectPlane::create({-33.0, 151.0}).value()}),
              HasSubstr("km from the map"));
  EXPECT_THAT(refused(at(500'000, 5'300'000, 0.25), "EPSG:32632",
                      {.plane = ProjectPlane::create({47.0, 9.0}).value(),
                       .enu_from_pixels = Affine2{Eigen::Matrix2d::Zero(), {0.0, 0.0}}}),
              StartsWith((scratch.path() / "odd.tif").string()));
}

}  // namespace overhead_image_pixels_test
}  // namespace nadir
