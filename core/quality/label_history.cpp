// SPDX-License-Identifier: Apache-2.0
#include "core/quality/label_history.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <optional>

#include "core/label/label_raster.h"
#include "core/quality/check_parts.h"

namespace nadir {
namespace {

void include_box(PlaneBounds& bounds, const PlaneBounds& box) {
  if (box.is_empty) return;
  bounds.include(box.low);
  bounds.include(box.high);
}

/// What an edit touches on the plane.
PlaneBounds touched(const LabelEdit& edit, const LabelGrid& grid) {
  PlaneBounds bounds;
  for (const ObjectChange& change : edit.objects) {
    for (const auto& object : {change.before, change.after}) {
      if (object != nullptr) include_box(bounds, drawn_bounds(*object));
    }
  }
  for (const TileChange& change : edit.tiles) {
    const CellRect cells =
        changed_cells({.title = {}, .objects = {}, .tiles = {change}, .values = {}}, grid, grid);
    if (!cells.empty()) include_box(bounds, bounds_of_cells(grid, cells));
  }
  return bounds;
}

/// Minutes since 1970; nothing where the text is no time.
std::optional<double> minutes_of(const std::string& time) {
  int year = 0;
  unsigned month = 0;
  unsigned day = 0;
  int hour = 0;
  int minute = 0;
  double second = 0.0;
  if (std::sscanf(time.c_str(), "%d-%u-%uT%d:%d:%lfZ", &year, &month, &day, &hour, &minute,
                  &second) != 6) {
    return std::nullopt;
  }
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(month),
                                         std::chrono::day(day)};
  if (!date.ok()) return std::nullopt;
  const auto days = std::chrono::sys_days(date).time_since_epoch().count();
  return static_cast<double>(days) * 1440.0 + hour * 60.0 + minute + second / 60.0;
}

/// Finds the group that a step belongs to, or begins one.
class Grouper {
 public:
  Grouper(HistoryGrouping grouping, double pause_min)
      : grouping_(grouping), pause_min_(pause_min) {}

  void add(std::size_t number, const HistoryEntry& entry) {
    HistoryGroup& group = group_of(entry.step);
    if (group.entries.empty()) group.from_time = entry.step.time;
    group.to_time = entry.step.time;
    group.entries.push_back(number);
    include_box(group.bounds, entry.bounds);
    const std::string& author = entry.step.author;
    if (std::find(group.authors.begin(), group.authors.end(), author) == group.authors.end()) {
      group.authors.push_back(author);
    }
    const auto is_title = [&](const auto& title) { return title.first == entry.step.title; };
    const auto found = std::find_if(group.titles.begin(), group.titles.end(), is_title);
    if (found != group.titles.end()) {
      ++found->second;
    } else {
      group.titles.emplace_back(entry.step.title, 1);
    }
  }
  [[nodiscard]] std::vector<HistoryGroup> groups() && {
    for (HistoryGroup& group : groups_) {
      std::stable_sort(group.titles.begin(), group.titles.end(),
                       [](const auto& a, const auto& b) { return a.second > b.second; });
    }
    return std::move(groups_);
  }

 private:
  HistoryGroup& group_of(const LabelStep& step) {
    const std::string key =
        grouping_ == HistoryGrouping::kDay ? step.time.substr(0, 10) : step.author;
    const auto [found, is_first] = last_.try_emplace(key, groups_.size());
    const bool begins = is_first || (grouping_ == HistoryGrouping::kSession &&
                                     is_pause(groups_[found->second], step));
    if (begins) {
      found->second = groups_.size();
      groups_.emplace_back();
    }
    return groups_[found->second];
  }
  [[nodiscard]] bool is_pause(const HistoryGroup& group, const LabelStep& step) const {
    const auto before = minutes_of(group.to_time);
    const auto now = minutes_of(step.time);
    return !before || !now || *now - *before > pause_min_;
  }

  HistoryGrouping grouping_;
  double pause_min_;
  std::map<std::string, std::size_t> last_;  ///< Group of what was done last, by author or day.
  std::vector<HistoryGroup> groups_;
};

}  // namespace

Result<std::vector<LabelEdit>> LabelReplay::go_to(std::int64_t step) {
  auto edits = way_(document_, step_, step);
  if (!edits) return edits;
  for (const LabelEdit& edit : *edits) document_.apply(edit);
  step_ = step;
  return edits;
}

Result<std::vector<HistoryEntry>> history_entries(std::span<const LabelStep> steps,
                                                  LabelReplay& replay,
                                                  const WorkContext& work) {
  std::vector<HistoryEntry> entries;
  entries.reserve(steps.size());
  for (const LabelStep& step : steps) {
    if (work.is_stopped()) return fail(ErrorCode::kCancelled, "the history was stopped");
    work.report(static_cast<double>(entries.size()) / static_cast<double>(steps.size()),
                "Reading the history");
    if (replay.step() != step.parent) {
      if (const auto gone = replay.go_to(step.parent); !gone) return forward_error(gone);
    }
    const auto edits = replay.go_to(step.number);
    if (!edits) return forward_error(edits);
    HistoryEntry entry{step, {}, 0, 0};
    for (const LabelEdit& edit : *edits) {
      include_box(entry.bounds, touched(edit, replay.document().grid()));
      entry.objects += static_cast<int>(edit.objects.size());
      entry.tiles += static_cast<int>(edit.tiles.size());
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

std::vector<HistoryGroup> grouped(std::span<const HistoryEntry> entries,
                                  HistoryGrouping grouping,
                                  double pause_min) {
  Grouper grouper(grouping, pause_min);
  for (std::size_t i = 0; i < entries.size(); ++i) grouper.add(i, entries[i]);
  return std::move(grouper).groups();
}

}  // namespace nadir
