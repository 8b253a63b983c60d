// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "core/base/raster.h"

namespace nadir {

/// A pixel of an image on the ground: sRGB, not premultiplied. Alpha 0: nothing was seen there.
struct ImagePixel {
  std::uint8_t red = 0, green = 0, blue = 0, alpha = 255;
  friend bool operator==(const ImagePixel&, const ImagePixel&) = default;
};
using ImageRaster = Raster<ImagePixel>;

/// How an image is shown. The default shows it as it is.
struct ImageLook {
  bool is_visible = true;
  double opacity =
      1.0;  ///< In [0, 1]. For whoever lays images on one another; pixels do not change.
  double brightness = 0.0;  ///< In [-1, 1]: from black to white.
  double contrast = 0.0;  ///< In [-1, 1]: from an eighth to eight times as much, about middle grey.
  friend bool operator==(const ImageLook&, const ImageLook&) = default;
};

/// What brightness and contrast make of each value of a channel. Values outside their range count as its end.
[[nodiscard]] std::array<std::uint8_t, 256> tone_table(const ImageLook& look);
/// Red, green and blue by the table; alpha stays.
void apply_tones(const std::array<std::uint8_t, 256>& table, ImageRaster& pixels);

}  // namespace nadir
