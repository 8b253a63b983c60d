// SPDX-License-Identifier: Apache-2.0
#include "core/desk/change_log.h"

namespace nadir {
namespace {

constexpr std::size_t kMostRemembered = 256;
/// Of one edit; more are told as one rectangle around them.
constexpr std::size_t kMostParts = 16;

void include(PlaneBounds& bounds, const PlaneBounds& other) {
  if (other.is_empty) return;
  bounds.include(other.low);
  bounds.include(other.high);
}

PlaneBounds bounds_of_tile(const PaintAddress& address, const LabelGrid& grid) {
  const Eigen::Vector2d corner(static_cast<double>(address.column) * kPaintTileSide,
                               static_cast<double>(address.row) * kPaintTileSide);
  PlaneBounds bounds;
  bounds.include(grid.enu_from_cells(corner));
  bounds.include(grid.enu_from_cells(corner + Eigen::Vector2d::Constant(kPaintTileSide)));
  return bounds;
}

}  // namespace

std::vector<PlaneBounds> changed_parts(const LabelEdit& edit, const LabelGrid& grid) {
  std::vector<PlaneBounds> parts;
  for (const auto& [before, after] : edit.objects) {
    PlaneBounds bounds;
    if (before != nullptr) include(bounds, drawn_bounds(*before));
    if (after != nullptr) include(bounds, drawn_bounds(*after));
    if (!bounds.is_empty) parts.push_back(bounds);
  }
  for (const TileChange& change : edit.tiles) parts.push_back(bounds_of_tile(change.address, grid));
  if (parts.size() <= kMostParts) return parts;
  PlaneBounds all;
  for (const PlaneBounds& part : parts) include(all, part);
  return {all};
}

void ChangeLog::add(const LabelEdit& edit, const LabelGrid& grid) {
  ++revision_;
  last_.push_back({false, changed_parts(edit, grid)});
  if (last_.size() > kMostRemembered) last_.pop_front();
}

void ChangeLog::add_everything() {
  ++revision_;
  last_.clear();
}

LabelChanges ChangeLog::since(std::int64_t revision) const {
  const std::int64_t missed = revision_ - revision;
  if (missed < 0 || missed > static_cast<std::int64_t>(last_.size())) return {true, {}};
  LabelChanges changes;
  for (auto entry = last_.end() - missed; entry != last_.end(); ++entry) {
    changes.parts.insert(changes.parts.end(), entry->parts.begin(), entry->parts.end());
  }
  return changes;
}

}  // namespace nadir
