// SPDX-License-Identifier: Apache-2.0
#include "core/session/shared_ground.h"

#include <cmath>

#include "core/session/run_comparison.h"

namespace nadir {
namespace {

bool is_same_origin(const Geodetic& a, const Geodetic& b) {
  constexpr double kCentimetreDeg = 1e-7;
  return std::abs(a.latitude_deg - b.latitude_deg) <= kCentimetreDeg &&
         std::abs(std::remainder(a.longitude_deg - b.longitude_deg, 360.0)) <= kCentimetreDeg;
}

Geodetic origin_of(const RunHeader& run) {
  Geodetic origin;
  origin.latitude_deg = run.plane_latitude_deg;
  origin.longitude_deg = run.plane_longitude_deg;
  return origin;
}

}  // namespace

bool is_on_plane(const RunHeader& run, const ProjectPlane& plane) {
  return is_same_origin(origin_of(run), plane.origin());
}

bool share_ground(const RunHeader& a, const RunHeader& b) {
  if (!is_same_origin(origin_of(a), origin_of(b))) return false;
  return are_on_same_map(a, b) || a.map == b.map || !is_same_origin(origin_of(a), Geodetic{});
}

}  // namespace nadir
