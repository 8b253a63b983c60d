// SPDX-License-Identifier: Apache-2.0
#include "core/assist/magic_wand.h"

#include <gmock/gmock.h>

#include "tests/core/assist/drawn_windows.h"

namespace nadir {
namespace magic_wand_test {

using testing::HasSubstr;

PixelMask wand(const AssistWindow& window, double x, double y, const WandOptions& options = {}) {
  auto found = magic_wand(window, window.enu_from_pixels() * Eigen::Vector2d(x, y), options);
  if (!found) throw std::runtime_error(error_text(found));
  return std::move(*found);
}

/// What '.' is grass and else roof.
AssistWindow window_drawn(const std::vector<std::string>& rows) {
  const PixelMask mask = mask_drawn(rows);
  return window_of(drawn_picture(mask.width(), mask.height(),
                                 [&](const Eigen::Vector2d& at) {
                                   return mask.at(static_cast<int>(at.x()),
                                                  static_cast<int>(at.y())) != 0;
                                 }),
                   plain_place());
}

TEST(MagicWand, FindsExactlyTheDiscThatWasDrawn) {
  const Inside inside = disc(61.3, 47.8, 31.0);
  const AssistWindow window = window_of(drawn_picture(120, 90, inside), turned_place());
  EXPECT_EQ(wand(window, 60.0, 50.0), pixels_inside(120, 90, inside));
}

TEST(MagicWand, FindsTheDiscUnderNoiseAndFillsItsSpeckles) {
  const Inside inside = disc(61.3, 47.8, 31.0);
  const AssistWindow window = window_of(noisy(drawn_picture(120, 90, inside), 6.0), plain_place());
  const PixelMask found = wand(window, 60.0, 50.0, {.tolerance = 18.0, .fill_holes_m2 = 20.0});
  EXPECT_GT(overlap(found, pixels_inside(120, 90, inside)), 0.99);
}

TEST(MagicWand, TakesWhatHangsTogetherWithinTheTolerance) {
  // Against a search that sweeps until nothing changes.
  const AssistWindow window = window_of(noisy(ImageRaster(40, 30, kGrass), 12.0), plain_place());
  for (const auto neighbours : {PixelNeighbours::kFour, PixelNeighbours::kEight}) {
    for (const double edge_stop : {0.0, 14.0}) {
      const WandOptions options{
          .tolerance = 13.0, .edge_stop = edge_stop, .neighbours = neighbours};
      LabColour mean;
      for (int row = 14; row <= 16; ++row) {
        for (int column = 19; column <= 21; ++column) {
          const LabColour& colour = window.colours().at(column, row);
          mean = {mean.lightness + colour.lightness / 9.0F, mean.a + colour.a / 9.0F,
                  mean.b + colour.b / 9.0F};
        }
      }
      PixelMask expected(40, 30);
      expected.at(20, 15) = 1;
      const auto reaches = [&](int column, int row) {
        const LabColour& colour = window.colours().at(column, row);
        if (colour_difference(colour, mean) > 13.0F) return false;
        for (int y = std::max(0, row - 1); y <= std::min(29, row + 1); ++y) {
          for (int x = std::max(0, column - 1); x <= std::min(39, column + 1); ++x) {
            if (neighbours == PixelNeighbours::kFour && x != column && y != row) continue;
            if (expected.at(x, y) == 0) continue;
            const float step = colour_difference(window.colours().at(x, y), colour);
            if (edge_stop == 0.0 || step <= edge_stop) return true;
          }
        }
        return false;
      };
      for (bool changes = true; changes;) {
        changes = false;
        for (int row = 0; row < 30; ++row) {
          for (int column = 0; column < 40; ++column) {
            if (expected.at(column, row) == 0 && reaches(column, row)) {
              expected.at(column, row) = 1;
              changes = true;
            }
          }
        }
      }
      EXPECT_GT(count_of(expected), 4);
      EXPECT_LT(count_of(expected), 1200);
      EXPECT_EQ(wand(window, 20.5, 15.5, options), expected);
    }
  }
}

TEST(MagicWand, GoesRoundCornersOnlyWhereTheyCount) {
  const AssistWindow window = window_drawn({"##..",  //
                                            "##..",  //
                                            "..##",  //
                                            "..##"});
  EXPECT_EQ(count_of(wand(window, 0.5, 0.5, {.neighbours = PixelNeighbours::kFour})), 4);
  EXPECT_EQ(count_of(wand(window, 0.5, 0.5, {.neighbours = PixelNeighbours::kEight})), 8);
}

TEST(MagicWand, StopsAtAnEdgeThatTheToleranceWouldCross) {
  ImageRaster pixels(60, 10);
  for (int row = 0; row < 10; ++row) {
    for (int column = 0; column < 60; ++column) {
      // A slow ramp with one step in it.
      const auto value = static_cast<std::uint8_t>(100 + column + (column >= 30 ? 15 : 0));
      pixels.at(column, row) = {value, value, value, 255};
    }
  }
  const AssistWindow window = window_of(pixels, plain_place());
  EXPECT_EQ(count_of(wand(window, 5.5, 5.5, {.tolerance = 60.0})), 600);
  EXPECT_EQ(wand(window, 5.5, 5.5, {.tolerance = 60.0, .edge_stop = 3.0}),
            pixels_inside(60, 10, [](const Eigen::Vector2d& at) { return at.x() < 30.0; }));
}

TEST(MagicWand, FillsHolesUpToASizeInSquareMetres) {
  const Inside inside = [](const Eigen::Vector2d& at) {
    const bool in_small = disc(20.0, 20.0, 3.0)(at);
    const bool in_large = disc(45.0, 20.0, 8.0)(at);
    return !in_small && !in_large;
  };
  // A pixel is 0.375 square metres; the holes are of about 28 and 201 pixels.
  const AssistWindow window = window_of(drawn_picture(70, 40, inside), turned_place());
  const int whole = 70 * 40;
  const int small = count_of(pixels_inside(70, 40, disc(20.0, 20.0, 3.0)));
  const int large = count_of(pixels_inside(70, 40, disc(45.0, 20.0, 8.0)));
  const auto found_with = [&](double hole_m2) {
    return count_of(wand(window, 2.0, 2.0, {.fill_holes_m2 = hole_m2}));
  };
  EXPECT_EQ(found_with(0.0), whole - small - large);
  EXPECT_EQ(found_with(0.375 * small - 0.1), whole - small - large);
  EXPECT_EQ(found_with(0.375 * small + 0.1), whole - large);
  EXPECT_EQ(found_with(0.375 * large + 0.1), whole);
}

TEST(MagicWand, LeavesOutWhatWasNotSeenAlsoInHoles) {
  ImageRaster pixels(20, 20, kGrass);
  pixels.at(10, 10).alpha = 0;
  const AssistWindow window = window_of(pixels, plain_place());
  const PixelMask found = wand(window, 3.0, 3.0, {.fill_holes_m2 = 100.0});
  EXPECT_EQ(count_of(found), 399);
  EXPECT_EQ(found.at(10, 10), 0);
  EXPECT_EQ(error_text(magic_wand(window, {10.5, -10.5})), "the image shows nothing at the place");
}

TEST(MagicWand, TakesAllOfOneColour) {
  EXPECT_EQ(count_of(wand(window_of(ImageRaster(50, 40, kRoof), plain_place()), 7.0, 7.0,
                          {.tolerance = 0.0})),
            2000);
  EXPECT_EQ(count_of(wand(window_of(ImageRaster(1, 1, kRoof), plain_place()), 0.5, 0.5)), 1);
}

TEST(MagicWand, AlwaysTakesThePixelThatWasClicked) {
  // In a chequered pattern the mean around it is another colour.
  const AssistWindow window = window_drawn({".#.", "#.#", ".#."});
  EXPECT_EQ(wand(window, 1.5, 1.5, {.tolerance = 1.0}), mask_drawn({"...", ".#.", "..."}));
}

TEST(MagicWand, OutsideOrWithAbsurdOptionsIsRefused) {
  const AssistWindow window = window_of(ImageRaster(5, 5, kRoof), plain_place());
  EXPECT_EQ(error_text(magic_wand(window, {5.5, -2.0})),
            "the place is outside of what is looked at");
  EXPECT_THAT(error_text(magic_wand(window, {2.5, -2.0}, {.tolerance = std::nan("")})),
              HasSubstr("--wand-tolerance"));
}

}  // namespace magic_wand_test
}  // namespace nadir
