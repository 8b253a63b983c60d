// SPDX-License-Identifier: Apache-2.0
#include "core/geo/affine2.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <limits>

#include "tests/support/error_text.h"

namespace nadir {
namespace affine2_test {

using testing::ElementsAre;
using testing::HasSubstr;

/// Rotated by 30 degrees, pixels of 0.2 x 0.5 m, sheared a little, far from zero as UTM coordinates
/// are.
Affine2 rotated_image() {
  Affine2 plane_from_pixel;
  plane_from_pixel.linear = Eigen::Rotation2Dd(0.5).toRotationMatrix() *
                            Eigen::Vector2d(0.2, -0.5).asDiagonal().toDenseMatrix();
  plane_from_pixel.linear(0, 1) += 0.01;
  plane_from_pixel.offset = {458'074.604, 5'429'380.172};
  return plane_from_pixel;
}

TEST(Affine2, GdalsGeotransformIsTheCornerOfTheUpperLeftPixel) {
  const Affine2 plane_from_pixel = Affine2::from_gdal({1000.0, 0.5, 0.0, 2000.0, 0.0, -0.5});
  EXPECT_EQ(plane_from_pixel * Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(1000.0, 2000.0));
  EXPECT_EQ(plane_from_pixel * Eigen::Vector2d(0.5, 0.5), Eigen::Vector2d(1000.25, 1999.75));
  EXPECT_TRUE(plane_from_pixel.is_north_up());
}

TEST(Affine2, GdalsSixNumbersComeBackUnchanged) {
  const std::array<double, 6> numbers = {1.0, 2.0, 3.0, 4.0, 5.0, -6.0};
  EXPECT_EQ(Affine2::from_gdal(numbers).to_gdal(), numbers);
  // GDAL: x = GT0 + column GT1 + row GT2, y = GT3 + column GT4 + row GT5.
  EXPECT_EQ(Affine2::from_gdal(numbers) * Eigen::Vector2d(10.0, 100.0),
            Eigen::Vector2d(1.0 + 20.0 + 300.0, 4.0 + 50.0 - 600.0));
}

TEST(Affine2, TheInverseHoldsForRotatedAndShearedImages) {
  const Affine2 plane_from_pixel = rotated_image();
  const auto pixel_from_plane = plane_from_pixel.inverse();
  ASSERT_TRUE(pixel_from_plane) << error_text(pixel_from_plane);
  for (const Eigen::Vector2d& pixel :
       {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(2101.0, 0.0), Eigen::Vector2d(17.5, 2508.0)}) {
    const Eigen::Vector2d back = *pixel_from_plane * (plane_from_pixel * pixel);
    EXPECT_NEAR(back.x(), pixel.x(), 1e-7);
    EXPECT_NEAR(back.y(), pixel.y(), 1e-7);
  }
}

TEST(Affine2, PixelSizeIsTheLengthOfAColumnHoweverTheImageIsTurned) {
  Affine2 plane_from_pixel;
  plane_from_pixel.linear = Eigen::Rotation2Dd(1.2).toRotationMatrix() *
                            Eigen::Vector2d(0.3, -0.7).asDiagonal().toDenseMatrix();
  EXPECT_NEAR(plane_from_pixel.pixel_size().x(), 0.3, 1e-15);
  EXPECT_NEAR(plane_from_pixel.pixel_size().y(), 0.7, 1e-15);
  EXPECT_FALSE(plane_from_pixel.is_north_up());
}

TEST(Affine2, PixelsWithoutAreaHaveNoInverse) {
  Affine2 flat;
  flat.linear << 1.0, 2.0, 2.0, 4.0;
  EXPECT_EQ(error_code(flat.inverse()), ErrorCode::kMalformed);
  EXPECT_THAT(error_text(flat.inverse()), HasSubstr("singular"));
  flat.linear.setZero();
  EXPECT_THAT(error_text(flat.inverse()), HasSubstr("singular"));
  Affine2 not_a_number;
  not_a_number.offset.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(error_text(not_a_number.inverse()), HasSubstr("not finite"));
}

TEST(Affine2, PixelsOfDegreesAreSmallButNotSingular) {
  const Affine2 plane_from_pixel = Affine2::from_gdal({8.0, 1e-7, 0.0, 48.0, 0.0, -1e-7});
  const auto pixel_from_plane = plane_from_pixel.inverse();
  ASSERT_TRUE(pixel_from_plane) << error_text(pixel_from_plane);
  EXPECT_NEAR((*pixel_from_plane * Eigen::Vector2d(8.0001, 48.0)).x(), 1000.0, 1e-5);
}

TEST(Affine2, CoordinatesBeyond32BitsKeepTheirMetres) {
  const Affine2 plane_from_pixel = Affine2::from_gdal({5e9, 1.0, 0.0, -7e9, 0.0, -1.0});
  const auto pixel_from_plane = plane_from_pixel.inverse();
  ASSERT_TRUE(pixel_from_plane);
  EXPECT_EQ(*pixel_from_plane * Eigen::Vector2d(5e9 + 3.0, -7e9 - 4.0), Eigen::Vector2d(3.0, 4.0));
}

}  // namespace affine2_test
}  // namespace nadir
