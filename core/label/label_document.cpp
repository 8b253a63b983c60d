// SPDX-License-Identifier: Apache-2.0
#include "core/label/label_document.h"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <utility>

#include "core/base/require.h"

namespace nadir {
namespace {

template <typename Map, typename Key>
auto found_in(const Map& map, const Key& key) -> typename Map::mapped_type {
  const auto found = map.find(key);
  return found == map.end() ? nullptr : found->second;
}

/// The same thing, or equal to it, or both none.
template <typename T>
bool is_same(const std::shared_ptr<const T>& a, const std::shared_ptr<const T>& b) {
  return a == b || (a != nullptr && b != nullptr && *a == *b);
}

tl::unexpected<Error> outdated(const LabelEdit& edit, const std::string& what) {
  return fail(ErrorCode::kInvalidOptions, "{}: {} has changed since",
              edit.title.empty() ? "edit" : edit.title, what);
}

tl::unexpected<Error> unsound(const LabelEdit& edit, const std::string& why) {
  return fail(ErrorCode::kMalformed, "{}: {}", edit.title.empty() ? "edit" : edit.title, why);
}

template <typename T>
void put(std::map<std::string, std::shared_ptr<const T>>& map,
         const std::string& key,
         const std::shared_ptr<const T>& value) {
  if (value == nullptr) {
    map.erase(key);
  } else {
    map[key] = value;
  }
}

bool is_near(const PaintAddress& address) {
  return std::abs(address.column) <= kMostPaintAddress &&
         std::abs(address.row) <= kMostPaintAddress;
}

Result<void> check_tile(const LabelEdit& edit, const TileChange& change) {
  if (!is_near(change.address)) return unsound(edit, "what is painted lies too far outside");
  if (change.tile.after == nullptr) return {};
  const auto& values = change.tile.after->values;
  if (!std::all_of(values.begin(), values.end(), is_paint_value)) {
    return unsound(edit, "what is painted is no class");
  }
  if (std::all_of(values.begin(), values.end(), [](PaintValue v) { return v == kNoPaint; })) {
    return unsound(edit, "a tile in which nothing is painted is none");
  }
  return {};
}

std::int64_t tile_of(std::int64_t cell) {
  return cell >= 0 ? cell / kPaintTileSide : -((-cell - 1) / kPaintTileSide) - 1;
}

/// Calls `take(key, change)` for what is not the same in two maps of shared things.
template <typename Key, typename T, typename Take>
void visit_differences(const std::map<Key, std::shared_ptr<const T>>& from,
                       const std::map<Key, std::shared_ptr<const T>>& to,
                       const Take& take) {
  for (const auto& [key, before] : from) {
    const std::shared_ptr<const T> after = found_in(to, key);
    if (!is_same(before, after)) take(key, Change<T>{before, after});
  }
  for (const auto& [key, after] : to) {
    if (from.count(key) == 0) take(key, Change<T>{nullptr, after});
  }
}

std::map<ObjectId, std::shared_ptr<const LabelObject>> objects_of(const LabelDocument& document) {
  std::map<ObjectId, std::shared_ptr<const LabelObject>> objects;
  for (const auto& [id, placed] : document.objects())
    objects.emplace_hint(objects.end(), id, placed.object);
  return objects;
}

}  // namespace

std::shared_ptr<const LabelObject> LabelDocument::object(ObjectId id) const {
  const auto found = objects_.find(id);
  return found == objects_.end() ? nullptr : found->second.object;
}

std::shared_ptr<const PaintTile> LabelDocument::tile(const PaintAddress& address) const {
  return found_in(paint_, address);
}

std::shared_ptr<const std::string> LabelDocument::value(const std::string& key) const {
  return found_in(values_, key);
}

PaintValue LabelDocument::paint_at(std::int64_t column, std::int64_t row) const {
  const std::int64_t tile_column = tile_of(column);
  const std::int64_t tile_row = tile_of(row);
  if (std::abs(tile_column) > kMostPaintAddress || std::abs(tile_row) > kMostPaintAddress) {
    return kNoPaint;
  }
  const auto found = paint_.find({static_cast<int>(tile_column), static_cast<int>(tile_row)});
  if (found == paint_.end()) return kNoPaint;
  return found->second->at(static_cast<int>(column - tile_column * kPaintTileSide),
                           static_cast<int>(row - tile_row * kPaintTileSide));
}

std::int64_t LabelDocument::next_order(ClassId id) const {
  const std::int64_t level = drawing_level(id);
  std::int64_t order = level * kOrdersPerLevel;
  for (const auto& [ignored, placed] : objects_) {
    if (level_of_order(placed.object->order) != level) continue;
    order = std::max(order, placed.object->order);
  }
  // Where somebody has raised something to the very top of a level, those that come next share its place.
  return std::min(order + kOrderStep, (level + 1) * kOrdersPerLevel - 1);
}

Result<void> LabelDocument::check(const LabelEdit& edit) const {
  std::set<ObjectId> ids;
  for (const auto& [before, after] : edit.objects) {
    if (before == nullptr && after == nullptr) return unsound(edit, "it changes nothing");
    const ObjectId id = after != nullptr ? after->id : before->id;
    if (before != nullptr && before->id != id) return unsound(edit, "it renumbers an object");
    if (!ids.insert(id).second) return unsound(edit, "it changes an object twice");
    if (!is_same(object(id), before)) return outdated(edit, fmt::format("object {}", id));
    if (after == nullptr) continue;
    if (const auto sound = check_object(*after); !sound) return forward_error(sound, edit.title);
  }
  std::set<PaintAddress> addresses;
  for (const TileChange& change : edit.tiles) {
    if (!addresses.insert(change.address).second) return unsound(edit, "it paints a tile twice");
    if (const auto sound = check_tile(edit, change); !sound) return forward_error(sound);
    if (!is_same(tile(change.address), change.tile.before)) return outdated(edit, "the paint");
  }
  std::set<std::string> keys;
  for (const ValueChange& change : edit.values) {
    if (!keys.insert(change.key).second) return unsound(edit, "it sets a value twice");
    if (!is_same(value(change.key), change.value.before)) return outdated(edit, change.key);
  }
  return {};
}

void LabelDocument::apply(const LabelEdit& edit) {
  for (const auto& [before, after] : edit.objects) {
    NADIR_REQUIRE(before != nullptr || after != nullptr);
    const ObjectId id = after != nullptr ? after->id : before->id;
    reserve_ids(id + 1);
    if (after == nullptr) {
      objects_.erase(id);
    } else {
      objects_[id] = {after, drawn_bounds(*after)};
    }
  }
  for (const TileChange& change : edit.tiles) {
    if (change.tile.after == nullptr) {
      paint_.erase(change.address);
    } else {
      paint_[change.address] = change.tile.after;
    }
  }
  for (const ValueChange& change : edit.values) put(values_, change.key, change.value.after);
}

void LabelDocument::reserve_ids(ObjectId id) { next_id_ = std::max(next_id_, id); }

bool operator==(const LabelDocument& a, const LabelDocument& b) {
  return a.plane_ == b.plane_ && a.grid_ == b.grid_ && difference(a, b, {}).empty();
}

LabelEdit difference(const LabelDocument& from, const LabelDocument& to, std::string title) {
  LabelEdit edit{.title = std::move(title), .objects = {}, .tiles = {}, .values = {}};
  visit_differences(objects_of(from), objects_of(to),
                    [&](ObjectId, const ObjectChange& change) { edit.objects.push_back(change); });
  visit_differences(from.paint(), to.paint(),
                    [&](const PaintAddress& address, const Change<PaintTile>& change) {
                      edit.tiles.push_back({address, change});
                    });
  visit_differences(from.values(), to.values(),
                    [&](const std::string& key, const Change<std::string>& change) {
                      edit.values.push_back({key, change});
                    });
  return edit;
}

}  // namespace nadir
