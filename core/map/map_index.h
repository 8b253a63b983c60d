// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <optional>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/map/class_planes.h"
#include "core/map/class_statistics.h"
#include "core/map/distance_field.h"
#include "core/map/overhead_map.h"

namespace nadir {

/// A map with what localising on it needs: statistics at once, planes and distance fields of a
/// class when first asked for.
///
/// Everything is built once and kept; references stay valid as long as the index. All members may
/// be called from several threads at once, also from inside parallel_for. Memory: a bit a cell and
/// plane, a byte a cell and field.
class MapIndex {
 public:
  /// @param map  Not null; shared because maps are big and never change.
  /// @param truncation_m  Of the distance fields, > 0.
  explicit MapIndex(std::shared_ptr<const OverheadMap> map, double truncation_m = 4.0);

  [[nodiscard]] const OverheadMap& map() const { return *map_; }
  [[nodiscard]] const std::shared_ptr<const OverheadMap>& shared_map() const { return map_; }
  [[nodiscard]] double truncation_m() const { return truncation_m_; }
  [[nodiscard]] const ClassStatistics& statistics() const { return statistics_; }
  [[nodiscard]] const ClassPlane& plane(ClassId id) const;              ///< id < kClassCount.
  [[nodiscard]] const DistanceField& distance_field(ClassId id) const;  ///< id < kClassCount.

  /// Builds planes and fields of every class that the map holds, so that later calls do not wait.
  /// @errors kCancelled.
  [[nodiscard]] Result<void> build_all(const WorkContext& context = {}) const;

 private:
  template <typename T>
  struct Lazy {
    std::once_flag once;
    std::optional<T> value;
  };

  std::shared_ptr<const OverheadMap> map_;
  double truncation_m_;
  ClassStatistics statistics_;
  mutable std::array<Lazy<ClassPlane>, kClassCount> planes_;
  mutable std::array<Lazy<DistanceField>, kClassCount> fields_;
};

}  // namespace nadir
