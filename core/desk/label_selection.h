// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>
#include <span>
#include <vector>

#include "core/desk/select_how.h"
#include "core/label/label_document.h"

namespace nadir {

/// Objects that were chosen, in the order of choosing.
class LabelSelection {
 public:
  [[nodiscard]] const std::vector<ObjectId>& ids() const { return ids_; }
  [[nodiscard]] bool empty() const { return ids_.empty(); }
  [[nodiscard]] bool contains(ObjectId id) const { return members_.count(id) > 0; }

  void choose(std::span<const ObjectId> ids, SelectHow how);
  void clear() { choose({}, SelectHow::kInstead); }
  /// Objects that are not there any more are not chosen either.
  void follow(const LabelDocument& document);

  /// Of what lies at a place, top-most first: the first, or, where one of them alone is chosen and was chosen at that place,
  /// the one below it. Nothing where nothing lies there.
  [[nodiscard]] std::optional<ObjectId> next_of(std::span<const ObjectId> at_place,
                                                const Eigen::Vector2d& point_in_enu_m,
                                                double reach_m);

 private:
  std::vector<ObjectId> ids_;
  std::set<ObjectId> members_;
  std::optional<Eigen::Vector2d> last_place_in_enu_m_;
};

}  // namespace nadir
