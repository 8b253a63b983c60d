// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "widgets/kit/ui_parts.h"

namespace nadir::kit {

/// How numbers of controls are written, read and rounded: what is shown is what is kept.

/// With the options' digits, without the unit; "-0.00" is "0.00", NaN "–".
[[nodiscard]] std::string digits_text(double value, const NumberOptions& options);
/// Rounded to the digits shown and clamped to the range.
[[nodiscard]] double kept_digits(double value, const NumberOptions& options);
/// One number with or without its unit ("0,85 m" too), clamped; what has more digits than are shown keeps them, for it was
/// asked for. Nothing where it is none.
[[nodiscard]] std::optional<double> read_number(const std::string& text,
                                                const NumberOptions& options);
/// The same, but nothing where it is out of range.
[[nodiscard]] std::optional<double> read_number_within(const std::string& text,
                                                       const NumberOptions& options);
/// What is wrong with a text that is being typed, in a word: "not a number", "at most 10.00 m". Empty where nothing is, or
/// nothing has been typed yet.
[[nodiscard]] std::string number_complaint(const std::string& text, const NumberOptions& options);
[[nodiscard]] double step_of(const NumberOptions& options);
/// The options' hint with unit and default.
[[nodiscard]] Hint number_hint(const NumberOptions& options);

}  // namespace nadir::kit
