// SPDX-License-Identifier: Apache-2.0
#include "core/map/class_statistics.h"

#include <gmock/gmock.h>

#include "core/base/parallel.h"
#include "tests/core/map/raster_files.h"
#include "tests/support/drawn_map.h"

namespace nadir {
namespace class_statistics_test {

using testing::Each;

constexpr std::array kReadings{ImportanceReading::kInverseShare, ImportanceReading::kShare,
                               ImportanceReading::kInverseRootShare, ImportanceReading::kUniform};

/// Ten cells: six road, two terrain, one curb, one unclassified.
OverheadMap ten_cells() { return drawn_map(1.0, {"RRRRR", "RTTC."}); }

TEST(ClassStatistics, CountsCellsAndShares) {
  const ClassStatistics statistics = class_statistics(ten_cells().labels);
  EXPECT_EQ(statistics.cells[kRoad], 6);
  EXPECT_EQ(statistics.cells[kTerrain], 2);
  EXPECT_EQ(statistics.cells[kCurb], 1);
  EXPECT_EQ(statistics.classified_cells, 9);
  EXPECT_EQ(statistics.all_cells, 10);
  EXPECT_EQ(statistics.present_classes(), 3);
  EXPECT_DOUBLE_EQ(statistics.share_of_classified(kRoad), 6.0 / 9.0);
  EXPECT_DOUBLE_EQ(statistics.share_of_all(kRoad), 0.6);
  EXPECT_EQ(statistics.share_of_all(kSky), 0.0);
  EXPECT_EQ(statistics.share_of_classified(kUnclassified), 0.0);
}

TEST(ClassStatistics, OfAnEmptyMapAreZero) {
  const ClassStatistics statistics = class_statistics(Raster<ClassId>());
  EXPECT_EQ(statistics.all_cells, 0);
  EXPECT_EQ(statistics.share_of_all(kRoad), 0.0);
  for (const ImportanceReading reading : kReadings) {
    EXPECT_THAT(importance_weights(statistics, reading), Each(0.0));
  }
}

TEST(ClassStatistics, AreTheSameOnOneAndFourThreads) {
  const Raster<ClassId> labels = patchwork(2000, 1700);
  const auto counts_on = [&](int threads) {
    const ThreadLimit limit(threads);
    return class_statistics(labels).cells;
  };
  EXPECT_EQ(counts_on(1), counts_on(4));
}

TEST(ImportanceWeights, OfTheTextGrowAsAClassGetsRarer) {
  const ClassWeights weights =
      importance_weights(class_statistics(ten_cells().labels), ImportanceReading::kInverseShare);
  // 1 / share, divided by the number of classes: 9/6/3, 9/2/3, 9/1/3.
  EXPECT_NEAR(weights[kRoad], 0.5, 1e-12);
  EXPECT_NEAR(weights[kTerrain], 1.5, 1e-12);
  EXPECT_NEAR(weights[kCurb], 3.0, 1e-12);
}

TEST(ImportanceWeights, OfEquationThreeSixAreInProportionToTheShare) {
  const ClassWeights weights =
      importance_weights(class_statistics(ten_cells().labels), ImportanceReading::kShare);
  EXPECT_NEAR(weights[kRoad] / weights[kCurb], 6.0, 1e-12);
  EXPECT_NEAR(weights[kTerrain] / weights[kCurb], 2.0, 1e-12);
  EXPECT_NEAR(weights[kRoad], 6.0 * 9.0 / (36.0 + 4.0 + 1.0), 1e-12);
}

TEST(ImportanceWeights, OfTheRootLieBetween) {
  const ClassWeights weights = importance_weights(class_statistics(ten_cells().labels),
                                                  ImportanceReading::kInverseRootShare);
  EXPECT_NEAR(weights[kCurb] / weights[kRoad], std::sqrt(6.0), 1e-12);
}

TEST(ImportanceWeights, AreZeroForWhatTheMapDoesNotHold) {
  const ClassStatistics statistics = class_statistics(ten_cells().labels);
  for (const ImportanceReading reading : kReadings) {
    const ClassWeights weights = importance_weights(statistics, reading);
    EXPECT_EQ(weights[kSky], 0.0);
    EXPECT_EQ(weights[kBuilding], 0.0);
  }
  EXPECT_EQ(importance_weights(statistics, ImportanceReading::kUniform)[kCurb], 1.0);
}

TEST(ImportanceWeights, HaveMeanOneOverTheClassifiedCells) {
  const ClassStatistics statistics = class_statistics(ten_cells().labels);
  for (const ImportanceReading reading : kReadings) {
    const ClassWeights weights = importance_weights(statistics, reading);
    double mean = 0.0;
    for (int id = 0; id < kClassCount; ++id) {
      const auto class_id = static_cast<ClassId>(id);
      mean += statistics.share_of_classified(class_id) * weights[class_id];
    }
    EXPECT_NEAR(mean, 1.0, 1e-12) << enum_name(reading);
  }
}

TEST(ImportanceReading, HasNamesForTheCommandLine) {
  EXPECT_EQ(enum_name(ImportanceReading::kInverseShare), "inverse-share");
  EXPECT_EQ(enum_name(ImportanceReading::kShare), "share");
  EXPECT_EQ(enum_name(ImportanceReading::kUniform), "uniform");
}

}  // namespace class_statistics_test
}  // namespace nadir
