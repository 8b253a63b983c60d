// SPDX-License-Identifier: Apache-2.0
#include "core/edit/polygon_algebra.h"

#include <geos_c.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/edit/edge_tree.h"
#include "core/edit/geos_geometry.h"

namespace nadir {
namespace {

constexpr int kQuarterCircle = 16;  ///< Edges of a round join's quarter.
constexpr double kLongestMitre = 2.0;

/// Refuses what would take GEOS minutes.
Result<void> check_effort(std::span<const Region> regions) {
  std::vector<Ring> rings;
  for (const Region& region : regions) {
    for (const auto& part : region.parts) rings.insert(rings.end(), part.begin(), part.end());
  }
  const auto crossings = count_crossings(rings);
  if (!crossings) return forward_error(crossings);
  return {};
}

using Overlay = GEOSGeometry* (*)(GEOSContextHandle_t,
                                  const GEOSGeometry*,
                                  const GEOSGeometry*,
                                  double);
Result<Region> overlaid(const Region& a, const Region& b, Overlay overlay) {
  const std::array<Region, 2> both{a, b};
  if (const auto possible = check_effort(both); !possible) return forward_error(possible);
  const Geos geos;
  const auto first = geometry_of(geos, a);
  if (!first) return forward_error(first);
  const auto second = geometry_of(geos, b);
  if (!second) return forward_error(second);
  const auto made = geos.made(overlay(geos.handle(), first->get(), second->get(), kLatticeM));
  if (!made) return forward_error(made);
  return region_from(geos, made->get());
}

/// A geometry brought onto the lattice as a region.
Result<Region> rounded_region(const Geos& geos, const Result<Geometry>& geometry) {
  if (!geometry) return forward_error(geometry);
  const auto rounded =
      geos.made(GEOSGeom_setPrecision_r(geos.handle(), geometry->get(), kLatticeM, 0));
  if (!rounded) return forward_error(rounded);
  return region_from(geos, rounded->get());
}

}  // namespace

Eigen::Vector2d on_lattice(const Eigen::Vector2d& point_in_enu_m) {
  return {std::round(point_in_enu_m.x() / kLatticeM) * kLatticeM + 0.0,
          std::round(point_in_enu_m.y() / kLatticeM) * kLatticeM + 0.0};
}

Result<Region> region_of(const LabelObject& object) {
  const Geos geos;
  if (is_closed(object.kind)) {
    // Even and odd is told of all rings together, so one part will do, and holes outside of the border are mended too.
    const auto sound = geometry_of(geos, {{object.rings}});
    if (!sound) return forward_error(sound);
    return region_from(geos, sound->get());
  }
  const auto line = line_geometry(geos, ring_on_lattice(object.rings.front(), false), false);
  if (!line) return forward_error(line);
  return rounded_region(geos, geos.made(GEOSBufferWithStyle_r(
                                  geos.handle(), line->get(), object.width_m / 2.0, kQuarterCircle,
                                  GEOSBUF_CAP_FLAT, GEOSBUF_JOIN_ROUND, 1.0)));
}

Result<Region> united(std::span<const Region> regions) {
  if (const auto possible = check_effort(regions); !possible) return forward_error(possible);
  const Geos geos;
  std::vector<Geometry> all;
  for (const Region& region : regions) {
    auto geometry = geometry_of(geos, region);
    if (!geometry) return forward_error(geometry);
    all.push_back(std::move(*geometry));
  }
  const auto made = union_of(geos, std::move(all));
  if (!made) return forward_error(made);
  return region_from(geos, made->get());
}

Result<Region> without(const Region& region, const Region& cut) {
  return overlaid(region, cut, GEOSDifferencePrec_r);
}

Result<Region> common(const Region& a, const Region& b) {
  return overlaid(a, b, GEOSIntersectionPrec_r);
}

Result<std::vector<Region>> split(const Region& region, std::span<const Ring> lines) {
  const Geos geos;
  const auto sound = geometry_of(geos, region);
  if (!sound) return forward_error(sound);
  std::vector<Ring> rings;
  for (auto& part : region_from(geos, sound->get()).parts) {
    rings.insert(rings.end(), part.begin(), part.end());
  }
  std::vector<Ring> across;
  for (const Ring& line : lines) {
    Ring places = ring_on_lattice(line, false);
    if (places.size() >= 2) across.push_back(std::move(places));
  }
  const auto faces = inner_faces(geos, rings, across);
  if (!faces) return forward_error(faces);
  std::vector<std::pair<double, Region>> pieces;
  for (const Geometry& face : *faces) {
    Region piece = region_from(geos, face.get());
    const double size = area_m2(piece);
    pieces.emplace_back(size, std::move(piece));
  }
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Region> sorted;
  sorted.reserve(pieces.size());
  for (auto& [size, piece] : pieces) sorted.push_back(std::move(piece));
  return sorted;
}

Result<Region> grown(const Region& region, double by_m) {
  const Geos geos;
  const auto sound = geometry_of(geos, region);
  if (!sound) return forward_error(sound);
  return rounded_region(
      geos, geos.made(GEOSBufferWithStyle_r(geos.handle(), sound->get(), by_m, kQuarterCircle,
                                            GEOSBUF_CAP_FLAT, GEOSBUF_JOIN_MITRE, kLongestMitre)));
}

Result<Region> simplified(const Region& region, double tolerance_m) {
  const Geos geos;
  const auto sound = geometry_of(geos, region);
  if (!sound) return forward_error(sound);
  return rounded_region(
      geos, geos.made(GEOSTopologyPreserveSimplify_r(geos.handle(), sound->get(), tolerance_m)));
}

bool is_equal_area(double a_m2, double b_m2) {
  return std::abs(a_m2 - b_m2) <= 1e-5 + 1e-9 * std::abs(a_m2);
}

double area_m2(const Region& region) {
  double area = 0.0;
  for (const auto& part : region.parts) {
    for (const Ring& ring : part) {
      area += std::abs(signed_area_m2(ring)) * (&ring == &part.front() ? 1.0 : -1.0);
    }
  }
  return area;
}

}  // namespace nadir
