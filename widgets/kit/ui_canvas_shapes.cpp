// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "widgets/kit/ui_canvas.h"

namespace nadir::kit {
namespace {

/// An edge of an outline that is not level, from its lower end up.
struct Edge {
  Eigen::Vector2d low, high;
  [[nodiscard]] double x_at(double y) const {
    const double share = (y - low.y()) / (high.y() - low.y());
    return low.x() + std::clamp(share, 0.0, 1.0) * (high.x() - low.x());
  }
};

void add_trapezoid(const Edge& left,
                   const Edge& right,
                   double bottom,
                   double top,
                   std::vector<Eigen::Vector2d>& triangles) {
  const Eigen::Vector2d a(left.x_at(bottom), bottom);
  const Eigen::Vector2d b(right.x_at(bottom), bottom);
  const Eigen::Vector2d c(right.x_at(top), top);
  const Eigen::Vector2d d(left.x_at(top), top);
  if (b.x() > a.x()) triangles.insert(triangles.end(), {a, b, c});
  if (c.x() > d.x()) triangles.insert(triangles.end(), {a, c, d});
}

/// Heights within (bottom, top) at which edges that are neighbours somewhere cross.
std::vector<double> crossings(const std::vector<const Edge*>& edges, double bottom, double top) {
  std::vector<double> heights;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      const double before = edges[j]->x_at(bottom) - edges[i]->x_at(bottom);
      const double after = edges[j]->x_at(top) - edges[i]->x_at(top);
      if (before * after < 0.0)
        heights.push_back(bottom + (top - bottom) * before / (before - after));
    }
  }
  std::sort(heights.begin(), heights.end());
  return heights;
}

void add_slab(const std::vector<const Edge*>& edges,
              double bottom,
              double top,
              std::vector<Eigen::Vector2d>& triangles) {
  std::vector<const Edge*> sorted = edges;
  const double middle = (bottom + top) / 2.0;
  std::sort(sorted.begin(), sorted.end(),
            [middle](const Edge* a, const Edge* b) { return a->x_at(middle) < b->x_at(middle); });
  for (std::size_t i = 0; i + 1 < sorted.size(); i += 2)
    add_trapezoid(*sorted[i], *sorted[i + 1], bottom, top, triangles);
}

}  // namespace

std::vector<Eigen::Vector2d> triangles_inside(std::span<const Eigen::Vector2d> outline) {
  std::vector<Eigen::Vector2d> corners;
  for (const Eigen::Vector2d& point : outline) {
    if (point.allFinite()) corners.push_back(point);
  }
  std::vector<Edge> edges;
  std::vector<double> heights;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d& from = corners[i];
    const Eigen::Vector2d& to = corners[(i + 1) % corners.size()];
    heights.push_back(from.y());
    if (from.y() < to.y()) edges.push_back(Edge{from, to});
    if (from.y() > to.y()) edges.push_back(Edge{to, from});
  }
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return a.low.y() < b.low.y(); });
  std::vector<Eigen::Vector2d> triangles;
  std::vector<const Edge*> crossing;  // of the slab
  std::size_t next = 0;
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    const double bottom = heights[i];
    const double top = heights[i + 1];
    std::erase_if(crossing, [bottom](const Edge* edge) { return edge->high.y() <= bottom; });
    for (; next < edges.size() && edges[next].low.y() <= bottom; ++next)
      crossing.push_back(&edges[next]);
    double from = bottom;
    for (const double height : crossings(crossing, bottom, top)) {
      add_slab(crossing, from, height, triangles);
      from = height;
    }
    add_slab(crossing, from, top, triangles);
  }
  return triangles;
}

std::vector<std::vector<Eigen::Vector2d>> dashed(std::span<const Eigen::Vector2d> line,
                                                 std::span<const double> dashes,
                                                 double begin) {
  std::vector<double> pattern(dashes.begin(), dashes.end());
  if (pattern.size() % 2 == 1) pattern.insert(pattern.end(), dashes.begin(), dashes.end());
  double period = 0.0;
  for (const double length : pattern) period += length;
  if (!(period > 0.0) || line.size() < 2)
    return {std::vector<Eigen::Vector2d>(line.begin(), line.end())};
  std::size_t part = 0;
  double left = std::fmod(begin, period);
  while (left >= pattern[part]) {
    left -= pattern[part];
    part = (part + 1) % pattern.size();
  }
  left = pattern[part] - left;  // of this dash or gap
  std::vector<std::vector<Eigen::Vector2d>> pieces;
  if (part % 2 == 0) pieces.push_back({line[0]});
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double length = (line[i + 1] - line[i]).norm();
    double done = 0.0;
    while (length - done > left) {
      done += left;
      const Eigen::Vector2d at = line[i] + (line[i + 1] - line[i]) * (done / length);
      if (part % 2 == 0) pieces.back().push_back(at);
      do {
        part = (part + 1) % pattern.size();
        left = pattern[part];
        if (part % 2 == 0) pieces.push_back({at});
      } while (left <= 0.0);
    }
    left -= length - done;
    if (part % 2 == 0) pieces.back().push_back(line[i + 1]);
  }
  std::erase_if(pieces, [](const auto& piece) { return piece.size() < 2; });
  return pieces;
}

}  // namespace nadir::kit
