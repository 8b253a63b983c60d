// SPDX-License-Identifier: Apache-2.0
// A vehicle that links Nadir: feeds odometry and topviews, reads the estimate. The map is a made-up
// chequered street.
#include <cmath>
#include <cstdio>
#include <memory>

#include "core/mcl/localiser.h"

namespace {

nadir::OverheadMap street_map() {
  nadir::OverheadMap map{"street",
                         nadir::ProjectPlane::create({32.4, -83.7}).value(),
                         0.2,
                         {0.0, 40.0},
                         nadir::Raster<nadir::ClassId>(400, 200, nadir::kTerrain)};
  for (int row = 0; row < 200; ++row) {
    for (int column = 0; column < 400; ++column) {
      if (row > 90 && row < 120) map.labels.at(column, row) = nadir::kRoad;
      if (row == 105 && column / 13 % 3 != 0) map.labels.at(column, row) = nadir::kLaneMarking;
      if (row < 85 && (column * column / 900) % 3 == 0)
        map.labels.at(column, row) = nadir::kBuilding;
    }
  }
  return map;
}

nadir::SemanticTopview seen_from(const nadir::OverheadMap& map, const nadir::Rigid2& pose) {
  nadir::SemanticCloud cloud;
  for (float forward = 0.1F; forward < 15.0F; forward += 0.2F) {
    for (float left = -0.6F * forward; left < 0.6F * forward; left += 0.2F) {
      const nadir::ClassId id = map.class_at(pose * Eigen::Vector2d(forward, left));
      if (id == nadir::kUnclassified) continue;
      cloud.points_in_level_m.emplace_back(forward, left, -2.0F);
      cloud.labels.push_back(id);
    }
  }
  return nadir::build_semantic_topview(cloud, map.metres_per_cell).value();
}

}  // namespace

int main() {
  const auto map = std::make_shared<const nadir::OverheadMap>(street_map());
  const nadir::Rigid2 start{5.0, 18.0, 0.1};
  auto localiser = nadir::Localiser::create(std::make_shared<const nadir::MapIndex>(map),
                                            nadir::LocaliserOptions{},
                                            nadir::GaussianPrior{.mean_in_enu = start});
  if (!localiser) {
    std::fprintf(stderr, "%s\n", localiser.error().message.c_str());
    return 1;
  }
  nadir::Rigid2 truth{start.x_m, start.y_m, 0.0};
  nadir::Rigid2 estimate;
  for (int step = 0; step < 80; ++step) {
    const nadir::Rigid2 motion{step == 0 ? 0.0 : 0.5, 0.0, 0.0};
    truth = truth * motion;
    const nadir::Rigid2 drifting{motion.x_m * 1.05, 0.0, step == 0 ? 0.0 : 0.005};
    estimate = localiser->update({drifting, step == 0 ? 0.0 : 0.25}, seen_from(*map, truth))
                   .estimate.moments.mean;
  }
  const double error_m = std::hypot(estimate.x_m - truth.x_m, estimate.y_m - truth.y_m);
  std::printf("error after 40 m: %.2f m\n", error_m);
  return error_m < 1.0 ? 0 : 1;
}
