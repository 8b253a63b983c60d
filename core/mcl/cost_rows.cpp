// SPDX-License-Identifier: Apache-2.0
#include "core/mcl/cost_rows.h"

#include <algorithm>
#include <array>

#include "core/base/require.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace nadir::detail {
namespace {

/// So many costs of at most 255 fit into 16 bits.
constexpr std::size_t kMostIn16Bits = 256;

using Lanes16 = std::array<std::uint16_t, kRowLanes>;

void add_portable(const std::uint8_t* values, std::span<const std::uint32_t> index, Lanes16& sums) {
  Lanes16
      local{};  // Costs are bytes, which might be those of `sums`: that would keep it from registers.
  for (const std::uint32_t i : index) {
    const std::uint8_t* const costs = values + i;
    for (std::size_t k = 0; k < kRowLanes; ++k) {
      local[k] = static_cast<std::uint16_t>(local[k] + costs[k]);
    }
  }
  sums = local;
}

#if defined(__x86_64__)

__attribute__((target("avx2"))) void add_avx2(const std::uint8_t* values,
                                              std::span<const std::uint32_t> index,
                                              Lanes16& sums) {
  __m256i first = _mm256_setzero_si256();
  __m256i second = first;
  __m256i third = first;
  __m256i fourth = first;
  for (const std::uint32_t i : index) {
    const auto* const costs = reinterpret_cast<const __m128i*>(values + i);
    first = _mm256_add_epi16(first, _mm256_cvtepu8_epi16(_mm_loadu_si128(costs)));
    second = _mm256_add_epi16(second, _mm256_cvtepu8_epi16(_mm_loadu_si128(costs + 1)));
    third = _mm256_add_epi16(third, _mm256_cvtepu8_epi16(_mm_loadu_si128(costs + 2)));
    fourth = _mm256_add_epi16(fourth, _mm256_cvtepu8_epi16(_mm_loadu_si128(costs + 3)));
  }
  auto* const out = reinterpret_cast<__m256i*>(sums.data());
  _mm256_storeu_si256(out, first);
  _mm256_storeu_si256(out + 1, second);
  _mm256_storeu_si256(out + 2, third);
  _mm256_storeu_si256(out + 3, fourth);
}

__attribute__((target("avx512f,avx512bw"))) void add_avx512(const std::uint8_t* values,
                                                            std::span<const std::uint32_t> index,
                                                            Lanes16& sums) {
  __m512i first = _mm512_setzero_si512();
  __m512i second = first;
  for (const std::uint32_t i : index) {
    const auto* const costs = reinterpret_cast<const __m256i*>(values + i);
    first = _mm512_add_epi16(first, _mm512_cvtepu8_epi16(_mm256_loadu_si256(costs)));
    second = _mm512_add_epi16(second, _mm512_cvtepu8_epi16(_mm256_loadu_si256(costs + 1)));
  }
  _mm512_storeu_si512(sums.data(), first);
  _mm512_storeu_si512(sums.data() + kRowLanes / 2, second);
}

#endif

/// Sums of at most kMostIn16Bits costs.
void add(const std::uint8_t* values,
         std::span<const std::uint32_t> index,
         Lanes16& sums,
         InstructionSet set) {
#if defined(__x86_64__)
  if (set == InstructionSet::kAvx512) return add_avx512(values, index, sums);
  if (set == InstructionSet::kAvx2) return add_avx2(values, index, sums);
#endif
  add_portable(values, index, sums);
}

}  // namespace

double CostWindow::bytes(double columns, double rows, int step_cells) {
  return (columns / step_cells + 1.0) * step_cells * rows;
}

CostWindow::CostWindow(
    const CostRaster& raster, const RasterPlace& corner, int columns, int rows, int step_cells)
    : corner_(corner),
      step_(static_cast<std::size_t>(step_cells)),
      phase_size_((static_cast<std::size_t>(columns) + step_ - 1) / step_),
      row_size_(step_ * phase_size_),
      values_(row_size_ * static_cast<std::size_t>(rows) + kRowLanes) {
  NADIR_REQUIRE(columns > 0 && rows > 0 && step_cells > 0);
  const auto stride = static_cast<std::size_t>(raster.stride());
  for (int row = 0; row < rows; ++row) {
    const int inside_row = std::clamp(corner.row + row, 0, raster.height + 1);
    const std::uint8_t* const from =
        raster.values.data() + static_cast<std::size_t>(inside_row) * stride;
    std::uint8_t* const to = values_.data() + static_cast<std::size_t>(row) * row_size_;
    std::size_t phase = 0;
    std::size_t along = 0;
    for (int column = 0; column < columns; ++column) {
      to[phase * phase_size_ + along] =
          from[std::clamp(corner.column + column, 0, raster.width + 1)];
      if (++phase == step_) {
        phase = 0;
        ++along;
      }
    }
  }
}

std::size_t CostWindow::index_of(const RasterPlace& place) const {
  const auto column = static_cast<std::size_t>(place.column - corner_.column);
  const auto row = static_cast<std::size_t>(place.row - corner_.row);
  return row * row_size_ + column % step_ * phase_size_ + column / step_;
}

void sum_rows(const std::uint8_t* values,
              std::span<const std::uint32_t> index,
              std::uint32_t* sums,
              InstructionSet set) {
  std::fill_n(sums, kRowLanes, 0U);
  while (!index.empty()) {
    const std::size_t count = std::min(index.size(), kMostIn16Bits);
    Lanes16 part{};
    add(values, index.first(count), part, set);
    for (std::size_t k = 0; k < kRowLanes; ++k) sums[k] += part[k];
    index = index.subspan(count);
  }
}

}  // namespace nadir::detail
