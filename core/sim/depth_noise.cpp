// SPDX-License-Identifier: Apache-2.0
#include "core/sim/depth_noise.h"

#include "core/base/parallel.h"
#include "core/base/random.h"

namespace nadir {
namespace {

float measured(float true_depth_m, double draw, const DepthNoise& noise) {
  const double depth_m = static_cast<double>(true_depth_m);
  if (!(depth_m > 0.0 && depth_m <= noise.max_range_m)) return 0.0F;
  if (noise.inverse_depth_sigma == 0.0) return true_depth_m;
  const double inverse = 1.0 / depth_m + noise.inverse_depth_sigma * draw;
  return inverse * noise.max_range_m >= 1.0 ? static_cast<float>(1.0 / inverse) : 0.0F;
}

}  // namespace

Raster<float> measure_depth(const Raster<float>& true_depth_m,
                            const DepthNoise& noise,
                            std::uint64_t seed,
                            std::uint32_t frame_number) {
  Raster<float> depth_m(true_depth_m.width(), true_depth_m.height());
  // One draw makes two numbers; chunks hold whole pairs.
  constexpr std::size_t kPairsAtOnce = 8192;
  const std::size_t count = true_depth_m.size();
  const auto& truth = true_depth_m.values();
  auto& values = depth_m.values();
  parallel_for((count + 1) / 2, kPairsAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t pair = begin; pair < end; ++pair) {
      const std::size_t i = 2 * pair;
      const bool is_last_alone = i + 1 == count;
      const bool is_any = truth[i] > 0.0F || (!is_last_alone && truth[i + 1] > 0.0F);
      if (!is_any) continue;
      std::array<double, 2> draws{};
      if (noise.inverse_depth_sigma != 0.0) {
        draws = standard_normals(
            {seed, kDepthNoise, frame_number, static_cast<std::uint32_t>(pair), 0});
      }
      values[i] = measured(truth[i], draws[0], noise);
      if (!is_last_alone) values[i + 1] = measured(truth[i + 1], draws[1], noise);
    }
  });
  return depth_m;
}

}  // namespace nadir
