// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/label/label_object.h"
#include "core/label/label_paint.h"

namespace nadir {

/// What one thing was and what it becomes; null: there is none. Never null both.
template <typename T>
struct Change {
  std::shared_ptr<const T> before, after;
};

/// Both have the same id.
using ObjectChange = Change<LabelObject>;

struct TileChange {
  PaintAddress address;
  Change<PaintTile> tile;  ///< A tile in which nothing is painted is none.
};

/// Something that a document knows beside what is drawn: its images, their offsets, control points, review marks.
struct ValueChange {
  std::string key;
  Change<std::string> value;
};

/// Everything that one gesture changes. The only way to change a document, what the journal keeps, and what has to be drawn
/// again; the difference of two documents is one too. Each object, tile and value at most once.
struct LabelEdit {
  std::string title;  ///< For menus and history: "Draw road".
  std::vector<ObjectChange> objects;
  std::vector<TileChange> tiles;
  std::vector<ValueChange> values;

  [[nodiscard]] bool empty() const { return objects.empty() && tiles.empty() && values.empty(); }
};

/// What takes it back.
[[nodiscard]] inline LabelEdit reversed(LabelEdit edit) {
  for (ObjectChange& change : edit.objects) std::swap(change.before, change.after);
  for (TileChange& change : edit.tiles) std::swap(change.tile.before, change.tile.after);
  for (ValueChange& change : edit.values) std::swap(change.value.before, change.value.after);
  return edit;
}

}  // namespace nadir
