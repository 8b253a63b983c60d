// SPDX-License-Identifier: Apache-2.0
#include "core/assist/superpixels.h"

#include <gmock/gmock.h>

#include "core/base/parallel.h"
#include "tests/core/assist/drawn_windows.h"

namespace nadir {
namespace superpixels_test {

using testing::ElementsAre;
using testing::HasSubstr;

Superpixels superpixels(const AssistWindow& window, const SuperpixelOptions& options = {}) {
  auto found = find_superpixels(window, options);
  if (!found) throw std::runtime_error(error_text(found));
  return std::move(*found);
}

std::vector<int> sizes_of(const Superpixels& found) {
  std::vector<int> sizes(static_cast<std::size_t>(found.count), 0);
  for (const SuperpixelId id : found.of_pixel.values()) {
    if (id != kNoSuperpixel) ++sizes.at(static_cast<std::size_t>(id));
  }
  return sizes;
}

/// Pieces that hang together by sides, over all superpixels.
int pieces_of(const Superpixels& found) {
  Raster<SuperpixelId> left = found.of_pixel;
  int pieces = 0;
  for (int row = 0; row < left.height(); ++row) {
    for (int column = 0; column < left.width(); ++column) {
      const SuperpixelId id = left.at(column, row);
      if (id == kNoSuperpixel) continue;
      ++pieces;
      std::vector<PixelPlace> waiting{{column, row}};
      while (!waiting.empty()) {
        const PixelPlace at = waiting.back();
        waiting.pop_back();
        if (!left.contains(at.column, at.row) || left.at(at.column, at.row) != id) continue;
        left.at(at.column, at.row) = kNoSuperpixel;
        for (const auto& [right, down] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
          waiting.push_back({at.column + right, at.row + down});
        }
      }
    }
  }
  return pieces;
}

AssistWindow noisy_disc(double sigma = 10.0) {
  return window_of(noisy(drawn_picture(160, 120, disc(70.0, 60.0, 37.0)), sigma), turned_place());
}

TEST(Superpixels, CoverTheWindowAndEachHangsTogether) {
  for (const double side : {4.0, 11.0, 16.0, 50.0, 200.0}) {
    const Superpixels found = superpixels(noisy_disc(), {.side_px = side});
    const std::vector<int> sizes = sizes_of(found);
    EXPECT_EQ(pieces_of(found), found.count) << side;
    EXPECT_THAT(sizes, testing::Each(testing::Ge(static_cast<int>(side * side / 4.0)))) << side;
    EXPECT_NEAR(found.count, std::max(1.0, 160.0 * 120.0 / (side * side)), 2.0 + 0.4 * found.count)
        << side;
  }
}

TEST(Superpixels, FollowAStrongEdgeToAPixel) {
  // Slanted, so that it runs through the grid of centres anyhow.
  const Eigen::Vector2d normal = Eigen::Vector2d(0.8, 0.6);
  const auto beyond = [&](const Eigen::Vector2d& at) { return normal.dot(at) - 101.3; };
  const AssistWindow window = window_of(
      noisy(drawn_picture(160, 120, [&](const Eigen::Vector2d& at) { return beyond(at) > 0.0; }),
            4.0),
      plain_place());
  const Superpixels found = superpixels(window);
  std::vector<double> sides(static_cast<std::size_t>(found.count), 0.0);
  for (const bool decides : {true, false}) {
    for (int row = 0; row < 120; ++row) {
      for (int column = 0; column < 160; ++column) {
        const double distance = beyond({column + 0.5, row + 0.5});
        double& side = sides[static_cast<std::size_t>(found.of_pixel.at(column, row))];
        if (decides) side += distance > 0.0 ? 1.0 : -1.0;
        if (!decides && distance * side < 0.0) {
          EXPECT_LT(std::abs(distance), 1.0);
        }
      }
    }
  }
}

TEST(Superpixels, AreTheSameOnAnyNumberOfThreads) {
  const AssistWindow window = noisy_disc(30.0);
  const ThreadLimit one(1);
  const Superpixels alone = superpixels(window);
  const ThreadLimit four(4);
  EXPECT_EQ(superpixels(window).of_pixel, alone.of_pixel);
}

TEST(Superpixels, OfOneColourAreSquares) {
  const AssistWindow window = window_of(ImageRaster(160, 96, kGrass), plain_place());
  const Superpixels found = superpixels(window, {.side_px = 16.0});
  EXPECT_EQ(found.count, 60);
  EXPECT_THAT(sizes_of(found), testing::Each(testing::AllOf(testing::Ge(200), testing::Le(320))));
}

TEST(Superpixels, LeaveOutWhatWasNotSeen) {
  ImageRaster pixels = noisy(ImageRaster(80, 60, kGrass), 8.0);
  for (int row = 0; row < 60; ++row) {
    for (int column = 38; column < 42; ++column) pixels.at(column, row).alpha = 0;
  }
  pixels.at(40, 30).alpha = 255;  // An island, which has no neighbour to join.
  const AssistWindow window = window_of(pixels, plain_place());
  const Superpixels found = superpixels(window);
  EXPECT_EQ(pieces_of(found), found.count);
  for (int row = 0; row < 60; ++row) {
    for (int column = 0; column < 80; ++column) {
      EXPECT_EQ(found.of_pixel.at(column, row) == kNoSuperpixel, !window.is_seen(column, row));
    }
  }
  EXPECT_FALSE(superpixel_at(found, window, {38.5, -3.5}));
  const auto island = superpixel_at(found, window, {40.5, -30.5});
  ASSERT_TRUE(island);
  EXPECT_EQ(count_of(mask_of(found, {*island})), 1);
}

TEST(Superpixels, OfOnePixelOrALineArePossible) {
  EXPECT_EQ(superpixels(window_of(ImageRaster(1, 1, kRoof), plain_place())).count, 1);
  const Superpixels line =
      superpixels(window_of(noisy(ImageRaster(200, 1, kRoof), 20.0), plain_place()));
  EXPECT_EQ(pieces_of(line), line.count);
}

TEST(Superpixels, AreChosenByDraggingOverThem) {
  const AssistWindow window = noisy_disc();
  const Superpixels found = superpixels(window);
  const auto enu = [&](double x, double y) {
    return window.enu_from_pixels() * Eigen::Vector2d(x, y);
  };
  std::set<SuperpixelId> expected;
  for (int column = 20; column < 120; ++column) expected.insert(found.of_pixel.at(column, 60));
  std::set<SuperpixelId> chosen =
      superpixels_along(found, window, enu(20.5, 60.5), enu(119.5, 60.5));
  EXPECT_EQ(chosen, expected);
  // A place alone, a way from outside, a way outside.
  EXPECT_THAT(superpixels_along(found, window, enu(3.0, 3.0), enu(3.0, 3.0)),
              ElementsAre(found.of_pixel.at(3, 3)));
  EXPECT_THAT(superpixels_along(found, window, enu(-500.0, 0.5), enu(0.5, 0.5)),
              ElementsAre(found.of_pixel.at(0, 0)));
  EXPECT_TRUE(superpixels_along(found, window, enu(-5.0, -5.0), enu(-5.0, 500.0)).empty());
  const PixelMask mask = mask_of(found, chosen);
  for (std::size_t i = 0; i < mask.size(); ++i) {
    EXPECT_EQ(mask.values()[i] != 0, chosen.count(found.of_pixel.values()[i]) > 0);
  }
  // Taken away again.
  chosen.erase(found.of_pixel.at(50, 60));
  EXPECT_EQ(mask_of(found, chosen).at(50, 60), 0);
}

TEST(Superpixels, WithAbsurdOptionsAreRefused) {
  EXPECT_THAT(error_text(find_superpixels(noisy_disc(), {.side_px = 0.0})),
              HasSubstr("--superpixel-side"));
}

}  // namespace superpixels_test
}  // namespace nadir
