// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/edit/polygon_algebra.h"

// Opaque types of GEOS's C interface, which the sources behind polygon_algebra.h alone include.
struct GEOSContextHandle_HS;
struct GEOSGeom_t;

namespace nadir {

/// Regions as geometries of GEOS. Private to this module.

struct GeosDeleter {
  GEOSContextHandle_HS* handle = nullptr;
  void operator()(GEOSGeom_t* geometry) const;
};
using Geometry = std::unique_ptr<GEOSGeom_t, GeosDeleter>;

/// GEOS for one call of ours, with the words of its last error. Its geometries must not outlive it.
class Geos {
 public:
  Geos();
  ~Geos();
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;

  [[nodiscard]] GEOSContextHandle_HS* handle() const { return handle_; }
  [[nodiscard]] Geometry own(GEOSGeom_t* geometry) const { return {geometry, {handle_}}; }
  /// kInvalidOptions with GEOS's own words.
  [[nodiscard]] tl::unexpected<Error> failed() const;
  /// What a call of GEOS has made; null is its error.
  [[nodiscard]] Result<Geometry> made(GEOSGeom_t* geometry) const;

 private:
  static void keep_words(const char* words, void* kept);
  GEOSContextHandle_HS* handle_;
  std::string words_;
};

/// On the lattice, without places that repeat the one before.
[[nodiscard]] Ring ring_on_lattice(Ring ring, bool is_ring);
[[nodiscard]] Result<Geometry> line_geometry(const Geos& geos, const Ring& places, bool is_ring);
/// A sound geometry of a region that need not be sound.
[[nodiscard]] Result<Geometry> geometry_of(const Geos& geos, const Region& region);
/// Polygons of what GEOS has made; points and lines, where borders only touch, are no part of a region.
[[nodiscard]] Region region_from(const Geos& geos, const GEOSGeom_t* geometry);
[[nodiscard]] Result<Geometry> union_of(const Geos& geos, std::vector<Geometry> polygons);
/// Faces between rings and lines that lie inside of the rings, by odd and even.
[[nodiscard]] Result<std::vector<Geometry>> inner_faces(const Geos& geos,
                                                        std::span<const Ring> rings,
                                                        std::span<const Ring> lines);

}  // namespace nadir
