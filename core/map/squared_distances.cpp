// SPDX-License-Identifier: Apache-2.0
#include "core/map/squared_distances.h"

#include <algorithm>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/require.h"

namespace nadir {
namespace {

using ColumnDistances = Raster<std::uint16_t>;

/// Distance to the nearest target of the same column, at most `cap`. One sweep down and one up, a
/// strip of columns a thread.
ColumnDistances column_distances(const Raster<ClassId>& labels, const IdSet& targets, int cap) {
  constexpr std::size_t kColumnsPerChunk = 256;
  ColumnDistances distances(labels.width(), labels.height());
  const auto cap_cells = static_cast<std::uint16_t>(cap);
  const auto one_more = [cap_cells](std::uint16_t distance) {
    return std::min<std::uint16_t>(
        cap_cells, static_cast<std::uint16_t>(distance + (distance < cap_cells ? 1 : 0)));
  };
  parallel_for(static_cast<std::size_t>(labels.width()), kColumnsPerChunk,
               [&](std::size_t begin, std::size_t end) {
                 const auto first = static_cast<int>(begin);
                 const auto last = static_cast<int>(end);
                 for (int row = 0; row < labels.height(); ++row) {
                   for (int column = first; column < last; ++column) {
                     std::uint16_t& distance = distances.at(column, row);
                     if (targets[labels.at(column, row)]) {
                       distance = 0;
                     } else {
                       distance = row == 0 ? cap_cells : one_more(distances.at(column, row - 1));
                     }
                   }
                 }
                 for (int row = labels.height() - 2; row >= 0; --row) {
                   for (int column = first; column < last; ++column) {
                     std::uint16_t& distance = distances.at(column, row);
                     distance = std::min(distance, one_more(distances.at(column, row + 1)));
                   }
                 }
               });
  return distances;
}

/// Lower envelope of the parabolas (x - i)^2 + g(i)^2 of one row.
class RowEnvelope {
 public:
  explicit RowEnvelope(std::size_t width) : centres_(width), starts_(width), squared_(width) {}

  std::span<const std::int64_t> of(std::span<const std::uint16_t> g) {
    const auto width = static_cast<std::int64_t>(g.size());
    const auto height = [&](std::int64_t i) {
      const std::int64_t distance = g[static_cast<std::size_t>(i)];
      return distance * distance;
    };
    const auto value = [&](std::int64_t x, std::int64_t i) {
      return (x - i) * (x - i) + height(i);
    };
    std::size_t top = 0;
    centres_[0] = 0;
    starts_[0] = 0;
    bool is_empty = false;
    for (std::int64_t u = 1; u < width; ++u) {
      while (!is_empty && value(starts_[top], centres_[top]) > value(starts_[top], u)) {
        if (top == 0) {
          is_empty = true;
        } else {
          --top;
        }
      }
      if (is_empty) {
        is_empty = false;
        centres_[0] = u;
        continue;
      }
      // First x at which u's parabola is below the last one's; the numerator is never negative
      // here.
      const std::int64_t i = centres_[top];
      const std::int64_t start = 1 + (u * u - i * i + height(u) - height(i)) / (2 * (u - i));
      if (start < width) {
        ++top;
        centres_[top] = u;
        starts_[top] = start;
      }
    }
    for (std::int64_t x = width - 1; x >= 0; --x) {
      squared_[static_cast<std::size_t>(x)] = value(x, centres_[top]);
      if (x == starts_[top] && top > 0) --top;
    }
    return squared_;
  }

 private:
  std::vector<std::int64_t> centres_, starts_, squared_;
};

}  // namespace

void visit_squared_distances(
    const Raster<ClassId>& labels,
    const IdSet& targets,
    int cap,
    const std::function<void(int row, std::span<const std::int64_t> squared)>& visit) {
  NADIR_REQUIRE(cap >= 1 && cap <= 65535);
  if (labels.empty()) return;
  constexpr std::size_t kRowsPerChunk = 16;
  const ColumnDistances columns = column_distances(labels, targets, cap);
  parallel_for(static_cast<std::size_t>(labels.height()), kRowsPerChunk,
               [&](std::size_t begin, std::size_t end) {
                 RowEnvelope envelope(static_cast<std::size_t>(labels.width()));
                 for (std::size_t row = begin; row < end; ++row) {
                   const auto index = static_cast<int>(row);
                   visit(index, envelope.of(columns.row(index)));
                 }
               });
}

}  // namespace nadir
