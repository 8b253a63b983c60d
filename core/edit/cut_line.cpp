// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "core/edit/edge_tree.h"
#include "core/edit/polygon_algebra.h"

namespace nadir {
namespace {

/// The line in pieces between the places where edges of a tree meet it, all on the lattice.
std::vector<Ring> pieces_between(const Ring& line, const EdgeTree& edges) {
  std::vector<Ring> pieces;
  Ring piece;
  const auto go_to = [&](const Eigen::Vector2d& place) {
    if (piece.empty() || piece.back() != place) piece.push_back(place);
  };
  const auto end_at = [&](const Eigen::Vector2d& place) {
    go_to(place);
    if (piece.size() > 1) pieces.push_back(std::exchange(piece, {}));
    piece = {place};
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Eigen::Vector2d& a = line[i];
    const Eigen::Vector2d& b = line[i + 1 < line.size() ? i + 1 : i];
    go_to(a);
    if (i + 1 == line.size()) break;
    // Where the segment is met, by how far along.
    std::vector<std::pair<double, Eigen::Vector2d>> met;
    const auto meet = [&](const Eigen::Vector2d& place) {
      met.emplace_back((place - a).squaredNorm(), on_lattice(place));
    };
    edges.visit(box_around(a, b, kLatticeM), [&](const EdgeTree::Edge& edge) {
      if (const auto crossing = crossing_of_edges(a, b, edge.from, edge.to)) meet(*crossing);
      for (const Eigen::Vector2d& end : {edge.from, edge.to}) {
        if ((nearest_on_edge(a, b, end) - end).norm() <= kLatticeM) meet(end);
      }
      for (const Eigen::Vector2d& end : {a, b}) {
        if ((nearest_on_edge(edge.from, edge.to, end) - end).norm() <= kLatticeM) meet(end);
      }
    });
    std::stable_sort(met.begin(), met.end(), [](const auto& first, const auto& second) {
      return first.first < second.first;
    });
    for (const auto& [distance, place] : met) end_at(place);
  }
  if (piece.size() > 1) pieces.push_back(std::move(piece));
  return pieces;
}

Ring cut_line_on_lattice(const Ring& line) {
  Ring places = line;
  for (Eigen::Vector2d& place : places) place = on_lattice(place);
  return without_repeats(std::move(places), false);
}

}  // namespace

CutLine cut(const Ring& line, const Region& region) {
  std::vector<Ring> rings;
  for (const auto& part : region.parts) rings.insert(rings.end(), part.begin(), part.end());
  const EdgeTree edges(rings, true);
  CutLine done;
  for (Ring& piece : pieces_between(cut_line_on_lattice(line), edges)) {
    const bool is_inside = edges.holds((piece[0] + piece[1]) / 2.0);
    if (!done.pieces.empty() && done.pieces.back().is_inside == is_inside) {
      Ring& before = done.pieces.back().places;
      before.insert(before.end(), piece.begin() + 1, piece.end());
    } else {
      done.pieces.push_back({std::move(piece), is_inside});
    }
  }
  return done;
}

std::vector<Ring> cut(const Ring& line, const Ring& across) {
  const std::vector<Ring> rings{cut_line_on_lattice(across)};
  return pieces_between(cut_line_on_lattice(line), EdgeTree(rings, false));
}

}  // namespace nadir
