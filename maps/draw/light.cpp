// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "maps/draw/painting.h"

namespace nadir::town {
namespace {

/// To the sun: it stands in the south-east, 50 degrees high, so that shadows fall to the
/// north-west.
constexpr double kSunEast = 0.66, kSunNorth = -0.751, kSunRise = 1.19;
constexpr double kLongestShadowM = 14.0;

/// Box blur along rows, then along columns; three of them make a good bell.
Raster<float> blurred(Raster<float> values, int reach) {
  const float share = 1.0F / static_cast<float>(2 * reach + 1);
  Raster<float> across(values.width(), values.height());
  for (int round = 0; round < 3; ++round) {
    for (const bool rows : {true, false}) {
      const int lines = rows ? values.height() : values.width();
      const int cells = rows ? values.width() : values.height();
      parallel_for(static_cast<std::size_t>(lines), 64, [&](std::size_t begin, std::size_t end) {
        for (int line = static_cast<int>(begin); line < static_cast<int>(end); ++line) {
          const auto value = [&](int i) {
            const int inside = std::clamp(i, 0, cells - 1);
            return rows ? values.at(inside, line) : values.at(line, inside);
          };
          double sum = 0.0;
          for (int i = -reach; i <= reach; ++i) sum += static_cast<double>(value(i));
          for (int i = 0; i < cells; ++i) {
            (rows ? across.at(i, line) : across.at(line, i)) = static_cast<float>(sum) * share;
            sum +=
                static_cast<double>(value(i + reach + 1)) - static_cast<double>(value(i - reach));
          }
        }
      });
      std::swap(values, across);
    }
  }
  return values;
}

/// 1 in the sun, 0 in the shadow of something higher towards the sun.
Raster<float> sunshine(const Canvas& canvas) {
  const Grid& grid = canvas.grid;
  Raster<float> lit(grid.columns, grid.rows, 1.0F);
  parallel_for(static_cast<std::size_t>(grid.rows), 16, [&](std::size_t begin, std::size_t end) {
    for (int row = static_cast<int>(begin); row < static_cast<int>(end); ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        const float from_m = canvas.height_m.at(column, row) + 0.12F;
        for (double away_m = 0.1; away_m < kLongestShadowM; away_m += 0.1) {
          const int c = static_cast<int>(column + 0.5 + kSunEast * away_m / grid.metres_per_cell);
          const int r = static_cast<int>(row + 0.5 - kSunNorth * away_m / grid.metres_per_cell);
          if (!canvas.height_m.contains(c, r)) break;
          if (canvas.height_m.at(c, r) > from_m + static_cast<float>(kSunRise * away_m)) {
            lit.at(column, row) = 0.0F;
            break;
          }
        }
      }
    }
  });
  return lit;
}

/// How squarely the sun meets the surface; 1 on level ground.
float facing(const Canvas& canvas, int column, int row) {
  const auto height_m = [&](int c, int r) {
    return canvas.height_m.at(std::clamp(c, 0, canvas.grid.columns - 1),
                              std::clamp(r, 0, canvas.grid.rows - 1));
  };
  // Walls are steep, but from above one does not see them: slopes end at 1.2.
  const float east =
      std::clamp((height_m(column + 1, row) - height_m(column - 1, row)) / 0.2F, -1.2F, 1.2F);
  const float north =
      std::clamp((height_m(column, row - 1) - height_m(column, row + 1)) / 0.2F, -1.2F, 1.2F);
  const float squarely = -east * static_cast<float>(kSunEast) -
                         north * static_cast<float>(kSunNorth) + static_cast<float>(kSunRise);
  return std::clamp(
      squarely / std::sqrt(1.0F + east * east + north * north) / static_cast<float>(kSunRise), 0.0F,
      1.35F);
}

/// The camera's blur: 1 4 6 4 1 both ways would be too soft at 10 cm, so half of it is kept sharp.
Paint soft(const Raster<Paint>& colour, int column, int row) {
  Paint sum = Paint::Zero();
  for (int j = -1; j <= 1; ++j) {
    for (int i = -1; i <= 1; ++i) {
      const float weight = (i == 0 ? 2.4F : 1.0F) * (j == 0 ? 2.4F : 1.0F) / (4.4F * 4.4F);
      sum += weight * colour.at(std::clamp(column + i, 0, colour.width() - 1),
                                std::clamp(row + j, 0, colour.height() - 1));
    }
  }
  return sum;
}

std::uint8_t eight_bits(float value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0F, 255.0F)));
}

}  // namespace

Raster<Colour> light(const Canvas& canvas) {
  const Grid& grid = canvas.grid;
  const Raster<float> lit = blurred(sunshine(canvas), 1);
  const Raster<float> around_m = blurred(canvas.height_m, 9);
  Raster<Paint> seen(grid.columns, grid.rows, Paint::Zero());
  const auto for_rows = [&grid](const std::function<void(int column, int row)>& body) {
    parallel_for(static_cast<std::size_t>(grid.rows), 16, [&](std::size_t begin, std::size_t end) {
      for (int row = static_cast<int>(begin); row < static_cast<int>(end); ++row) {
        for (int column = 0; column < grid.columns; ++column) body(column, row);
      }
    });
  };
  for_rows([&](int column, int row) {
    // Things that stand about hide part of the sky: corners and the feet of walls are darker.
    const float walled_m =
        std::max(0.0F, around_m.at(column, row) - canvas.height_m.at(column, row));
    const Paint sky = Paint{0.37F, 0.41F, 0.47F} * std::exp(-0.14F * walled_m);
    const Paint sun =
        Paint{0.65F, 0.615F, 0.555F} * (lit.at(column, row) * facing(canvas, column, row));
    seen.at(column, row) = canvas.colour.at(column, row).cwiseProduct(sky + sun);
  });
  Raster<Colour> picture(grid.columns, grid.rows);
  for_rows([&](int column, int row) {
    const auto word = [&](std::uint32_t purpose) {
      return chance(purpose, static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(column));
    };
    // The sum of two uniform numbers is noise enough for a sensor.
    const float noise = 4.5F * (word(120) + word(121) - 1.0F);
    const Paint colour = 1.03F * soft(seen, column, row) + Paint{6.0F, 8.0F, 11.0F};  // haze
    picture.at(column, row) = {eight_bits(colour.x() + noise), eight_bits(colour.y() + noise),
                               eight_bits(colour.z() + noise)};
  });
  return picture;
}

}  // namespace nadir::town
