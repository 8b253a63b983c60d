// SPDX-License-Identifier: Apache-2.0
#include "core/quality/cell_regions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/require.h"

namespace nadir {
namespace {

using Sides = std::vector<std::pair<CellValue, std::int64_t>>;

void add_sides(Sides& sides, CellValue other, std::int64_t count) {
  const auto found = std::find_if(sides.begin(), sides.end(),
                                  [other](const auto& side) { return side.first == other; });
  if (found != sides.end()) {
    found->second += count;
  } else {
    sides.emplace_back(other, count);
  }
}

}  // namespace

std::int64_t RegionOfCells::sides_with(CellValue other) const {
  for (const auto& [id, count] : sides) {
    if (id == other) return count;
  }
  return 0;
}

std::int64_t RegionOfCells::all_sides() const {
  std::int64_t all = 0;
  for (const auto& [id, count] : sides) all += count;
  return all;
}

double RegionOfCells::border_length() const {
  const auto all = static_cast<double>(all_sides());
  const auto upright = static_cast<double>(upright_sides);
  return std::max(std::hypot(upright, all - upright), all * std::numbers::pi / 4.0);
}

double RegionOfCells::mean_width() const {
  return 2.0 * static_cast<double>(cells) / border_length();
}

RegionFinder::RegionFinder(const CellRect& window,
                           const CellRect& asked_for,
                           std::function<bool(CellValue)> joins_corners)
    : window_(window),
      asked_for_(asked_for),
      joins_corners_(std::move(joins_corners)),
      next_row_(window.top) {}

std::size_t RegionFinder::root(std::size_t node) {
  while (nodes_[node].parent != node) {
    nodes_[node].parent = nodes_[nodes_[node].parent].parent;
    node = nodes_[node].parent;
  }
  return node;
}

std::size_t RegionFinder::begin_region(CellValue value) {
  Node node;
  node.region.value = value;
  node.parent = nodes_.size();
  nodes_.push_back(std::move(node));
  return nodes_.size() - 1;
}

std::size_t RegionFinder::join(std::size_t a, std::size_t b) {
  a = root(a);
  b = root(b);
  if (a == b) return a;
  if (b < a) std::swap(a, b);
  Node& kept = nodes_[a];
  Node& gone = nodes_[b];
  RegionOfCells& region = kept.region;
  region.cells += gone.region.cells;
  region.bounds = region.bounds.joined(gone.region.bounds);
  region.is_touched = region.is_touched || gone.region.is_touched;
  for (const auto& [other, count] : gone.region.sides) add_sides(region.sides, other, count);
  region.upright_sides += gone.region.upright_sides;
  const bool is_earlier = gone.region.row < region.row ||
                          (gone.region.row == region.row && gone.region.column < region.column);
  if (gone.longest > kept.longest || (gone.longest == kept.longest && is_earlier)) {
    kept.longest = gone.longest;
    region.column = gone.region.column;
    region.row = gone.region.row;
  }
  gone.region.sides = {};
  gone.parent = a;
  return a;
}

void RegionFinder::add_run(const Run& run) {
  Node& node = nodes_[root(run.region)];
  RegionOfCells& region = node.region;
  const CellRect cells{run.from, next_row_, run.to, next_row_ + 1};
  region.cells += cells.width();
  region.bounds = region.bounds.joined(cells);
  region.is_touched = region.is_touched || !cells.cut_to(asked_for_).empty();
  if (cells.width() > node.longest) {
    node.longest = cells.width();
    region.column = run.from + cells.width() / 2;
    region.row = next_row_;
  }
}

void RegionFinder::join_with_above() {
  std::size_t first = 0;
  for (Run& run : row_) {
    bool has_region = false;
    const std::int64_t reach = joins_corners_(run.value) ? 1 : 0;
    while (first < above_.size() && above_[first].to < run.from) ++first;
    for (std::size_t i = first; i < above_.size() && above_[i].from < run.to + reach; ++i) {
      if (above_[i].value != run.value || above_[i].to <= run.from - reach) continue;
      run.region = has_region ? join(run.region, above_[i].region) : root(above_[i].region);
      has_region = true;
    }
    if (!has_region) run.region = begin_region(run.value);
  }
}

void RegionFinder::count_sides_with_above() {
  const auto count = [this](const Run& run, CellValue other, std::int64_t sides) {
    add_sides(nodes_[root(run.region)].region.sides, other, sides);
  };
  if (above_.empty()) {
    for (const Run& run : row_) count(run, kBesideWindow, run.to - run.from);
    return;
  }
  for (std::size_t i = 0, j = 0; i < above_.size() && j < row_.size();) {
    const Run& upper = above_[i];
    const Run& lower = row_[j];
    const std::int64_t common = std::min(upper.to, lower.to) - std::max(upper.from, lower.from);
    if (common > 0 && upper.value != lower.value) {
      count(upper, lower.value, common);
      count(lower, upper.value, common);
    }
    const bool ends_upper = upper.to <= lower.to;
    const bool ends_lower = lower.to <= upper.to;
    i += ends_upper ? 1 : 0;
    j += ends_lower ? 1 : 0;
  }
}

void RegionFinder::take_row() {
  NADIR_REQUIRE(next_row_ < window_.bottom);
  join_with_above();
  for (std::size_t i = 0; i < row_.size(); ++i) {
    add_run(row_[i]);
    RegionOfCells& region = nodes_[root(row_[i].region)].region;
    add_sides(region.sides, i > 0 ? row_[i - 1].value : kBesideWindow, 1);
    add_sides(region.sides, i + 1 < row_.size() ? row_[i + 1].value : kBesideWindow, 1);
    region.upright_sides += 2;
  }
  count_sides_with_above();
  above_.swap(row_);
  ++next_row_;
}

std::vector<RegionOfCells> RegionFinder::finish() {
  for (const Run& run : above_) {
    add_sides(nodes_[root(run.region)].region.sides, kBesideWindow, run.to - run.from);
  }
  std::vector<RegionOfCells> regions;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].parent == i) regions.push_back(std::move(nodes_[i].region));
  }
  nodes_.clear();
  above_.clear();
  return regions;
}

