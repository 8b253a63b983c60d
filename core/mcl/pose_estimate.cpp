// SPDX-License-Identifier: Apache-2.0
#include "core/mcl/pose_estimate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/base/angle.h"
#include "core/base/require.h"
#include "core/mcl/pose_bins.h"

namespace nadir {
namespace {

/// Moments of the chosen particles; their weights need not sum to 1.
PoseMoments moments_of(const ParticleSet& particles, const std::vector<std::size_t>& chosen) {
  double total = 0.0;
  double x = 0.0;
  double y = 0.0;
  double cosine = 0.0;
  double sine = 0.0;
  // Sums are taken relative to one particle, so that coordinates of kilometres cost no digits.
  const Rigid2 origin = particles.pose(chosen.front());
  for (const std::size_t i : chosen) {
    const double weight = particles.weight[i];
    total += weight;
    x += weight * (particles.x_in_enu_m[i] - origin.x_m);
    y += weight * (particles.y_in_enu_m[i] - origin.y_m);
    cosine += weight * std::cos(particles.yaw_rad[i]);
    sine += weight * std::sin(particles.yaw_rad[i]);
  }
  const double mean_x = x / total;
  const double mean_y = y / total;
  PoseMoments moments;
  moments.mean = {origin.x_m + mean_x, origin.y_m + mean_y, std::atan2(sine, cosine)};
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const std::size_t i : chosen) {
    const Eigen::Vector3d deviation(particles.x_in_enu_m[i] - origin.x_m - mean_x,
                                    particles.y_in_enu_m[i] - origin.y_m - mean_y,
                                    wrap_rad(particles.yaw_rad[i] - moments.mean.yaw_rad));
    sum += particles.weight[i] * deviation * deviation.transpose();
  }
  moments.covariance = sum / total;
  // Thesis 3.13: the variance of a wrapped normal with mean resultant length R. Rounding may lift R
  // above 1, and R = 0 (all directions alike) has no finite variance: that of the uniform circle is
  // the most that yaw can have.
  constexpr double kUniformVariance = std::numbers::pi * std::numbers::pi / 3.0;
  const double length = std::min(1.0, std::hypot(cosine, sine) / total);
  const double wrapped_normal =
      length > 0.0 ? std::max(0.0, -2.0 * std::log(length)) : kUniformVariance;
  const double sampled = moments.covariance(2, 2);
  moments.covariance(2, 2) = std::min(wrapped_normal, kUniformVariance);
  if (sampled > 0.0) {  // keep the correlations when the variance is replaced
    const double scale = std::sqrt(moments.covariance(2, 2) / sampled);
    moments.covariance(0, 2) *= scale;
    moments.covariance(1, 2) *= scale;
    moments.covariance(2, 0) *= scale;
    moments.covariance(2, 1) *= scale;
  }
  // Products in another order differ in the last digit; one triangle stands for both.
  moments.covariance = moments.covariance.selfadjointView<Eigen::Lower>();
  return moments;
}

/// Smallest index of the group that i belongs to (union-find with path halving).
std::size_t root_of(std::vector<std::size_t>& parent, std::size_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

struct OccupiedBin {
  PoseBins::Bin bin;
  double mass = 0.0;
  std::vector<std::size_t> particles;
};

/// Occupied bins in order; bins with next to no mass are left out, so that stray particles build no
/// bridges.
std::vector<OccupiedBin> occupied_bins(const ParticleSet& particles, const PoseBins& bins) {
  constexpr double kLeastShareOfHeaviest = 1e-3;
  std::vector<std::pair<PoseBins::Bin, std::size_t>> order(particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i) order[i] = {bins.bin(particles.pose(i)), i};
  std::sort(order.begin(), order.end());
  std::vector<OccupiedBin> occupied;
  double heaviest = 0.0;
  for (const auto& [bin, i] : order) {
    if (occupied.empty() || occupied.back().bin != bin) occupied.push_back({bin, 0.0, {}});
    occupied.back().mass += particles.weight[i];
    occupied.back().particles.push_back(i);
    heaviest = std::max(heaviest, occupied.back().mass);
  }
  std::erase_if(occupied, [&](const OccupiedBin& bin) {
    return bin.mass < kLeastShareOfHeaviest * heaviest;
  });
  return occupied;
}

/// Group of each occupied bin: touching bins, corners included, belong together.
std::vector<std::size_t> groups_of(const std::vector<OccupiedBin>& occupied, const PoseBins& bins) {
  std::vector<std::size_t> parent(occupied.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  for (std::size_t i = 0; i < occupied.size(); ++i) {
    for (int neighbour = 0; neighbour < 27; ++neighbour) {
      const auto wanted =
          bins.moved(occupied[i].bin, neighbour % 3 - 1, neighbour / 3 % 3 - 1, neighbour / 9 - 1);
      const auto found = std::lower_bound(
          occupied.begin(), occupied.end(), wanted,
          [](const OccupiedBin& bin, const auto& value) { return bin.bin < value; });
      if (found == occupied.end() || found->bin != wanted) continue;
      const std::size_t a = root_of(parent, i);
      const std::size_t b = root_of(parent, static_cast<std::size_t>(found - occupied.begin()));
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  for (std::size_t i = 0; i < parent.size(); ++i) parent[i] = root_of(parent, i);
  return parent;
}

}  // namespace

PoseMoments pose_moments(const ParticleSet& particles) {
  NADIR_REQUIRE(!particles.empty());
  std::vector<std::size_t> all(particles.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return moments_of(particles, all);
}

std::vector<PoseMode> find_modes(const ParticleSet& particles, const ModeOptions& options) {
  if (particles.empty()) return {};
  const PoseBins bins(options.bin_m, options.bin_rad);
  const std::vector<OccupiedBin> occupied = occupied_bins(particles, bins);
  const std::vector<std::size_t> group = groups_of(occupied, bins);
  std::map<std::size_t, std::vector<std::size_t>> members;  // of each group, by its first bin
  std::map<std::size_t, double> mass;
  for (std::size_t i = 0; i < occupied.size(); ++i) {
    auto& list = members[group[i]];
    list.insert(list.end(), occupied[i].particles.begin(), occupied[i].particles.end());
    mass[group[i]] += occupied[i].mass;
  }
  std::vector<PoseMode> modes;
  for (const auto& [first_bin, chosen] : members) {
    if (mass[first_bin] < options.min_mass) continue;
    modes.push_back({std::min(1.0, mass[first_bin]), moments_of(particles, chosen)});
  }
  std::stable_sort(modes.begin(), modes.end(),
                   [](const PoseMode& a, const PoseMode& b) { return a.mass > b.mass; });
  if (modes.size() > static_cast<std::size_t>(options.max_modes)) {
    modes.resize(static_cast<std::size_t>(options.max_modes));
  }
  return modes;
}

}  // namespace nadir
