// SPDX-License-Identifier: Apache-2.0
#include "core/desk/label_selection.h"

#include <algorithm>
#include <utility>

namespace nadir {

void LabelSelection::choose(std::span<const ObjectId> ids, SelectHow how) {
  if (how == SelectHow::kInstead) {
    ids_.clear();
    members_.clear();
  }
  std::set<ObjectId> leaving;
  for (const ObjectId id : ids) {
    const bool is_member = contains(id);
    if (is_member && how != SelectHow::kAdd && how != SelectHow::kInstead) {
      members_.erase(id);
      leaving.insert(id);
    } else if (!is_member && how != SelectHow::kRemove && leaving.count(id) == 0) {
      members_.insert(id);
      ids_.push_back(id);
    }
  }
  if (leaving.empty()) return;
  std::erase_if(ids_, [&](ObjectId id) { return leaving.count(id) > 0; });
}

void LabelSelection::follow(const LabelDocument& document) {
  std::erase_if(ids_, [&](ObjectId id) {
    if (document.object(id) != nullptr) return false;
    members_.erase(id);
    return true;
  });
}

std::optional<ObjectId> LabelSelection::next_of(std::span<const ObjectId> at_place,
                                                const Eigen::Vector2d& point_in_enu_m,
                                                double reach_m) {
  const bool is_same_place =
      last_place_in_enu_m_ && (*last_place_in_enu_m_ - point_in_enu_m).norm() <= reach_m;
  last_place_in_enu_m_ = point_in_enu_m;
  if (at_place.empty()) return std::nullopt;
  if (is_same_place && ids_.size() == 1) {
    const auto chosen = std::find(at_place.begin(), at_place.end(), ids_.front());
    if (chosen != at_place.end() && chosen + 1 != at_place.end()) return *(chosen + 1);
  }
  return at_place.front();
}

}  // namespace nadir
