// SPDX-License-Identifier: Apache-2.0
#include "core/edit/geos_geometry.h"

#include <geos_c.h>

#include <utility>

#include "core/edit/edge_tree.h"

namespace nadir {
namespace {

GEOSCoordSequence* sequence_of(const Geos& geos, const Ring& places, bool repeats_first) {
  std::vector<double> numbers;
  numbers.reserve(2 * places.size() + 2);
  for (const Eigen::Vector2d& place : places) {
    numbers.push_back(place.x());
    numbers.push_back(place.y());
  }
  if (repeats_first) {
    numbers.push_back(places.front().x());
    numbers.push_back(places.front().y());
  }
  return GEOSCoordSeq_copyFromBuffer_r(geos.handle(), numbers.data(),
                                       static_cast<unsigned>(numbers.size() / 2), 0, 0);
}

Result<Geometry> ring_geometry(const Geos& geos, const Ring& places) {
  GEOSCoordSequence* const sequence = sequence_of(geos, places, true);
  if (sequence == nullptr) return geos.failed();
  return geos.made(GEOSGeom_createLinearRing_r(geos.handle(), sequence));
}

/// Of a type of collection; takes over the members.
Result<Geometry> collection(const Geos& geos, int type, std::vector<Geometry> members) {
  std::vector<GEOSGeometry*> raw;
  raw.reserve(members.size());
  for (Geometry& member : members) raw.push_back(member.release());
  return geos.made(GEOSGeom_createCollection_r(geos.handle(), type, raw.data(),
                                               static_cast<unsigned>(raw.size())));
}

Ring places_of(const Geos& geos, const GEOSGeometry* line, bool is_ring) {
  const GEOSCoordSequence* const sequence = GEOSGeom_getCoordSeq_r(geos.handle(), line);
  unsigned count = 0;
  if (sequence == nullptr || GEOSCoordSeq_getSize_r(geos.handle(), sequence, &count) == 0)
    return {};
  std::vector<double> numbers(std::size_t{2} * count);
  if (GEOSCoordSeq_copyToBuffer_r(geos.handle(), sequence, numbers.data(), 0, 0) == 0) return {};
  Ring places;
  places.reserve(count);
  for (std::size_t i = 0; i < count; ++i) places.emplace_back(numbers[2 * i], numbers[2 * i + 1]);
  return ring_on_lattice(std::move(places), is_ring);
}

/// All members of a collection, of collections in it, or the one geometry.
template <typename Visit>
void visit_members(const Geos& geos, const GEOSGeometry* geometry, const Visit& visit) {
  if (GEOSGeomTypeId_r(geos.handle(), geometry) < GEOS_MULTIPOINT) {
    visit(geometry);
    return;
  }
  for (int i = 0; i < GEOSGetNumGeometries_r(geos.handle(), geometry); ++i) {
    visit_members(geos, GEOSGetGeometryN_r(geos.handle(), geometry, i), visit);
  }
}

Result<Geometry> polygon_of(const Geos& geos, std::span<const Ring> rings) {
  auto border = ring_geometry(geos, rings.front());
  if (!border) return border;
  std::vector<Geometry> holes;
  for (const Ring& hole : rings.subspan(1)) {
    auto made = ring_geometry(geos, hole);
    if (!made) return made;
    holes.push_back(std::move(*made));
  }
  std::vector<GEOSGeometry*> raw;
  raw.reserve(holes.size());
  for (Geometry& hole : holes) raw.push_back(hole.release());
  return geos.made(GEOSGeom_createPolygon_r(geos.handle(), border->release(), raw.data(),
                                            static_cast<unsigned>(raw.size())));
}

/// All rings of a region on the lattice, without those that are too small for it.
std::vector<std::vector<Ring>> parts_on_lattice(const Region& region) {
  std::vector<std::vector<Ring>> parts;
  for (const std::vector<Ring>& part : region.parts) {
    std::vector<Ring> rings;
    for (const Ring& ring : part) {
      Ring rounded = ring_on_lattice(ring, true);
      if (rounded.size() >= 3) rings.push_back(std::move(rounded));
    }
    if (!rings.empty()) parts.push_back(std::move(rings));
  }
  return parts;
}

}  // namespace

void GeosDeleter::operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(handle, geometry); }

Geos::Geos() : handle_(GEOS_init_r()) {
  GEOSContext_setErrorMessageHandler_r(handle_, keep_words, &words_);
}
Geos::~Geos() { GEOS_finish_r(handle_); }

tl::unexpected<Error> Geos::failed() const {
  return fail(ErrorCode::kInvalidOptions, "borders cannot be computed ({})", words_);
}

