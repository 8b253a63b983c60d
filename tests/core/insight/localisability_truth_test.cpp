// SPDX-License-Identifier: Apache-2.0
// What a localisability map predicts, against what the filter makes of noisy views of the same places.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/base/random.h"
#include "core/insight/localisability.h"
#include "core/map/overhead_map_file.h"
#include "core/mcl/measurement_model.h"
#include "core/mcl/pose_estimate.h"
#include "core/mcl/prior.h"
#include "core/sim/camera_renderer.h"
#include "core/sim/depth_noise.h"
#include "core/sim/label_noise.h"

namespace nadir {
namespace localisability_truth_test {

constexpr double kHeightM = 2.0;
constexpr std::uint64_t kSeed = 4;
constexpr double kPriorM = 3.0;
constexpr double kPriorRad = 0.15;

/// Ranks from 0, the mean of those of equal values.
std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> result(values.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t last = first;
    while (last < order.size() && values[order[last]] == values[order[first]]) ++last;
    for (std::size_t i = first; i < last; ++i) {
      result[order[i]] = 0.5 * static_cast<double>(first + last - 1);
    }
    first = last;
  }
  return result;
}

double spearman(const std::vector<double>& a, const std::vector<double>& b) {
  const auto x = ranks(a);
  const auto y = ranks(b);
  const double mean = 0.5 * static_cast<double>(x.size() - 1);
  double xy = 0.0;
  double xx = 0.0;
  double yy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xy += (x[i] - mean) * (y[i] - mean);
    xx += (x[i] - mean) * (x[i] - mean);
    yy += (y[i] - mean) * (y[i] - mean);
  }
  return xy / std::sqrt(xx * yy);
}

TEST(Spearman, OfKnownOrders) {
  EXPECT_DOUBLE_EQ(spearman({1, 2, 3, 9}, {2, 5, 7, 8}), 1.0);
  EXPECT_DOUBLE_EQ(spearman({1, 2, 3, 9}, {8, 7, 5, 2}), -1.0);
  EXPECT_NEAR(spearman({1, 2, 3, 4, 5}, {5, 6, 7, 8, 7}), 0.82078, 1e-5);  // Wikipedia's tie rule
}

struct Scene {
  OverheadMap map = read_overhead_map(NADIR_PROVING_GROUND).value();
  std::shared_ptr<const MapIndex> index =
      std::make_shared<const MapIndex>(std::make_shared<const OverheadMap>(map));
  World world = raise_world(map, {}, kSeed);
  LabelNoise label_noise{kSeed};
  LocalisabilityOptions options;
  LocalisabilityMap predicted = LocalisabilityMap::create(map, {}, options).value();
  LocaliserOptions filter;
  MapMatcher matcher = MapMatcher::create(index, filter).value();
};

bool is_inland(const OverheadMap& map, const Eigen::Vector2d& place_in_enu_m) {
  const Eigen::Vector2d cell = map.overhead_from_enu(place_in_enu_m);
  const double margin = 4.0 * kPriorM / map.metres_per_cell;
  return cell.minCoeff() > margin && cell.x() < map.labels.width() - margin &&
         cell.y() < map.labels.height() - margin;
}

/// Anywhere that a vehicle may be: no walls, no roofs, and not so near the border that what is known before would lie off the map.
std::vector<Rigid2> random_places(const OverheadMap& map, std::size_t count) {
  std::vector<Rigid2> places;
  for (std::uint32_t i = 0; places.size() < count; ++i) {
    const auto [u, v] = uniforms({.seed = kSeed, .particle = i, .draw = 0});
    const auto [turn, unused] = uniforms({.seed = kSeed, .particle = i, .draw = 1});
    static_cast<void>(unused);
    const Eigen::Vector2d place =
        map.enu_from_overhead({u * map.labels.width(), v * map.labels.height()});
    const ClassId id = map.class_at(place);
    if (id == kUnclassified || id == kBuilding) continue;
    if (!is_inland(map, place)) continue;
    places.push_back({place.x(), place.y(), wrap_rad(2.0 * std::numbers::pi * turn)});
  }
  return places;
}

