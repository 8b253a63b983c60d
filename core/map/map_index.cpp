// SPDX-License-Identifier: Apache-2.0
#include "core/map/map_index.h"

#include <oneapi/tbb/task_arena.h>

#include <utility>

#include "core/base/require.h"

namespace nadir {

MapIndex::MapIndex(std::shared_ptr<const OverheadMap> map, double truncation_m)
    : map_(std::move(map)), truncation_m_(truncation_m) {
  NADIR_REQUIRE(map_ != nullptr && truncation_m_ > 0.0);
  statistics_ = class_statistics(map_->labels);
}

// A thread that waits for its own parallel_for may pick up other tasks meanwhile. Without isolation
// such a task could ask for the very class that this thread is building, and wait for itself for
// ever.

const ClassPlane& MapIndex::plane(ClassId id) const {
  NADIR_REQUIRE(id < kClassCount);
  Lazy<ClassPlane>& lazy = planes_[id];
  std::call_once(lazy.once, [&] {
    tbb::this_task_arena::isolate([&] { lazy.value = ClassPlane::of(map_->labels, id); });
  });
  return *lazy.value;
}

const DistanceField& MapIndex::distance_field(ClassId id) const {
  NADIR_REQUIRE(id < kClassCount);
  Lazy<DistanceField>& lazy = fields_[id];
  std::call_once(lazy.once, [&] {
    tbb::this_task_arena::isolate(
        [&] { lazy.value = build_class_distance_field(*map_, id, truncation_m_); });
  });
  return *lazy.value;
}

Result<void> MapIndex::build_all(const WorkContext& context) const {
  const double present = statistics_.present_classes();
  double done = 0.0;
  for (std::size_t i = 0; i < kClassCount; ++i) {
    const auto id = static_cast<ClassId>(i);
    if (statistics_.cells[i] == 0) continue;
    if (context.is_stopped()) {
      return fail(ErrorCode::kCancelled, "{}: preparing the map was cancelled", map_->name);
    }
    context.report(done / present, fmt::format("distances to {}", class_info(id).name));
    static_cast<void>(plane(id));
    static_cast<void>(distance_field(id));
    done += 1.0;
  }
  context.report(1.0, "map prepared");
  return {};
}

}  // namespace nadir
