// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/overhead_view.h"

#include <fstream>
#include <numbers>

#include "tests/widgets/views/map_on_the_ground.h"

namespace nadir {
namespace overhead_view_test {

TEST_F(MapOnTheGround, ShowsEachCellInItsPlaceAndColour) {
  OverheadView view(scene, tiles(Layer::kLabels), Layer::kLabels);
  // Inside, over the corner of four tiles, over the map's border, and turned.
  for (const Eigen::Vector2d& cell : {Eigen::Vector2d(200.3, 300.7), Eigen::Vector2d(512.1, 512.4),
                                      Eigen::Vector2d(690.2, 1090.6), Eigen::Vector2d(1.3, 2.9)}) {
    for (const double metres_per_px : {0.061, 0.23, 0.5, 0.77}) {
      for (const double up_rad : {std::numbers::pi / 2.0, 0.9, -2.3}) {
        const MapCamera camera{map()->enu_from_overhead(cell), metres_per_px, up_rad};
        SCOPED_TRACE(std::to_string(metres_per_px) + " m, up " + std::to_string(up_rad));
        update(view, camera);
        expect_everywhere(draw(scene, camera, kWidth, kHeight), camera, label_at);
      }
    }
  }
}

TEST_F(MapOnTheGround, TakesTheLevelWhosePixelsAreAsLargeAsThoseOfThePage) {
  const OverheadView view(scene, tiles(Layer::kLabels), Layer::kLabels);
  ASSERT_EQ(view.tiles().level_count(), 3);  // 1100 cells are 512 twice halved
  EXPECT_EQ(view.level_for(0.001), 0);
  EXPECT_EQ(view.level_for(0.5), 0);
  EXPECT_EQ(view.level_for(0.99), 0);
  EXPECT_EQ(view.level_for(1.0), 1);
  EXPECT_EQ(view.level_for(1.99), 1);
  EXPECT_EQ(view.level_for(2.0), 2);
  EXPECT_EQ(view.level_for(1000.0), 2);
}

TEST_F(MapOnTheGround, ShowsOnlyClassesFromNearbyWhereItIsReduced) {
  OverheadView view(scene, tiles(Layer::kLabels), Layer::kLabels);
  for (const double metres_per_px : {1.1, 2.3, 5.0}) {
    const MapCamera camera{map()->enu_from_overhead({350, 550}), metres_per_px};
    update(view, camera);
    const Raster<Rgba> drawn = draw(scene, camera, kWidth, kHeight);
    const PageRect page{0, 0, kWidth, kHeight};
    const int reach = 3 << view.level_for(metres_per_px);
    for (int row = 0; row < kHeight; ++row) {
      for (int column = 0; column < kWidth; ++column) {
        const Eigen::Vector2d cell = map()->overhead_from_enu(
            camera.enu_from_page(centre_of_pixel(drawn, column, row), page));
        bool is_near = false;
        for (int y = -reach; y <= reach && !is_near; ++y) {
          for (int x = -reach; x <= reach && !is_near; ++x) {
            const int c = static_cast<int>(std::floor(cell.x())) + x;
            const int r = static_cast<int>(std::floor(cell.y())) + y;
            const ClassId id = map()->labels.contains(c, r) ? map()->labels.at(c, r)
                                                            : static_cast<ClassId>(kUnclassified);
            is_near = drawn.at(column, row) == class_colour(id);
          }
        }
        ASSERT_TRUE(is_near) << column << " " << row << " " << metres_per_px;
      }
    }
  }
}

TEST_F(MapOnTheGround, ShowsThePictureSoThatItsPixelsAreThoseOfTheFile) {
  OverheadView view(scene, tiles(Layer::kPicture), Layer::kPicture);
  const auto picture = read_overhead_image(folder()->path() / "map").value().value();
  // One pixel of the page is one of the picture, centre on centre, also across the border of tiles.
  for (const Eigen::Vector2d& cell : {Eigen::Vector2d(200, 300), Eigen::Vector2d(512, 512)}) {
    const MapCamera camera{map()->enu_from_overhead(cell), 0.5};
    update(view, camera);
    expect_everywhere(
        draw(scene, camera, kWidth, kHeight), camera,
        [&](const Eigen::Vector2d& point) -> std::optional<Rgba> {
          const Eigen::Vector2d at = map()->overhead_from_enu(point);
          const Colour& colour = picture.at(static_cast<int>(std::floor(at.x())),
                                            static_cast<int>(std::floor(at.y())));
          return Rgba{colour.red, colour.green, colour.blue};
        },
        2);
  }
}

TEST_F(MapOnTheGround, NeedsNothingWhereTheMapIsNotInSight) {
  OverheadView view(scene, tiles(Layer::kLabels), Layer::kLabels);
  for (const Eigen::Vector2d& cell : {Eigen::Vector2d(-5000, 300), Eigen::Vector2d(200, 1e9)}) {
    const MapCamera camera{map()->enu_from_overhead(cell), 0.23};
    EXPECT_TRUE(view.update(camera, kWidth, kHeight, 0).value());
    EXPECT_EQ(draw(scene, camera, kWidth, kHeight), Raster<Rgba>(kWidth, kHeight, kNothing));
  }
}

TEST_F(MapOnTheGround, IsHiddenAndShownAgain) {
  OverheadView view(scene, tiles(Layer::kLabels), Layer::kLabels);
  const MapCamera camera{map()->enu_from_overhead({200.3, 300.7}), 0.23};
  update(view, camera);
  view.set_visible(false);
  EXPECT_EQ(draw(scene, camera, kWidth, kHeight), Raster<Rgba>(kWidth, kHeight, kNothing));
  EXPECT_TRUE(view.update(camera, kWidth, kHeight, 0).value());
  EXPECT_EQ(draw(scene, camera, kWidth, kHeight), Raster<Rgba>(kWidth, kHeight, kNothing));
  view.set_visible(true);
  update(view, camera);
  expect_everywhere(draw(scene, camera, kWidth, kHeight), camera, label_at);
}

TEST_F(MapOnTheGround, HasItsOpacityAlsoWhereTilesComeLater) {
  OverheadView view(scene, tiles(Layer::kLabels), Layer::kLabels);
  view.set_opacity(0.5);
  const MapCamera camera{map()->enu_from_overhead({512.1, 512.4}), 0.23};
  EXPECT_FALSE(view.update(camera, kWidth, kHeight, 2).value());
  update(view, camera);
  expect_everywhere(
      draw(scene, camera, kWidth, kHeight), camera,
      [](const Eigen::Vector2d& point) {
        auto colour = label_at(point);
        if (colour) colour->alpha = 128;
        return colour;
      },
      3);
}

TEST_F(MapOnTheGround, LiesBelowWhatWasThereBeforeItsTilesCame) {
  OverheadView labels(scene, tiles(Layer::kLabels), Layer::kLabels);
  OverheadView picture(scene, tiles(Layer::kPicture), Layer::kPicture);
  RasterView topview(scene, MapLayer::kTopview);
  const MapCamera camera{map()->enu_from_overhead({200.3, 300.7}), 0.23};
  const PageRect patch{camera.centre_in_enu_m.x() - 4.0, camera.centre_in_enu_m.y() - 4.0, 8.0,
                       8.0};
  topview.show(Raster<Rgba>(1, 1, kRed), {patch.left, patch.top(), 0.0}, {8.0, 8.0}, false);
  update(labels, camera);
  update(picture, camera);
  expect_everywhere(draw(scene, camera, kWidth, kHeight), camera,
                    [&](const Eigen::Vector2d& point) -> std::optional<Rgba> {
                      return holds(patch, point) ? kRed : label_at(point);
                    });
}

TEST_F(MapOnTheGround, SaysWhereItsFileIsDamaged) {
  const ScratchFolder own;
  std::filesystem::copy(folder()->path() / "map", own.path() / "map");
  const auto path = own.path() / "map" / "labels.tif";
  {
    std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
    const auto size = static_cast<std::streamoff>(std::filesystem::file_size(path));
    file.seekp(size / 2);  // overviews lie before the full cells
    for (std::streamoff i = 0; i < size / 4; ++i) file.put('\x55');
  }
  auto opened = OverheadTiles::open(own.path() / "map", Layer::kLabels);
  ASSERT_TRUE(opened) << error_text(opened);
  OverheadView view(scene, std::move(*opened), Layer::kLabels);
  const MapCamera camera{map()->enu_from_overhead({350, 550}), 0.9};
  const auto complete = view.update(camera, 2000, 2000, kAnyNumber);
  ASSERT_FALSE(complete);
  EXPECT_EQ(error_code(complete), ErrorCode::kMalformed);
  EXPECT_THAT(error_text(complete), testing::StartsWith(path.string() + ": cannot be read at"));
  // Once is enough, and what can be read is shown, with coarser tiles in place of those that cannot.
  for (int i = 0; i < 3; ++i) {
    const auto next = view.update(camera, 2000, 2000, kAnyNumber);
    EXPECT_TRUE(next) << error_text(next);
  }
  EXPECT_TRUE(view.update(camera, 2000, 2000, 0).value()) << "nothing is tried again";
  std::size_t clear = 0;
  int exact_tiles = 0;
  for (const Eigen::Vector2d& cell :
       {Eigen::Vector2d(256, 256), Eigen::Vector2d(600, 256), Eigen::Vector2d(256, 768),
        Eigen::Vector2d(600, 768), Eigen::Vector2d(256, 1060), Eigen::Vector2d(600, 1060)}) {
    const MapCamera inside{map()->enu_from_overhead(cell), 0.2};
    EXPECT_TRUE(view.update(inside, kWidth, kHeight, 0).value());
    const Raster<Rgba> drawn = draw(scene, inside, kWidth, kHeight);
    std::size_t wrong = 0;
    for (int row = 0; row < kHeight; ++row) {
      for (int column = 0; column < kWidth; ++column) {
        const auto truth = label_at(
            inside.enu_from_page(centre_of_pixel(drawn, column, row), {0, 0, kWidth, kHeight}));
        clear += drawn.at(column, row).alpha == 0 ? 1U : 0U;
        wrong += truth && *truth != drawn.at(column, row) ? 1U : 0U;
      }
    }
    exact_tiles += wrong == 0 ? 1 : 0;
  }
  EXPECT_EQ(clear, 0U) << "no holes";
  EXPECT_GT(exact_tiles, 0);
  EXPECT_LT(exact_tiles, 6) << "the file is damaged, after all";
}

}  // namespace overhead_view_test
}  // namespace nadir
