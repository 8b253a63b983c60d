// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkSmartPointer.h>

#include <array>

#include "widgets/canvas/canvas.h"

class vtkImageData;

namespace nadir {

/// Columns, rows, slices.
[[nodiscard]] std::array<int, 3> image_size(vtkImageData& image);

/// VTK counts rows from the bottom, we from the top. @param image  One slice of 8-bit grey, RGB or RGBA.
[[nodiscard]] Raster<Rgba> raster_of(vtkImageData& image);
/// RGBA with the bottom row first.
[[nodiscard]] vtkSmartPointer<vtkImageData> vtk_image_of(const Raster<Rgba>& pixels);

}  // namespace nadir
