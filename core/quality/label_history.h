// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/field.h"
#include "core/base/progress.h"
#include "core/label/label_store.h"

namespace nadir {

/// Who has done what when, and the document as it was at any step, without changing anything.

/// LabelStore::way() of the file that a document is in.
using LabelWay = std::function<Result<std::vector<LabelEdit>>(
    const LabelDocument& document, std::int64_t from, std::int64_t to)>;

/// A copy of a document that goes to and fro in its history. Going a few steps costs what their edits do.
class LabelReplay {
 public:
  /// @param step  At which the document stands; 0: the empty document. @param way  Must outlive the replay's use.
  LabelReplay(LabelDocument document, std::int64_t step, LabelWay way)
      : document_(std::move(document)), step_(step), way_(std::move(way)) {}

  [[nodiscard]] const LabelDocument& document() const { return document_; }
  [[nodiscard]] std::int64_t step() const { return step_; }
  /// @returns the edits that were done, for what has to be drawn again. @errors those of LabelStore::way(); then it stays.
  [[nodiscard]] Result<std::vector<LabelEdit>> go_to(std::int64_t step);

 private:
  LabelDocument document_;
  std::int64_t step_;
  LabelWay way_;
};

/// A step with what it touched.
struct HistoryEntry {
  LabelStep step;
  PlaneBounds
      bounds;  ///< Of what it drew, changed or took away; empty where that is nothing on the plane.
  int objects = 0;  ///< That it changed.
  int tiles = 0;    ///< Of paint.
};
/// Replays all steps, in the order in which they were made. @param replay  Goes through the history and comes to stand at the
/// last. @errors kCancelled; those of LabelReplay::go_to(). O(what all steps have changed).
[[nodiscard]] Result<std::vector<HistoryEntry>> history_entries(std::span<const LabelStep> steps,
                                                                LabelReplay& replay,
                                                                const WorkContext& work = {});

enum class HistoryGrouping {
  kSession,  ///< What one person did without a long pause.
  kDay,      ///< What everybody did in a day, UTC.
  kAuthor,   ///< What one person did at all.
};
template <>
struct EnumNames<HistoryGrouping> {
  static constexpr std::array<std::string_view, 3> kNames = {"session", "day", "author"};
};

struct HistoryGroup {
  std::vector<std::string> authors;                 ///< In the order in which they appear.
  std::string from_time, to_time;                   ///< Of the first and last step; UTC, ISO 8601.
  std::vector<std::size_t> entries;                 ///< By their place among the entries given.
  std::vector<std::pair<std::string, int>> titles;  ///< How often each was done, most often first.
  PlaneBounds bounds;
};
/// A longer pause begins another session.
inline constexpr double kSessionPauseMin = 30.0;
/// In the order of their first steps. @param entries  By time.
[[nodiscard]] std::vector<HistoryGroup> grouped(std::span<const HistoryEntry> entries,
                                                HistoryGrouping grouping,
                                                double pause_min = kSessionPauseMin);

}  // namespace nadir
