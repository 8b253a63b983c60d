// SPDX-License-Identifier: Apache-2.0
#include "core/desk/object_index.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nadir {
namespace {

/// A centimetre to more than anything may measure.
constexpr int kFinestLevel = -7;
constexpr int kCoarsestLevel = 22;

int level_of_bounds(const PlaneBounds& bounds) {
  const double side_m = (bounds.high - bounds.low).maxCoeff();
  if (!(side_m > std::ldexp(1.0, kFinestLevel))) return kFinestLevel;
  return std::min(kCoarsestLevel, static_cast<int>(std::ceil(std::log2(side_m))));
}

struct BinRange {
  std::int64_t left, bottom, right, top;  ///< Both ends count.
  [[nodiscard]] double count() const {
    return static_cast<double>(right - left + 1) * static_cast<double>(top - bottom + 1);
  }
};

BinRange bins_of(const PlaneBounds& bounds, int level) {
  const auto whole = [level](double metres) {
    constexpr double kMost = 4e15;
    return static_cast<std::int64_t>(
        std::clamp(std::floor(std::ldexp(metres, -level)), -kMost, kMost));
  };
  return {whole(bounds.low.x()), whole(bounds.low.y()), whole(bounds.high.x()),
          whole(bounds.high.y())};
}

bool do_overlap(const PlaneBounds& a, const PlaneBounds& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

bool is_inside_rings(const std::vector<Ring>& rings, const Eigen::Vector2d& point) {
  bool is_inside = false;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0, before = ring.size() - 1; i < ring.size(); before = i++) {
      const Eigen::Vector2d& a = ring[before];
      const Eigen::Vector2d& b = ring[i];
      if ((a.y() <= point.y()) == (b.y() <= point.y())) continue;
      const double x = a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
      if (x > point.x()) is_inside = !is_inside;
    }
  }
  return is_inside;
}

double squared_distance_to_leg(const Eigen::Vector2d& point,
                               const Eigen::Vector2d& a,
                               const Eigen::Vector2d& b) {
  const Eigen::Vector2d leg = b - a;
  const double length = leg.squaredNorm();
  const double along = length > 0.0 ? std::clamp((point - a).dot(leg) / length, 0.0, 1.0) : 0.0;
  return (point - a - along * leg).squaredNorm();
}

bool is_near_rings(const LabelObject& object, const Eigen::Vector2d& point, double reach_m) {
  const bool is_closed = object.kind != ObjectKind::kLine;
  for (const Ring& ring : object.rings) {
    for (std::size_t i = is_closed ? 0 : 1; i < ring.size(); ++i) {
      const Eigen::Vector2d& before = i > 0 ? ring[i - 1] : ring.back();
      if (squared_distance_to_leg(point, before, ring[i]) <= reach_m * reach_m) return true;
    }
  }
  return false;
}

void sort_from_top(const LabelDocument& document, std::vector<ObjectId>& ids) {
  std::vector<std::pair<std::int64_t, ObjectId>> ranked;
  ranked.reserve(ids.size());
  for (const ObjectId id : ids) ranked.emplace_back(document.object(id)->order, id);
  std::sort(ranked.rbegin(), ranked.rend());
  for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = ranked[i].second;
}

}  // namespace

std::size_t ObjectIndex::BinHash::operator()(const Bin& bin) const {
  auto mixed = static_cast<std::uint64_t>(bin.column) * 0x9E3779B97F4A7C15ULL;
  mixed = (mixed ^ static_cast<std::uint64_t>(bin.row)) * 0xC2B2AE3D27D4EB4FULL;
  mixed = (mixed ^ static_cast<std::uint64_t>(bin.level)) * 0x165667B19E3779F9ULL;
  return static_cast<std::size_t>(mixed ^ (mixed >> 29U));
}

ObjectIndex::ObjectIndex(const LabelDocument& document) {
  for (const auto& [id, placed] : document.objects()) put(id, placed.bounds);
}

