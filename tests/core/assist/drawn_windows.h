// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/assist/pixel_mask.h"
#include "core/base/random.h"
#include "tests/support/error_text.h"

namespace nadir {

inline constexpr ImagePixel kGrass{70, 120, 60, 255};
inline constexpr ImagePixel kRoof{170, 90, 70, 255};

/// Pixels of half a metre, turned by 30 degrees, one and a half times as long as wide, with rows that lead down.
[[nodiscard]] inline Affine2 turned_place() {
  const double turn = std::acos(-1.0) / 6.0;
  Affine2 place;
  place.linear << 0.5 * std::cos(turn), 0.75 * std::sin(turn), 0.5 * std::sin(turn),
      -0.75 * std::cos(turn);
  place.offset = {1234.5, -321.25};
  return place;
}
/// A metre a pixel, so that pixel (x, y) lies at enu (x, -y).
[[nodiscard]] inline Affine2 plain_place() {
  Affine2 place;
  place.linear << 1.0, 0.0, 0.0, -1.0;
  return place;
}

[[nodiscard]] inline AssistWindow window_of(ImageRaster pixels, const Affine2& place) {
  auto window = AssistWindow::create(std::move(pixels), place);
  if (!window) throw std::runtime_error(error_text(window));
  return std::move(*window);
}

/// Whether a place, in pixels from the corner of a picture, is inside of what is drawn.
using Inside = std::function<bool(const Eigen::Vector2d& at_in_pixels)>;
[[nodiscard]] inline Inside disc(double x, double y, double radius) {
  return [=](const Eigen::Vector2d& at) { return std::hypot(at.x() - x, at.y() - y) <= radius; };
}

/// One colour in another: each pixel as its centre has it, or with `samples` on a side as a camera would see it.
[[nodiscard]] inline ImageRaster drawn_picture(int width,
                                               int height,
                                               const Inside& inside,
                                               int samples = 1,
                                               const ImagePixel& in = kRoof,
                                               const ImagePixel& out = kGrass) {
  ImageRaster pixels(width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      int hits = 0;
      for (int i = 0; i < samples * samples; ++i) {
        const Eigen::Vector2d at(column + (i % samples + 0.5) / samples,
                                 row + (i / samples + 0.5) / samples);
        if (inside(at)) ++hits;
      }
      const double share = static_cast<double>(hits) / (samples * samples);
      const auto mixed = [&](std::uint8_t a, std::uint8_t b) {
        return static_cast<std::uint8_t>(std::lround(share * a + (1.0 - share) * b));
      };
      pixels.at(column, row) = {mixed(in.red, out.red), mixed(in.green, out.green),
                                mixed(in.blue, out.blue), 255};
    }
  }
  return pixels;
}

/// With normal noise on every channel.
[[nodiscard]] inline ImageRaster noisy(ImageRaster pixels, double sigma, std::uint64_t seed = 7) {
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const auto number = static_cast<std::uint32_t>(i);
    const auto [one, two] = standard_normals({seed, 0, 0, number, 0});
    const auto [three, unused] = standard_normals({seed, 0, 0, number, 1});
    const auto moved = [&](std::uint8_t value, double by) {
      return static_cast<std::uint8_t>(std::clamp(std::lround(value + sigma * by), 0L, 255L));
    };
    ImagePixel& pixel = pixels.values()[i];
    pixel = {moved(pixel.red, one), moved(pixel.green, two), moved(pixel.blue, three), pixel.alpha};
  }
  return pixels;
}

/// Those whose centre is inside.
[[nodiscard]] inline PixelMask pixels_inside(int width, int height, const Inside& inside) {
  PixelMask mask(width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      mask.at(column, row) = inside({column + 0.5, row + 0.5}) ? 1 : 0;
    }
  }
  return mask;
}

/// A mask as it is drawn in a test: what is no '.' belongs.
[[nodiscard]] inline PixelMask mask_drawn(const std::vector<std::string>& rows) {
  PixelMask mask(static_cast<int>(rows.front().size()), static_cast<int>(rows.size()));
  for (int row = 0; row < mask.height(); ++row) {
    for (int column = 0; column < mask.width(); ++column) {
      mask.at(column, row) =
          rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] == '.' ? 0 : 1;
    }
  }
  return mask;
}

/// Pixels that both have by those that either has.
[[nodiscard]] inline double overlap(const PixelMask& a, const PixelMask& b) {
  int both = 0;
  int either = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    both += a.values()[i] & b.values()[i];
    either += a.values()[i] | b.values()[i];
  }
  return static_cast<double>(both) / either;
}

[[nodiscard]] inline int count_of(const PixelMask& mask) {
  return static_cast<int>(std::count(mask.values().begin(), mask.values().end(), 1));
}

}  // namespace nadir
