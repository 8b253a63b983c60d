// SPDX-License-Identifier: Apache-2.0
#include "core/desk/label_desk.h"

#include <utility>

#include "core/desk/object_index.h"
#include "core/label/label_raster.h"

namespace nadir {

Result<LabelDesk> LabelDesk::open(const std::filesystem::path& named,
                                  const std::string& author,
                                  const LabelOpening& how) {
  auto sheet = LabelSheet::open(named, author, how);
  if (!sheet) return forward_error(sheet);
  return LabelDesk(std::move(*sheet));
}

Result<std::vector<std::string>> LabelDesk::poll() {
  const std::int64_t before = sheet_.revision();
  auto words = sheet_.poll();
  if (sheet_.revision() != before) follow_document();
  return words;
}

UnderPlace LabelDesk::under(const Eigen::Vector2d& point_in_enu_m) const {
  const LabelDocument& document = sheet_.now();
  const LabelGrid& grid = document.grid();
  UnderPlace found;
  const Eigen::Vector2d at = grid.cells_from_enu(point_in_enu_m);
  found.is_on_grid = at.x() >= 0.0 && at.y() >= 0.0 && at.x() < grid.width && at.y() < grid.height;
  const auto objects = objects_at(document, sheet_.objects(), point_in_enu_m, 0.0);
  if (!objects.empty()) found.object = objects.front();
  if (!found.is_on_grid) return found;
  const auto column = static_cast<std::int64_t>(at.x());
  const auto row = static_cast<std::int64_t>(at.y());
  found.class_id = rasterise(document, grid, {column, row, column + 1, row + 1}).at(0, 0);
  found.paint = document.paint_at(column, row);
  return found;
}

std::optional<std::string> LabelDesk::undo_title() const {
  if (!points_.empty()) return "Last place";
  if (image_tool_.is_told()) return "Last stroke";
  return sheet_.undo_title();
}

std::optional<std::string> LabelDesk::redo_title() const {
  if (points_.can_give_again()) return "Place";
  return points_.empty() && !image_tool_.is_told() ? sheet_.redo_title() : std::nullopt;
}

Result<void> LabelDesk::undo() {
  if (!points_.empty()) {
    // A stroke has places by the dozen, which nobody has put there one by one.
    if (draws_freely(tool_.kind)) {
      points_.clear();
    } else {
      points_.take_back();
    }
    return {};
  }
  if (image_tool_.is_told()) {
    image_tool_.take_back(tool_);
    return {};
  }
  auto undone = sheet_.undo();
  if (!undone) return undone;
  points_.clear();
  follow_document();
  return {};
}

Result<void> LabelDesk::redo() {
  if (points_.can_give_again()) {
    points_.give_again();
    return {};
  }
  if (!points_.empty() || image_tool_.is_told()) {
    return fail(ErrorCode::kInvalidOptions, "there is nothing to do again");
  }
  auto redone = sheet_.redo();
  if (redone) follow_document();
  return redone;
}

Result<void> LabelDesk::go_to(std::int64_t step) {
  auto gone = sheet_.go_to(step);
  follow_document();
  return gone;
}

Result<void> LabelDesk::commit(const LabelEdit& edit) { return take(edit, Chooses::kAsBefore); }

Result<void> LabelDesk::take(const Result<LabelEdit>& edit, Chooses chooses) {
  if (!edit) return forward_error(edit);
  if (auto done = sheet_.commit(*edit); !done) return done;
  if (edit->empty()) return {};
  if (chooses == Chooses::kWhatWasMade) {
    std::vector<ObjectId> made;
    for (const auto& [before, after] : edit->objects) {
      if (before == nullptr) made.push_back(after->id);
    }
    selection_.choose(made, SelectHow::kInstead);
  }
  follow_document();
  return {};
}

void LabelDesk::follow_document() {
  const LabelDocument& document = sheet_.now();
  selection_.follow(document);
  // A corner that is not where it was picked is another one.
  std::erase_if(picked_, [&](const PickedVertex& picked) {
    const auto object = document.object(picked.at.object);
    return object == nullptr || picked.at.ring >= object->rings.size() ||
           picked.at.place >= object->rings[picked.at.ring].size() ||
           object->rings[picked.at.ring][picked.at.place] != picked.in_enu_m;
  });
}

SharedBorders LabelDesk::shared() const {
  return tool_.shares_borders ? SharedBorders::kTogether : SharedBorders::kAlone;
}

Result<void> LabelDesk::needs_selection() const {
  if (!selection_.empty()) return {};
  return fail(ErrorCode::kInvalidOptions, "nothing is selected");
}

}  // namespace nadir
