// SPDX-License-Identifier: Apache-2.0
#include "core/map/overhead_tiles.h"

#include <gmock/gmock.h>

#include <fstream>
#include <set>
#include <stdexcept>

#include "tests/core/map/raster_files.h"
#include "tests/support/drawn_map.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace overhead_tiles_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;
using Layer = OverheadTiles::Layer;

struct Size {
  int width, height;
};

void PrintTo(const Size& size, std::ostream* out) { *out << size.width << " x " << size.height; }

/// A package of blocks of classes and of a picture whose colours change slowly.
struct Package {
  explicit Package(const Size& size) {
    map.labels = patchwork(size.width, size.height);
    map.labels.at(0, 0) = kUnclassified;
    map.top_left_in_enu_m = {-35.5, 25.5};
    ColourRaster picture(size.width, size.height);
    for (int row = 0; row < size.height; ++row) {
      for (int column = 0; column < size.width; ++column) {
        picture.at(column, row) = {static_cast<std::uint8_t>(column / 8),
                                   static_cast<std::uint8_t>(200 - row / 8), 100};
      }
    }
    const auto written = write_overhead_map(map, {}, picture, path());
    if (!written) throw std::runtime_error(error_text(written));
  }
  [[nodiscard]] fs::path path() const { return folder.path() / "town"; }
  [[nodiscard]] OverheadTiles open(Layer layer) const {
    return OverheadTiles::open(path(), layer).value();
  }

  ScratchFolder folder;
  OverheadMap map = drawn_map(0.25, {"R"});
};

std::vector<TileAddress> addresses(const OverheadTiles& tiles, int level) {
  std::vector<TileAddress> all;
  for (int row = 0; row < tiles.rows(level); ++row) {
    for (int column = 0; column < tiles.columns(level); ++column) {
      all.push_back({level, column, row});
    }
  }
  return all;
}

/// Level 0 put together from its tiles.
template <typename Pixel, typename Read>
Raster<Pixel> assembled(const OverheadTiles& tiles, Pixel nothing, Read read) {
  Raster<Pixel> whole(tiles.width(), tiles.height(), nothing);
  for (const TileAddress& tile : addresses(tiles, 0)) {
    const Eigen::Vector4i cells = tiles.cells_of(tile);
    const Raster<Pixel> pixels = read(tile);
    EXPECT_EQ(pixels.width(), cells[2]);
    EXPECT_EQ(pixels.height(), cells[3]);
    for (int row = 0; row < pixels.height(); ++row) {
      for (int column = 0; column < pixels.width(); ++column) {
        whole.at(cells[0] + column, cells[1] + row) = pixels.at(column, row);
      }
    }
  }
  return whole;
}

// Larger than a tile, exactly one or two, one cell more or less, smaller than one, and a single cell.
class TilesOfEverySize : public testing::TestWithParam<Size> {
 protected:
  static void TearDownTestSuite() { packages().clear(); }

  const Package& package = package_of(GetParam());

 private:
  /// Each is written once: that takes longer than a test.
  static std::map<std::array<int, 2>, std::unique_ptr<Package>>& packages() {
    static std::map<std::array<int, 2>, std::unique_ptr<Package>> written;
    return written;
  }
  static const Package& package_of(const Size& size) {
    auto& made = packages()[{size.width, size.height}];
    if (made == nullptr) made = std::make_unique<Package>(size);
    return *made;
  }
};

INSTANTIATE_TEST_SUITE_P(Maps,
                         TilesOfEverySize,
                         testing::Values(Size{1100, 600},
                                         Size{512, 512},
                                         Size{1024, 512},
                                         Size{511, 513},
                                         Size{513, 1025},
                                         Size{40, 30},
                                         Size{2100, 3},
                                         Size{1, 1}));

TEST_P(TilesOfEverySize, LieWhereTheMapLies) {
  const OverheadTiles tiles = package.open(Layer::kLabels);
  EXPECT_EQ(tiles.width(), package.map.labels.width());
  EXPECT_EQ(tiles.height(), package.map.labels.height());
  EXPECT_EQ(tiles.metres_per_cell(), package.map.metres_per_cell);
  EXPECT_EQ(tiles.top_left_in_enu_m(), package.map.top_left_in_enu_m);
}

