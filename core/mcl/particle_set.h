// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "core/geo/rigid2.h"

namespace nadir {

/// Hypotheses about where the body is: element i of every array is particle i.
/// Invariant: all arrays have the same length; `weight` sums to 1 unless the set is empty.
struct ParticleSet {
  std::vector<double> x_in_enu_m, y_in_enu_m;
  std::vector<double> yaw_rad;  ///< Counter-clockwise from east, in (-pi, pi].
  std::vector<double> weight;

  [[nodiscard]] std::size_t size() const { return weight.size(); }
  [[nodiscard]] bool empty() const { return weight.empty(); }
  [[nodiscard]] Rigid2 pose(std::size_t i) const {
    return {x_in_enu_m[i], y_in_enu_m[i], yaw_rad[i]};
  }
  void resize(std::size_t count);
  void set_pose(std::size_t i, const Rigid2& enu_from_body);
  friend bool operator==(const ParticleSet&, const ParticleSet&) = default;
};

/// 1 / sum of squared weights: how many equal particles would say as much. 0 for an empty set.
[[nodiscard]] double effective_sample_size(const ParticleSet& particles);

}  // namespace nadir
