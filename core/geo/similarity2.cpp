// SPDX-License-Identifier: Apache-2.0
#include "core/geo/similarity2.h"

#include <cmath>

#include "core/base/require.h"

namespace nadir {
namespace {

/// What both alignments need: the means, and the second moments about them.
struct Moments {
  Eigen::Vector2d mean_from_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d mean_to_m = Eigen::Vector2d::Zero();
  double spread_from_m2 = 0.0;
  double dot_m2 = 0.0;    ///< Sum of from . to: proportional to the cosine of the best yaw.
  double cross_m2 = 0.0;  ///< Sum of from x to: proportional to its sine.
};

Result<Moments> moments(std::span<const Eigen::Vector2d> points_from,
                        std::span<const Eigen::Vector2d> points_to) {
  NADIR_REQUIRE(points_from.size() == points_to.size());
  if (points_from.size() < 2) {
    return fail(ErrorCode::kMalformed, "alignment: needs two points at least, there are {}",
                points_from.size());
  }
  Moments result;
  const auto count = static_cast<double>(points_from.size());
  // Counted from the first point, so that points that are all the same have no spread at all.
  for (std::size_t i = 1; i < points_from.size(); ++i) {
    result.mean_from_m += (points_from[i] - points_from[0]) / count;
    result.mean_to_m += (points_to[i] - points_to[0]) / count;
  }
  result.mean_from_m += points_from[0];
  result.mean_to_m += points_to[0];
  double spread_to_m2 = 0.0;
  for (std::size_t i = 0; i < points_from.size(); ++i) {
    const Eigen::Vector2d from_m = points_from[i] - result.mean_from_m;
    const Eigen::Vector2d to_m = points_to[i] - result.mean_to_m;
    result.spread_from_m2 += from_m.squaredNorm();
    spread_to_m2 += to_m.squaredNorm();
    result.dot_m2 += from_m.dot(to_m);
    result.cross_m2 += from_m.x() * to_m.y() - from_m.y() * to_m.x();
  }
  // Negated, so that NaN is refused too.
  constexpr double kSmallestCorrelation = 1e-12;
  const double largest_m2 = std::sqrt(result.spread_from_m2) * std::sqrt(spread_to_m2);
  if (!(std::hypot(result.dot_m2, result.cross_m2) > kSmallestCorrelation * largest_m2) ||
      !std::isfinite(largest_m2)) {
    return fail(ErrorCode::kMalformed, "alignment: the points do not determine a rotation");
  }
  return result;
}

Similarity2 aligned(const Moments& m, double scale) {
  Similarity2 result{scale, {0.0, 0.0, wrap_rad(std::atan2(m.cross_m2, m.dot_m2))}};
  const Eigen::Vector2d translation_m = m.mean_to_m - result * m.mean_from_m;
  result.rigid.x_m = translation_m.x();
  result.rigid.y_m = translation_m.y();
  return result;
}

}  // namespace

Similarity2 Similarity2::inverse() const {
  Similarity2 result{1.0 / scale, {0.0, 0.0, wrap_rad(-rigid.yaw_rad)}};
  const Eigen::Vector2d moved = result * rigid.translation_m();
  result.rigid.x_m = -moved.x();
  result.rigid.y_m = -moved.y();
  return result;
}

Result<Rigid2> align_rigid2(std::span<const Eigen::Vector2d> points_from,
                            std::span<const Eigen::Vector2d> points_to) {
  const auto m = moments(points_from, points_to);
  if (!m) return forward_error(m);
  return aligned(*m, 1.0).rigid;
}

Result<Similarity2> align_similarity2(std::span<const Eigen::Vector2d> points_from,
                                      std::span<const Eigen::Vector2d> points_to) {
  const auto m = moments(points_from, points_to);
  if (!m) return forward_error(m);
  return aligned(*m, std::hypot(m->dot_m2, m->cross_m2) / m->spread_from_m2);
}

}  // namespace nadir