std::vector<CellRect> rows_of_region(std::span<const std::uint8_t> values,
                                     const CellRect& window,
                                     std::int64_t column,
                                     std::int64_t row,
                                     bool joins_corners) {
  const auto index = [&](std::int64_t x, std::int64_t y) {
    return static_cast<std::size_t>((y - window.top) * window.width() + (x - window.left));
  };
  const std::uint8_t wanted = values[index(column, row)];
  std::vector<bool> is_in(values.size(), false);
  std::vector<std::pair<std::int64_t, std::int64_t>> waiting{{column, row}};
  is_in[index(column, row)] = true;
  while (!waiting.empty()) {
    const auto [x, y] = waiting.back();
    waiting.pop_back();
    for (int side = 0; side < 9; ++side) {
      const std::int64_t across = side % 3 - 1;
      const std::int64_t down = side / 3 - 1;
      if (!joins_corners && across != 0 && down != 0) continue;
      const CellRect cell{x + across, y + down, x + across + 1, y + down + 1};
      if (cell.cut_to(window).empty()) continue;
      const std::size_t at = index(cell.left, cell.top);
      if (is_in[at] || values[at] != wanted) continue;
      is_in[at] = true;
      waiting.emplace_back(cell.left, cell.top);
    }
  }
  std::vector<CellRect> rows;
  for (std::int64_t y = window.top; y < window.bottom; ++y) {
    for (std::int64_t x = window.left; x < window.right; ++x) {
      if (!is_in[index(x, y)]) continue;
      const std::int64_t from = x;
      while (x + 1 < window.right && is_in[index(x + 1, y)]) ++x;
      rows.push_back({from, y, x + 1, y + 1});
    }
  }
  return rows;
}

}  // namespace nadir
