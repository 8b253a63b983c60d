// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/base/raster.h"

namespace nadir {

/// What a depth camera gets wrong (thesis 4.2).
struct DepthNoise {
  double inverse_depth_sigma =
      0.0;  ///< 1/m; Gaussian, added to 1 / depth, independent from pixel to pixel.
  double max_range_m = 20.0;  ///< Depths beyond it are "none", before and after the noise.
};

/// Depths as the camera measures them; 0 where there is none. The same seed and frame number give
/// the same depths.
[[nodiscard]] Raster<float> measure_depth(const Raster<float>& true_depth_m,
                                          const DepthNoise& noise,
                                          std::uint64_t seed,
                                          std::uint32_t frame_number);

}  // namespace nadir
