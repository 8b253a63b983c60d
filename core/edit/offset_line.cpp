// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/edit/edge_tree.h"
#include "core/edit/polygon_algebra.h"

namespace nadir {
namespace {

/// What rounding to the lattice may take from a distance.
constexpr double kRoundingM = 4.0 * kLatticeM;

Eigen::Vector2d direction(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return (to - from).normalized();
}
Eigen::Vector2d left_of(const Eigen::Vector2d& along) { return {-along.y(), along.x()}; }

/// The corner of the offset line at a place where the line turns from one direction to another: at outer corners pieces of at
/// most a right angle that touch the circle around the place; at inner ones where both sides meet, or if they are too
/// short for that both of their ends, between which it goes back.
void add_corner(Ring& offset,
                const Eigen::Vector2d& place,
                const Eigen::Vector2d& before,
                const Eigen::Vector2d& after,
                double shorter_m,
                double by_m) {
  const double turn =
      std::atan2(before.x() * after.y() - before.y() * after.x(), before.dot(after));
  const bool is_outer = turn * by_m <= 0.0;
  const int pieces = is_outer ? std::max(1, static_cast<int>(std::ceil(
                                                std::abs(turn) / (std::numbers::pi / 2.0) - 1e-9)))
                              : 1;
  const double half = turn / (2.0 * pieces);
  if (!is_outer && std::abs(by_m * std::tan(half)) > shorter_m) {
    offset.push_back(on_lattice(place + by_m * left_of(before)));
    offset.push_back(on_lattice(place + by_m * left_of(after)));
    return;
  }
  for (int i = 0; i < pieces; ++i) {
    const double angle = (2 * i + 1) * half;
    const Eigen::Vector2d normal = left_of(before);
    const Eigen::Vector2d turned(std::cos(angle) * normal.x() - std::sin(angle) * normal.y(),
                                 std::sin(angle) * normal.x() + std::cos(angle) * normal.y());
    offset.push_back(on_lattice(place + turned * (by_m / std::cos(half))));
  }
}

/// All sides moved, joined at corners; where the line bends too sharply it crosses itself and lies too near.
Ring moved_sides(const Ring& line, double by_m) {
  const bool is_ring = line.size() > 3 && line.front() == line.back();
  const std::size_t sides = line.size() - 1;
  const auto along = [&](std::size_t side) { return direction(line[side], line[side + 1]); };
  const auto length = [&](std::size_t side) { return (line[side + 1] - line[side]).norm(); };
  Ring offset;
  if (!is_ring) offset.push_back(on_lattice(line.front() + by_m * left_of(along(0))));
  for (std::size_t i = is_ring ? 0 : 1; i < sides; ++i) {
    const std::size_t before = i > 0 ? i - 1 : sides - 1;
    add_corner(offset, line[i], along(before), along(i), std::min(length(before), length(i)), by_m);
  }
  if (is_ring) {
    offset.push_back(offset.front());
  } else {
    offset.push_back(on_lattice(line.back() + by_m * left_of(along(sides - 1))));
  }
  return without_repeats(std::move(offset), false);
}

/// The same line with a place wherever it meets itself.
Ring with_meetings(const Ring& line) {
  std::vector<std::vector<Eigen::Vector2d>> met(line.size());
  const std::vector<Ring> rings{line};
  const EdgeTree edges(rings, false);
  edges.visit_pairs([&](const EdgeTree::Edge& a, const EdgeTree::Edge& b) {
    if (const auto crossing = crossing_of_edges(a.from, a.to, b.from, b.to)) {
      met[a.place].push_back(on_lattice(*crossing));
      met[b.place].push_back(on_lattice(*crossing));
    }
    const auto touch = [&](const EdgeTree::Edge& edge, const Eigen::Vector2d& end) {
      if ((nearest_on_edge(edge.from, edge.to, end) - end).norm() <= kLatticeM)
        met[edge.place].push_back(end);
    };
    touch(a, b.from);
    touch(a, b.to);
    touch(b, a.from);
    touch(b, a.to);
    return true;
  });
  Ring all;
  for (std::size_t i = 0; i < line.size(); ++i) {
    std::sort(met[i].begin(), met[i].end(),
              [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
                return (a - line[i]).squaredNorm() < (b - line[i]).squaredNorm();
              });
    all.push_back(line[i]);
    all.insert(all.end(), met[i].begin(), met[i].end());
  }
  return without_repeats(std::move(all), false);
}

bool is_nearer_than(const Eigen::Vector2d& a,
                    const Eigen::Vector2d& b,
                    const EdgeTree& line,
                    double distance_m) {
  bool is_near = false;
  line.visit(box_around(a, b, distance_m), [&](const EdgeTree::Edge& edge) {
    if (is_near) return;
    const auto reaches = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                             const Eigen::Vector2d& place) {
      return (nearest_on_edge(from, to, place) - place).norm() < distance_m;
    };
    is_near = reaches(a, b, edge.from) || reaches(a, b, edge.to) ||
              reaches(edge.from, edge.to, a) || reaches(edge.from, edge.to, b) ||
              crossing_of_edges(a, b, edge.from, edge.to);
  });
  return is_near;
}

}  // namespace

Result<std::vector<Ring>> beside(const Ring& line, double to_the_left_m) {
  Ring places = line;
  for (Eigen::Vector2d& place : places) place = on_lattice(place);
  places = without_repeats(std::move(places), false);
  if (places.size() < 2) {
    return fail(ErrorCode::kInvalidOptions, "a line needs two different places");
  }
  if (std::abs(to_the_left_m) < kLatticeM) return std::vector<Ring>{places};
  const std::vector<Ring> rings{places};
  const auto crossings = count_crossings(rings);
  if (!crossings) return forward_error(crossings);
  const EdgeTree edges(rings, false);
  const Ring offset = with_meetings(moved_sides(places, to_the_left_m));
  // What lies at least that far from the whole line is kept; where the rest was cut out its ends meet.
  const double least_m = std::abs(to_the_left_m) - kRoundingM;
  std::vector<Ring> kept;
  for (std::size_t i = 1; i < offset.size(); ++i) {
    const Eigen::Vector2d& from = offset[i - 1];
    if (is_nearer_than(from, offset[i], edges, least_m)) continue;
    if (kept.empty() || kept.back().back() != from) kept.push_back({from});
    kept.back().push_back(offset[i]);
  }
  // Of a closed line what comes last goes on with what came first.
  if (kept.size() > 1 && offset.front() == offset.back() &&
      kept.back().back() == kept.front().front()) {
    Ring& last = kept.back();
    last.insert(last.end(), kept.front().begin() + 1, kept.front().end());
    kept.front() = std::move(last);
    kept.pop_back();
  }
  return kept;
}

}  // namespace nadir
