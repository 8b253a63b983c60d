// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/label/label_object.h"

namespace nadir {

/// Set operations on what objects cover, by GEOS. All places of what comes out lie on a lattice, so that nearly parallel edges
/// never make an operation fail, and borders that two results have in common are equal to the last bit.

/// A micrometre, more or less: a power of two, so that places up to 1e6 m away are exact numbers.
inline constexpr double kLatticeM = 1.0 / (1 << 20);
[[nodiscard]] Eigen::Vector2d on_lattice(const Eigen::Vector2d& point_in_enu_m);

/// Some parts, each a border and its holes. On the way into the functions below inside is told by odd and even over all
/// rings, whatever they cross; what comes out is sound: rings do not cross, insides of parts do not overlap.
struct Region {
  std::vector<std::vector<Ring>> parts;
  [[nodiscard]] bool empty() const { return parts.empty(); }
};

// All of these fail with kInvalidOptions where borders cross more than 100,000 times, and where GEOS cannot compute them.

/// What an object covers, so that nothing below it shows: of a line its stroke with round joins; of an outline its inside
/// too, for it draws that as unclassified. This is what an object takes from others that it cuts.
[[nodiscard]] Result<Region> region_of(const LabelObject& object);
[[nodiscard]] Result<Region> united(std::span<const Region> regions);
[[nodiscard]] Result<Region> without(const Region& region, const Region& cut);
[[nodiscard]] Result<Region> common(const Region& a, const Region& b);
/// The pieces into which lines across cut it, largest first. O(n log n).
[[nodiscard]] Result<std::vector<Region>> split(const Region& region, std::span<const Ring> lines);
/// Grown, or shrunk by a negative distance; corners stay corners up to twice the distance.
[[nodiscard]] Result<Region> grown(const Region& region, double by_m);
/// With fewer places, no farther than that from where they were, and as sound as before.
[[nodiscard]] Result<Region> simplified(const Region& region, double tolerance_m);
/// A line beside a line, in its direction: to its left, or right where negative. Several where it falls apart, none where
/// nothing is left of it. Inner corners do not cross.
[[nodiscard]] Result<std::vector<Ring>> beside(const Ring& line, double to_the_left_m);

/// A line in pieces, in its order: those inside of a region and those outside.
struct CutLine {
  struct Piece {
    Ring places;
    bool is_inside = false;
  };
  std::vector<Piece> pieces;
};
[[nodiscard]] CutLine cut(const Ring& line, const Region& region);
/// The pieces into which another line cuts a line.
[[nodiscard]] std::vector<Ring> cut(const Ring& line, const Ring& across);

[[nodiscard]] double area_m2(const Region& region);
/// Whether areas differ by no more than rounding to the lattice may make of them.
[[nodiscard]] bool is_equal_area(double a_m2, double b_m2);

}  // namespace nadir
