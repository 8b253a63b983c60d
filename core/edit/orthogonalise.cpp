// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Geometry>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "core/edit/edge_tree.h"
#include "core/edit/edit_builder.h"
#include "core/edit/edit_vertices.h"
#include "core/edit/polygon_algebra.h"

namespace nadir {
namespace {

/// Sets of numbers that only grow together.
class Groups {
 public:
  explicit Groups(std::size_t count) : parents_(count) {
    std::iota(parents_.begin(), parents_.end(), std::size_t{0});
  }
  std::size_t of(std::size_t member) {
    while (parents_[member] != member) {
      parents_[member] = parents_[parents_[member]];
      member = parents_[member];
    }
    return member;
  }
  void join(std::size_t a, std::size_t b) { parents_[of(a)] = of(b); }

 private:
  std::vector<std::size_t> parents_;
};

/// The mean of each group in place of its members' numbers: what moves them least and makes them equal.
void level(std::vector<double>& numbers, Groups& groups) {
  std::vector<double> sums(numbers.size(), 0.0);
  std::vector<int> counts(numbers.size(), 0);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    sums[groups.of(i)] += numbers[i];
    ++counts[groups.of(i)];
  }
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = sums[groups.of(i)] / counts[groups.of(i)];
}

/// Places and edges of the selected objects, each place once.
struct PlaceGraph {
  std::vector<Eigen::Vector2d> places;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  PlaceMap<std::size_t> numbers;

  explicit PlaceGraph(std::span<const LabelObject* const> objects) {
    for (const LabelObject* const object : objects) {
      for (const Ring& ring : object->rings) {
        for (std::size_t i = is_closed(object->kind) ? 0 : 1; i < ring.size(); ++i) {
          const std::size_t from = number(ring[i > 0 ? i - 1 : ring.size() - 1]);
          const std::size_t to = number(ring[i]);
          if (from != to) edges.emplace_back(from, to);
        }
      }
    }
  }
  std::size_t number(const Eigen::Vector2d& place) {
    const auto [found, is_new] = numbers.try_emplace(place, places.size());
    if (is_new) places.push_back(place);
    return found->second;
  }
};

/// Where all places go.
std::vector<Eigen::Vector2d> squared(const PlaceGraph& graph, Angle tolerance) {
  const std::size_t count = graph.places.size();
  Groups whole(count);
  for (const auto& [from, to] : graph.edges) whole.join(from, to);
  // Four times an angle is the same for all four directions at right angles: the sum of those points to what most of the
  // length has.
  std::vector<std::complex<double>> fourfold(count);
  for (const auto& [from, to] : graph.edges) {
    const Eigen::Vector2d along = graph.places[to] - graph.places[from];
    fourfold[whole.of(from)] += std::polar(along.norm(), 4.0 * std::atan2(along.y(), along.x()));
  }
  const auto turned = [&](std::size_t i) {
    return Eigen::Rotation2Dd(std::arg(fourfold[whole.of(i)]) / 4.0);
  };
  std::vector<double> x(count);
  std::vector<double> y(count);
  // Around the first place of what hangs together, because far from 0 rotations lose digits.
  const auto origin = [&](std::size_t i) { return graph.places[whole.of(i)]; };
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector2d place = turned(i).inverse() * (graph.places[i] - origin(i));
    x[i] = place.x();
    y[i] = place.y();
  }
  Groups same_x(count);
  Groups same_y(count);
  for (const auto& [from, to] : graph.edges) {
    const double dx = std::abs(x[to] - x[from]);
    const double dy = std::abs(y[to] - y[from]);
    if (std::atan2(dy, dx) <= tolerance.radians()) {
      same_y.join(from, to);
    } else if (std::atan2(dx, dy) <= tolerance.radians()) {
      same_x.join(from, to);
    }
  }
  level(x, same_x);
  level(y, same_y);
  std::vector<Eigen::Vector2d> places;
  for (std::size_t i = 0; i < count; ++i) {
    places.push_back(on_lattice(origin(i) + turned(i) * Eigen::Vector2d(x[i], y[i])));
  }
  return places;
}

}  // namespace

Result<LabelEdit> orthogonalise(const LabelDocument& document,
                                std::span<const ObjectId> objects,
                                Angle tolerance) {
  if (!(tolerance.degrees() > 0.0 && tolerance.degrees() <= 45.0)) {
    return fail(ErrorCode::kInvalidOptions, "a tolerance of {} deg is not in (0, 45]",
                tolerance.degrees());
  }
  const auto selected = selected_objects(document, objects);
  if (!selected) return forward_error(selected);
  const PlaceGraph graph(*selected);
  const std::vector<Eigen::Vector2d> moved = squared(graph, tolerance);
  PlaneBounds bounds;
  for (const Eigen::Vector2d& place : graph.places) bounds.include(place);
  EditBuilder builder(document, "Make right-angled");
  for (const auto& [id, placed] : document.objects()) {
    if (!do_meet(placed.bounds, bounds)) continue;
    const LabelObject& before = *placed.object;
    std::vector<Ring> rings = before.rings;
    for (Ring& ring : rings) {
      for (Eigen::Vector2d& place : ring) {
        const auto found = graph.numbers.find(place);
        if (found != graph.numbers.end()) place = moved[found->second];
      }
    }
    if (rings == before.rings) continue;
    for (std::size_t i = 0; is_closed(before.kind) && i < rings.size(); ++i) {
      const double area = signed_area_m2(before.rings[i]);
      const double ratio = area != 0.0 ? signed_area_m2(rings[i]) / area : 1.0;
      if (ratio > 0.5 && ratio < 2.0) continue;
      return fail(ErrorCode::kInvalidOptions, "{} has too few right angles to get more",
                  object_name(before));
    }
    builder.change(id).rings = std::move(rings);
  }
  return builder.edit();
}

}  // namespace nadir