Result<Geometry> Geos::made(GEOSGeometry* geometry) const {
  if (geometry == nullptr) return failed();
  return own(geometry);
}

void Geos::keep_words(const char* words, void* kept) { *static_cast<std::string*>(kept) = words; }

Ring ring_on_lattice(Ring ring, bool is_ring) {
  for (Eigen::Vector2d& place : ring) place = on_lattice(place);
  return without_repeats(std::move(ring), is_ring);
}

Result<Geometry> line_geometry(const Geos& geos, const Ring& places, bool is_ring) {
  GEOSCoordSequence* const sequence = sequence_of(geos, places, is_ring);
  if (sequence == nullptr) return geos.failed();
  return geos.made(GEOSGeom_createLineString_r(geos.handle(), sequence));
}

Region region_from(const Geos& geos, const GEOSGeometry* geometry) {
  Region region;
  visit_members(geos, geometry, [&](const GEOSGeometry* member) {
    if (GEOSGeomTypeId_r(geos.handle(), member) != GEOS_POLYGON ||
        GEOSisEmpty_r(geos.handle(), member) != 0)
      return;
    std::vector<Ring> rings{places_of(geos, GEOSGetExteriorRing_r(geos.handle(), member), true)};
    for (int i = 0; i < GEOSGetNumInteriorRings_r(geos.handle(), member); ++i) {
      rings.push_back(places_of(geos, GEOSGetInteriorRingN_r(geos.handle(), member, i), true));
    }
    region.parts.push_back(std::move(rings));
  });
  return region;
}

Result<std::vector<Geometry>> inner_faces(const Geos& geos,
                                          std::span<const Ring> rings,
                                          std::span<const Ring> lines) {
  std::vector<Geometry> edges;
  for (const bool is_ring : {true, false}) {
    for (const Ring& places : is_ring ? rings : lines) {
      auto line = line_geometry(geos, places, is_ring);
      if (!line) return forward_error(line);
      edges.push_back(std::move(*line));
    }
  }
  const auto all = collection(geos, GEOS_MULTILINESTRING, std::move(edges));
  if (!all) return forward_error(all);
  const auto noded = geos.made(GEOSUnaryUnionPrec_r(geos.handle(), all->get(), kLatticeM));
  if (!noded) return forward_error(noded);
  const GEOSGeometry* const noded_lines = noded->get();
  const auto faces = geos.made(GEOSPolygonize_r(geos.handle(), &noded_lines, 1));
  if (!faces) return forward_error(faces);
  const EdgeTree inside(rings, true);
  std::vector<Geometry> inner;
  bool is_sound = true;
  visit_members(geos, faces->get(), [&](const GEOSGeometry* face) {
    const Geometry point = geos.own(GEOSPointOnSurface_r(geos.handle(), face));
    double x = 0.0;
    double y = 0.0;
    if (point == nullptr || GEOSGeomGetX_r(geos.handle(), point.get(), &x) != 1 ||
        GEOSGeomGetY_r(geos.handle(), point.get(), &y) != 1) {
      is_sound = false;
    } else if (inside.holds({x, y})) {
      inner.push_back(geos.own(GEOSGeom_clone_r(geos.handle(), face)));
    }
  });
  if (!is_sound) return geos.failed();
  return inner;
}

Result<Geometry> union_of(const Geos& geos, std::vector<Geometry> polygons) {
  const auto all = collection(geos, GEOS_GEOMETRYCOLLECTION, std::move(polygons));
  if (!all) return forward_error(all);
  return geos.made(GEOSUnaryUnionPrec_r(geos.handle(), all->get(), kLatticeM));
}

Result<Geometry> geometry_of(const Geos& geos, const Region& region) {
  const std::vector<std::vector<Ring>> parts = parts_on_lattice(region);
  std::vector<Geometry> polygons;
  for (const std::vector<Ring>& rings : parts) {
    auto polygon = polygon_of(geos, rings);
    if (!polygon) return polygon;
    polygons.push_back(std::move(*polygon));
  }
  auto all = collection(geos, GEOS_MULTIPOLYGON, std::move(polygons));
  if (!all) return all;
  const char is_valid = GEOSisValid_r(geos.handle(), all->get());
  if (is_valid == 1) return all;
  if (is_valid != 0) return geos.failed();
  std::vector<Ring> rings;
  for (const auto& part : parts) rings.insert(rings.end(), part.begin(), part.end());
  const auto crossings = count_crossings(rings);
  if (!crossings) return forward_error(crossings);
  auto faces = inner_faces(geos, rings, {});
  if (!faces) return forward_error(faces);
  return union_of(geos, std::move(*faces));
}

}  // namespace nadir