void ObjectIndex::apply(const LabelEdit& edit) {
  for (const auto& [before, after] : edit.objects) {
    if (before != nullptr) take(before->id, drawn_bounds(*before));
    if (after != nullptr) put(after->id, drawn_bounds(*after));
  }
}

void ObjectIndex::put(ObjectId id, const PlaneBounds& bounds) {
  const int level = level_of_bounds(bounds);
  const BinRange range = bins_of(bounds, level);
  for (std::int64_t row = range.bottom; row <= range.top; ++row) {
    for (std::int64_t column = range.left; column <= range.right; ++column) {
      std::vector<Entry>& bin = bins_[{level, column, row}];
      if (bin.empty()) ++filled_[level];
      bin.push_back({id, bounds});
    }
  }
}

void ObjectIndex::take(ObjectId id, const PlaneBounds& bounds) {
  const int level = level_of_bounds(bounds);
  const BinRange range = bins_of(bounds, level);
  for (std::int64_t row = range.bottom; row <= range.top; ++row) {
    for (std::int64_t column = range.left; column <= range.right; ++column) {
      const auto bin = bins_.find({level, column, row});
      if (bin == bins_.end()) continue;
      const auto of_id = [id](const Entry& entry) { return entry.id == id; };
      std::erase_if(bin->second, of_id);
      if (!bin->second.empty()) continue;
      bins_.erase(bin);
      if (--filled_[level] == 0) filled_.erase(level);
    }
  }
}

std::vector<ObjectId> ObjectIndex::near(const PlaneBounds& box) const {
  std::vector<ObjectId> found;
  if (box.is_empty || !box.low.allFinite() || !box.high.allFinite()) return found;
  const auto look_in = [&](const std::vector<Entry>& bin) {
    for (const Entry& entry : bin) {
      if (do_overlap(entry.bounds, box)) found.push_back(entry.id);
    }
  };
  double to_look_at = 0.0;
  for (const auto& [level, count] : filled_) to_look_at += bins_of(box, level).count();
  if (to_look_at > static_cast<double>(bins_.size())) {
    for (const auto& [place, bin] : bins_) look_in(bin);
  } else {
    for (const auto& [level, count] : filled_) {
      const BinRange range = bins_of(box, level);
      for (std::int64_t row = range.bottom; row <= range.top; ++row) {
        for (std::int64_t column = range.left; column <= range.right; ++column) {
          const auto bin = bins_.find({level, column, row});
          if (bin != bins_.end()) look_in(bin->second);
        }
      }
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

bool is_hit(const LabelObject& object, const Eigen::Vector2d& point_in_enu_m, double reach_m) {
  if (object.kind == ObjectKind::kLine) {
    return is_near_rings(object, point_in_enu_m, std::max(reach_m, object.width_m / 2.0));
  }
  return is_inside_rings(object.rings, point_in_enu_m) ||
         is_near_rings(object, point_in_enu_m, reach_m);
}

std::vector<ObjectId> objects_at(const LabelDocument& document,
                                 const ObjectIndex& index,
                                 const Eigen::Vector2d& point_in_enu_m,
                                 double reach_m) {
  PlaneBounds box;
  box.include(point_in_enu_m);
  box.grow(reach_m);
  std::vector<ObjectId> found = index.near(box);
  std::erase_if(
      found, [&](ObjectId id) { return !is_hit(*document.object(id), point_in_enu_m, reach_m); });
  sort_from_top(document, found);
  return found;
}

std::vector<ObjectId> objects_within(const LabelDocument& document,
                                     const ObjectIndex& index,
                                     const PlaneBounds& box) {
  std::vector<ObjectId> found = index.near(box);
  std::erase_if(found, [&](ObjectId id) {
    const std::vector<Ring>& rings = document.object(id)->rings;
    return !std::all_of(rings.begin(), rings.end(), [&](const Ring& ring) {
      return std::all_of(ring.begin(), ring.end(), [&](const Eigen::Vector2d& place) {
        return (place.array() >= box.low.array()).all() &&
               (place.array() <= box.high.array()).all();
      });
    });
  });
  sort_from_top(document, found);
  return found;
}

}  // namespace nadir
