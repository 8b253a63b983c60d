// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <memory>

#include "tests/core/session/made_run.h"
#include "tests/support/scenery.h"
#include "widgets/panels/map_view.h"
#include "widgets/panels/moment_model.h"

namespace nadir {

/// A flight over a patchwork of 60 x 50 m: what was seen is what the map has at the truth, and the estimate of every step is
/// 3 m farther north.
struct MadeMoment {
  static constexpr double kCellM = 0.25;
  static constexpr double kErrorM = 3.0;

  std::shared_ptr<const MapIndex> map = index_of(patchwork_map(240, 200, kCellM));
  std::shared_ptr<const RunDocument> document = made_document(20, [](RunStep& one) {
    one.truth_in_enu = Rigid2{20.0 + 0.5 * one.step, 25.0, 0.0};
    one.odometry_in_enu = Rigid2{20.0 + 0.5 * one.step, 24.0, 0.0};
    one.estimate.moments.mean = {20.0 + 0.5 * one.step, 25.0 + kErrorM, 0.0};
  });
  std::size_t index = 8;
  std::shared_ptr<const RunStep> step = decoded(index);

  /// The step with a topview and 400 particles on a grid around the estimate, 0.1 m apart, the first one south-west.
  [[nodiscard]] std::shared_ptr<const RunStep> decoded(std::size_t at) const {
    RunStep made = document->steps[at];
    made.topview = perfect_topview(map->map(), *made.truth_in_enu, 12.0);
    ParticleSet particles;
    particles.resize(400);
    for (int i = 0; i < 400; ++i) {
      const Rigid2& mean = made.estimate.moments.mean;
      particles.set_pose(static_cast<std::size_t>(i),
                         {mean.x_m + 0.1 * (i % 20 - 10), mean.y_m + 0.1 * (i / 20 - 10), 0.0});
      particles.weight[static_cast<std::size_t>(i)] = 1.0 / 400.0;
    }
    made.particles = particles;
    return std::make_shared<const RunStep>(std::move(made));
  }

  [[nodiscard]] MomentModel moment() const {
    MomentModel model;
    model.run_name = "loop";
    model.document = document;
    model.index = index;
    model.step = step;
    model.map = map;
    model.has_flight = true;
    return model;
  }

  /// Looks at the estimate, 40 m across.
  [[nodiscard]] MapViewModel map_view() const {
    MapViewModel model;
    model.look = default_map_look();
    model.look.centre_in_enu_m = document->steps[index].estimate.moments.mean.translation_m();
    model.look.width_m = 40.0;
    MapRun run;
    run.name = "loop";
    run.is_active = true;
    run.document = document;
    run.step = index;
    model.runs = {run};
    model.step = step;
    model.map = map;
    model.plane = map->map().plane;
    return model;
  }
};

}  // namespace nadir
