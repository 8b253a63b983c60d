// SPDX-License-Identifier: Apache-2.0
#include "core/sim/smooth_noise.h"

#include <cmath>
#include <numbers>

#include "core/base/random.h"
#include "core/base/require.h"

namespace nadir {
namespace {

constexpr unsigned kSize = 256;
constexpr unsigned kMask = kSize - 1U;

double fade(double t) { return t * t * (3.0 - 2.0 * t); }

}  // namespace

SmoothNoise::SmoothNoise(std::uint64_t seed, std::uint32_t stream) : lattice_(kSize * kSize) {
  // The lattice takes a `step` that frames, which count from 0, never reach.
  constexpr std::uint32_t kLatticeStep = 0xFFFFFFFFU;
  for (std::uint32_t i = 0; i < kSize * kSize; i += 2) {
    const auto [first, second] = standard_normals({seed, stream, kLatticeStep, i, 0});
    lattice_[i] = static_cast<float>(first);
    lattice_[i + 1U] = static_cast<float>(second);
  }
}

double SmoothNoise::at(double x, double y) const {
  const double x_floor = std::floor(x);
  const double y_floor = std::floor(y);
  const auto column = static_cast<unsigned>(static_cast<std::int64_t>(x_floor)) & kMask;
  const auto row = static_cast<unsigned>(static_cast<std::int64_t>(y_floor)) & kMask;
  const float* upper = lattice_.data() + static_cast<std::size_t>(row) * kSize;
  const float* lower = lattice_.data() + static_cast<std::size_t>((row + 1U) & kMask) * kSize;
  const unsigned next = (column + 1U) & kMask;
  const double right = fade(x - x_floor);
  const double down = fade(y - y_floor);
  const double left = 1.0 - right;
  const double up = 1.0 - down;
  const double sum =
      up * (left * static_cast<double>(upper[column]) + right * static_cast<double>(upper[next])) +
      down * (left * static_cast<double>(lower[column]) + right * static_cast<double>(lower[next]));
  return sum / std::sqrt((left * left + right * right) * (up * up + down * down));
}

double normal_share_below(double value) { return 0.5 * std::erfc(-value / std::numbers::sqrt2); }

double normal_quantile(double share) {
  NADIR_REQUIRE(share > 0.0 && share < 1.0);
  double low = -40.0;
  double high = 40.0;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (normal_share_below(middle) < share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace nadir
