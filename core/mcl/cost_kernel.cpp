// SPDX-License-Identifier: Apache-2.0
#include "core/mcl/cost_kernel.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/require.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace nadir {
namespace {

constexpr double kFactorOne = 16384.0;  // 2^14
// A body that lies just out of reach, plus what its cells may add, still fits into 31 bits.
static_assert((kMaxMapSide + 2LL * (kMaxReachCells + 2)) << kFractionBits <= 1LL << 31U);
constexpr double kReachCells = kMaxReachCells + 1.0;

std::uint32_t sum_portable(const CostRaster& raster,
                           std::span<const HalfCell> cells,
                           const FixedPose& pose) {
  const int stride = raster.stride();
  std::uint32_t sum = 0;
  for (const HalfCell& cell : cells) {
    const auto [column, row] = place_of(cell, pose);
    const int inside_column = std::clamp(column, 0, raster.width + 1);
    const int inside_row = std::clamp(row, 0, raster.height + 1);
    sum += raster.values[static_cast<std::size_t>(inside_row) * static_cast<std::size_t>(stride) +
                         static_cast<std::size_t>(inside_column)];
  }
  return sum;
}

#if defined(__x86_64__)

/// Two 16-bit factors in one lane, low half first, as madd multiplies them with (forward, left).
std::int32_t factor_pair(int forward, int left) {
  return static_cast<std::int32_t>((static_cast<std::uint32_t>(left) << 16U) |
                                   (static_cast<std::uint32_t>(forward) & 0xFFFFU));
}

__attribute__((target("avx2"))) std::uint32_t sum_avx2(const CostRaster& raster,
                                                       std::span<const HalfCell> cells,
                                                       const FixedPose& pose) {
  constexpr std::size_t kLanes = 8;
  const __m256i column_factors = _mm256_set1_epi32(factor_pair(pose.cos, -pose.sin));
  const __m256i row_factors = _mm256_set1_epi32(factor_pair(-pose.sin, -pose.cos));
  const __m256i base_column = _mm256_set1_epi32(pose.base_column);
  const __m256i base_row = _mm256_set1_epi32(pose.base_row);
  const __m256i last_column = _mm256_set1_epi32(raster.width + 1);
  const __m256i last_row = _mm256_set1_epi32(raster.height + 1);
  const __m256i stride = _mm256_set1_epi32(raster.stride());
  const __m256i low_byte = _mm256_set1_epi32(0xFF);
  const __m256i zero = _mm256_setzero_si256();
  __m256i sums = zero;
  std::size_t i = 0;
  for (; i + kLanes <= cells.size(); i += kLanes) {
    const __m256i cell = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(cells.data() + i));
    __m256i column = _mm256_add_epi32(base_column, _mm256_madd_epi16(cell, column_factors));
    __m256i row = _mm256_add_epi32(base_row, _mm256_madd_epi16(cell, row_factors));
    column = _mm256_srai_epi32(column, kFractionBits);
    row = _mm256_srai_epi32(row, kFractionBits);
    column = _mm256_max_epi32(zero, _mm256_min_epi32(column, last_column));
    row = _mm256_max_epi32(zero, _mm256_min_epi32(row, last_row));
    const __m256i index = _mm256_add_epi32(_mm256_mullo_epi32(row, stride), column);
    const __m256i found =
        _mm256_i32gather_epi32(reinterpret_cast<const int*>(raster.values.data()), index, 1);
    sums = _mm256_add_epi32(sums, _mm256_and_si256(found, low_byte));
  }
  alignas(32) std::uint32_t lanes[kLanes];
  _mm256_store_si256(reinterpret_cast<__m256i*>(lanes), sums);
  std::uint32_t sum = sum_portable(raster, cells.subspan(i), pose);
  for (const std::uint32_t lane : lanes) sum += lane;
  return sum;
}

