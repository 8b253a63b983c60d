// SPDX-License-Identifier: Apache-2.0
#include "core/base/random.h"

#include <cmath>
#include <numbers>

namespace nadir {
namespace {

struct WordPair {
  std::uint32_t high, low;
};

WordPair multiply(std::uint32_t a, std::uint32_t b) {
  const std::uint64_t product = static_cast<std::uint64_t>(a) * b;
  return {static_cast<std::uint32_t>(product >> 32U), static_cast<std::uint32_t>(product)};
}

std::uint64_t join(std::uint32_t high, std::uint32_t low) {
  return (static_cast<std::uint64_t>(high) << 32U) | low;
}

}  // namespace

std::array<std::uint32_t, 4> random_words(const DrawId& id) {
  // The constants are those of the paper: two multipliers, and the golden ratio and sqrt(3) - 1 as
  // key increments.
  constexpr std::uint32_t kMultiplier0 = 0xD2511F53U;
  constexpr std::uint32_t kMultiplier1 = 0xCD9E8D57U;
  constexpr std::uint32_t kKeyStep0 = 0x9E3779B9U;
  constexpr std::uint32_t kKeyStep1 = 0xBB67AE85U;
  constexpr int kRounds = 10;

  std::array<std::uint32_t, 4> counter = {id.draw, id.particle, id.step, id.stream};
  auto key0 = static_cast<std::uint32_t>(id.seed);
  auto key1 = static_cast<std::uint32_t>(id.seed >> 32U);
  for (int round = 0; round < kRounds; ++round) {
    const WordPair product0 = multiply(kMultiplier0, counter[0]);
    const WordPair product1 = multiply(kMultiplier1, counter[2]);
    counter = {product1.high ^ counter[1] ^ key0, product1.low, product0.high ^ counter[3] ^ key1,
               product0.low};
    key0 += kKeyStep0;
    key1 += kKeyStep1;
  }
  return counter;
}

std::array<double, 2> uniforms(const DrawId& id) {
  constexpr double kUnit = 0x1.0p-53;
  const auto words = random_words(id);
  return {static_cast<double>(join(words[0], words[1]) >> 11U) * kUnit,
          static_cast<double>(join(words[2], words[3]) >> 11U) * kUnit};
}

std::array<double, 2> standard_normals(const DrawId& id) {
  const auto [first, second] = uniforms(id);
  const double radius = std::sqrt(-2.0 * std::log1p(-first));  // 1 - first is in (0, 1]
  const double angle_rad = 2.0 * std::numbers::pi * second;
  return {radius * std::cos(angle_rad), radius * std::sin(angle_rad)};
}

}  // namespace nadir
