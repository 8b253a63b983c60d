// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/edit/edge_tree.h"
#include "core/edit/edit_builder.h"
#include "core/edit/edit_objects.h"
#include "core/edit/polygon_algebra.h"

namespace nadir {
namespace {

/// Areas are equal when they differ by no more than rounding to the lattice may make of them.
bool is_equal_area(double a_m2, double b_m2) {
  return std::abs(a_m2 - b_m2) <= 1e-5 + 1e-9 * std::abs(a_m2);
}

Result<const LabelObject*> found_object(const LabelDocument& document, ObjectId id) {
  const auto found = selected_objects(document, std::span(&id, 1));
  if (!found) return forward_error(found);
  return found->front();
}

Result<const LabelObject*> found_area(const LabelDocument& document, ObjectId id) {
  auto found = found_object(document, id);
  if (found && !is_closed((*found)->kind)) {
    return fail(ErrorCode::kInvalidOptions, "{} is no area", object_name(**found));
  }
  return found;
}

/// Takes a region from an object, of which its pieces remain. Whether it changes anything.
Result<bool> take_from(EditBuilder& builder, const LabelObject& object, const Region& region) {
  if (!is_closed(object.kind)) {
    std::vector<std::vector<Ring>> outside;
    const CutLine done = cut(object.rings.front(), region);
    for (const CutLine::Piece& piece : done.pieces) {
      if (!piece.is_inside) outside.push_back({piece.places});
    }
    if (outside.size() == done.pieces.size()) return false;
    builder.replace(object.id, std::move(outside));
    return true;
  }
  const auto whole = region_of(object);
  if (!whole) return forward_error(whole, object_name(object));
  auto rest = without(*whole, region);
  if (!rest) return forward_error(rest, object_name(object));
  if (is_equal_area(area_m2(*whole), area_m2(*rest))) return false;
  std::stable_sort(rest->parts.begin(), rest->parts.end(),
                   [](const auto& a, const auto& b) { return area_m2({{a}}) > area_m2({{b}}); });
  builder.replace(object.id, std::move(rest->parts));
  return true;
}

/// Lines put together end to end; nothing where they are not one.
std::optional<Ring> one_line(std::vector<Ring> lines) {
  Ring line = std::move(lines.front());
  lines.erase(lines.begin());
  while (!lines.empty()) {
    bool has_grown = false;
    for (std::size_t i = 0; i < lines.size() && !has_grown; ++i) {
      Ring& next = lines[i];
      const bool is_at_end = next.front() == line.back() || next.back() == line.back();
      const bool is_at_begin = next.front() == line.front() || next.back() == line.front();
      if (!is_at_end && !is_at_begin) continue;
      has_grown = true;
      if (!is_at_end) std::reverse(line.begin(), line.end());
      if (next.front() != line.back()) std::reverse(next.begin(), next.end());
      line.insert(line.end(), next.begin() + 1, next.end());
      if (!is_at_end) std::reverse(line.begin(), line.end());
      lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(i));
    }
    if (!has_grown) return std::nullopt;
  }
  return line;
}

std::vector<std::vector<Ring>> lines_as_pieces(std::vector<Ring> lines) {
  std::vector<std::vector<Ring>> pieces;
  pieces.reserve(lines.size());
  for (Ring& line : lines) pieces.push_back({std::move(line)});
  return pieces;
}

}  // namespace

Result<LabelEdit> cut_hole(const LabelDocument& document, ObjectId object, Ring hole) {
  const auto area = found_area(document, object);
  if (!area) return forward_error(area);
  LabelObject as_area = **area;
  as_area.rings = {std::move(hole)};
  for (Eigen::Vector2d& place : as_area.rings.front()) place = on_lattice(place);
  if (const auto sound = check_object(as_area); !sound) return forward_error(sound, "Cut hole");
  const auto crossing = new_crossing(nullptr, as_area);
  if (!crossing) return forward_error(crossing, "Cut hole");
  if (*crossing) return fail(ErrorCode::kInvalidOptions, "Cut hole: the hole crosses itself");
  const auto whole = region_of(**area);
  if (!whole) return forward_error(whole, "Cut hole");
  const auto inner = region_of(as_area);
  if (!inner) return forward_error(inner, "Cut hole");
  auto rest = without(*whole, *inner);
  if (!rest) return forward_error(rest, "Cut hole");
  if (rest->parts.size() != 1 ||
      !is_equal_area(area_m2(*whole), area_m2(*rest) + area_m2(*inner))) {
    return fail(ErrorCode::kInvalidOptions, "Cut hole: the hole reaches out of {}",
                object_name(**area));
  }
  EditBuilder builder(document, "Cut hole");
  builder.replace(object, std::move(rest->parts));
  builder.share_new_places();
  return builder.edit();
}

Result<LabelEdit> split(const LabelDocument& document,
                        std::span<const ObjectId> objects,
                        const Ring& line) {
  const auto selected = selected_objects(document, objects);
  if (!selected) return forward_error(selected);
  EditBuilder builder(document, "Split");
  bool has_cut = false;
  for (const LabelObject* const object : *selected) {
    std::vector<std::vector<Ring>> pieces;
    if (is_closed(object->kind)) {
      const auto whole = region_of(*object);
      if (!whole) return forward_error(whole, object_name(*object));
      auto regions = split(*whole, std::span(&line, 1));
      if (!regions) return forward_error(regions, object_name(*object));
      if (regions->size() <= whole->parts.size()) continue;
      for (Region& region : *regions) pieces.push_back(std::move(region.parts.front()));
    } else {
      pieces = lines_as_pieces(cut(object->rings.front(), line));
      if (pieces.size() < 2) continue;
    }
    has_cut = true;
    builder.replace(object->id, std::move(pieces));
  }
  if (!has_cut) return fail(ErrorCode::kInvalidOptions, "the line does not cut across anything");
  builder.share_new_places();
  return builder.edit();
}

