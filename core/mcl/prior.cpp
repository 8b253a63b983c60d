// SPDX-License-Identifier: Apache-2.0
#include "core/mcl/prior.h"

#include <cmath>
#include <numbers>

#include "core/base/angle.h"
#include "core/base/random.h"
#include "core/base/require.h"

namespace nadir {
namespace {

Result<void> check(const GaussianPrior& prior, const OverheadMap& map) {
  const Rigid2& mean = prior.mean_in_enu;
  for (const double value : {mean.x_m, mean.y_m, mean.yaw_rad}) {
    if (!std::isfinite(value)) {
      return fail(ErrorCode::kInvalidOptions, "prior: {} is not a finite number", value);
    }
  }
  for (const double sigma : {prior.position_sigma_m, prior.yaw_sigma_rad}) {
    if (!(sigma >= 0.0) || !std::isfinite(sigma)) {
      return fail(ErrorCode::kInvalidOptions, "prior: a deviation of {} is not possible", sigma);
    }
  }
  if (!map.contains(mean.translation_m())) {
    return fail(ErrorCode::kInvalidOptions, "prior: {:.1f} m east, {:.1f} m north is off map '{}'",
                mean.x_m, mean.y_m, map.name);
  }
  return {};
}

Rigid2 draw(const GaussianPrior& prior, DrawId id) {
  const auto [east, north] = standard_normals(id);
  id.draw = 1;
  const double turn = standard_normals(id)[0];
  return {prior.mean_in_enu.x_m + prior.position_sigma_m * east,
          prior.mean_in_enu.y_m + prior.position_sigma_m * north,
          wrap_rad(prior.mean_in_enu.yaw_rad + prior.yaw_sigma_rad * turn)};
}

Rigid2 draw_anywhere(const OverheadMap& map, DrawId id) {
  const auto [column, row] = uniforms(id);
  id.draw = 1;
  const double turn = uniforms(id)[0];
  const Eigen::Vector2d position =
      map.enu_from_overhead({column * map.labels.width(), row * map.labels.height()});
  return {position.x(), position.y(), wrap_rad(2.0 * std::numbers::pi * turn)};
}

}  // namespace

Result<ParticleSet> draw_particles(const Prior& prior,
                                   const OverheadMap& map,
                                   int count,
                                   std::uint64_t seed) {
  NADIR_REQUIRE(count > 0);
  const auto* gaussian = std::get_if<GaussianPrior>(&prior);
  if (gaussian != nullptr) {
    if (const auto valid = check(*gaussian, map); !valid) return forward_error(valid);
  }
  ParticleSet particles;
  particles.resize(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const DrawId id{
        .seed = seed, .stream = kInitialPose, .particle = static_cast<std::uint32_t>(i)};
    particles.set_pose(i, gaussian != nullptr ? draw(*gaussian, id) : draw_anywhere(map, id));
    particles.weight[i] = 1.0 / count;
  }
  return particles;
}

}  // namespace nadir
