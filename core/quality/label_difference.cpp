// SPDX-License-Identifier: Apache-2.0
#include "core/quality/label_difference.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/edit/edge_tree.h"
#include "core/quality/check_parts.h"

namespace nadir {
namespace {

/// Places that are no farther apart were not moved.
constexpr double kSamePlaceM = 1e-6;

/// By how much an object was moved as a whole; nothing where it was not, or was changed otherwise.
std::optional<Eigen::Vector2d> shift_of(const LabelObject& before, const LabelObject& after) {
  if (before.rings.size() != after.rings.size()) return std::nullopt;
  const Eigen::Vector2d shift = after.rings.front().front() - before.rings.front().front();
  for (std::size_t i = 0; i < before.rings.size(); ++i) {
    const Ring& was = before.rings[i];
    const Ring& is = after.rings[i];
    if (was.size() != is.size()) return std::nullopt;
    for (std::size_t j = 0; j < was.size(); ++j) {
      if ((is[j] - was[j] - shift).norm() > kSamePlaceM) return std::nullopt;
    }
  }
  return shift;
}

/// "120 m2" of an area, "35 m" of a line.
std::string extent_text(const LabelObject& object) {
  if (object.kind == ObjectKind::kLine) {
    return fmt::format("{} m", size_text(length_m(object.rings.front())));
  }
  double area = std::abs(signed_area_m2(object.rings.front()));
  for (std::size_t i = 1; i < object.rings.size(); ++i) {
    area -= std::abs(signed_area_m2(object.rings[i]));
  }
  return fmt::format("{} m2", size_text(std::abs(area)));
}

std::string kind_text(const LabelObject& object) {
  return fmt::format("{} {}", class_info(object.class_id).name, enum_name(object.kind));
}

void describe_shape(const LabelObject& before,
                    const LabelObject& after,
                    LabelDifference& difference,
                    std::vector<std::string>& words) {
  if (before.rings == after.rings) return;
  const auto shift = shift_of(before, after);
  if (shift && shift->norm() > kSamePlaceM) {
    difference.is_moved = true;
    words.push_back(fmt::format("moved by {} m", size_text(shift->norm())));
    return;
  }
  difference.is_reshaped = true;
  const std::string was = extent_text(before);
  const std::string is = extent_text(after);
  words.push_back(was == is ? "reshaped" : fmt::format("reshaped from {} to {}", was, is));
}

LabelDifference changed_object(const LabelObject& before, const LabelObject& after) {
  LabelDifference difference;
  difference.kind = DifferenceKind::kChanged;
  difference.object = after.id;
  difference.class_id = after.class_id;
  std::vector<std::string> words;
  if (before.class_id != after.class_id || before.kind != after.kind) {
    difference.is_reclassed = true;
    words.push_back(fmt::format("became {}", kind_text(after)));
  }
  describe_shape(before, after, difference, words);
  if (before.width_m != after.width_m) {
    difference.is_resized = true;
    words.push_back(fmt::format("is {} m wide instead of {} m", size_text(after.width_m),
                                size_text(before.width_m)));
  }
  // Another class has another level; only what somebody has done beside that is told.
  const std::int64_t rise = level_of_order(after.order) - level_of_order(before.order) -
                            (drawing_level(after.class_id) - drawing_level(before.class_id));
  if (before.order != after.order && (before.class_id == after.class_id || rise != 0)) {
    difference.is_reordered = true;
    words.emplace_back(before.order < after.order ? "was raised" : "was lowered");
  }
  if (before.note != after.note) {
    difference.is_renoted = true;
    words.emplace_back("has another note");
  }
  difference.sentence = named(before);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const char* const joint = i == 0 ? " " : i + 1 == words.size() ? " and " : ", ";
    difference.sentence += joint + words[i];
  }
  return difference;
}

LabelDifference object_difference(const ObjectChange& change) {
  if (change.before != nullptr && change.after != nullptr) {
    LabelDifference difference = changed_object(*change.before, *change.after);
    for (const auto& object : {change.before, change.after}) {
      const PlaneBounds bounds = drawn_bounds(*object);
      difference.bounds.include(bounds.low);
      difference.bounds.include(bounds.high);
    }
    return difference;
  }
  LabelDifference difference;
  const bool is_added = change.before == nullptr;
  const LabelObject& object = is_added ? *change.after : *change.before;
  difference.kind = is_added ? DifferenceKind::kAdded : DifferenceKind::kRemoved;
  difference.object = object.id;
  difference.class_id = object.class_id;
  difference.bounds = drawn_bounds(object);
  difference.sentence = fmt::format("{} of {} was {}", named(object), extent_text(object),
                                    is_added ? "drawn" : "deleted");
  return difference;
}

/// What cells have become: by class, then unclassified, then nothing.
using PaintCounts = std::array<std::int64_t, kClassCount + 2>;

std::string paint_text(const PaintCounts& counts) {
  std::vector<std::pair<std::int64_t, std::size_t>> most;
  std::int64_t all = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    all += counts.at(i);
    if (counts.at(i) > 0) most.emplace_back(-counts.at(i), i);
  }
  std::sort(most.begin(), most.end());
  std::string text = fmt::format("paint of {} cell{} changed: ", all, all == 1 ? "" : "s");
  for (std::size_t i = 0; i < most.size(); ++i) {
    const std::size_t id = most[i].second;
    text += fmt::format("{}{} {}", i > 0 ? ", " : "", -most[i].first,
                        id > kClassCount ? "erased" : class_info(static_cast<ClassId>(id)).name);
  }
  return text;
}

