// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <compare>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/field.h"
#include "core/base/progress.h"
#include "core/label/label_document.h"

namespace nadir {

/// Going through labels tile by tile. What somebody has said of each tile is kept in the document's values: "review" has the
/// side of the tiles in metres, "review COLUMN ROW" a state, who, when, a digest of the cells as they were, and a note. Marks are
/// made by edits, so that they are undone, journalled and shared like all else.

enum class ReviewState { kOpen, kDone, kToDo };
template <>
struct EnumNames<ReviewState> {
  static constexpr std::array<std::string_view, 3> kNames = {"open", "done", "to do"};
};

/// Counted from the upper left corner of the document's grid.
struct ReviewAddress {
  int column = 0, row = 0;
  friend auto operator<=>(const ReviewAddress&, const ReviewAddress&) = default;
};

struct ReviewMark {
  ReviewState state = ReviewState::kOpen;
  std::string author, time;  ///< Each one line; the time is UTC, ISO 8601.
  std::string digest;        ///< Of the tile's cells when it was marked.
  std::string note;
  friend bool operator==(const ReviewMark&, const ReviewMark&) = default;
};
[[nodiscard]] std::string review_text(const ReviewMark& mark);
/// Nothing where the text is none of review_text().
[[nodiscard]] std::optional<ReviewMark> review_mark_from(const std::string& text);

/// Side of the review's tiles; nothing where no review was begun.
[[nodiscard]] std::optional<double> review_side_m(const LabelDocument& document);
/// Begins a review, or one with tiles of another size, which forgets all marks.
/// @param side_m  In [1, 10000]. @errors kInvalidOptions.
[[nodiscard]] Result<LabelEdit> begin_review(const LabelDocument& document, double side_m);
/// @param state  kOpen takes a mark back. @errors kInvalidOptions: no review was begun; the tile has no cells.
[[nodiscard]] Result<LabelEdit> mark_tile(const LabelDocument& document,
                                          const ReviewAddress& tile,
                                          ReviewState state,
                                          const std::string& note,
                                          const std::string& author,
                                          const std::string& time);

struct ReviewTile {
  ReviewAddress address;
  PlaneBounds bounds;
  ReviewMark mark;
  bool is_stale = false;  ///< Done, but its cells have changed since.
  [[nodiscard]] bool is_open() const { return mark.state == ReviewState::kOpen || is_stale; }
};
/// The tiles over everything that is labelled, row by row from the north west. None where no review was begun.
struct ReviewMap {
  std::vector<ReviewTile> tiles;
  int columns = 0;
  /// Tiles that are done and not stale, by all; 0 where there are none.
  [[nodiscard]] double done_share() const;
  /// Null where the place is in none.
  [[nodiscard]] const ReviewTile* tile_at(const Eigen::Vector2d& place_in_enu_m) const;
  /// The next open tile after the one at a place, or nearest to it, along rows that are gone through to and fro from the north;
  /// after the last comes the first. Null where no other tile is open.
  [[nodiscard]] const ReviewTile* next_open(const Eigen::Vector2d& place_in_enu_m) const;
};
/// Draws the cells of all tiles that are done. @errors kCancelled; kInvalidOptions: more than a million tiles.
[[nodiscard]] Result<ReviewMap> review_map_of(const LabelDocument& document,
                                              const WorkContext& work = {});

}  // namespace nadir
