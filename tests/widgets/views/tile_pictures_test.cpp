// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/tile_pictures.h"

#include "core/map/overhead_image.h"
#include "tests/core/map/image_files.h"
#include "tests/support/scratch_folder.h"
#include "tests/widgets/views/label_tiles.h"

namespace nadir {
namespace tile_pictures_test {

constexpr int kAll = 1000;

TEST(LabelPictures, AreTheRasterOfTheirLevelToThePixel) {
  LabelDocument document(test_plane(), LabelGrid{0.3, {-5.0, 9.0}, 1500, 700});
  for (std::uint32_t seed = 0; seed < 50; ++seed) document.apply(random_edit(document, seed));
  const LabelPictures pictures(std::make_shared<const LabelDocument>(document));
  ASSERT_EQ(pictures.level_count(), 3);
  for (int level = 0; level < 3; ++level) {
    LabelGrid coarse = document.grid();
    coarse.metres_per_cell *= 1 << level;
    coarse.width = (1500 + (1 << level) - 1) >> level;
    coarse.height = (700 + (1 << level) - 1) >> level;
    const Raster<Rgba> whole = class_picture(rasterise(document, coarse, coarse.whole()));
    std::size_t compared = 0;
    for (int row = 0; row < pictures.rows(level); ++row) {
      for (int column = 0; column < pictures.columns(level); ++column) {
        const TileAddress address{level, column, row};
        const Raster<Rgba> tile = pictures.picture(address).value();
        for (int y = 0; y < tile.height(); ++y) {
          for (int x = 0; x < tile.width(); ++x, ++compared) {
            ASSERT_EQ(tile.at(x, y), whole.at(column * kTileSide + x, row * kTileSide + y));
          }
        }
        const CellRect cells = pictures.cells_of(address);
        EXPECT_EQ(cells.left, std::int64_t{column} * kTileSide << level);
        EXPECT_EQ(cells.width(), std::int64_t{tile.width()} << level);
        EXPECT_EQ(cells.height(), std::int64_t{tile.height()} << level);
        const CellRect part{tile.width() / 3, tile.height() / 4, tile.width() / 3 + 5,
                            tile.height() / 4 + 7};
        const Raster<Rgba> cut = pictures.part(address, part).value();
        for (int y = 0; y < 7; ++y) {
          for (int x = 0; x < 5; ++x) {
            ASSERT_EQ(cut.at(x, y),
                      tile.at(static_cast<int>(part.left) + x, static_cast<int>(part.top) + y));
          }
        }
      }
    }
    EXPECT_EQ(compared, whole.size());
  }
}

TEST(LabelPictures, KeepThinLinesAtEveryLevel) {
  LabelDocument document(test_plane(), LabelGrid{0.1, {0.0, 0.0}, 4000, 4000});
  document.apply(adding({line(kLaneMarking, {{1.0, -1.0}, {390.0, -377.0}}, 0.05)}));
  const LabelPictures pictures(std::make_shared<const LabelDocument>(document));
  const int coarsest = pictures.level_count() - 1;
  ASSERT_GE(coarsest, 3);
  const Raster<Rgba> all = pictures.picture({coarsest, 0, 0}).value();
  const auto seen =
      std::count(all.values().begin(), all.values().end(), class_colour(kLaneMarking));
  EXPECT_GE(seen, 389.0 / std::ldexp(0.1, coarsest) - 2) << "a pixel a column at least";
}

/// Turned by 30 degrees, pixels of 0.5 m, in UTM.
void place_turned(DrawnImage& drawn) {
  const double c = 0.5 * std::cos(0.5236), s = 0.5 * std::sin(0.5236);
  Affine2 placed;
  placed.linear << c, s, s, -c;
  placed.offset = {455'000.0, 5'427'000.0};
  drawn.crs_from_pixel = placed;
  drawn.crs = "EPSG:32632";
}

/// An image that its file says lies turned and stretched, on the plane and in a window.
class TurnedImage : public MapPage {
 protected:
  void SetUp() override {
    DrawnImage drawn{.pixels = mosaic(400, 300)};  // colours change each 16 pixels
    place_turned(drawn);
    write_image(drawn, folder.path() / "turned.tif");
    auto opened = open_overhead_image(folder.path() / "turned.tif");
    ASSERT_TRUE(opened) << error_text(opened);
    tiles = std::make_shared<const OverheadTiles>(std::move(opened->tiles));
  }
  const ScratchFolder folder;
  std::shared_ptr<const OverheadTiles> tiles;
};

TEST_F(TurnedImage, ShowsAKnownCornerOnTheKnownPixelOfTheWindow) {
  const Eigen::Vector2d offset(3.0, -2.0);
  const auto pictures = std::make_shared<const OverheadPictures>(
      tiles, OverheadTiles::Layer::kPicture, ImageLook{}, offset);
  const LabelGrid& grid = pictures->grid();
  MapScene scene(grid.enu_from_cells({grid.width / 2.0, grid.height / 2.0}));
  TilePyramidView view(scene, MapLayer::kPicture, pictures);
  const PageRect page{0, 0, 300, 240};
  for (const double up_rad : {1.5707963267948966, 0.4}) {
    const MapCamera camera{grid.enu_from_cells({grid.width / 2.0, grid.height / 2.0}), 0.5, up_rad};
    ASSERT_TRUE(view.update(camera, page.width, page.height, kAll).value());
    const Raster<Rgba> drawn = draw(scene, camera, 300, 240);
    int compared = 0;
    for (int row = 0; row < drawn.height(); ++row) {
      for (int column = 0; column < drawn.width(); ++column) {
        // Where this pixel's centre is in the file, whose squares it must show: away from their borders, for both ways of
        // mixing colours reach more than a pixel far, one of them askew.
        const Eigen::Vector2d in_enu =
            camera.enu_from_page(centre_of_pixel(drawn, column, row), page) - offset;
        const auto in_file = tiles->pixels_from_enu(in_enu);
        ASSERT_TRUE(in_file);
        const Eigen::Vector2d in_square(std::fmod(in_file->x(), 16.0),
                                        std::fmod(in_file->y(), 16.0));
        if (in_file->minCoeff() < 2.0 || in_file->x() > 398.0 || in_file->y() > 298.0 ||
            in_square.minCoeff() < 3.25 || in_square.maxCoeff() > 12.75) {
          continue;
        }
        const ImagePixel truth =
            mosaic_colour(static_cast<int>(in_file->x()), static_cast<int>(in_file->y()));
        ASSERT_LE(difference(drawn.at(column, row), {truth.red, truth.green, truth.blue}), 2)
            << column << " " << row;
        ++compared;
      }
    }
    EXPECT_GT(compared, 15'000);
  }
}

TEST_F(TurnedImage, LiesWhereItsFileSaysToATwentiethOfAPixel) {
  const ScratchFolder ramps;
  DrawnImage drawn{.pixels = ImageRaster(400, 300)};
  for (int row = 0; row < 300; ++row) {
    for (int column = 0; column < 400; ++column) {
      const auto level = [](double at, double per_pixel) {
        return static_cast<std::uint8_t>(std::lround(20.0 + at * per_pixel));
      };
      drawn.pixels.at(column, row) = {level(column + 0.5, 0.5), level(row + 0.5, 0.5), 128, 255};
    }
  }
  place_turned(drawn);
  write_image(drawn, ramps.path() / "ramp.tif");
  auto opened = open_overhead_image(ramps.path() / "ramp.tif");
  ASSERT_TRUE(opened) << error_text(opened);
  const auto ramp = std::make_shared<const OverheadTiles>(std::move(opened->tiles));
  const ImageRaster whole = whole_picture(*ramp);
  const LabelGrid grid = OverheadPictures(ramp, OverheadTiles::Layer::kPicture).grid();
  double sum_x = 0.0, sum_y = 0.0;
  int compared = 0;
  for (int row = 0; row < whole.height(); ++row) {
    for (int column = 0; column < whole.width(); ++column) {
      const Eigen::Vector2d in_enu = grid.enu_from_cells({column + 0.5, row + 0.5});
      const auto in_file = ramp->pixels_from_enu(in_enu);
      if (!in_file || in_file->minCoeff() < 4.0 || in_file->x() > 396.0 || in_file->y() > 296.0)
        continue;
      sum_x += (whole.at(column, row).red - 20.0) / 0.5 - in_file->x();
      sum_y += (whole.at(column, row).green - 20.0) / 0.5 - in_file->y();
      ++compared;
    }
  }
  ASSERT_GT(compared, 90'000);
  EXPECT_NEAR(sum_x / compared, 0.0, 0.05);
  EXPECT_NEAR(sum_y / compared, 0.0, 0.05);
}

TEST_F(TurnedImage, HasBrightnessAndContrastInItsPixels) {
  const ImageLook look{.brightness = 0.3, .contrast = -0.2};
  const OverheadPictures plain(tiles, OverheadTiles::Layer::kPicture);
  const OverheadPictures bright(tiles, OverheadTiles::Layer::kPicture, look);
  const auto table = tone_table(look);
  const Raster<Rgba> before = plain.picture({0, 0, 0}).value();
  const Raster<Rgba> after = bright.picture({0, 0, 0}).value();
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Rgba& was = before.values()[i];
    ASSERT_EQ(after.values()[i],
              (Rgba{table.at(was.red), table.at(was.green), table.at(was.blue), was.alpha}));
  }
  // What is cut out is what is there.
  const CellRect part{3, 5, 40, 60};
  const Raster<Rgba> cut = bright.part({0, 0, 0}, part).value();
  ASSERT_EQ(cut.width(), 37);
  ASSERT_EQ(cut.height(), 55);
  for (int row = 0; row < 55; ++row) {
    for (int column = 0; column < 37; ++column) {
      ASSERT_EQ(cut.at(column, row), after.at(column + 3, row + 5));
    }
  }
}

TEST_F(TurnedImage, ShowsAnotherBrightnessTileByTileWithoutEverBeingClear) {
  const auto plain =
      std::make_shared<const OverheadPictures>(tiles, OverheadTiles::Layer::kPicture);
  const auto bright = std::make_shared<const OverheadPictures>(
      tiles, OverheadTiles::Layer::kPicture, ImageLook{.brightness = 0.5});
  const LabelGrid& grid = plain->grid();
  const MapCamera camera{grid.enu_from_cells({grid.width / 2.0, grid.height / 2.0}), 0.5};
  MapScene scene(camera.centre_in_enu_m);
  TilePyramidView view(scene, MapLayer::kPicture, plain, nullptr, TileMaking::kInThread);
  while (!view.update(camera, 100, 80, kAll).value()) view.wait();
  const Raster<Rgba> before = draw(scene, camera, 100, 80);
  view.show(bright);
  view.forget_all();
  EXPECT_FALSE(view.update(camera, 100, 80, 0).value()) << "a frame does not wait for files";
  EXPECT_EQ(draw(scene, camera, 100, 80), before);
  while (!view.update(camera, 100, 80, kAll).value()) view.wait();
  MapScene own(camera.centre_in_enu_m);
  TilePyramidView anew(own, MapLayer::kPicture, bright);
  ASSERT_TRUE(anew.update(camera, 100, 80, kAll).value());
  EXPECT_EQ(draw(scene, camera, 100, 80), draw(own, camera, 100, 80));
  EXPECT_NE(draw(scene, camera, 100, 80), before);
}

}  // namespace tile_pictures_test
}  // namespace nadir
