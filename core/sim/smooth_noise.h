// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace nadir {

/// A smooth random field over the plane with lattice spacing 1. At every point its value over all
/// seeds is exactly N(0, 1): four lattice values are blended with weights whose squares sum to 1.
/// Repeats every 256.
class SmoothNoise {
 public:
  SmoothNoise(std::uint64_t seed, std::uint32_t stream);

  [[nodiscard]] double at(double x, double y) const;

 private:
  std::vector<float> lattice_;
};

/// Share of N(0, 1) below `value`.
[[nodiscard]] double normal_share_below(double value);
/// The value that a share of N(0, 1) is below; share in (0, 1). Accurate to 1e-9.
[[nodiscard]] double normal_quantile(double share);

}  // namespace nadir
