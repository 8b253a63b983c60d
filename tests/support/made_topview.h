// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "core/topview/semantic_topview.h"

namespace nadir {

/// A topview of exactly these cells.
[[nodiscard]] inline SemanticTopview topview_of(std::vector<std::pair<TopviewCell, ClassId>> cells,
                                                double metres_per_cell) {
  std::sort(cells.begin(), cells.end(), [](const auto& a, const auto& b) {
    return std::tuple(a.second, a.first.forward, a.first.left) <
           std::tuple(b.second, b.first.forward, b.first.left);
  });
  SemanticTopview topview;
  topview.metres_per_cell = metres_per_cell;
  for (const auto& [cell, id] : cells) {
    topview.cells.push_back(cell);
    for (std::size_t later = id + std::size_t{1}; later < topview.class_begin.size(); ++later) {
      ++topview.class_begin[later];
    }
  }
  return topview;
}

/// A topview whose cells reach up to `reach` cells to every side of the body: about one in two is
/// seen, as one of the first `classes` classes that an overhead can hold.
[[nodiscard]] inline SemanticTopview random_topview(std::uint64_t seed,
                                                    int reach,
                                                    int classes,
                                                    double metres_per_cell) {
  std::vector<std::pair<TopviewCell, ClassId>> cells;
  std::uint32_t number = 0;
  for (int forward = -reach; forward < reach; ++forward) {
    for (int left = -reach; left < reach; ++left) {
      const auto words = random_words({.seed = seed, .particle = number++});
      if (words[0] % 2 == 0) continue;
      const auto id = static_cast<ClassId>(words[1] % static_cast<std::uint32_t>(classes));
      if (!can_lie_in_overhead(id)) continue;
      cells.push_back({{static_cast<std::int16_t>(forward), static_cast<std::int16_t>(left)}, id});
    }
  }
  return topview_of(std::move(cells), metres_per_cell);
}

}  // namespace nadir
