// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "core/session/run_comparison.h"
#include "widgets/kit/ui.h"

namespace nadir {

/// Before the best of a row, which is also green: not everybody sees that.
inline constexpr const char* kBestMark = "•";

/// Some of the compared runs, as many as have room beside each other, and what stands above their columns.
struct RunColumns {
  std::size_t first = 0, end = 0;  ///< Places in RunsState::numbers.
  double width = 0.0;
  std::vector<kit::Column> columns;  ///< The first one is of the rows' names.
};

/// Where tables of all runs are broken, kept while their room stays.
struct BrokenColumns {
  double widest = 0.0, names = 0.0;  ///< Of the values and of the rows' names, pixels.
  double room = -1.0;                ///< That `parts` were made for.
  std::vector<RunColumns> parts;
};

/// A row of ShownMetric.
struct MetricTexts {
  std::vector<std::string> digits;  ///< One a run, the best ones marked; empty: not known.
  std::vector<bool> is_best;
  bool is_shared = false;  ///< Several are the best.
  bool is_there = false;   ///< False: the comparison knows no such number.
};

/// Settings that differ: numbers and names in columns, and what no column has room for in words.
struct SettingTexts {
  std::vector<SettingDifference> in_columns, in_words;
  BrokenColumns columns;
};

/// What the tables of the runs panel say, and how wide that is. Words are dear to make and to measure, and the same from frame to
/// frame: made anew for another comparison, other names, or another size of text.
struct RunTableTexts {
  // What it was made for.
  std::uint64_t revision = 0;
  std::vector<std::string> names;
  std::set<std::string> live;
  double px = 0.0;

  std::vector<std::string> titles;   ///< The names without what they have in common.
  std::string span, copied;          ///< Of span_words() and copied_words().
  std::vector<MetricTexts> metrics;  ///< As shown_metrics().
  BrokenColumns metric_columns;
  SettingTexts settings, idle_settings;
};

/// Makes them anew where that is needed.
/// @param revision  Of the comparison, not 0: another one for another comparison.
/// @param runs   As compared. @param names  Of them. @param live  Those of them that this program is making, by name.
void renew_table_texts(RunTableTexts& texts,
                       const kit::Ui& ui,
                       std::uint64_t revision,
                       const RunComparison& comparison,
                       RunDocuments runs,
                       std::vector<std::string> names,
                       std::set<std::string> live);

/// Parts that fit the current room: all runs in one where they do; no value is cut.
[[nodiscard]] const std::vector<RunColumns>& parts_for(BrokenColumns& broken,
                                                       const kit::Ui& ui,
                                                       const RunTableTexts& texts,
                                                       kit::Align align);

/// "along-noise [m/m]".
[[nodiscard]] std::string label_of_setting(const SettingDifference& setting);

}  // namespace nadir
