// SPDX-License-Identifier: Apache-2.0
#include "core/map/class_planes.h"

#include <bit>
#include <numeric>

#include "core/base/parallel.h"

namespace nadir {

ClassPlane::ClassPlane(int width, int height)
    : width_(width),
      height_(height),
      words_per_row_(width / 64 + (width % 64 != 0 ? 1 : 0) + 1),
      words_(static_cast<std::size_t>(words_per_row_) * static_cast<std::size_t>(height)) {}

ClassPlane ClassPlane::of(const Raster<ClassId>& labels, ClassId id) {
  constexpr std::size_t kRowsPerChunk = 64;
  ClassPlane plane(labels.width(), labels.height());
  const auto length = static_cast<std::size_t>(plane.words_per_row_);
  parallel_for(static_cast<std::size_t>(labels.height()), kRowsPerChunk,
               [&](std::size_t begin, std::size_t end) {
                 for (std::size_t row = begin; row < end; ++row) {
                   const std::span<const ClassId> cells = labels.row(static_cast<int>(row));
                   std::uint64_t* words = plane.words_.data() + row * length;
                   for (std::size_t column = 0; column < cells.size(); ++column) {
                     const std::uint64_t bit = cells[column] == id ? 1U : 0U;
                     words[column / 64] |= bit << (column % 64);
                   }
                 }
               });
  return plane;
}

std::uint64_t ClassPlane::word_at(int column, int row) const {
  if (row < 0 || row >= height_ || column >= width_ || column <= -64) return 0;
  const std::span<const std::uint64_t> words = row_words(row);
  if (column < 0) return words[0] << -column;
  const auto word = static_cast<std::size_t>(column) / 64;
  const int shift = column % 64;
  if (shift == 0) return words[word];
  return words[word] >> shift | words[word + 1] << (64 - shift);
}

std::int64_t ClassPlane::count() const {
  return std::accumulate(
      words_.begin(), words_.end(), std::int64_t{0},
      [](std::int64_t sum, std::uint64_t word) { return sum + std::popcount(word); });
}

}  // namespace nadir