__attribute__((target("avx512f,avx512bw"))) std::uint32_t sum_avx512(
    const CostRaster& raster, std::span<const HalfCell> cells, const FixedPose& pose) {
  constexpr std::size_t kLanes = 16;
  const __m512i column_factors = _mm512_set1_epi32(factor_pair(pose.cos, -pose.sin));
  const __m512i row_factors = _mm512_set1_epi32(factor_pair(-pose.sin, -pose.cos));
  const __m512i base_column = _mm512_set1_epi32(pose.base_column);
  const __m512i base_row = _mm512_set1_epi32(pose.base_row);
  const __m512i last_column = _mm512_set1_epi32(raster.width + 1);
  const __m512i last_row = _mm512_set1_epi32(raster.height + 1);
  const __m512i stride = _mm512_set1_epi32(raster.stride());
  const __m512i low_byte = _mm512_set1_epi32(0xFF);
  const __m512i zero = _mm512_setzero_si512();
  __m512i sums = zero;
  for (std::size_t i = 0; i < cells.size(); i += kLanes) {
    const std::size_t left = std::min(kLanes, cells.size() - i);
    const auto mask = static_cast<__mmask16>((1U << left) - 1U);
    const __m512i cell = _mm512_maskz_loadu_epi32(mask, cells.data() + i);
    __m512i column = _mm512_add_epi32(base_column, _mm512_madd_epi16(cell, column_factors));
    __m512i row = _mm512_add_epi32(base_row, _mm512_madd_epi16(cell, row_factors));
    column = _mm512_srai_epi32(column, kFractionBits);
    row = _mm512_srai_epi32(row, kFractionBits);
    column = _mm512_max_epi32(zero, _mm512_min_epi32(column, last_column));
    row = _mm512_max_epi32(zero, _mm512_min_epi32(row, last_row));
    const __m512i index = _mm512_add_epi32(_mm512_mullo_epi32(row, stride), column);
    const __m512i found = _mm512_mask_i32gather_epi32(zero, mask, index, raster.values.data(), 1);
    sums = _mm512_add_epi32(sums, _mm512_and_si512(found, low_byte));
  }
  return static_cast<std::uint32_t>(_mm512_reduce_add_epi32(sums));
}

#endif

}  // namespace

FixedPose fixed_pose(const Rigid2& enu_from_body, const OverheadMap& map) {
  NADIR_REQUIRE(map.labels.width() <= kMaxMapSide && map.labels.height() <= kMaxMapSide);
  if (!std::isfinite(enu_from_body.yaw_rad)) {
    constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
    return fixed_pose({kNowhere, kNowhere, 0.0}, map);
  }
  const Eigen::Vector2d body_in_overhead = map.overhead_from_enu(enu_from_body.translation_m());
  // The border of one cell moves everything by one; NaN is sent off the map.
  const auto to_fixed = [](double cells, int side) {
    const double near =
        std::isnan(cells) ? -kReachCells : std::clamp(cells, -kReachCells, side + kReachCells);
    return static_cast<std::int32_t>(std::lround((near + 1.0) * (1 << kFractionBits)));
  };
  return {to_fixed(body_in_overhead.x(), map.labels.width()),
          to_fixed(body_in_overhead.y(), map.labels.height()),
          static_cast<std::int16_t>(std::lround(std::cos(enu_from_body.yaw_rad) * kFactorOne)),
          static_cast<std::int16_t>(std::lround(std::sin(enu_from_body.yaw_rad) * kFactorOne))};
}

bool is_available(InstructionSet set) {
#if defined(__x86_64__)
  switch (set) {
    case InstructionSet::kAvx512:
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw");
    case InstructionSet::kAvx2:
      return __builtin_cpu_supports("avx2");
    case InstructionSet::kPortable:
      return true;
  }
#endif
  return set == InstructionSet::kPortable;
}

InstructionSet best_instruction_set() {
  // Gathers set the pace, and wider ones are no faster on the machines measured (tests/benchmarks/REPORT.md).
  for (const InstructionSet set : {InstructionSet::kAvx2, InstructionSet::kAvx512}) {
    if (is_available(set)) return set;
  }
  return InstructionSet::kPortable;
}

std::uint32_t sum_costs(const CostRaster& raster,
                        std::span<const HalfCell> cells,
                        const FixedPose& pose,
                        InstructionSet set) {
#if defined(__x86_64__)
  if (set == InstructionSet::kAvx512) return sum_avx512(raster, cells, pose);
  if (set == InstructionSet::kAvx2) return sum_avx2(raster, cells, pose);
#endif
  return sum_portable(raster, cells, pose);
}

}  // namespace nadir