TEST_P(TilesOfEverySize, CoverEachCellOnceOnEveryLevel) {
  const OverheadTiles tiles = package.open(Layer::kLabels);
  for (int level = 0; level < tiles.level_count(); ++level) {
    Raster<int> covered(tiles.width(), tiles.height());
    for (const TileAddress& tile : addresses(tiles, level)) {
      const Eigen::Vector4i cells = tiles.cells_of(tile);
      EXPECT_EQ(cells[0], tile.column * (kTileSide << level));
      EXPECT_EQ(cells[1], tile.row * (kTileSide << level));
      for (int row = cells[1]; row < cells[1] + cells[3]; ++row) {
        for (int column = cells[0]; column < cells[0] + cells[2]; ++column) {
          ASSERT_TRUE(covered.contains(column, row));
          ++covered.at(column, row);
        }
      }
    }
    EXPECT_TRUE(std::all_of(covered.values().begin(), covered.values().end(), [](int count) {
      return count == 1;
    })) << level;
  }
}

TEST_P(TilesOfEverySize, EndWithTheFirstLevelThatFitsIntoOne) {
  const OverheadTiles tiles = package.open(Layer::kLabels);
  const int last = tiles.level_count() - 1;
  EXPECT_EQ(tiles.columns(last), 1);
  EXPECT_EQ(tiles.rows(last), 1);
  if (last > 0) {
    EXPECT_GT(std::max(tiles.columns(last - 1), tiles.rows(last - 1)), 1);
  }
}

TEST_P(TilesOfEverySize, TogetherAreTheLabelsOfTheMap) {
  const OverheadTiles tiles = package.open(Layer::kLabels);
  const auto whole = assembled(tiles, ClassId{77},
                               [&](const TileAddress& tile) { return tiles.labels(tile).value(); });
  EXPECT_EQ(whole, read_overhead_map(package.path())->labels);
  EXPECT_EQ(whole, package.map.labels);
}

TEST_P(TilesOfEverySize, TogetherAreThePictureOfTheMap) {
  const OverheadTiles tiles = package.open(Layer::kPicture);
  const auto whole = assembled(tiles, ImagePixel{1, 2, 3, 4}, [&](const TileAddress& tile) {
    return tiles.picture(tile).value();
  });
  const ColourRaster picture = read_overhead_image(package.path())->value();
  ImageRaster opaque(picture.width(), picture.height());
  std::transform(picture.values().begin(), picture.values().end(), opaque.values().begin(),
                 [](const Colour& colour) {
                   return ImagePixel{colour.red, colour.green, colour.blue, 255};
                 });
  EXPECT_EQ(whole, opaque);
}

TEST_P(TilesOfEverySize, HaveHalfAsManyPixelsASideOnEachLevel) {
  const OverheadTiles labels = package.open(Layer::kLabels);
  const OverheadTiles picture = package.open(Layer::kPicture);
  for (int level = 0; level < labels.level_count(); ++level) {
    for (const TileAddress& tile : addresses(labels, level)) {
      const Eigen::Vector4i cells = labels.cells_of(tile);
      const auto pixels = [level](int count) {
        const int side = 1 << level;
        return count / side + (count % side == 0 ? 0 : 1);
      };
      const auto ids = labels.labels(tile).value();
      EXPECT_EQ(ids.width(), pixels(cells[2]));
      EXPECT_EQ(ids.height(), pixels(cells[3]));
      EXPECT_LE(std::max(ids.width(), ids.height()), kTileSide);
      const auto colours = picture.picture(tile).value();
      EXPECT_EQ(colours.width(), ids.width());
      EXPECT_EQ(colours.height(), ids.height());
    }
  }
}

TEST_P(TilesOfEverySize, HaveOnlyClassesThatAreNearby) {
  const OverheadTiles tiles = package.open(Layer::kLabels);
  const Raster<ClassId>& labels = package.map.labels;
  for (int level = 1; level < tiles.level_count(); ++level) {
    for (const TileAddress& tile : addresses(tiles, level)) {
      const Eigen::Vector4i cells = tiles.cells_of(tile);
      const auto pixels = tiles.labels(tile).value();
      const int reach =
          1 << level;  // of the cell itself, and as far again for overviews of odd sizes
      for (int row = 0; row < pixels.height(); ++row) {
        for (int column = 0; column < pixels.width(); ++column) {
          const int left = cells[0] + column * cells[2] / pixels.width();
          const int top = cells[1] + row * cells[3] / pixels.height();
          bool is_there = false;
          for (int y = top - reach; y < top + 2 * reach && !is_there; ++y) {
            for (int x = left - reach; x < left + 2 * reach && !is_there; ++x) {
              is_there = labels.contains(x, y) && labels.at(x, y) == pixels.at(column, row);
            }
          }
          ASSERT_TRUE(is_there) << "level " << level << ", " << column << " " << row << ": "
                                << static_cast<int>(pixels.at(column, row));
        }
      }
    }
  }
}

