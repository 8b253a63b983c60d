// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/ground_view.h"

#include <filesystem>
#include <fstream>
#include <numbers>

#include "core/geo/rigid2.h"
#include "core/map/overhead_map_file.h"
#include "tests/support/scenery.h"
#include "tests/support/scratch_folder.h"
#include "tests/widgets/views/map_page.h"
#include "tests/widgets/views/space_page.h"
#include "widgets/views/theme.h"

namespace nadir {
namespace ground_view_test {

using Layer = OverheadTiles::Layer;

class Ground : public SpacePage {
 protected:
  Ground() : map_(patchwork_map(1300, 700, 0.5)) {
    const auto written = write_overhead_map(map_, {}, std::nullopt, scratch_.path() / "map");
    EXPECT_TRUE(written) << error_text(written);
  }
  [[nodiscard]] OverheadTiles tiles() const {
    return OverheadTiles::open(scratch_.path() / "map", Layer::kLabels).value();
  }
  [[nodiscard]] Eigen::Vector2d middle() const {
    return map_.enu_from_overhead({map_.labels.width() / 2.0, map_.labels.height() / 2.0});
  }

  /// Compares each pixel with the class under it, by the inverse projection; borders of cells may go either way.
  void expect_classes(const Raster<Rgba>& drawn,
                      const SpaceCamera& camera,
                      const Eigen::AlignedBox2d& shown) const {
    int compared = 0;
    int wrong = 0;
    for (int row = 0; row < drawn.height(); ++row) {
      for (int column = 0; column < drawn.width(); ++column) {
        const auto place = camera.ground_from_page(centre_of_pixel(drawn, column, row), kPage);
        const bool is_ground = place && shown.contains(*place) && map_.contains(*place);
        if (place) {
          const Eigen::Vector2d cell = map_.overhead_from_enu(*place);
          const double edge_m = std::min((*place - shown.min()).cwiseAbs().minCoeff(),
                                         (shown.max() - *place).cwiseAbs().minCoeff());
          if (is_near_border(cell.x()) || is_near_border(cell.y()) || edge_m < 0.1) continue;
        }
        ++compared;
        const Rgba expected = is_ground ? class_colour(map_.class_at(*place)) : kNothing;
        wrong += drawn.at(column, row) == expected ? 0 : 1;
      }
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(compared, kPageWidth * kPageHeight * 8 / 10);
  }

  ScratchFolder scratch_;
  OverheadMap map_;
};

TEST_F(Ground, LiesWhereTheInverseProjectionOfEachPixelSays) {
  SpaceScene scene(middle());
  GroundView view(scene, tiles(), Layer::kLabels);
  // Across the borders of tiles, inside of the map and over its rim.
  for (const Eigen::Vector2d& offset :
       {Eigen::Vector2d(0, 0), Eigen::Vector2d(-70, 4), Eigen::Vector2d(-320, 170)}) {
    for (const double yaw : {0.4, -2.0}) {
      const Eigen::Vector2d target = middle() + offset;
      const SpaceCamera camera{{target.x(), target.y(), 0.0}, 20.0, yaw, 0.6, 0.7};
      const Eigen::AlignedBox2d shown(target - Eigen::Vector2d(9, 14),
                                      target + Eigen::Vector2d(12, 8));
      ASSERT_TRUE(view.show(shown, 0.05));
      SCOPED_TRACE(testing::PrintToString(offset.x()) + ", yaw " + std::to_string(yaw));
      expect_classes(draw(scene, camera), camera, shown);
    }
  }
}

TEST_F(Ground, OfManyTilesIsCoarserButStaysInItsPlace) {
  SpaceScene scene(middle());
  GroundView view(scene, tiles(), Layer::kLabels);
  const Eigen::AlignedBox2d all(middle() - Eigen::Vector2d(400, 400),
                                middle() + Eigen::Vector2d(400, 400));
  const SpaceCamera camera{
      {middle().x(), middle().y(), 0.0}, 900.0, 0.0, std::numbers::pi / 2.0, 0.7};
  for (const double metres_per_px : {0.01, 4.0, 1e6}) {
    ASSERT_TRUE(view.show(all, metres_per_px));
    const Raster<Rgba> drawn = draw(scene, camera);
    int outside = 0;
    int missing = 0;
    for (int row = 0; row < drawn.height(); ++row) {
      for (int column = 0; column < drawn.width(); ++column) {
        const auto place = camera.ground_from_page(centre_of_pixel(drawn, column, row), kPage);
        ASSERT_TRUE(place);
        const Eigen::Vector2d cell = map_.overhead_from_enu(*place);
        const bool is_inside = cell.x() > 20 && cell.y() > 20 && cell.x() < 1280 && cell.y() < 680;
        const bool is_outside =
            cell.x() < -20 || cell.y() < -20 || cell.x() > 1320 || cell.y() > 720;
        const bool is_drawn = drawn.at(column, row).alpha > 0;
        missing += is_inside && !is_drawn && map_.class_at(*place) != kUnclassified ? 1 : 0;
        outside += is_outside && is_drawn ? 1 : 0;
      }
    }
    EXPECT_EQ(missing, 0) << metres_per_px;
    EXPECT_EQ(outside, 0) << metres_per_px;
  }
}

TEST_F(Ground, AwayFromTheMapIsNothing) {
  SpaceScene scene(middle());
  GroundView view(scene, tiles(), Layer::kLabels);
  for (const double away : {5'000.0, -5'000.0, 1e9}) {
    const Eigen::Vector2d target = middle() + Eigen::Vector2d(away, away);
    ASSERT_TRUE(
        view.show({target - Eigen::Vector2d(10, 10), target + Eigen::Vector2d(10, 10)}, 0.1));
    const SpaceCamera camera{{target.x(), target.y(), 0.0}, 20.0, 0.4, 0.6, 0.7};
    EXPECT_EQ(draw(scene, camera), Raster<Rgba>(kPageWidth, kPageHeight, kNothing));
  }
}

TEST_F(Ground, IsAsItWasAfterItsFileCouldNotBeRead) {
  const auto labels = scratch_.path() / "map" / "labels.tif";
  const auto whole = scratch_.path() / "whole.tif";
  std::filesystem::copy_file(labels, whole);
  const auto damage = [&labels](std::streamoff begin_share, std::streamoff end_share) {
    std::fstream file(labels, std::ios::binary | std::ios::in | std::ios::out);
    const auto size = static_cast<std::streamoff>(std::filesystem::file_size(labels));
    file.seekp(size * begin_share / 100);
    while (file.tellp() < size * end_share / 100) file.put('\x55');
  };
  SpaceScene scene(middle());
  const SpaceCamera camera{
      {middle().x(), middle().y(), 0.0}, 40.0, 0.0, std::numbers::pi / 2.0, 0.7};
  const Eigen::AlignedBox2d near(middle() - Eigen::Vector2d(9, 9),
                                 middle() + Eigen::Vector2d(9, 9));
  const Eigen::AlignedBox2d all(middle() - Eigen::Vector2d(400, 400),
                                middle() + Eigen::Vector2d(400, 400));
  damage(40, 45);
  GroundView view(scene, tiles(), Layer::kLabels);
  // Some tiles can be read and others not: whichever were shown must not be lost.
  int shown = 0;
  int failed = 0;
  for (int column = 0; column < 26; ++column) {
    const Eigen::Vector2d place = middle() + Eigen::Vector2d(-312.0 + 25.0 * column, 0.0);
    const Eigen::AlignedBox2d part(place - Eigen::Vector2d(5, 150),
                                   place + Eigen::Vector2d(5, 150));
    const bool was_shown = view.show(part, 0.5).has_value();
    const Raster<Rgba> before = draw(scene, camera);
    const auto everything = view.show(all, 0.5);
    EXPECT_FALSE(everything);
    EXPECT_EQ(draw(scene, camera), before);
    EXPECT_FALSE(view.show(all, 0.5));  // again
    ++(was_shown ? shown : failed);
  }
  EXPECT_GT(shown, 0);
  EXPECT_GT(failed, 0);
  view.set_opacity(0.5);
}

TEST_F(Ground, CanBeMadeTransparent) {
  SpaceScene scene(middle());
  GroundView view(scene, tiles(), Layer::kLabels);
  view.set_opacity(0.5);
  const Eigen::AlignedBox2d shown(middle() - Eigen::Vector2d(3, 3),
                                  middle() + Eigen::Vector2d(3, 3));
  ASSERT_TRUE(view.show(shown, 0.1));
  const SpaceCamera camera{{middle().x(), middle().y(), 0.0}, 20.0, 0.4, 0.6, 0.1};
  EXPECT_NEAR(draw(scene, camera).at(kPageWidth / 2, kPageHeight / 2).alpha, 128, 2);
  view.set_opacity(1.0);
  EXPECT_EQ(draw(scene, camera).at(kPageWidth / 2, kPageHeight / 2).alpha, 255);
}

}  // namespace ground_view_test
}  // namespace nadir
