// SPDX-License-Identifier: Apache-2.0
#include "core/assist/superpixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/assist/joined_pieces.h"
#include "core/base/parallel.h"
#include "core/base/require.h"

namespace nadir {
namespace {

/// Mean of the pixels of a superpixel; places are those of centres of pixels.
struct Centre {
  LabColour colour;
  float x = 0.0F, y = 0.0F;
};

/// How much the colours around a pixel differ, squared: a centre does not begin on an edge.
float gradient_at(const AssistWindow& window, int column, int row) {
  const auto held = [&](int right, int down) {
    return window.colours().at(std::clamp(column + right, 0, window.width() - 1),
                               std::clamp(row + down, 0, window.height() - 1));
  };
  const float across = colour_difference(held(-1, 0), held(1, 0));
  const float along = colour_difference(held(0, -1), held(0, 1));
  return across * across + along * along;
}

/// The place of the lowest gradient among the 3 x 3 pixels around one.
PixelPlace calmest_around(const AssistWindow& window, int column, int row) {
  PixelPlace best{column, row};
  float least = gradient_at(window, column, row);
  for (int y = std::max(0, row - 1); y <= std::min(window.height() - 1, row + 1); ++y) {
    for (int x = std::max(0, column - 1); x <= std::min(window.width() - 1, column + 1); ++x) {
      const float gradient = gradient_at(window, x, y);
      if (gradient < least) {
        least = gradient;
        best = {x, y};
      }
    }
  }
  return best;
}

std::vector<Centre> first_centres(const AssistWindow& window, double side) {
  const auto count_along = [&](int pixels) {
    return std::max(1, static_cast<int>(std::lround(pixels / side)));
  };
  const int columns = count_along(window.width());
  const int rows = count_along(window.height());
  std::vector<Centre> centres;
  centres.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const auto [column, row] =
          calmest_around(window, static_cast<int>((j + 0.5) * window.width() / columns),
                         static_cast<int>((i + 0.5) * window.height() / rows));
      centres.push_back(
          {window.colours().at(column, row), static_cast<float>(column), static_cast<float>(row)});
    }
  }
  return centres;
}

/// Each pixel gets the nearest centre of those that look at it. Each chunk of rows is by itself, so threads do not matter.
void assign(const AssistWindow& window,
            const std::vector<Centre>& centres,
            double side,
            double compactness,
            Raster<SuperpixelId>& nearest) {
  const auto reach = static_cast<float>(side + 1.0);
  const auto weight = static_cast<float>((compactness / side) * (compactness / side));
  constexpr std::size_t kRowsAtOnce = 32;
  parallel_for(
      static_cast<std::size_t>(window.height()), kRowsAtOnce,
      [&](std::size_t begin, std::size_t end) {
        const int top = static_cast<int>(begin);
        const int bottom = static_cast<int>(end);
        Raster<float> least(window.width(), bottom - top, std::numeric_limits<float>::max());
        for (std::size_t i = 0; i < centres.size(); ++i) {
          const Centre& centre = centres[i];
          const int first_row = std::max(top, static_cast<int>(std::ceil(centre.y - reach)));
          const int end_row = std::min(bottom, static_cast<int>(std::floor(centre.y + reach)) + 1);
          const int first_column = std::max(0, static_cast<int>(std::ceil(centre.x - reach)));
          const int end_column =
              std::min(window.width(), static_cast<int>(std::floor(centre.x + reach)) + 1);
          for (int row = first_row; row < end_row; ++row) {
            const float down = static_cast<float>(row) - centre.y;
            for (int column = first_column; column < end_column; ++column) {
              const LabColour& colour = window.colours().at(column, row);
              const float lightness = colour.lightness - centre.colour.lightness;
              const float a = colour.a - centre.colour.a;
              const float b = colour.b - centre.colour.b;
              const float right = static_cast<float>(column) - centre.x;
              const float distance =
                  lightness * lightness + a * a + b * b + weight * (right * right + down * down);
              float& best = least.at(column, row - top);
              if (distance < best) {
                best = distance;
                nearest.at(column, row) = static_cast<SuperpixelId>(i);
              }
            }
          }
        }
      });
}

