// SPDX-License-Identifier: Apache-2.0
#include "widgets/canvas/vtk_image.h"

#include <vtkImageData.h>

#include <cstring>

#include "core/base/require.h"

namespace nadir {

std::array<int, 3> image_size(vtkImageData& image) {
  std::array<int, 3> size{};
  image.GetDimensions(size.data());
  return size;
}

Raster<Rgba> raster_of(vtkImageData& image) {
  const auto [width, height, slices] = image_size(image);
  const int components = image.GetNumberOfScalarComponents();
  NADIR_REQUIRE(slices == 1 && image.GetScalarType() == VTK_UNSIGNED_CHAR);
  Raster<Rgba> pixels(width, height);
  const auto* bytes = static_cast<const unsigned char*>(image.GetScalarPointer());
  for (int row = height - 1; row >= 0; --row) {
    for (Rgba& pixel : pixels.row(row)) {
      const bool is_grey = components < 3;
      pixel = {bytes[0], is_grey ? bytes[0] : bytes[1], is_grey ? bytes[0] : bytes[2],
               components == 4 ? bytes[3] : static_cast<unsigned char>(255)};
      bytes += components;
    }
  }
  return pixels;
}

vtkSmartPointer<vtkImageData> vtk_image_of(const Raster<Rgba>& pixels) {
  static_assert(sizeof(Rgba) == 4);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(pixels.width(), pixels.height(), 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int row = pixels.height() - 1; row >= 0; --row) {
    const auto line = pixels.row(row);
    std::memcpy(bytes, line.data(), line.size_bytes());
    bytes += line.size_bytes();
  }
  return image;
}

}  // namespace nadir