/// What a simulated vehicle sees there, errors of segmentation, depth and all that the map does not hold included.
SemanticTopview noisy_topview(const Scene& scene, const Rigid2& pose, std::uint32_t number) {
  const CameraModel& lens = scene.options.camera;
  const Rigid3 enu_from_camera =
      Rigid3{rotation_of({0.0, 0.0, pose.yaw_rad}), {pose.x_m, pose.y_m, kHeightM}} *
      Rigid3{forward_body_from_camera(), Eigen::Vector3d::Zero()};
  SemanticFrame frame = render(scene.world, lens, enu_from_camera, 0.0, kFarthestLabelM);
  frame.labels = scene.label_noise.apply(frame, lens, enu_from_camera, number);
  frame.depth_m = measure_depth(frame.depth_m, {0.01, 20.0}, kSeed, number);
  const Eigen::Isometry3d level_from_camera{forward_body_from_camera()};
  const auto cloud =
      build_semantic_cloud(frame.labels, frame.depth_m, lens, level_from_camera, 40.0);
  return build_semantic_topview(*cloud, scene.map.metres_per_cell, scene.options.topview).value();
}

/// One place: as predicted, and as the filter has it after one update of particles from a wide prior.
struct Trial {
  double predicted_m = 0.0, predicted_heading_rad = 0.0, predicted_ambiguity = 0.0;
  double sigma_m = 0.0, sigma_heading_rad = 0.0, error_m = 0.0;
};

std::vector<Trial> trials(const Scene& scene, std::size_t count) {
  std::vector<Trial> result;
  const auto places = random_places(scene.map, count);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto number = static_cast<std::uint32_t>(i);
    const ViewInformation view = scene.predicted.look_from(places[i]);
    const MatchCells seen = scene.matcher.prepare(noisy_topview(scene, places[i], number));
    // What is known before is as wrong as it says, or else knowing nothing more would make no error.
    const auto [east, north] = standard_normals({.seed = kSeed, .particle = number, .draw = 2});
    const auto [turn, unused] = standard_normals({.seed = kSeed, .particle = number, .draw = 3});
    static_cast<void>(unused);
    const Rigid2 before{places[i].x_m + kPriorM * east, places[i].y_m + kPriorM * north,
                        wrap_rad(places[i].yaw_rad + kPriorRad * turn)};
    ParticleSet particles =
        draw_particles(GaussianPrior{before, kPriorM, kPriorRad}, scene.map, 10'000, 100 + i)
            .value();
    if (!seen.empty()) {
      LocaliserOptions trusting = scene.filter;
      trusting.min_effective_fraction = 0.0;  // a single update shall say all that it says
      const double evidence = std::min(1.0, seen.area_m2 / trusting.full_evidence_area_m2);
      apply_likelihood(particles, scene.matcher.mean_costs(seen, particles), evidence, trusting);
    }
    const PoseMoments after = pose_moments(particles);
    result.push_back(
        {.predicted_m = std::hypot(view.std_major_m, view.std_minor_m),
         .predicted_heading_rad = static_cast<double>(view.std_heading_rad),
         .predicted_ambiguity = static_cast<double>(view.ambiguity),
         .sigma_m = std::sqrt(after.covariance(0, 0) + after.covariance(1, 1)),
         .sigma_heading_rad = std::sqrt(after.covariance(2, 2)),
         .error_m = std::hypot(after.mean.x_m - places[i].x_m, after.mean.y_m - places[i].y_m)});
  }
  return result;
}

std::vector<double> values(const std::vector<Trial>& all, double Trial::*member) {
  std::vector<double> result;
  for (const Trial& trial : all) result.push_back(trial.*member);
  return result;
}

TEST(LocalisabilityOnTheProvingGround, RanksPlacesBetterThanChanceAsTheFilterDoesOnNoisyViews) {
  const Scene scene;
  const auto all = trials(scene, 120);
  const auto predicted = values(all, &Trial::predicted_m);
  const double sigma = spearman(predicted, values(all, &Trial::sigma_m));
  const double error = spearman(predicted, values(all, &Trial::error_m));
  const double heading =
      spearman(values(all, &Trial::predicted_heading_rad), values(all, &Trial::sigma_heading_rad));
  const double ambiguity =
      spearman(values(all, &Trial::predicted_ambiguity), values(all, &Trial::sigma_m));
  RecordProperty("spearman",
                 fmt::format("sigma {:.3f} error {:.3f} heading {:.3f} ambiguity {:.3f}", sigma,
                             error, heading, ambiguity));
  // Without any relation a rank correlation of n places is normal with deviation 1 / sqrt(n - 1). One error is a single draw of
  // what the deviation describes, so that even a perfect deviation ranks errors badly: it is asked for less.
  const double chance = 1.0 / std::sqrt(static_cast<double>(all.size() - 1));
  EXPECT_GT(sigma, 4.0 * chance) << "deviation";
  EXPECT_GT(heading, 0.5) << "deviation of the heading";
  EXPECT_GT(ambiguity, 0.4) << "ambiguity";
  EXPECT_GT(error, 1.645 * chance) << "error of the position";
}

}  // namespace localisability_truth_test
}  // namespace nadir
