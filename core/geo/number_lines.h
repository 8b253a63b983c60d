// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace nadir {

/// The numbers of one line of a text file. `values` lives until the next line is asked for.
struct NumberLine {
  std::size_t line =
      0;  ///< Counted from 1, blank lines and comments included, as an editor shows it.
  std::span<const double> values;
};

/// Walks over a text of numbers: trajectories, times, world files.
///
/// Numbers are separated by spaces or tabs and use a decimal point whatever the locale; `#` starts
/// a comment; blank lines, a byte order mark and line ends of Windows are skipped. O(text), no copy
/// of the text, which must outlive the walk.
class NumberLines {
 public:
  /// `name` stands for the file in messages.
  NumberLines(std::string_view text, std::string name);

  /// The next line that holds numbers, or nothing at the end.
  /// @errors kMalformed: a word that is not a number, NaN, infinity, a number too large for a
  /// double.
  [[nodiscard]] Result<std::optional<NumberLine>> next();

  /// Where a line is, for messages: "poses.txt: line 7".
  [[nodiscard]] std::string where(std::size_t line) const;

 private:
  [[nodiscard]] Result<void> read_values(std::string_view line);

  std::string_view rest_;
  std::string name_;
  std::size_t line_ = 0;
  std::vector<double> values_;
};

}  // namespace nadir