LabelDifference paint_difference(const TileChange& change, const LabelGrid& grid) {
  const auto value = [](const std::shared_ptr<const PaintTile>& tile, int column, int row) {
    return tile != nullptr ? tile->at(column, row) : kNoPaint;
  };
  PaintCounts counts{};
  CellRect cells;
  for (int row = 0; row < kPaintTileSide; ++row) {
    for (int column = 0; column < kPaintTileSide; ++column) {
      const PaintValue after = value(change.tile.after, column, row);
      if (after == value(change.tile.before, column, row)) continue;
      cells = cells.joined({column, row, column + 1, row + 1});
      ++counts.at(after == kNoPaint ? kClassCount + 1
                                    : std::min<std::size_t>(painted_class(after), kClassCount));
    }
  }
  const std::int64_t left = std::int64_t{change.address.column} * kPaintTileSide;
  const std::int64_t top = std::int64_t{change.address.row} * kPaintTileSide;
  LabelDifference difference;
  difference.kind = DifferenceKind::kPaint;
  difference.bounds = bounds_of_cells(
      grid, {cells.left + left, cells.top + top, cells.right + left, cells.bottom + top});
  difference.sentence = paint_text(counts);
  return difference;
}

LabelDifference value_difference(const ValueChange& change) {
  LabelDifference difference;
  difference.kind = DifferenceKind::kValue;
  difference.sentence = fmt::format("{} was {}", change.key,
                                    change.value.before == nullptr  ? "set"
                                    : change.value.after == nullptr ? "removed"
                                                                    : "changed");
  return difference;
}

}  // namespace

std::vector<LabelDifference> differences(const LabelDocument& from, const LabelDocument& to) {
  const LabelEdit edit = difference(from, to, {});
  std::vector<LabelDifference> all;
  all.reserve(edit.objects.size() + edit.tiles.size() + edit.values.size());
  for (const ObjectChange& change : edit.objects) all.push_back(object_difference(change));
  std::stable_sort(all.begin(), all.end(), [](const LabelDifference& a, const LabelDifference& b) {
    return a.object < b.object;
  });
  for (const TileChange& change : edit.tiles) all.push_back(paint_difference(change, from.grid()));
  for (const ValueChange& change : edit.values) all.push_back(value_difference(change));
  return all;
}

}  // namespace nadir
