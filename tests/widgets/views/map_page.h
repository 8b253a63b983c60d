// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>

#include <functional>
#include <memory>
#include <optional>

#include "tests/support/error_text.h"
#include "tests/support/page_pixels.h"
#include "widgets/gl/offscreen_renderer.h"
#include "widgets/views/map_scene.h"

namespace nadir {

/// A test that draws maps. Not for each test a renderer of its own: starting one takes longer than the test.
class MapPage : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto made = OffscreenRenderer::create();
    ASSERT_TRUE(made) << error_text(made);
    offscreen() = std::move(*made);
  }
  static void TearDownTestSuite() { offscreen().reset(); }

  [[nodiscard]] static Raster<Rgba> draw(MapScene& scene, const MapSight& sight) {
    const int width = static_cast<int>(sight.width_px);
    const int height = static_cast<int>(sight.height_px);
    scene.look(sight);
    auto drawn = offscreen()->render(scene.renderer(), width, height);
    EXPECT_TRUE(drawn) << error_text(drawn);
    return drawn ? *drawn : Raster<Rgba>(width, height);
  }
  [[nodiscard]] static Raster<Rgba> draw(MapScene& scene,
                                         const MapCamera& camera,
                                         int width,
                                         int height) {
    return draw(scene, {camera, static_cast<double>(width), static_cast<double>(height), 1.0});
  }

  /// Colour at a place; nothing where it may be one or another.
  using Truth = std::function<std::optional<Rgba>(const Eigen::Vector2d& point_in_enu_m)>;

  /// Compares each pixel with what the camera says lies under its centre. At most a tenth may stay undecided.
  static void expect_everywhere(const Raster<Rgba>& drawn,
                                const MapCamera& camera,
                                const Truth& truth,
                                int tolerance = 0) {
    const PageRect page{0.0, 0.0, static_cast<double>(drawn.width()),
                        static_cast<double>(drawn.height())};
    std::size_t wrong = 0;
    std::size_t undecided = 0;
    std::string first;
    for (int row = 0; row < drawn.height(); ++row) {
      for (int column = 0; column < drawn.width(); ++column) {
        const auto expected =
            truth(camera.enu_from_page(centre_of_pixel(drawn, column, row), page));
        if (!expected) {
          ++undecided;
        } else if (difference(drawn.at(column, row), *expected) > tolerance) {
          if (wrong++ > 0) continue;
          first = "first at column " + std::to_string(column) + ", row " + std::to_string(row) +
                  ": " + testing::PrintToString(drawn.at(column, row)) + " instead of " +
                  testing::PrintToString(*expected);
        }
      }
    }
    EXPECT_EQ(wrong, 0U) << first;
    EXPECT_LE(undecided, drawn.size() / 10);
  }

 private:
  static std::unique_ptr<OffscreenRenderer>& offscreen() {
    static std::unique_ptr<OffscreenRenderer> renderer;
    return renderer;
  }
};

/// Whether a number of cells lies so near a border between two that rounding decides.
[[nodiscard]] inline bool is_near_border(double cells) {
  constexpr double kNear = 0.02;
  return std::abs(cells - std::round(cells)) < kNear;
}

}  // namespace nadir
