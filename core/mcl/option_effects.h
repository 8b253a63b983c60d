// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <span>
#include <string>
#include <string_view>

namespace nadir {

/// What a condition asks of a number.
inline constexpr std::string_view kAboveZero = "> 0";

/// How the value of "prior" begins for a run that goes on from a step of another one.
inline constexpr std::string_view kGoesOnPrior = "particles of step";

/// Another option has to be so.
struct EffectCondition {
  std::string_view option;  ///< Empty: no condition.
  std::string_view value;   ///< Its text, or kAboveZero.
};

/// "has effect when": an option that the filter does not read, or whose value changes nothing, unless one of the conditions
/// holds. An option with several rules needs all of them; one without any always has an effect.
struct EffectRule {
  std::string_view option;
  std::array<EffectCondition, 2> needs;
};

/// All rules, as the sources of the filter have them; a test runs the filter and holds them to it. Next to an option in
/// localiser_options.h that others can switch off stands a line here.
[[nodiscard]] std::span<const EffectRule> effect_rules();

/// What keeps an option from having any effect: "motion = scaled", "adapt-particles is off". Empty where it has one, or where
/// the values do not say.
/// @param values  Of options by name, as text; a run's header has them so, with how the run began as "prior".
[[nodiscard]] std::string why_no_effect(std::string_view option,
                                        const std::map<std::string, std::string>& values);

}  // namespace nadir
