// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/map/overhead_map_file.h"
#include "core/map/semantic_classes.h"
#include "widgets/canvas/canvas.h"

namespace nadir {

/// Rasters of the core as pictures, pixel by pixel.

/// Each class in its colour of the palette; clear where there is none.
[[nodiscard]] Raster<Rgba> class_picture(const Raster<ClassId>& labels);
/// The same colours, opaque.
[[nodiscard]] Raster<Rgba> colour_picture(const ColourRaster& colours);

}  // namespace nadir
