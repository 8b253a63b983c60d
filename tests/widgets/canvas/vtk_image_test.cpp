// SPDX-License-Identifier: Apache-2.0
#include "widgets/canvas/vtk_image.h"

#include <gmock/gmock.h>
#include <vtkImageData.h>
#include <vtkNew.h>

#include <stdexcept>

#include "tests/support/page_pixels.h"

namespace nadir {
namespace vtk_image_test {

Raster<Rgba> numbered(int width, int height) {
  Raster<Rgba> pixels(width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      pixels.at(column, row) = {static_cast<std::uint8_t>(column), static_cast<std::uint8_t>(row),
                                200, static_cast<std::uint8_t>(10 + column)};
    }
  }
  return pixels;
}

/// One slice whose bytes count up.
vtkSmartPointer<vtkImageData> counting(int width, int height, int components) {
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  auto* const bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < width * height * components; ++i) bytes[i] = static_cast<unsigned char>(i);
  return image;
}

TEST(VtkImage, ComesBackAsItWas) {
  const Raster<Rgba> pixels = numbered(5, 3);
  const auto image = vtk_image_of(pixels);
  EXPECT_EQ(image_size(*image), (std::array<int, 3>{5, 3, 1}));
  EXPECT_EQ(raster_of(*image), pixels);
}

TEST(VtkImage, CountsRowsFromTheBottom) {
  const Raster<Rgba> pixels = numbered(5, 3);
  const auto image = vtk_image_of(pixels);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) {
      const Rgba expected = pixels.at(x, 2 - y);
      EXPECT_EQ(image->GetScalarComponentAsDouble(x, y, 0, 0), expected.red);
      EXPECT_EQ(image->GetScalarComponentAsDouble(x, y, 0, 1), expected.green);
      EXPECT_EQ(image->GetScalarComponentAsDouble(x, y, 0, 3), expected.alpha);
    }
  }
}

TEST(VtkImage, ReadsGreyAndColourAsOpaque) {
  const auto grey = counting(2, 2, 1);
  EXPECT_EQ(raster_of(*grey).at(1, 0), (Rgba{3, 3, 3}));  // upper right: the last of all
  EXPECT_EQ(raster_of(*grey).at(0, 1), (Rgba{0, 0, 0}));
  const auto colour = counting(2, 2, 3);
  EXPECT_EQ(raster_of(*colour).at(1, 0), (Rgba{9, 10, 11}));
  const auto with_alpha = counting(2, 2, 4);
  EXPECT_EQ(raster_of(*with_alpha).at(0, 0), (Rgba{8, 9, 10, 11}));
}

TEST(VtkImage, RefusesWhatIsNotAPicture) {
  const vtkNew<vtkImageData> deep;
  deep->SetDimensions(2, 2, 2);
  deep->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  EXPECT_THROW((void)raster_of(*deep), std::logic_error);
  const vtkNew<vtkImageData> fine;
  fine->SetDimensions(2, 2, 1);
  fine->AllocateScalars(VTK_FLOAT, 1);
  EXPECT_THROW((void)raster_of(*fine), std::logic_error);
}

}  // namespace vtk_image_test
}  // namespace nadir
