// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/label_borders_view.h"

#include <algorithm>
#include <array>
#include <set>

#include "tests/widgets/views/label_tiles.h"

namespace nadir {
namespace label_borders_view_test {

class LabelBorders : public MapPage {
 protected:
  static constexpr int kSide = 160;

  static std::shared_ptr<const LabelDocument> document_with(std::vector<LabelObject> objects) {
    return std::make_shared<const LabelDocument>(document_of(std::move(objects), 1000, 1000));
  }
  [[nodiscard]] Raster<Rgba> drawn(const MapCamera& camera) {
    return draw(scene, camera, kSide, kSide);
  }
  static bool is_light(Rgba pixel) { return pixel.alpha > 200 && pixel.green > 200; }
  static int light_pixels(const Raster<Rgba>& page) {
    return static_cast<int>(std::count_if(page.values().begin(), page.values().end(), is_light));
  }

  /// Way along the border of box(20, 30, 60, 80) to the point of it that is nearest to `at`, in [0, 180).
  static double metres_around(const Eigen::Vector2d& at) {
    const double x = std::clamp(at.x(), 20.0, 60.0) - 20.0,
                 y = std::clamp(-at.y(), 30.0, 80.0) - 30.0;
    const std::array<double, 4> to_sides = {y, 40.0 - x, 50.0 - y, x};
    switch (std::min_element(to_sides.begin(), to_sides.end()) - to_sides.begin()) {
      case 0:
        return std::min(x, 39.999);
      case 1:
        return 40.0 + std::min(y, 49.999);
      case 2:
        return 90.0 + std::min(40.0 - x, 39.999);
      default:
        return 130.0 + std::min(50.0 - y, 49.999);
    }
  }

  MapScene scene{Eigen::Vector2d(50.0, -50.0)};
};

TEST_F(LabelBorders, LieWhereTheObjectsDo) {
  LabelBordersView view(scene);
  view.show(document_with({area(kRoad, {box(20, 30, 60, 80)}, 1)}));
  for (const double up_rad : {1.5707963267948966, 0.8}) {
    const MapCamera camera{{40.0, -55.0}, 0.5, up_rad};
    const Raster<Rgba> page = drawn(camera);
    const PageRect where{0, 0, kSide, kSide};
    std::set<int> light;  // Metres along the border that have a light pixel.
    for (int row = 0; row < kSide; ++row) {
      for (int column = 0; column < kSide; ++column) {
        const Eigen::Vector2d at = camera.enu_from_page(centre_of_pixel(page, column, row), where);
        const double x = at.x(), y = -at.y();
        // Signed distance to the rectangle's border.
        const double inside = std::min({x - 20, 60 - x, y - 30, 80 - y});
        const Eigen::Vector2d beyond(std::max({20 - x, x - 60, 0.0}),
                                     std::max({30 - y, y - 80, 0.0}));
        const double distance_m = inside > 0 ? inside : beyond.norm();
        if (is_light(page.at(column, row))) {
          ASSERT_LE(distance_m, 0.8) << column << " " << row;
          light.insert(static_cast<int>(metres_around(at)));
        }
        if (distance_m > 2.5) {
          ASSERT_EQ(page.at(column, row).alpha, 0) << column << " " << row;
        }
      }
    }
    EXPECT_EQ(light.size(), 180U) << "all around";
  }
}

TEST_F(LabelBorders, AreCasedSoThatTheyAreSeenOnAnyGround) {
  LabelBordersView view(scene);
  view.show(document_with({area(kRoad, {box(20, 30, 60, 80)}, 1)}));
  for (const Rgba ground : {kWhite, kBlack}) {
    scene.set_background(ground, false);
    const Raster<Rgba> page = drawn({{40.0, -55.0}, 0.5});
    int different = 0;
    for (const Rgba pixel : page.values()) different += difference(pixel, ground) > 80 ? 1 : 0;
    EXPECT_GT(different, 300);
  }
}

TEST_F(LabelBorders, LeaveOutWhatIsSmallerThanTwoPixels) {
  LabelBordersView view(scene);
  view.show(document_with({area(kRoad, {box(50, 50, 51.9, 51.9)}, 1)}));
  EXPECT_EQ(light_pixels(drawn({{50.0, -50.0}, 1.0})), 0);
  EXPECT_GT(light_pixels(drawn({{50.0, -50.0}, 0.5})), 3);
}

TEST_F(LabelBorders, AreDrawnAnewOnlyWhereTheCameraHasGoneFar) {
  LabelBordersView view(scene);
  std::vector<LabelObject> objects;
  for (int i = 0; i < 400; ++i) {
    const double x = 50 * (i % 20), y = 50 * (i / 20);
    objects.push_back(area(kRoad, {box(x, y, x + 30, y + 30)}, i + 1));
  }
  view.show(document_with(std::move(objects)));
  (void)drawn({{500.0, -500.0}, 0.5});
  ASSERT_EQ(view.times_drawn(), 1U);
  // 40 pixels are there beyond each side.
  for (int i = 0; i <= 10; ++i) (void)drawn({{500.0 + 1.9 * i, -500.0 - 1.0 * i}, 0.5});
  EXPECT_EQ(view.times_drawn(), 1U);
  (void)drawn({{520.5, -500.0}, 0.5});
  EXPECT_EQ(view.times_drawn(), 2U);
  (void)drawn({{520.5, -500.0}, 0.49});
  EXPECT_EQ(view.times_drawn(), 3U) << "lines have the width of the page's pixels";
  // Wherever it is, it shows what one that begins there shows.
  for (std::uint32_t step = 0; step < 60; ++step) {
    const MapCamera camera{{1000.0 * share_of(step, 1), -1000.0 * share_of(step, 2)},
                           0.1 * std::exp2(5.0 * share_of(step, 3)),
                           6.0 * share_of(step, 4)};
    const int seen = light_pixels(drawn(camera));
    view.show(document_with({}));
    EXPECT_EQ(light_pixels(drawn(camera)), 0);
    std::vector<LabelObject> again;
    for (int i = 0; i < 400; ++i) {
      const double x = 50 * (i % 20), y = 50 * (i / 20);
      again.push_back(area(kRoad, {box(x, y, x + 30, y + 30)}, i + 1));
    }
    view.show(document_with(std::move(again)));
    EXPECT_EQ(light_pixels(drawn(camera)), seen) << step;
  }
}

TEST_F(LabelBorders, AreHiddenAndGone) {
  {
    LabelBordersView view(scene);
    view.show(document_with({area(kRoad, {box(20, 30, 60, 80)}, 1)}));
    const MapCamera camera{{40.0, -55.0}, 0.5};
    EXPECT_GT(light_pixels(drawn(camera)), 0);
    view.set_visible(false);
    EXPECT_EQ(light_pixels(drawn(camera)), 0);
    view.set_visible(true);
    EXPECT_GT(light_pixels(drawn(camera)), 0);
    view.show(nullptr);
    EXPECT_EQ(light_pixels(drawn(camera)), 0);
  }
  EXPECT_EQ(light_pixels(drawn({{40.0, -55.0}, 0.5})), 0);
}

}  // namespace label_borders_view_test
}  // namespace nadir
