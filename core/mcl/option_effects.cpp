// SPDX-License-Identifier: Apache-2.0
#include "core/mcl/option_effects.h"

#include <charconv>
#include <optional>

namespace nadir {
namespace {

/// In the order of the field list.
constexpr std::array<EffectRule, 22> kEffectRules = {{
    {"min-particles", {{{"adapt-particles", "true"}}}},
    {"global-particles", {{{"prior", "global"}}}},
    {"adapt-particles", {{{"resample-below", kAboveZero}}}},
    {"kld-error", {{{"adapt-particles", "true"}}}},
    {"rotation-noise", {{{"motion", "thesis"}}}},
    {"translation-noise", {{{"motion", "thesis"}}}},
    {"position-noise", {{{"motion", "scaled"}}}},
    {"along-noise", {{{"motion", "scaled"}}}},
    {"across-noise", {{{"motion", "scaled"}}}},
    {"yaw-noise", {{{"motion", "scaled"}}}},
    {"turn-noise", {{{"motion", "scaled"}}}},
    {"truncation", {{{"match", "distance"}}}},
    {"gamma0", {{{"likelihood", "thesis"}}}},
    {"temperature", {{{"likelihood", "tempered"}}}},
    {"min-effective", {{{"likelihood", "tempered"}}}},
    {"full-evidence-area", {{{"likelihood", "tempered"}}}},
    {"evidence-spacing", {{{"likelihood", "tempered"}}}},
    {"standstill-evidence", {{{"likelihood", "tempered"}}}},
    {"standstill-evidence", {{{"evidence-spacing", kAboveZero}}}},
    {"resampling", {{{"resample-below", kAboveZero}}}},
    {"estimate-after-resampling", {{{"resample-below", kAboveZero}}}},
    {"blur-interval", {{{"blur-position", kAboveZero}, {"blur-yaw", kAboveZero}}}},
}};

std::optional<double> number_of(std::string_view text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end) return std::nullopt;
  return value;
}

/// How an option is, for people: "motion = scaled".
std::string as_it_is(std::string_view option, const std::string& value) {
  if (option == "prior") {
    return value.starts_with(kGoesOnPrior) ? "the run goes on with recorded particles"
                                           : "the start is known";
  }
  if (value == "false") return std::string(option) + " is off";
  if (value == "true") return std::string(option) + " is on";
  return std::string(option) + " = " + value;
}

/// Why a condition does not hold; empty: it does, or nobody knows.
std::string why_not(const EffectCondition& condition,
                    const std::map<std::string, std::string>& values) {
  // What has no effect itself lends none.
  if (std::string why = why_no_effect(condition.option, values); !why.empty()) return why;
  const auto found = values.find(std::string(condition.option));
  if (found == values.end()) return {};
  if (condition.value == kAboveZero) {
    const auto number = number_of(found->second);
    if (!number || *number > 0.0) return {};
  } else if (found->second == condition.value) {
    return {};
  }
  return as_it_is(condition.option, found->second);
}

std::string why_not(const EffectRule& rule, const std::map<std::string, std::string>& values) {
  std::string all;
  for (const EffectCondition& condition : rule.needs) {
    if (condition.option.empty()) continue;
    const std::string why = why_not(condition, values);
    if (why.empty()) return {};
    all += (all.empty() ? "" : " and ") + why;
  }
  return all;
}

}  // namespace

std::span<const EffectRule> effect_rules() { return kEffectRules; }

std::string why_no_effect(std::string_view option,
                          const std::map<std::string, std::string>& values) {
  for (const EffectRule& rule : kEffectRules) {
    if (rule.option != option) continue;
    if (std::string why = why_not(rule, values); !why.empty()) return why;
  }
  return {};
}

}  // namespace nadir
