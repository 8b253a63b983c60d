// SPDX-License-Identifier: Apache-2.0
// What an OverheadView shows while tiles are missing, and which it keeps.
#include "tests/widgets/views/map_on_the_ground.h"

namespace nadir {
namespace overhead_view_pieces_test {

TEST_F(MapOnTheGround, ComesPieceByPieceAndSaysSo) {
  OverheadView view(scene, tiles(Layer::kLabels), Layer::kLabels);
  const MapCamera camera{map()->enu_from_overhead({512.1, 512.4}), 0.23};  // four tiles meet here
  std::vector<bool> complete;
  for (int i = 0; i < 6; ++i) complete.push_back(view.update(camera, kWidth, kHeight, 1).value());
  // First the tile of the whole map, then the four.
  EXPECT_THAT(complete, testing::ElementsAre(false, false, false, false, true, true));
  expect_everywhere(draw(scene, camera, kWidth, kHeight), camera, label_at);
  // What is there already costs nothing.
  EXPECT_TRUE(view.update(camera, kWidth, kHeight, 0).value());
  // Elsewhere something would have to be read.
  const MapCamera north{map()->enu_from_overhead({200, 1090}), 0.23};
  EXPECT_FALSE(view.update(north, kWidth, kHeight, 0).value());
  // Where there is time for all at once, the whole map is not read.
  OverheadView other(scene, tiles(Layer::kLabels), Layer::kLabels);
  EXPECT_TRUE(other.update(camera, kWidth, kHeight, 4).value());
  EXPECT_FALSE(
      other.update({map()->enu_from_overhead({350, 550}), 5.0}, kWidth, kHeight, 0).value());
}

TEST_F(MapOnTheGround, HasNoHolesWhileTilesAreMissing) {
  OverheadView view(scene, tiles(Layer::kLabels), Layer::kLabels);
  const MapCamera camera{map()->enu_from_overhead({512.1, 512.4}), 0.23};
  const PageRect page{0, 0, kWidth, kHeight};
  int exact_before = 0;
  for (int i = 0; i < 5; ++i) {
    (void)view.update(camera, kWidth, kHeight, 1).value();
    const Raster<Rgba> drawn = draw(scene, camera, kWidth, kHeight);
    int exact = 0;
    for (int row = 0; row < kHeight; ++row) {
      for (int column = 0; column < kWidth; ++column) {
        const Rgba seen = drawn.at(column, row);
        ASSERT_EQ(seen.alpha, 255) << i << ": " << column << " " << row;
        const auto truth =
            label_at(camera.enu_from_page(centre_of_pixel(drawn, column, row), page));
        exact += truth && *truth == seen ? 1 : 0;
      }
    }
    EXPECT_GE(exact, exact_before) << i;  // each tile is finer than what stood in for it
    exact_before = exact;
  }
}

TEST_F(MapOnTheGround, StandsInWithTheRightPlaceOfTheFinestTileThatIsThere) {
  OverheadView view(scene, tiles(Layer::kPicture), Layer::kPicture);
  // Level 1 around here, then one tile further in: nothing may be read for that.
  const MapCamera camera{map()->enu_from_overhead({400, 500}), 0.5};
  ASSERT_TRUE(view.update({camera.centre_in_enu_m, 1.3}, kWidth, kHeight, kAnyNumber).value());
  EXPECT_FALSE(view.update(camera, kWidth, kHeight, 0).value());
  const Raster<Rgba> drawn = draw(scene, camera, kWidth, kHeight);
  // The picture's red changes by one in four columns, its green by one in five rows: single pixels suffer from JPEG, but
  // their mean shows a place that is wrong by a cell.
  const PageRect page{0, 0, kWidth, kHeight};
  Eigen::Vector2d error = Eigen::Vector2d::Zero();
  for (int row = 0; row < kHeight; ++row) {
    for (int column = 0; column < kWidth; ++column) {
      const Eigen::Vector2d cell =
          map()->overhead_from_enu(camera.enu_from_page(centre_of_pixel(drawn, column, row), page));
      const Rgba seen = drawn.at(column, row);
      ASSERT_NEAR(seen.red, cell.x() / 4.0, 7.0);
      ASSERT_NEAR(seen.green, cell.y() / 5.0, 7.0);
      error +=
          Eigen::Vector2d(4.0 * (seen.red + 0.5) - cell.x(), 5.0 * (seen.green + 0.5) - cell.y());
    }
  }
  error /= static_cast<double>(drawn.size());
  EXPECT_LT(error.norm(), 1.5) << error.transpose();
  // What stood in is not seen through the tiles that come.
  view.set_opacity(0.5);
  for (const int new_tiles : {1, kAnyNumber}) {
    (void)view.update(camera, kWidth, kHeight, new_tiles).value();
    const Raster<Rgba> half = draw(scene, camera, kWidth, kHeight);
    for (const Rgba pixel : half.values()) {
      ASSERT_NEAR(pixel.alpha, 128, 2);
    }
  }
}

TEST_F(MapOnTheGround, ReadsTheMiddleOfThePageFirst) {
  OverheadView view(scene, tiles(Layer::kLabels), Layer::kLabels);
  // Most of the page is the lower right of four tiles.
  const MapCamera camera{map()->enu_from_overhead({530, 525}), 0.5};
  (void)view.update(camera, kWidth, kHeight, 2).value();  // the whole map and one
  const Raster<Rgba> drawn = draw(scene, camera, kWidth, kHeight);
  const PageRect page{0, 0, kWidth, kHeight};
  for (int row = kHeight / 2; row < kHeight; ++row) {
    for (int column = kWidth / 2; column < kWidth; ++column) {
      const auto truth = label_at(camera.enu_from_page(centre_of_pixel(drawn, column, row), page));
      if (truth) {
        ASSERT_EQ(drawn.at(column, row), *truth);
      }
    }
  }
}

TEST_F(MapOnTheGround, ForgetsWhatItHasShownWhenThereIsTooMuch) {
  // One row of tiles, more than are kept.
  const ScratchFolder own;
  OverheadMap strip = drawn_map(0.5, {"R"});
  strip.labels = Raster<ClassId>(512 * 200, 4, kRoad);
  strip.labels.at(0, 0) = kTerrain;
  ASSERT_TRUE(write_overhead_map(strip, {}, std::nullopt, own.path() / "strip"));
  MapScene long_scene(strip.top_left_in_enu_m);
  constexpr std::size_t kTileBytes = 2 * 512 * 4 * sizeof(Rgba);  // in main memory and as a texture
  const auto budget = std::make_shared<TileBudget>(190 * kTileBytes);
  OverheadView view(long_scene, OverheadTiles::open(own.path() / "strip", Layer::kLabels).value(),
                    Layer::kLabels, budget);
  const auto camera_at = [&](int tile) {
    return MapCamera{strip.enu_from_overhead({512.0 * tile + 256.0, 2.0}), 0.1};
  };
  for (int tile = 0; tile < 200; ++tile) {
    ASSERT_TRUE(view.update(camera_at(tile), kWidth, kHeight, 1).value());
  }
  EXPECT_LE(budget->used_bytes(), 190 * kTileBytes);
  EXPECT_GT(budget->used_bytes(), 180 * kTileBytes);
  EXPECT_TRUE(view.update(camera_at(199), kWidth, kHeight, 0).value());  // still there
  EXPECT_TRUE(view.update(camera_at(20), kWidth, kHeight, 0).value());
  EXPECT_FALSE(view.update(camera_at(0), kWidth, kHeight, 0).value());  // gone
  EXPECT_TRUE(view.update(camera_at(0), kWidth, kHeight, 1).value());
  EXPECT_EQ(draw(long_scene, camera_at(0), kWidth, kHeight).at(kWidth / 2, kHeight / 2),
            class_colour(kRoad));
}

TEST_F(MapOnTheGround, OfSeveralViewsShareOneBudget) {
  const auto budget = std::make_shared<TileBudget>(0);  // nothing fits that is not shown
  const MapCamera camera{map()->enu_from_overhead({512.1, 512.4}), 0.23};  // four tiles meet here
  OverheadView labels(scene, tiles(Layer::kLabels), Layer::kLabels, budget);
  update(labels, camera);
  const std::size_t of_labels = budget->used_bytes();
  EXPECT_GT(of_labels, 0U);
  {
    OverheadView picture(scene, tiles(Layer::kPicture), Layer::kPicture, budget);
    update(picture, camera);
    EXPECT_EQ(budget->used_bytes(), 2 * of_labels) << "both are shown: nothing can go";
    labels.set_visible(false);
    update(picture, camera);
    EXPECT_EQ(budget->used_bytes(), of_labels) << "what is hidden makes room for what is not";
  }
  EXPECT_EQ(budget->used_bytes(), 0U);
  labels.set_visible(true);
  EXPECT_FALSE(labels.update(camera, kWidth, kHeight, 0).value()) << "its tiles are gone";
  update(labels, camera);
  expect_everywhere(draw(scene, camera, kWidth, kHeight), camera, label_at);
}

}  // namespace overhead_view_pieces_test
}  // namespace nadir
