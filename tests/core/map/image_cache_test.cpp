// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "core/map/overhead_image.h"
#include "tests/core/map/image_files.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace image_cache_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::size_t entries_of(const fs::path& folder) {
  std::error_code error;
  std::size_t count = 0;
  for (auto entry = fs::directory_iterator(folder, error);
       !error && entry != fs::directory_iterator(); entry.increment(error)) {
    ++count;
  }
  return count;
}

/// Squares of 128 pixels.
ImagePixel large_colour(int column, int row) { return mosaic_colour(column / 8, row / 8); }

/// Larger than what is read while somebody waits.
class LargeImage : public testing::Test {
 protected:
  static constexpr int kSide = 2300;

  [[nodiscard]] OpenedImage opened(const fs::path& path) const {
    auto result = open_overhead_image(path, {.cache = cache()});
    if (!result) throw std::runtime_error(error_text(result));
    return std::move(*result);
  }
  /// In a folder of its own.
  [[nodiscard]] fs::path written(const std::string& name, const DrawnImage& image) const {
    fs::path path = scratch.path() / "images" / name;
    fs::create_directories(path.parent_path());
    write_image(image, path);
    return path;
  }
  [[nodiscard]] fs::path sparse() const {
    fs::path path = scratch.path() / "images" / "sparse.tif";
    fs::create_directories(path.parent_path());
    write_sparse_image(kSide, path);
    return path;
  }
  [[nodiscard]] static ImageRaster large_mosaic() {
    ImageRaster pixels(kSide, kSide);
    for (int row = 0; row < kSide; ++row) {
      for (int column = 0; column < kSide; ++column) {
        pixels.at(column, row) = large_colour(column, row);
      }
    }
    return pixels;
  }
  [[nodiscard]] fs::path cache() const { return scratch.path() / "cache" / "images"; }

  /// Of the tile that shows the whole image, whether pixels are averages of what they cover, a few grey levels apart.
  static void expect_averages(const OverheadTiles& tiles) {
    const int level = tiles.level_count() - 1;
    const ImageRaster pixels = tiles.picture({level, 0, 0}).value();
    const double cells = static_cast<double>(kSide) / pixels.width();
    int compared = 0;
    for (int row = 4; row + 4 < pixels.height(); row += 5) {
      for (int column = 4; column + 4 < pixels.width(); column += 5) {
        // Well inside a square, for the overviews of pictures are JPEG.
        const auto cell = [cells](double pixel) { return static_cast<int>(pixel * cells); };
        const int left = cell(column - 2.5), right = cell(column + 3.5);
        const int top = cell(row - 2.5), bottom = cell(row + 3.5);
        if (left / 128 != right / 128 || top / 128 != bottom / 128) continue;
        EXPECT_NEAR(pixels.at(column, row).red, large_colour(left, top).red, 10);
        ++compared;
      }
    }
    EXPECT_GT(compared, 50);
  }

  ScratchFolder scratch;
};

TEST_F(LargeImage, ThatIsReadFromItsBeginningIsClearUntilItIsCopied) {
  const ImageRaster drawn = large_mosaic();
  const fs::path path =
      written("town.png", {.pixels = drawn, .driver = "PNG", .options = {"ZLEVEL=1"}});
  {
    const OpenedImage waiting = opened(path);
    EXPECT_EQ(waiting.image.readiness, ImageReadiness::kWantsCopy);
    EXPECT_EQ(waiting.tiles.picture({0, 0, 0}).value().at(5, 5).alpha, 0);
  }
  double furthest = 0.0;
  bool is_rising = true;
  const auto done = prepare_image(
      path, cache(), {.stop = {}, .progress = [&](double fraction, const std::string&) {
                        is_rising = is_rising && fraction >= furthest;
                        furthest = fraction;
                      }});
  ASSERT_TRUE(done) << error_text(done);
  EXPECT_TRUE(is_rising);
  EXPECT_NEAR(furthest, 1.0, 1e-6);
  EXPECT_EQ(entries_of(path.parent_path()), 1U);  // nothing beside the image
  const OpenedImage ready = opened(path);
  EXPECT_EQ(ready.image.readiness, ImageReadiness::kReady);
  EXPECT_EQ(whole_picture(ready.tiles), drawn);
  expect_averages(ready.tiles);
}

