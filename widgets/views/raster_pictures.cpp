// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/raster_pictures.h"

#include <algorithm>
#include <array>

#include "widgets/views/theme.h"

namespace nadir {

Raster<Rgba> class_picture(const Raster<ClassId>& labels) {
  std::array<Rgba, 256> colours{};
  for (int id = 0; id < 256; ++id) {
    colours.at(static_cast<std::size_t>(id)) = class_colour(static_cast<ClassId>(id));
  }
  Raster<Rgba> picture(labels.width(), labels.height());
  std::transform(labels.values().begin(), labels.values().end(), picture.values().begin(),
                 [&colours](ClassId id) { return colours[id]; });
  return picture;
}

Raster<Rgba> colour_picture(const ColourRaster& colours) {
  Raster<Rgba> picture(colours.width(), colours.height());
  std::transform(colours.values().begin(), colours.values().end(), picture.values().begin(),
                 [](const Colour& colour) {
                   return Rgba{colour.red, colour.green, colour.blue};
                 });
  return picture;
}

Raster<Rgba> colour_picture(const ImageRaster& pixels) {
  Raster<Rgba> picture(pixels.width(), pixels.height());
  std::transform(pixels.values().begin(), pixels.values().end(), picture.values().begin(),
                 [](const ImagePixel& pixel) {
                   return Rgba{pixel.red, pixel.green, pixel.blue, pixel.alpha};
                 });
  return picture;
}

}  // namespace nadir
