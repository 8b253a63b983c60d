// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "core/label/label_document.h"

namespace nadir {

/// What of a document is not any more what it was.
struct LabelChanges {
  bool is_everything = false;
  /// Rectangles in enu that hold all of it. What they draw may reach half a cell of the drawing farther.
  std::vector<PlaneBounds> parts;
  [[nodiscard]] bool empty() const { return !is_everything && parts.empty(); }
};

/// Remembers the last edits of a document, for views that draw again only what they must. Revisions count the edits.
class ChangeLog {
 public:
  [[nodiscard]] std::int64_t revision() const { return revision_; }
  void add(const LabelEdit& edit, const LabelGrid& grid);
  void add_everything();
  /// Everything where that is too long ago, or lies in the future.
  [[nodiscard]] LabelChanges since(std::int64_t revision) const;

 private:
  std::int64_t revision_ = 1;
  std::deque<LabelChanges> last_;  ///< The newest at the back.
};

/// Rectangles in enu of what an edit changes: one a thing while they are few.
[[nodiscard]] std::vector<PlaneBounds> changed_parts(const LabelEdit& edit, const LabelGrid& grid);

}  // namespace nadir
