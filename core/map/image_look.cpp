// SPDX-License-Identifier: Apache-2.0
#include "core/map/image_look.h"

#include <algorithm>
#include <cmath>

namespace nadir {

std::array<std::uint8_t, 256> tone_table(const ImageLook& look) {
  constexpr double kMiddle = 127.5;
  const double slope = std::exp2(3.0 * std::clamp(look.contrast, -1.0, 1.0));
  const double shift = 255.0 * std::clamp(look.brightness, -1.0, 1.0);
  std::array<std::uint8_t, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double value = (static_cast<double>(i) - kMiddle) * slope + kMiddle + shift;
    table.at(i) = static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
  }
  return table;
}

void apply_tones(const std::array<std::uint8_t, 256>& table, ImageRaster& pixels) {
  for (ImagePixel& pixel : pixels.values()) {
    pixel.red = table[pixel.red];
    pixel.green = table[pixel.green];
    pixel.blue = table[pixel.blue];
  }
}

}  // namespace nadir
