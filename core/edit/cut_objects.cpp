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

/// Lines put together end to end, each in turn at the end of the first and then at its beginning; nothing where they are not
/// one. O(places).
std::optional<Ring> one_line(std::vector<Ring> lines) {
  PlaceMap<std::vector<std::size_t>> ends;
  for (std::size_t i = lines.size(); i-- > 1;) {
    ends[lines[i].front()].push_back(i);
    ends[lines[i].back()].push_back(i);
  }
  std::vector<bool> is_used(lines.size(), false);
  std::size_t used = 1;
  Ring line = std::move(lines.front());
  for (const bool is_end : {true, false}) {
    if (!is_end) std::reverse(line.begin(), line.end());
    for (auto at = ends.find(line.back()); at != ends.end(); at = ends.find(line.back())) {
      std::vector<std::size_t>& candidates = at->second;
      while (!candidates.empty() && is_used[candidates.back()]) candidates.pop_back();
      if (candidates.empty()) break;
      Ring& next = lines[candidates.back()];
      is_used[candidates.back()] = true;
      ++used;
      if (next.front() != line.back()) std::reverse(next.begin(), next.end());
      line.insert(line.end(), next.begin() + 1, next.end());
    }
    if (!is_end) std::reverse(line.begin(), line.end());
  }
  if (used < lines.size()) return std::nullopt;
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