TEST_F(LargeImage, WithoutOverviewsShowsSamplesUntilTheyAreMade) {
  const fs::path path = written("town.tif", {.pixels = large_mosaic(), .options = {"TILED=YES"}});
  const OpenedImage waiting = opened(path);
  EXPECT_EQ(waiting.image.readiness, ImageReadiness::kWantsOverviews);
  const int level = waiting.tiles.level_count() - 1;
  const ImageRaster samples = waiting.tiles.picture({level, 0, 0}).value();
  for (const int at : {0, 7, 15}) {  // 16 x 16 places
    const int pixel = (2 * at + 1) * samples.width() / 32;
    const int cell = (2 * at + 1) * kSide / 32;
    EXPECT_EQ(samples.at(pixel, pixel), large_colour(cell, cell));
  }
  EXPECT_EQ(waiting.tiles.picture({0, 1, 1}).value().at(3, 3),
            large_colour(kTileSide + 3, kTileSide + 3));
  const auto done = prepare_image(path, cache());
  ASSERT_TRUE(done) << error_text(done);
  EXPECT_EQ(entries_of(path.parent_path()), 1U);
  const OpenedImage ready = opened(path);
  EXPECT_EQ(ready.image.readiness, ImageReadiness::kReady);
  expect_averages(ready.tiles);
  EXPECT_EQ(ready.tiles.picture({0, 1, 1}).value(), waiting.tiles.picture({0, 1, 1}).value());
}

TEST_F(LargeImage, IsPreparedOnceAndAgainWhenItHasChanged) {
  const fs::path path = sparse();
  ASSERT_TRUE(prepare_image(path, cache()));
  int reports = 0;
  const WorkContext counting{.stop = {},
                             .progress = [&](double, const std::string&) { ++reports; }};
  ASSERT_TRUE(prepare_image(path, cache(), counting));
  EXPECT_EQ(reports, 0);
  fs::last_write_time(path, fs::last_write_time(path) + std::chrono::seconds(5));
  EXPECT_EQ(opened(path).image.readiness, ImageReadiness::kWantsOverviews);
  ASSERT_TRUE(prepare_image(path, cache(), counting));
  EXPECT_GT(reports, 0);
  EXPECT_EQ(opened(path).image.readiness, ImageReadiness::kReady);
  EXPECT_EQ(entries_of(cache()), 1U);
}

TEST_F(LargeImage, LeavesNothingWhenItIsStopped) {
  const fs::path path = sparse();
  std::stop_source stop;
  const auto stopped = prepare_image(
      path, cache(),
      {.stop = stop.get_token(), .progress = [&](double fraction, const std::string&) {
         if (fraction > 0.2) stop.request_stop();
       }});
  ASSERT_FALSE(stopped);
  EXPECT_EQ(error_code(stopped), ErrorCode::kCancelled);
  EXPECT_EQ(entries_of(cache()), 0U);
  EXPECT_EQ(opened(path).image.readiness, ImageReadiness::kWantsOverviews);
}

TEST_F(LargeImage, SaysWhereItsOverviewsHaveNoPlace) {
  const fs::path path = sparse();
  const fs::path file = scratch.file("full", "no folder");
  const auto refused = prepare_image(path, file / "images");
  ASSERT_FALSE(refused);
  EXPECT_EQ(error_code(refused), ErrorCode::kIo);
  EXPECT_THAT(error_text(refused), HasSubstr(file.string()));
}

TEST_F(LargeImage, ThatIsSmallEnoughIsReadyAsItIs) {
  const fs::path path = scratch.path() / "small.png";
  write_image({.pixels = mosaic(300, 200), .driver = "PNG"}, path);
  EXPECT_EQ(opened(path).image.readiness, ImageReadiness::kReady);
  ASSERT_TRUE(prepare_image(path, cache()));
  EXPECT_FALSE(fs::exists(cache()));
}

TEST_F(LargeImage, OfFortyThousandPixelsASideOpensAndShowsAtOnce) {
  const fs::path path = scratch.path() / "huge.tif";
  write_sparse_image(40'000, path);
  const OpenedImage huge = opened(path);
  EXPECT_EQ(huge.image.width, 40'000);
  EXPECT_EQ(huge.image.readiness, ImageReadiness::kWantsOverviews);
  EXPECT_GE(huge.tiles.width(), 40'000);
  for (int level = huge.tiles.level_count() - 1; level >= 0; level -= 3) {
    const ImageRaster tile =
        huge.tiles.picture({level, huge.tiles.columns(level) / 2, huge.tiles.rows(level) / 2})
            .value();
    EXPECT_EQ(tile.at(tile.width() / 4, tile.height() / 4), (ImagePixel{0, 0, 0, 255}));
  }
}

}  // namespace image_cache_test
}  // namespace nadir