TEST_P(TilesOfEverySize, AreAveragedWhereThePictureIsReduced) {
  const OverheadTiles tiles = package.open(Layer::kPicture);
  const auto whole = read_overhead_image(package.path())->value();
  for (int level = 1; level < tiles.level_count(); ++level) {
    for (const TileAddress& tile : addresses(tiles, level)) {
      const Eigen::Vector4i cells = tiles.cells_of(tile);
      const auto pixels = tiles.picture(tile).value();
      for (int row = 0; row < pixels.height(); row += 7) {
        for (int column = 0; column < pixels.width(); column += 7) {
          // Overviews are JPEG again, whose last blocks of 16 x 16 also hold what lies beyond the border.
          const bool is_whole_block =
              (cells[0] + cells[2] < tiles.width() || column + 16 < pixels.width()) &&
              (cells[1] + cells[3] < tiles.height() || row + 16 < pixels.height());
          if (!is_whole_block) continue;
          Eigen::Vector3d sum = Eigen::Vector3d::Zero();
          int count = 0;
          for (int y = row * cells[3] / pixels.height(); y < (row + 1) * cells[3] / pixels.height();
               ++y) {
            for (int x = column * cells[2] / pixels.width();
                 x < (column + 1) * cells[2] / pixels.width(); ++x) {
              const Colour& colour = whole.at(cells[0] + x, cells[1] + y);
              sum += Eigen::Vector3d(colour.red, colour.green, colour.blue);
              ++count;
            }
          }
          const Eigen::Vector3d mean = sum / count;
          const ImagePixel& pixel = pixels.at(column, row);
          ASSERT_NEAR(pixel.red, mean[0], 10.0) << level << " " << column << " " << row;
          ASSERT_NEAR(pixel.green, mean[1], 10.0) << level << " " << column << " " << row;
          ASSERT_NEAR(pixel.blue, mean[2], 10.0) << level << " " << column << " " << row;
        }
      }
    }
  }
}

TEST(OverheadTiles, AverageStripesToGrey) {
  const ScratchFolder folder;
  OverheadMap map = drawn_map(0.25, {"R"});
  map.labels = Raster<ClassId>(1024, 1024, kRoad);
  map.labels.at(0, 0) = kTerrain;
  ColourRaster stripes(1024, 1024, Colour{255, 255, 255});
  for (int row = 0; row < 1024; ++row) {
    for (int column = 0; column < 1024; column += 2) stripes.at(column, row) = {0, 0, 0};
  }
  ASSERT_TRUE(write_overhead_map(map, {}, stripes, folder.path() / "map"));
  const auto tiles = OverheadTiles::open(folder.path() / "map", Layer::kPicture).value();
  const auto reduced = tiles.picture({1, 0, 0}).value();
  for (const ImagePixel& colour : reduced.values()) ASSERT_NEAR(colour.green, 127, 12);
}

TEST(OverheadTiles, CanBeMovedAndReadInAnyOrder) {
  const Package package({1100, 600});
  OverheadTiles opened = package.open(Layer::kLabels);
  const auto last = opened.labels({0, 2, 1}).value();
  const auto coarse = opened.labels({2, 0, 0}).value();
  const OverheadTiles tiles = std::move(opened);
  EXPECT_EQ(tiles.labels({2, 0, 0}).value(), coarse);
  (void)tiles.labels({0, 0, 0});
  EXPECT_EQ(tiles.labels({0, 2, 1}).value(), last);
}

TEST(OverheadTiles, ThatAreNotThereAreABrokenPrecondition) {
  const Package package({1100, 600});
  const OverheadTiles tiles = package.open(Layer::kLabels);
  for (const TileAddress& tile :
       {TileAddress{-1, 0, 0}, TileAddress{3, 0, 0}, TileAddress{0, 3, 0}, TileAddress{0, 0, 2},
        TileAddress{0, -1, 0}, TileAddress{1, 2, 0}}) {
    EXPECT_THROW((void)tiles.cells_of(tile), std::logic_error);
    EXPECT_THROW((void)tiles.labels(tile), std::logic_error);
  }
}

