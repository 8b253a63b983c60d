// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/tile_pyramid_view.h"

#include <numbers>

#include "tests/support/scratch_folder.h"
#include "tests/widgets/views/label_tiles.h"

namespace nadir {
namespace tile_pyramid_view_test {

constexpr int kWidth = 150;
constexpr int kHeight = 110;
constexpr int kAll = 1000;

/// A document of 1300 x 900 cells of 0.2 m, where tiles of the finest level meet at (512, 512).
class TiledLabels : public MapPage {
 protected:
  static LabelDocument some_labels() {
    LabelDocument document({test_plane(), LabelGrid{0.2, {35.0, 120.0}, 1300, 900}});
    for (std::uint32_t seed = 0; seed < 40; ++seed) document.apply(random_edit(document, seed));
    return document;
  }
  [[nodiscard]] Eigen::Vector2d at_cell(double column, double row) const {
    return labels.document().grid().enu_from_cells({column, row});
  }
  /// What a view that has shown nothing before shows.
  [[nodiscard]] Raster<Rgba> drawn_anew(const MapCamera& camera) const {
    MapScene own({100.0, 50.0});
    TilePyramidView view(own, MapLayer::kLabels, labels.pictures());
    EXPECT_TRUE(view.update(camera, kWidth, kHeight, kAll).value());
    return draw(own, camera, kWidth, kHeight);
  }
  /// Lets the thread work until nothing is missing.
  static void settle(TilePyramidView& view, const MapCamera& camera) {
    for (int i = 0; i < 50; ++i) {
      if (view.update(camera, kWidth, kHeight, kAll).value()) return;
      view.wait();
    }
    ADD_FAILURE() << "something is missing for ever";
  }