Result<LabelEdit> merge(const LabelDocument& document, std::span<const ObjectId> objects) {
  const auto selected = selected_objects(document, objects);
  if (!selected) return forward_error(selected);
  if (selected->size() < 2) {
    return fail(ErrorCode::kInvalidOptions, "there must be two objects or more to merge");
  }
  const LabelObject& first = *document.objects().at(objects.front()).object;
  std::vector<Region> regions;
  std::vector<Ring> lines{first.rings.front()};
  for (const LabelObject* const object : *selected) {
    if (object->kind != first.kind) {
      return fail(ErrorCode::kInvalidOptions, "{} and {} are not of one kind", object_name(first),
                  object_name(*object));
    }
    if (is_closed(first.kind)) {
      auto region = region_of(*object);
      if (!region) return forward_error(region, object_name(*object));
      regions.push_back(std::move(*region));
    } else if (object != &first) {
      lines.push_back(object->rings.front());
    }
  }
  std::vector<Ring> rings;
  if (is_closed(first.kind)) {
    auto all = united(regions);
    if (!all) return forward_error(all, "Merge");
    if (all->parts.size() == 1) rings = std::move(all->parts.front());
  } else if (auto line = one_line(std::move(lines))) {
    rings.push_back(std::move(*line));
  }
  if (rings.empty()) {
    return fail(ErrorCode::kInvalidOptions, "the {} objects do not all touch each other",
                selected->size());
  }
  EditBuilder builder(document, "Merge");
  for (const LabelObject* const object : *selected) {
    if (object != &first) builder.remove(object->id);
  }
  builder.change(first.id).rings = std::move(rings);
  builder.share_new_places();
  return builder.edit();
}

Result<LabelEdit> subtract(const LabelDocument& document, ObjectId from, ObjectId cut) {
  const auto object = found_object(document, from);
  if (!object) return forward_error(object);
  const auto other = found_object(document, cut);
  if (!other) return forward_error(other);
  if (from == cut) return fail(ErrorCode::kInvalidOptions, "an object cannot be cut by itself");
  const auto region = region_of(**other);
  if (!region) return forward_error(region, object_name(**other));
  EditBuilder builder(document, "Subtract");
  const auto has_cut = take_from(builder, **object, *region);
  if (!has_cut) return forward_error(has_cut);
  if (*has_cut) builder.share_new_places();
  return builder.edit();
}

Result<LabelEdit> clip(const LabelDocument& document, ObjectId object, ClipSide side) {
  const auto area = found_area(document, object);
  if (!area) return forward_error(area);
  const PlaneBounds bounds = drawn_bounds(**area);
  const std::int64_t level = level_of_order((*area)->order);
  std::vector<const LabelObject*> others;
  for (const auto& [id, placed] : document.objects()) {
    const LabelObject& other = *placed.object;
    const std::int64_t others_level = level_of_order(other.order);
    const bool counts = side == ClipSide::kThis ? others_level >= level : others_level <= level;
    if (id != object && counts && is_closed(other.kind) && do_meet(placed.bounds, bounds))
      others.push_back(&other);
  }
  EditBuilder builder(document, "Clip");
  bool has_cut = false;
  if (side == ClipSide::kThis) {
    std::vector<Region> regions;
    for (const LabelObject* const other : others) {
      auto region = region_of(*other);
      if (!region) return forward_error(region, object_name(*other));
      regions.push_back(std::move(*region));
    }
    const auto all = united(regions);
    if (!all) return forward_error(all, "Clip");
    const auto taken = take_from(builder, **area, *all);
    if (!taken) return forward_error(taken);
    has_cut = *taken;
  } else {
    const auto region = region_of(**area);
    if (!region) return forward_error(region, object_name(**area));
    for (const LabelObject* const other : others) {
      const auto taken = take_from(builder, *other, *region);
      if (!taken) return forward_error(taken);
      has_cut = has_cut || *taken;
    }
  }
  if (has_cut) builder.share_new_places();
  return builder.edit();
}

Result<LabelEdit> copy_beside(const LabelDocument& document, ObjectId object, double by_m) {
  const auto found = found_object(document, object);
  if (!found) return forward_error(found);
  if (!(std::abs(by_m) <= kMostObjectWidthM)) {
    return fail(ErrorCode::kInvalidOptions, "a distance of {} m is not in [-{:.0f}, {:.0f}]", by_m,
                kMostObjectWidthM, kMostObjectWidthM);
  }
  std::vector<std::vector<Ring>> pieces;
  if (is_closed((*found)->kind)) {
    const auto whole = region_of(**found);
    if (!whole) return forward_error(whole, object_name(**found));
    auto copy = grown(*whole, by_m);
    if (!copy) return forward_error(copy, object_name(**found));
    pieces = std::move(copy->parts);
  } else {
    auto lines = beside((*found)->rings.front(), by_m);
    if (!lines) return forward_error(lines, object_name(**found));
    pieces = lines_as_pieces(std::move(*lines));
  }
  if (pieces.empty()) {
    return fail(ErrorCode::kInvalidOptions, "nothing of {} is left {:.2f} m beside it",
                object_name(**found), by_m);
  }
  EditBuilder builder(document, "Copy beside");
  for (std::vector<Ring>& rings : pieces) {
    LabelObject copy = **found;
    copy.rings = std::move(rings);
    copy.order = builder.next_order(copy.class_id);
    builder.add(std::move(copy));
  }
  return builder.edit();
}

}  // namespace nadir
