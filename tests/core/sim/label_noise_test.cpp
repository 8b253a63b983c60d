// SPDX-License-Identifier: Apache-2.0
#include "core/sim/label_noise.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/parallel.h"
#include "core/sim/camera_renderer.h"
#include "tests/core/sim/street_map.h"

namespace nadir {
namespace label_noise_test {

CameraModel camera() {
  return CameraModel::from_horizontal_view(320, 240, 59.95 * std::numbers::pi / 180.0);
}

/// A place and direction in the street, another one for every number.
Rigid3 some_view(int number) {
  const double yaw_deg = (number % 2) * 180.0 + (number * 37) % 50 - 25.0;
  if (number % 4 == 0)
    return camera_over(39.0 + number % 3, 5.0 + (number * 7) % 50, 90.0, 2.0, 3.0);
  return camera_over(6.0 + (number * 13) % 68, 29.0 + number % 3, yaw_deg, -3.0, 4.0);
}

struct Pixels {
  std::array<double, kClassCount> all{}, right{};
};

Pixels count_right(const Raster<ClassId>& truth, const Raster<ClassId>& seen, Pixels pixels = {}) {
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const ClassId label = truth.values()[i];
    if (label >= kClassCount) continue;
    pixels.all[label] += 1.0;
    pixels.right[label] += seen.values()[i] == label ? 1.0 : 0.0;
  }
  return pixels;
}

TEST(LabelNoise, GivesTheAccuracyOfThePublishedNetworkClassByClass) {
  Pixels pixels;
  std::uint32_t number = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const World world = raise_world(street_map(), {}, seed);
    const LabelNoise noise(seed);
    for (int view = 0; view < 16; ++view) {
      const Rigid3 pose = some_view(view);
      const SemanticFrame frame = render(world, camera(), pose, view, kFarthestLabelM);
      pixels = count_right(frame.labels, noise.apply(frame, camera(), pose, number++), pixels);
    }
  }
  for (const ClassId id : {kRoad, kSidewalk, kBuilding, kVegetation, kTerrain, kSky, kCar, kCurb,
                           kLaneMarking, kPole}) {
    ASSERT_GT(pixels.all[id], 1000.0) << class_info(id).name;
    EXPECT_NEAR(pixels.right[id] / pixels.all[id], class_errors(id).accuracy, 0.07)
        << class_info(id).name;
  }
}

TEST(LabelNoise, HasATableThatAgreesWithThePublishedMeanAccuracy) {
  double mean = 0.0;
  for (ClassId id = 0; id < kClassCount; ++id) {
    const ClassErrors& errors = class_errors(id);
    mean += errors.accuracy / kClassCount;
    EXPECT_LT(errors.border_loss, 1.0 - errors.accuracy) << "borders alone cannot cost more";
    double shares = 0.0;
    for (const auto& confusion : errors.confusions) {
      shares += confusion.share;
      EXPECT_LT(confusion.taken_for, kClassCount);
      EXPECT_NE(confusion.taken_for, id);
    }
    EXPECT_NEAR(shares, 1.0, 1e-12);
  }
  EXPECT_GT(mean, 0.478);
  EXPECT_LT(mean, 0.569);
}

/// Mean size in pixels of the connected regions (4 neighbours) of wrong pixels, weighted by their
/// size.
double typical_error_size(const Raster<ClassId>& truth, const Raster<ClassId>& seen) {
  Raster<std::uint8_t> is_open(truth.width(), truth.height());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    is_open.values()[i] = truth.values()[i] != seen.values()[i] ? 1 : 0;
  }
  double wrong = 0.0;
  double squares = 0.0;
  for (int row = 0; row < truth.height(); ++row) {
    for (int column = 0; column < truth.width(); ++column) {
      if (is_open.at(column, row) == 0) continue;
      double size = 0.0;
      std::vector<std::pair<int, int>> open = {{column, row}};
      is_open.at(column, row) = 0;
      while (!open.empty()) {
        const auto [x, y] = open.back();
        open.pop_back();
        size += 1.0;
        for (const auto& [dx, dy] :
             {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
          if (!is_open.contains(x + dx, y + dy) || is_open.at(x + dx, y + dy) == 0) continue;
          is_open.at(x + dx, y + dy) = 0;
          open.emplace_back(x + dx, y + dy);
        }
      }
      wrong += size;
      squares += size * size;
    }
  }
  return squares / wrong;
}

