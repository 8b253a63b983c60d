// SPDX-License-Identifier: Apache-2.0
#include "core/desk/coming_stroke.h"

#include <algorithm>
#include <utility>

#include "core/label/edit_paint.h"

namespace nadir {
namespace {

void join(LabelChanges& changes, const LabelChanges& more) {
  changes.is_everything |= more.is_everything;
  changes.parts.insert(changes.parts.end(), more.parts.begin(), more.parts.end());
}

}  // namespace

bool ComingStroke::goes_on(const Painted& wanted) const {
  return wanted.radius_m == painted_.radius_m && wanted.value == painted_.value &&
         wanted.places.size() >= painted_.places.size() &&
         std::equal(painted_.places.begin(), painted_.places.end(), wanted.places.begin());
}

void ComingStroke::paint(const Painted& wanted, std::size_t from) {
  if (from >= wanted.places.size()) return;
  // From the last place that was there already: a stroke is its legs.
  const auto first = wanted.places.begin() + static_cast<std::ptrdiff_t>(from > 0 ? from - 1 : 0);
  const LabelEdit edit =
      paint_stroke(*document_, Ring(first, wanted.places.end()), wanted.radius_m, wanted.value, {});
  painted_ = wanted;
  if (edit.empty()) return;
  auto painted = std::make_shared<LabelDocument>(*document_);
  painted->apply(edit);
  const LabelChanges changes{false, changed_parts(edit, painted->grid())};
  document_ = std::move(painted);
  join(of_stroke_, changes);
  join(new_, changes);
}

LabelChanges ComingStroke::follow(const LabelDesk& desk) {
  const LabelSheet& sheet = desk.sheet();
  const ToolKind kind = desk.tool().kind;
  const bool is_stroke =
      (kind == ToolKind::kBrush || kind == ToolKind::kEraser) && !desk.points().empty();
  Painted wanted;
  if (is_stroke) {
    wanted = {desk.points().ring(), brush_radius_m(desk.tool(), sheet.now().grid().metres_per_cell),
              paint_value(desk.tool())};
  }
  const bool is_base_new = document_ == nullptr || revision_ != sheet.revision();
  const bool was_stroke = !painted_.places.empty();
  if (is_base_new || (was_stroke && !(is_stroke && goes_on(wanted)))) {
    join(new_, document_ == nullptr ? LabelChanges{true, {}} : sheet.changed_since(revision_));
    join(new_, std::exchange(of_stroke_, {}));
    document_ = sheet.document();
    revision_ = sheet.revision();
    painted_ = {};
  }
  if (is_stroke) paint(wanted, painted_.places.size());
  return std::exchange(new_, {});
}

}  // namespace nadir
