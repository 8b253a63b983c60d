// SPDX-License-Identifier: Apache-2.0
#include "core/mcl/particle_set.h"

namespace nadir {

void ParticleSet::resize(std::size_t count) {
  x_in_enu_m.resize(count);
  y_in_enu_m.resize(count);
  yaw_rad.resize(count);
  weight.resize(count);
}

void ParticleSet::set_pose(std::size_t i, const Rigid2& enu_from_body) {
  x_in_enu_m[i] = enu_from_body.x_m;
  y_in_enu_m[i] = enu_from_body.y_m;
  yaw_rad[i] = enu_from_body.yaw_rad;
}

double effective_sample_size(const ParticleSet& particles) {
  double sum_of_squares = 0.0;
  for (const double weight : particles.weight) sum_of_squares += weight * weight;
  return sum_of_squares > 0.0 ? 1.0 / sum_of_squares : 0.0;
}

}  // namespace nadir
