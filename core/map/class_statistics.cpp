// SPDX-License-Identifier: Apache-2.0
#include "core/map/class_statistics.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/require.h"

namespace nadir {
namespace {

using Histogram = std::array<std::int64_t, 256>;

double ratio(std::int64_t part, std::int64_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

double unnormalised_weight(double share, ImportanceReading reading) {
  switch (reading) {
    case ImportanceReading::kInverseShare:
      return 1.0 / share;
    case ImportanceReading::kShare:
      return share;
    case ImportanceReading::kInverseRootShare:
      return 1.0 / std::sqrt(share);
    case ImportanceReading::kUniform:
      return 1.0;
  }
  NADIR_REQUIRE(false && "unknown reading");
  return 0.0;
}

}  // namespace

double ClassStatistics::share_of_classified(ClassId id) const {
  return id < kClassCount ? ratio(cells[id], classified_cells) : 0.0;
}

double ClassStatistics::share_of_all(ClassId id) const {
  return id < kClassCount ? ratio(cells[id], all_cells) : 0.0;
}

int ClassStatistics::present_classes() const {
  return static_cast<int>(
      std::count_if(cells.begin(), cells.end(), [](std::int64_t count) { return count > 0; }));
}

ClassStatistics class_statistics(const Raster<ClassId>& labels) {
  constexpr std::size_t kChunk = 1U << 20U;
  const std::vector<ClassId>& values = labels.values();
  std::vector<Histogram> partial((values.size() + kChunk - 1) / kChunk, Histogram{});
  parallel_for(values.size(), kChunk, [&](std::size_t begin, std::size_t end) {
    Histogram& counts = partial[begin / kChunk];
    for (std::size_t i = begin; i < end; ++i) ++counts[values[i]];
  });
  ClassStatistics statistics;
  statistics.all_cells = static_cast<std::int64_t>(values.size());
  for (const Histogram& counts : partial) {
    for (std::size_t id = 0; id < kClassCount; ++id) {
      statistics.cells[id] += counts[id];
      statistics.classified_cells += counts[id];
    }
  }
  return statistics;
}

ClassWeights importance_weights(const ClassStatistics& statistics, ImportanceReading reading) {
  ClassWeights weights{};
  double mean = 0.0;
  for (std::size_t id = 0; id < kClassCount; ++id) {
    const double share = statistics.share_of_classified(static_cast<ClassId>(id));
    if (share <= 0.0) continue;
    weights[id] = unnormalised_weight(share, reading);
    mean += share * weights[id];
  }
  if (mean > 0.0) {
    for (double& weight : weights) weight /= mean;
  }
  return weights;
}

}  // namespace nadir
