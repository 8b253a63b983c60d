// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

#include "core/label/label_document.h"

namespace nadir {

/// Finds the objects of a document by place, among 20,000 in microseconds. An object lies in the bins, at most four, that its
/// bounds touch, of squares at least as large as itself. Follows a document by its edits.
class ObjectIndex {
 public:
  explicit ObjectIndex(const LabelDocument& document);
  void apply(const LabelEdit& edit);

  /// Objects whose bounds meet a rectangle, in no order.
  [[nodiscard]] std::vector<ObjectId> near(const PlaneBounds& box) const;

 private:
  struct Bin {
    int level = 0;  ///< Its side is 2^level metres.
    std::int64_t column = 0, row = 0;
    friend bool operator==(const Bin&, const Bin&) = default;
  };
  struct BinHash {
    std::size_t operator()(const Bin& bin) const;
  };
  struct Entry {
    ObjectId id = 0;
    PlaneBounds bounds;
  };
  void put(ObjectId id, const PlaneBounds& bounds);
  void take(ObjectId id, const PlaneBounds& bounds);

  std::unordered_map<Bin, std::vector<Entry>, BinHash> bins_;
  std::map<int, std::size_t> filled_;  ///< Bins that are not empty, by level.
};

/// Whether a place is on an object, as one points at things: within reach of what is drawn of it; of an area or outline
/// inside counts too.
[[nodiscard]] bool is_hit(const LabelObject& object,
                          const Eigen::Vector2d& point_in_enu_m,
                          double reach_m);

/// Those that are hit, top-most first.
[[nodiscard]] std::vector<ObjectId> objects_at(const LabelDocument& document,
                                               const ObjectIndex& index,
                                               const Eigen::Vector2d& point_in_enu_m,
                                               double reach_m);
/// Those that lie in a rectangle with all of their places, top-most first.
[[nodiscard]] std::vector<ObjectId> objects_within(const LabelDocument& document,
                                                   const ObjectIndex& index,
                                                   const PlaneBounds& box);

}  // namespace nadir
