// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "widgets/canvas/canvas.h"

namespace nadir {

/// A PNG file of as few bytes as is easily had, for pictures that are kept with the sources: a palette where there are at
/// most 256 opaque colours, else the filters that PNG's specification recommends or none, whichever comes out smaller. The
/// same pixels give the same bytes. @param pixels  Not empty.
[[nodiscard]] std::string small_png(const Raster<Rgba>& pixels);

/// The same picture in few colours, so that it makes a small file: what covers a thousandth of it or more keeps its colour,
/// the rest (edges of letters, photographs) gets the nearest of five values in each channel. Opacity stays.
[[nodiscard]] Raster<Rgba> in_few_colours(Raster<Rgba> pixels);

}  // namespace nadir
