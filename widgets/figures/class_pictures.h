// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/map/overhead_map_file.h"
#include "core/map/semantic_classes.h"
#include "core/mcl/cell_agreement.h"
#include "core/topview/semantic_topview.h"
#include "widgets/views/theme.h"

namespace nadir {

/// Rasters of the core as pictures.

/// Each class in its colour of the palette; clear where there is none.
[[nodiscard]] Raster<Rgba> class_picture(const Raster<ClassId>& labels);
/// The same colours, opaque.
[[nodiscard]] Raster<Rgba> colour_picture(const ColourRaster& colours);
/// Cells of a topview that agree with the map and that do not, in the theme's two colours, on the topview's raster; what
/// the map does not know is grey.
[[nodiscard]] Raster<Rgba> agreement_picture(const SemanticTopview& seen,
                                             const CellAgreement& agreement,
                                             const TopviewRaster& raster,
                                             const Theme& theme);

/// The largest rectangle of a picture's shape inside of another, in its middle.
[[nodiscard]] PageRect fitted(double width, double height, const PageRect& inside);

}  // namespace nadir
