// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "widgets/canvas/canvas.h"

namespace nadir {

/// Where goldens are kept, and what is done where a picture differs from its own.
struct GoldenPlaces {
  std::filesystem::path goldens;    ///< NAME.png each.
  std::filesystem::path leftovers;  ///< Of failures: NAME-actual, -expected and -difference.png.
  bool rewrites = false;            ///< Take what was drawn as the golden from now on.
};

/// tests/golden, golden in the build tree, and rewriting where the environment has NADIR_UPDATE_GOLDEN=1.
[[nodiscard]] GoldenPlaces usual_golden_places();

/// Greatest structural distance at which a picture still counts as its golden.
inline constexpr double kGoldenTolerance = 0.02;

/// Adds a failure to the running test unless the picture has the pixels of its golden NAME.png, or its size and a structural
/// distance of at most kGoldenTolerance from it. A failure leaves its pictures and names them; success removes those that an
/// earlier failure left. A golden that is missing is a failure too, and leaves what was drawn.
/// @param name  Letters, digits and hyphens.
void expect_golden(const std::string& name, const Raster<Rgba>& actual);
void expect_golden(const std::string& name, const Raster<Rgba>& actual, const GoldenPlaces& places);

/// (1 - SSIM) / 2 in [0, 1], SSIM averaged over the image: Wang, Bovik, Sheikh and Simoncelli, "Image quality assessment: from
/// error visibility to structural similarity", IEEE Transactions on Image Processing 13 (2004), with its Gaussian window of
/// 11 x 11 pixels and sigma 1.5, K1 = 0.01, K2 = 0.03. Taken of the luma (ITU-R BT.601) on white paper and of the opacity; the
/// greater counts. Symmetric; 0 for equal pixels. Colours of one luma are equal to it, and what covers little of a page
/// moves the mean little. Both images have the same size and are not empty.
[[nodiscard]] double structural_distance(const Raster<Rgba>& a, const Raster<Rgba>& b);

/// Absolute difference of red, green and blue, eight times, at most 255; that of the opacity is added to all three. White
/// where only one image has a pixel.
[[nodiscard]] Raster<Rgba> amplified_difference(const Raster<Rgba>& a, const Raster<Rgba>& b);

}  // namespace nadir