TEST(OverheadTiles, OfALayerThatIsNotInThePackageAreAnError) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_overhead_map(drawn_map(0.5, {"RT"}), {}, std::nullopt, folder.path() / "map"));
  const auto tiles = OverheadTiles::open(folder.path() / "map", Layer::kPicture);
  ASSERT_FALSE(tiles);
  EXPECT_EQ(error_code(tiles), ErrorCode::kNotFound);
  EXPECT_THAT(error_text(tiles), HasSubstr("image.tif"));
  EXPECT_TRUE(OverheadTiles::open(folder.path() / "map", Layer::kLabels));
  const auto nowhere = OverheadTiles::open(folder.path() / "none", Layer::kLabels);
  ASSERT_FALSE(nowhere);
  EXPECT_EQ(error_code(nowhere), ErrorCode::kNotFound);
}

TEST(OverheadTiles, OfAPictureInGreyAreRefused) {
  const Package package({40, 30});
  RasterFile grey{.ids = patchwork(40, 30), .crs = package.map.plane.wkt()};
  Eigen::Matrix2d linear;
  linear << 0.25, 0.0, 0.0, -0.25;
  grey.crs_from_pixel = Affine2{linear, package.map.top_left_in_enu_m};
  write_raster(grey, package.path() / "image.tif");
  const auto tiles = OverheadTiles::open(package.path(), Layer::kPicture);
  ASSERT_FALSE(tiles);
  EXPECT_EQ(error_code(tiles), ErrorCode::kMalformed);
  EXPECT_EQ(error_text(tiles),
            (package.path() / "image.tif").string() + ": has 1 bands instead of 3");
}

TEST(OverheadTiles, WithAnIdThatIsNoClassSayWhere) {
  const Package package({700, 30});
  RasterFile file{.ids = Raster<std::uint8_t>(700, 30, kRoad), .crs = package.map.plane.wkt()};
  file.ids.at(600, 7) = 99;
  Eigen::Matrix2d linear;
  linear << 0.25, 0.0, 0.0, -0.25;
  file.crs_from_pixel = Affine2{linear, package.map.top_left_in_enu_m};
  fs::remove(package.path() / "labels.tif.aux.xml");
  write_raster(file, package.path() / "labels.tif");
  const OverheadTiles tiles = package.open(Layer::kLabels);
  EXPECT_TRUE(tiles.labels({0, 0, 0}));
  const auto bad = tiles.labels({0, 1, 0});
  ASSERT_FALSE(bad);
  EXPECT_EQ(error_code(bad), ErrorCode::kMalformed);
  EXPECT_EQ(error_text(bad), (package.path() / "labels.tif").string() +
                                 ": id 99 at column 600, row 7 of level 0 is no class");
}

// Sixteen copies, each with another sixteenth of the file overwritten.
TEST(OverheadTiles, OfADamagedFileAreTheTruthOrAnError) {
  const Package package({1100, 600});
  const fs::path path = package.path() / "labels.tif";
  const std::string whole = [&path] {
    std::ifstream file(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }();
  int good = 0;
  int bad = 0;
  for (std::size_t part = 0; part < 16; ++part) {
    std::string damaged = whole;
    const std::size_t size = whole.size() / 16;
    std::fill_n(damaged.begin() + static_cast<std::ptrdiff_t>(part * size), size, '\x55');
    std::ofstream(path, std::ios::binary) << damaged;
    const auto tiles = OverheadTiles::open(package.path(), Layer::kLabels);
    if (!tiles) {
      EXPECT_THAT(error_text(tiles), StartsWith(path.string() + ": "));
      continue;
    }
    for (const TileAddress& tile : addresses(*tiles, 0)) {
      const auto labels = tiles->labels(tile);
      ++(labels ? good : bad);
      if (!labels) {
        EXPECT_EQ(error_code(labels), ErrorCode::kMalformed);
        EXPECT_THAT(error_text(labels), StartsWith(path.string() + ": "));
        continue;
      }
      const Eigen::Vector4i cells = tiles->cells_of(tile);
      for (int row = 0; row < labels->height(); ++row) {
        const auto truth =
            package.map.labels.row(cells[1] + row)
                .subspan(static_cast<std::size_t>(cells[0]), static_cast<std::size_t>(cells[2]));
        const auto read = labels->row(row);
        ASSERT_TRUE(std::equal(read.begin(), read.end(), truth.begin())) << part << " " << row;
      }
    }
  }
  EXPECT_GT(good, 20);
  EXPECT_GT(bad, 10);
}

}  // namespace overhead_tiles_test
}  // namespace nadir
