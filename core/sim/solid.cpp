// SPDX-License-Identifier: Apache-2.0
#include "core/sim/solid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nadir {
namespace {

constexpr double kMiss = std::numeric_limits<double>::infinity();

/// Part of a ray, in units of its direction; empty where begin > end.
struct Span {
  double begin = -kMiss;
  double end = kMiss;

  void meet(const Span& other) {
    begin = std::max(begin, other.begin);
    end = std::min(end, other.end);
  }
  /// Where the ray enters, if it does so ahead of its origin.
  [[nodiscard]] double entry() const { return begin <= end && begin > 0.0 ? begin : kMiss; }
};

constexpr Span kNowhere{kMiss, -kMiss};

/// Where |position + t * rate| <= half.
Span slab(double position, double rate, double half) {
  if (rate == 0.0) return std::abs(position) <= half ? Span{} : kNowhere;
  const double first = (-half - position) / rate;
  const double second = (half - position) / rate;
  return {std::min(first, second), std::max(first, second)};
}

/// Where |position + t * rate| <= radius for vectors of any dimension.
template <typename Vector>
Span ball(const Vector& position, const Vector& rate, double radius) {
  const double a = rate.squaredNorm();
  const double c = position.squaredNorm() - radius * radius;
  if (a == 0.0) return c <= 0.0 ? Span{} : kNowhere;
  const double b = position.dot(rate);
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0) return kNowhere;
  const double root = std::sqrt(discriminant);
  return {(-b - root) / a, (-b + root) / a};
}

double capsule_entry(const Eigen::Vector3d& position,
                     const Eigen::Vector3d& rate,
                     double radius,
                     double half_height) {
  const double half_trunk = std::max(0.0, half_height - radius);
  const Eigen::Vector3d up(0.0, 0.0, half_trunk);
  Span trunk = ball<Eigen::Vector2d>(position.head<2>(), rate.head<2>(), radius);
  trunk.meet(slab(position.z(), rate.z(), half_trunk));
  const Span top = ball<Eigen::Vector3d>(position - up, rate, radius);
  const Span bottom = ball<Eigen::Vector3d>(position + up, rate, radius);
  double entry = kMiss;
  for (const Span& part : {trunk, top, bottom}) {
    if (part.begin > part.end) continue;
    if (part.begin <= 0.0 && part.end >= 0.0) return kMiss;  // the origin is inside
    entry = std::min(entry, part.entry());
  }
  return entry;
}

/// A vector with the solid's axes as its own.
Eigen::Vector3d turned(const Solid& solid, const Eigen::Vector3d& v) {
  return {solid.heading.x() * v.x() + solid.heading.y() * v.y(),
          solid.heading.x() * v.y() - solid.heading.y() * v.x(), v.z()};
}

/// The normal at a point of the surface, both along the solid's axes; of any length.
Eigen::Vector3d normal_along_axes(const Solid& solid, const Eigen::Vector3d& position) {
  const Eigen::Vector3d& half = solid.half_size_m;
  const Eigen::Vector3d shares = position.cwiseQuotient(half);
  switch (solid.shape) {
    case Solid::Shape::kBox: {
      Eigen::Index axis = 0;
      shares.cwiseAbs().maxCoeff(&axis);
      return Eigen::Vector3d::Unit(axis) * shares[axis];
    }
    case Solid::Shape::kCylinder:
      if (std::abs(shares.z()) > position.head<2>().norm() / half.x()) {
        return {0.0, 0.0, position.z()};
      }
      return {position.x(), position.y(), 0.0};
    case Solid::Shape::kEllipsoid:
      return shares.cwiseQuotient(half);
    case Solid::Shape::kCapsule:
      break;
  }
  const double half_trunk = std::max(0.0, half.z() - half.x());
  return position - Eigen::Vector3d(0.0, 0.0, std::clamp(position.z(), -half_trunk, half_trunk));
}

}  // namespace

double Solid::footprint_radius_m() const {
  switch (shape) {
    case Shape::kBox:
      return half_size_m.head<2>().norm();
    case Shape::kEllipsoid:
      return half_size_m.head<2>().maxCoeff();
    case Shape::kCylinder:
    case Shape::kCapsule:
      break;
  }
  return half_size_m.x();
}

double first_hit(const Solid& solid,
                 const Eigen::Vector3d& origin_in_enu_m,
                 const Eigen::Vector3d& direction_in_enu) {
  const Eigen::Vector3d position = turned(solid, origin_in_enu_m - solid.centre_in_enu_m);
  const Eigen::Vector3d rate = turned(solid, direction_in_enu);
  const Eigen::Vector3d& half = solid.half_size_m;
  switch (solid.shape) {
    case Solid::Shape::kBox: {
      Span span = slab(position.x(), rate.x(), half.x());
      span.meet(slab(position.y(), rate.y(), half.y()));
      span.meet(slab(position.z(), rate.z(), half.z()));
      return span.entry();
    }
    case Solid::Shape::kCylinder: {
      Span span = ball<Eigen::Vector2d>(position.head<2>(), rate.head<2>(), half.x());
      span.meet(slab(position.z(), rate.z(), half.z()));
      return span.entry();
    }
    case Solid::Shape::kEllipsoid:
      return ball<Eigen::Vector3d>(position.cwiseQuotient(half), rate.cwiseQuotient(half), 1.0)
          .entry();
    case Solid::Shape::kCapsule:
      break;
  }
  return capsule_entry(position, rate, half.x(), half.z());
}

Eigen::Vector3d outward_normal(const Solid& solid, const Eigen::Vector3d& point_in_enu_m) {
  const Eigen::Vector3d normal =
      normal_along_axes(solid, turned(solid, point_in_enu_m - solid.centre_in_enu_m));
  const Eigen::Vector3d in_enu(solid.heading.x() * normal.x() - solid.heading.y() * normal.y(),
                               solid.heading.y() * normal.x() + solid.heading.x() * normal.y(),
                               normal.z());
  const double length = in_enu.norm();
  if (length > 0.0) return in_enu / length;
  return Eigen::Vector3d::UnitZ();  // At the very centre.
}

}  // namespace nadir
