// SPDX-License-Identifier: Apache-2.0
#include "core/assist/magic_wand.h"

#include <algorithm>
#include <vector>

namespace nadir {
namespace {

LabColour mean_around(const AssistWindow& window, const PixelPlace& at) {
  LabColour sum;
  int count = 0;
  for (int row = at.row - 1; row <= at.row + 1; ++row) {
    for (int column = at.column - 1; column <= at.column + 1; ++column) {
      if (!window.pixels().contains(column, row) || !window.is_seen(column, row)) continue;
      const LabColour& colour = window.colours().at(column, row);
      sum.lightness += colour.lightness;
      sum.a += colour.a;
      sum.b += colour.b;
      ++count;
    }
  }
  const auto by = static_cast<float>(count);
  return {sum.lightness / by, sum.a / by, sum.b / by};
}

}  // namespace

Result<PixelMask> magic_wand(const AssistWindow& window,
                             const Eigen::Vector2d& at_in_enu_m,
                             const WandOptions& options) {
  if (const auto valid = validate(options); !valid) return forward_error(valid);
  const auto start = window.seen_pixel_at(at_in_enu_m);
  if (!start) return forward_error(start);
  const LabColour wanted = mean_around(window, *start);
  const Raster<LabColour>& colours = window.colours();
  const auto tolerance = static_cast<float>(options.tolerance);
  const auto edge_stop = static_cast<float>(options.edge_stop);
  const bool by_corners = options.neighbours == PixelNeighbours::kEight;
  PixelMask found(window.width(), window.height());
  found.at(start->column, start->row) = 1;
  std::vector<PixelPlace> waiting{*start};
  while (!waiting.empty()) {
    const PixelPlace at = waiting.back();
    waiting.pop_back();
    for (int down = -1; down <= 1; ++down) {
      for (int right = -1; right <= 1; ++right) {
        if (!by_corners && down != 0 && right != 0) continue;
        const PixelPlace next{at.column + right, at.row + down};
        if (!found.contains(next.column, next.row) || found.at(next.column, next.row) != 0 ||
            !window.is_seen(next.column, next.row)) {
          continue;
        }
        const LabColour& colour = colours.at(next.column, next.row);
        const bool is_stopped = edge_stop > 0.0F && colour_difference(colours.at(at.column, at.row),
                                                                      colour) > edge_stop;
        if (is_stopped || !(colour_difference(colour, wanted) <= tolerance)) continue;
        found.at(next.column, next.row) = 1;
        waiting.push_back(next);
      }
    }
  }
  const double pixel_m2 = window.metres_per_pixel() * window.metres_per_pixel();
  const double hole = std::min(options.fill_holes_m2 / pixel_m2, static_cast<double>(found.size()));
  PixelMask filled = filled_holes(found, static_cast<int>(hole), options.neighbours);
  for (int row = 0; row < filled.height(); ++row) {
    for (int column = 0; column < filled.width(); ++column) {
      if (!window.is_seen(column, row)) filled.at(column, row) = 0;
    }
  }
  return filled;
}

}  // namespace nadir