TEST(LabelNoise, ErrsInBlobsAndNotInSinglePixels) {
  const World world = raise_world(street_map(), {}, 1);
  const LabelNoise noise(1);
  double size = 0.0;
  for (int view = 0; view < 8; ++view) {
    const SemanticFrame frame = render(world, camera(), some_view(view), 0.0, kFarthestLabelM);
    const auto seen =
        noise.apply(frame, camera(), some_view(view), static_cast<std::uint32_t>(view));
    size += typical_error_size(frame.labels, seen) / 8.0;
  }
  // Independent errors in 5 % of the pixels would make regions of about one pixel.
  EXPECT_GT(size, 100.0);
}

/// How alike the errors of two frames of the same view are: correlation of "is wrong" over the
/// ground pixels.
double error_correlation(const Raster<ClassId>& truth,
                         const Raster<ClassId>& a,
                         const Raster<ClassId>& b) {
  double n = 0.0;
  double sum_a = 0.0;
  double sum_b = 0.0;
  double sum_ab = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const ClassId label = truth.values()[i];
    if (label != kSidewalk && label != kTerrain) continue;
    const double wrong_a = a.values()[i] != label ? 1.0 : 0.0;
    const double wrong_b = b.values()[i] != label ? 1.0 : 0.0;
    n += 1.0;
    sum_a += wrong_a;
    sum_b += wrong_b;
    sum_ab += wrong_a * wrong_b;
  }
  const double mean_a = sum_a / n;
  const double mean_b = sum_b / n;
  return (sum_ab / n - mean_a * mean_b) /
         std::sqrt(mean_a * (1.0 - mean_a) * mean_b * (1.0 - mean_b));
}

TEST(LabelNoise, RepeatsHalfOfItsErrorsFromFrameToFrame) {
  const World world = raise_world(street_map(), {}, 1);
  double same_seed = 0.0;
  double other_seed = 0.0;
  constexpr int kTrials = 48;
  for (int trial = 0; trial < kTrials; ++trial) {
    const Rigid3 pose = some_view(trial);
    const SemanticFrame frame = render(world, camera(), pose, 0.0, kFarthestLabelM);
    const auto seed = static_cast<std::uint64_t>(trial);
    const LabelNoise noise(seed);
    const auto first = noise.apply(frame, camera(), pose, 1);
    const auto second = noise.apply(frame, camera(), pose, 2);
    const auto foreign = LabelNoise(seed + 1).apply(frame, camera(), pose, 3);
    same_seed += error_correlation(frame.labels, first, second) / kTrials;
    other_seed += error_correlation(frame.labels, first, foreign) / kTrials;
  }
  // Fields that are half common give indicators with a correlation of (2 / pi) asin(1 / 2) = 0.33
  // at most.
  EXPECT_GT(same_seed, other_seed + 0.1);
  EXPECT_LT(same_seed, 0.5);
}

TEST(LabelNoise, IsAFunctionOfSeedAndFrameOnAnyNumberOfThreads) {
  const World world = raise_world(street_map(), {}, 1);
  const Rigid3 pose = some_view(3);
  const SemanticFrame frame = render(world, camera(), pose, 0.0, kFarthestLabelM);
  const auto labels = [&](std::uint64_t seed, std::uint32_t number, int threads) {
    const ThreadLimit limit(threads);
    return LabelNoise(seed).apply(frame, camera(), pose, number);
  };
  EXPECT_EQ(labels(1, 4, 1), labels(1, 4, 2));
  EXPECT_NE(labels(1, 4, 1), labels(1, 5, 1));
  EXPECT_NE(labels(1, 4, 1), labels(2, 4, 1));
}

TEST(LabelNoise, LeavesUnclassifiedGroundUnclassified) {
  SemanticFrame frame{.labels = Raster<ClassId>(320, 240, kUnclassified),
                      .depth_m = Raster<float>(320, 240, 5.0F)};
  const auto seen = LabelNoise(1).apply(frame, camera(), some_view(1), 0);
  EXPECT_THAT(seen.values(), testing::Each(kUnclassified));
}

}  // namespace label_noise_test
}  // namespace nadir