/// Means of what each centre has got, in the order of pixels; a centre that has lost all stays where it was.
void move_centres(const AssistWindow& window,
                  const Raster<SuperpixelId>& nearest,
                  std::vector<Centre>& centres) {
  struct Sum {
    double lightness = 0.0, a = 0.0, b = 0.0, x = 0.0, y = 0.0, count = 0.0;
  };
  std::vector<Sum> sums(centres.size());
  for (int row = 0; row < window.height(); ++row) {
    for (int column = 0; column < window.width(); ++column) {
      if (!window.is_seen(column, row)) continue;
      const LabColour& colour = window.colours().at(column, row);
      Sum& sum = sums[static_cast<std::size_t>(nearest.at(column, row))];
      sum.lightness += colour.lightness;
      sum.a += colour.a;
      sum.b += colour.b;
      sum.x += column;
      sum.y += row;
      sum.count += 1.0;
    }
  }
  const auto mean = [](double sum, double count) { return static_cast<float>(sum / count); };
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const Sum& sum = sums[i];
    if (sum.count == 0.0) continue;
    centres[i] = {{mean(sum.lightness, sum.count), mean(sum.a, sum.count), mean(sum.b, sum.count)},
                  mean(sum.x, sum.count),
                  mean(sum.y, sum.count)};
  }
}

}  // namespace

Result<Superpixels> find_superpixels(const AssistWindow& window, const SuperpixelOptions& options) {
  if (const auto valid = validate(options); !valid) return forward_error(valid);
  const double side = options.side_px;
  std::vector<Centre> centres = first_centres(window, side);
  // Whoever is out of every centre's reach keeps the first, until pieces are made.
  Raster<SuperpixelId> nearest(window.width(), window.height(), 0);
  for (int i = 0; i < options.iterations; ++i) {
    assign(window, centres, side, options.compactness, nearest);
    move_centres(window, nearest, centres);
  }
  for (int row = 0; row < window.height(); ++row) {
    for (int column = 0; column < window.width(); ++column) {
      if (!window.is_seen(column, row)) nearest.at(column, row) = kNoSuperpixel;
    }
  }
  return joined_pieces(window, nearest, static_cast<int>(side * side / 4.0));
}

std::optional<SuperpixelId> superpixel_at(const Superpixels& superpixels,
                                          const AssistWindow& window,
                                          const Eigen::Vector2d& at_in_enu_m) {
  const auto pixel = window.pixel_at(at_in_enu_m);
  if (!pixel) return std::nullopt;
  const SuperpixelId id = superpixels.of_pixel.at(pixel->column, pixel->row);
  return id == kNoSuperpixel ? std::nullopt : std::optional(id);
}

std::set<SuperpixelId> superpixels_along(const Superpixels& superpixels,
                                         const AssistWindow& window,
                                         const Eigen::Vector2d& from_in_enu_m,
                                         const Eigen::Vector2d& to_in_enu_m) {
  std::set<SuperpixelId> met;
  const Eigen::Vector2d way =
      window.pixels_from_enu() * to_in_enu_m - window.pixels_from_enu() * from_in_enu_m;
  if (!way.allFinite()) return met;
  // Half a pixel each, and no more than cross a window from far outside.
  const double steps = std::clamp(std::ceil(2.0 * way.cwiseAbs().maxCoeff()), 1.0, 1e5);
  for (int i = 0; i <= static_cast<int>(steps); ++i) {
    const Eigen::Vector2d at = from_in_enu_m + (to_in_enu_m - from_in_enu_m) * (i / steps);
    if (const auto id = superpixel_at(superpixels, window, at)) met.insert(*id);
  }
  return met;
}

PixelMask mask_of(const Superpixels& superpixels, const std::set<SuperpixelId>& chosen) {
  std::vector<std::uint8_t> is_chosen(static_cast<std::size_t>(superpixels.count), 0);
  for (const SuperpixelId id : chosen) {
    NADIR_REQUIRE(id >= 0 && id < superpixels.count);
    is_chosen[static_cast<std::size_t>(id)] = 1;
  }
  PixelMask mask(superpixels.of_pixel.width(), superpixels.of_pixel.height());
  for (std::size_t i = 0; i < mask.size(); ++i) {
    const SuperpixelId id = superpixels.of_pixel.values()[i];
    if (id != kNoSuperpixel) mask.values()[i] = is_chosen[static_cast<std::size_t>(id)];
  }
  return mask;
}

}  // namespace nadir
