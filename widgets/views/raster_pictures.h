// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/map/image_look.h"
#include "core/map/overhead_map_file.h"
#include "core/map/semantic_classes.h"
#include "widgets/canvas/canvas.h"

namespace nadir {

/// Rasters of the core as pictures, pixel by pixel.

/// Each class in its colour of the palette; clear where there is none.
[[nodiscard]] Raster<Rgba> class_picture(const Raster<ClassId>& labels);
/// The same colours, opaque.
[[nodiscard]] Raster<Rgba> colour_picture(const ColourRaster& colours);
/// The same colours, as clear as they are.
[[nodiscard]] Raster<Rgba> colour_picture(const ImageRaster& pixels);

}  // namespace nadir
