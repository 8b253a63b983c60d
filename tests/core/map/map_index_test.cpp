// SPDX-License-Identifier: Apache-2.0
#include "core/map/map_index.h"

#include <gmock/gmock.h>

#include <stdexcept>
#include <thread>
#include <vector>

#include "core/base/parallel.h"
#include "tests/core/map/raster_files.h"
#include "tests/support/drawn_map.h"
#include "tests/support/error_text.h"

namespace nadir {
namespace map_index_test {

std::shared_ptr<const OverheadMap> patchwork_map(int width, int height) {
  OverheadMap map = drawn_map(0.2, {"."});
  map.labels = patchwork(width, height);
  return std::make_shared<const OverheadMap>(std::move(map));
}

TEST(MapIndex, HoldsWhatTheMapSays) {
  const auto map = patchwork_map(130, 70);
  const MapIndex index(map, 4.0);
  EXPECT_EQ(&index.map(), map.get());
  EXPECT_EQ(index.statistics().cells, class_statistics(map->labels).cells);
  EXPECT_EQ(index.plane(kRoad).count(), index.statistics().cells[kRoad]);
  EXPECT_EQ(index.distance_field(kRoad).codes, build_class_distance_field(*map, kRoad, 4.0).codes);
}

TEST(MapIndex, BuildsEveryThingOnce) {
  const MapIndex index(patchwork_map(64, 64));
  EXPECT_EQ(&index.plane(kTerrain), &index.plane(kTerrain));
  EXPECT_EQ(&index.distance_field(kTerrain), &index.distance_field(kTerrain));
}

TEST(MapIndex, GivesAllThreadsTheSameObjects) {
  const MapIndex index(patchwork_map(600, 500));
  std::vector<const DistanceField*> fields(8, nullptr);
  {
    std::vector<std::jthread> threads;
    threads.reserve(fields.size());
    for (const DistanceField*& field : fields) {
      threads.emplace_back([&] { field = &index.distance_field(kSidewalk); });
    }
  }
  EXPECT_THAT(fields, testing::Each(&index.distance_field(kSidewalk)));
}

TEST(MapIndex, MayBeAskedFromInsideAParallelLoop) {
  const MapIndex index(patchwork_map(900, 900));
  std::vector<std::int64_t> counts(64, 0);
  parallel_for(counts.size(), 1, [&](std::size_t begin, std::size_t) {
    const auto id = static_cast<ClassId>(begin % kClassCount);
    static_cast<void>(index.distance_field(id));
    counts[begin] = index.plane(id).count();
  });
  for (std::size_t i = 0; i < counts.size(); ++i) {
    EXPECT_EQ(counts[i], index.statistics().cells[i % kClassCount]);
  }
}

TEST(MapIndex, TellsHowFarItIs) {
  const MapIndex index(patchwork_map(40, 40));
  std::vector<double> fractions;
  WorkContext context;
  context.progress = [&](double fraction, const std::string&) { fractions.push_back(fraction); };
  ASSERT_TRUE(index.build_all(context));
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_EQ(fractions.size(), 4U);  // three classes and the end
  EXPECT_EQ(fractions.back(), 1.0);
}

TEST(MapIndex, StopsWhenAsked) {
  const MapIndex index(patchwork_map(40, 40));
  std::stop_source source;
  source.request_stop();
  WorkContext context;
  context.stop = source.get_token();
  const auto built = index.build_all(context);
  ASSERT_FALSE(built);
  EXPECT_EQ(error_code(built), ErrorCode::kCancelled);
}

TEST(MapIndex, NeedsAMap) { EXPECT_THROW(MapIndex(nullptr), std::logic_error); }

}  // namespace map_index_test
}  // namespace nadir