  FollowedLabels labels{some_labels()};
  MapScene scene{Eigen::Vector2d(100.0, 50.0)};
};

TEST_F(TiledLabels, ShowAtLevel0WhatIsExported) {
  TilePyramidView view(scene, MapLayer::kLabels, labels.pictures());
  const Raster<ClassId> cells = rasterise(labels.document());
  const LabelGrid& grid = labels.document().grid();
  for (const Eigen::Vector2d& middle :
       {at_cell(512.2, 511.7), at_cell(1290.4, 880.3), at_cell(80.0, 450.0)}) {
    for (const double metres_per_px : {0.03, 0.2, 0.33}) {
      for (const double up_rad : {std::numbers::pi / 2.0, 0.7}) {
        const MapCamera camera{middle, metres_per_px, up_rad};
        ASSERT_TRUE(view.update(camera, kWidth, kHeight, kAll).value());
        expect_everywhere(draw(scene, camera, kWidth, kHeight), camera,
                          [&](const Eigen::Vector2d& point) -> std::optional<Rgba> {
                            const Eigen::Vector2d cell = grid.cells_from_enu(point);
                            if (is_near_border(cell.x()) || is_near_border(cell.y()))
                              return std::nullopt;
                            const int column = static_cast<int>(std::floor(cell.x()));
                            const int row = static_cast<int>(std::floor(cell.y()));
                            return cells.contains(column, row) ? class_colour(cells.at(column, row))
                                                               : kNothing;
                          });
      }
    }
  }
}

TEST_F(TiledLabels, ShowAKnownCornerOnTheKnownPixelOfTheWindow) {
  // The red object's corner lies at cell (500, 400): with one pixel a cell, on the border of two pixels, in both directions.
  FollowedLabels corner(LabelDocument(test_plane(), LabelGrid{0.2, {35.0, 120.0}, 1300, 900}));
  const LabelGrid grid = corner.document().grid();
  TilePyramidView view(scene, MapLayer::kLabels, corner.pictures());
  Ring square;
  for (const auto& [column, row] : {std::pair(500, 400), {560, 400}, {560, 460}, {500, 460}}) {
    square.push_back(grid.enu_from_cells({column, row}));
  }
  corner.edit(adding({area(kRoad, {square})}), view);
  // Page pixel (50, 30 from the top) begins where cell (500, 400) does.
  const Eigen::Vector2d middle = grid.enu_from_cells({500.0 + 75 - 50, 400.0 + 55 - 30});
  const MapCamera camera{middle, 0.2};
  ASSERT_TRUE(view.update(camera, kWidth, kHeight, kAll).value());
  const Raster<Rgba> drawn = draw(scene, camera, kWidth, kHeight);
  for (int row = 20; row < 100; ++row) {
    for (int column = 40; column < 120; ++column) {
      const bool is_inside = column >= 50 && column < 110 && row >= 30 && row < 90;
      ASSERT_EQ(drawn.at(column, row), is_inside ? class_colour(kRoad) : kNothing)
          << column << " " << row;
    }
  }
}

TEST_F(TiledLabels, AfterEditsLookAsIfTheyWereMadeAnew) {
  for (const TileMaking making : {TileMaking::kInFrame, TileMaking::kInThread}) {
    TilePyramidView view(scene, MapLayer::kLabels, labels.pictures(), nullptr, making);
    for (std::uint32_t step = 0; step < 60; ++step) {
      const MapCamera camera{at_cell(1300.0 * share_of(step, 200), 900.0 * share_of(step, 201)),
                             0.05 * std::exp2(7.0 * share_of(step, 202))};
      settle(view, camera);
      labels.edit_at_random(1000 + step, view);
      // One frame is enough for what is in sight, where nothing is missing besides.
      EXPECT_TRUE(view.update(camera, kWidth, kHeight, kAll).value()) << step;
      ASSERT_EQ(draw(scene, camera, kWidth, kHeight), drawn_anew(camera)) << step;
    }
  }
}

TEST_F(TiledLabels, LoseNoTileWhenPeopleZoomFastAndEdit) {
  const auto budget = std::make_shared<TileBudget>(std::size_t{12} << 20U);
  TilePyramidView view(scene, MapLayer::kLabels, labels.pictures(), budget, TileMaking::kInThread);
  for (std::uint32_t step = 0; step < 400; ++step) {
    const MapCamera camera{at_cell(1300.0 * share_of(step, 300), 900.0 * share_of(step, 301)),
                           0.02 * std::exp2(9.0 * share_of(step, 302)), 6.28 * share_of(step, 303)};
    (void)view.update(camera, kWidth, kHeight, static_cast<int>(step % 4)).value();
    if (step % 3 == 0) labels.edit_at_random(2000 + step, view);
    if (step % 50 == 7) view.forget_all();
    if (step % 20 != 19) continue;
    settle(view, camera);
    ASSERT_EQ(draw(scene, camera, kWidth, kHeight), drawn_anew(camera)) << step;
  }
}

TEST_F(TiledLabels, KeepWhatWasSeenUntilWhatReplacesItIsMade) {
  TilePyramidView view(scene, MapLayer::kLabels, labels.pictures());
  const MapCamera camera{at_cell(512, 512), 0.2};
  ASSERT_TRUE(view.update(camera, kWidth, kHeight, kAll).value());
  const Raster<Rgba> before = draw(scene, camera, kWidth, kHeight);
  Ring everything;
  for (const auto& [column, row] : {std::pair(0, 0), {1300, 0}, {1300, 900}, {0, 900}}) {
    everything.push_back(at_cell(column, row));
  }
  LabelObject cover = area(kUnclassified, {everything}, labels.document().next_id());
  cover.order = std::int64_t{100} * kOrdersPerLevel;
  labels.edit(adding({cover}), view);
  EXPECT_EQ(draw(scene, camera, kWidth, kHeight), before) << "not before the next update";
  EXPECT_TRUE(view.update(camera, kWidth, kHeight, 0).value()) << "no tile is new";
  EXPECT_NE(draw(scene, camera, kWidth, kHeight), before);
  EXPECT_EQ(draw(scene, camera, kWidth, kHeight), drawn_anew(camera));
}

TEST_F(TiledLabels, MoveWithTheirGridWithoutBeingMadeAnew) {
  TilePyramidView view(scene, MapLayer::kLabels, labels.pictures());
  const MapCamera camera{at_cell(512, 512), 0.2};
  ASSERT_TRUE(view.update(camera, kWidth, kHeight, kAll).value());
  const Raster<Rgba> before = draw(scene, camera, kWidth, kHeight);
  // The same document on a grid elsewhere would have other cells; the tiles that are there show what they have shown.
  LabelGrid elsewhere = labels.document().grid();
  elsewhere.top_left_in_enu_m += Eigen::Vector2d(3.0, -7.0);
  view.show(std::make_shared<const LabelPictures>(
      std::make_shared<const LabelDocument>(test_plane(), elsewhere)));
  const MapCamera moved{camera.centre_in_enu_m + Eigen::Vector2d(3.0, -7.0), 0.2};
  ASSERT_TRUE(view.update(moved, kWidth, kHeight, 0).value());
  EXPECT_EQ(draw(scene, moved, kWidth, kHeight), before);
  // Of another size nothing stays.
  elsewhere.width = 700;
  view.show(std::make_shared<const LabelPictures>(
      std::make_shared<const LabelDocument>(test_plane(), elsewhere)));
  EXPECT_FALSE(view.update(moved, kWidth, kHeight, 0).value());
  EXPECT_EQ(draw(scene, moved, kWidth, kHeight), Raster<Rgba>(kWidth, kHeight, kNothing));
}

}  // namespace tile_pyramid_view_test
}  // namespace nadir
