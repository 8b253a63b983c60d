// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/run/run_options.h"

namespace nadir {

/// One option of the next run as a control needs it: everything comes from the one list of fields.
struct SettingRow {
  enum class Kind { kNumber, kWhole, kBigWhole, kSwitch, kChoice, kText };
  Kind kind = Kind::kNumber;
  std::string name, unit, help, range;
  std::string value;  ///< Of the draft, as text.
  std::string
      preset_value;  ///< Of the preset, or of the run whose options the draft's differ from.
  std::string base = "preset";  ///< Which of the two: "preset" or "run".
  std::string group;
  std::string no_effect;  ///< What keeps it from having any: "motion = scaled"; empty: it has one.
  bool is_of_start =
      false;  ///< It has one, but only on a run from the start: one from the cursor does not read it.
  double least = 0.0, most = 0.0;    ///< Of numbers; infinite where open.
  std::vector<std::string> choices;  ///< Of kChoice.
  [[nodiscard]] bool differs() const { return value != preset_value; }
};

/// Every option, in the order of the list. @param prior  How the run begins, as a run's header has it; empty: not known.
[[nodiscard]] std::vector<SettingRow> setting_rows(const RunOptions& draft,
                                                   const RunOptions& preset,
                                                   const std::string& prior = {});

/// Digits after the point that a control for a number shows: enough for its value and its preset's, and one to change.
[[nodiscard]] int setting_decimals(const SettingRow& row);
/// What an arrow key adds: a tenth of the leading digit's place of the preset's value, and at least what is shown.
[[nodiscard]] double setting_step(const SettingRow& row);
/// A number as set_option() takes it, without needless zeros: "0.05", "12000".
[[nodiscard]] std::string setting_text(double value, int decimals);

/// Why a text cannot be an option's value, with its range and unit; empty: it can.
[[nodiscard]] std::string why_refused(const SettingRow& row, const std::string& text);

/// Whether all words typed are in name, help, group or unit.
[[nodiscard]] bool fits_search(const SettingRow& row, std::string_view typed);

}  // namespace nadir
