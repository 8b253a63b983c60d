// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/setting_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>

#include "core/mcl/option_effects.h"
#include "widgets/panels/panel_text.h"

namespace nadir {
namespace {

/// Options come in groups; each begins with one of these. An option that is new stays in the group of those before it.
struct SettingGroup {
  std::string_view first, title;
};
constexpr std::array<SettingGroup, 5> kSettingGroups = {{{"seed", "Particles"},
                                                         {"motion", "Motion"},
                                                         {"min-update-interval", "Matching"},
                                                         {"resampling", "Resampling and blur"},
                                                         {"min-votes", "Topview"}}};

double number_in(const std::string& text) {
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// Digits after the point of "0.0125" (4) or "1e-06" (6).
int decimals_in(const std::string& text) {
  const std::size_t exponent_at = text.find('e');
  const std::string digits = text.substr(0, exponent_at);
  const std::size_t point = digits.find('.');
  int decimals = point == std::string::npos ? 0 : static_cast<int>(digits.size() - point - 1);
  if (exponent_at != std::string::npos) {
    int exponent = 0;
    std::string_view rest = std::string_view(text).substr(exponent_at + 1);
    if (rest.starts_with('+')) rest.remove_prefix(1);
    std::from_chars(rest.data(), rest.data() + rest.size(), exponent);
    decimals -= exponent;
  }
  return std::max(decimals, 0);
}

template <typename T>
void describe_value(SettingRow& row, const T& value, const Field& field) {
  row.value = detail::value_text(value);
  row.least = field.minimum;
  row.most = field.maximum;
  if constexpr (std::is_same_v<T, bool>) {
    row.kind = SettingRow::Kind::kSwitch;
  } else if constexpr (std::is_enum_v<T>) {
    row.kind = SettingRow::Kind::kChoice;
    for (const std::string_view name : EnumNames<T>::kNames) row.choices.emplace_back(name);
  } else if constexpr (OwnText<T>) {
    row.kind = SettingRow::Kind::kText;
  } else if constexpr (std::is_integral_v<T>) {
    // More digits than a double holds are typed as text.
    row.kind = sizeof(T) > sizeof(int) ? SettingRow::Kind::kBigWhole : SettingRow::Kind::kWhole;
    row.least = std::max(row.least, static_cast<double>(std::numeric_limits<T>::lowest()));
    row.most = std::min(row.most, static_cast<double>(std::numeric_limits<T>::max()));
  } else {
    row.kind = SettingRow::Kind::kNumber;
  }
}

}  // namespace

std::vector<SettingRow> setting_rows(const RunOptions& draft,
                                     const RunOptions& preset,
                                     const std::string& prior) {
  const std::vector<OptionText> texts = option_texts(draft);
  std::map<std::string, std::string> values;
  for (const OptionText& text : texts) values[text.name] = text.value;
  if (!prior.empty()) values["prior"] = prior;
  std::map<std::string, std::string> of_cursor = values;
  of_cursor["prior"] = kGoesOnPrior;
  const std::vector<OptionText> preset_texts = option_texts(preset);
  std::vector<SettingRow> rows;
  rows.reserve(texts.size());
  std::string group;
  visit_fields(draft, [&](const auto& value, const Field& field) {
    const OptionText& text = texts[rows.size()];
    SettingRow row;
    row.name = text.name;
    row.unit = text.unit;
    row.help = text.help;
    row.range = text.range;
    row.preset_value = preset_texts[rows.size()].value;
    const auto begins =
        std::find_if(kSettingGroups.begin(), kSettingGroups.end(),
                     [&](const SettingGroup& one) { return one.first == text.name; });
    if (begins != kSettingGroups.end()) group = begins->title;
    row.group = group;
    row.no_effect = why_no_effect(row.name, values);
    // Only where it is known that the start reads it.
    row.is_of_start =
        !prior.empty() && row.no_effect.empty() && !why_no_effect(row.name, of_cursor).empty();
    describe_value(row, value, field);
    rows.push_back(std::move(row));
  });
  return rows;
}

int setting_decimals(const SettingRow& row) {
  if (row.kind != SettingRow::Kind::kNumber) return 0;
  const int shown = std::max(decimals_in(row.value), decimals_in(row.preset_value));
  // Another digit for what is small, so that a drag of it has somewhere to go.
  const double size = std::abs(number_in(row.preset_value));
  const int wanted = size > 0.0 ? 1 - static_cast<int>(std::floor(std::log10(size))) : 2;
  return std::clamp(std::max(shown, wanted), 1, 8);
}

double setting_step(const SettingRow& row) {
  const double shown = std::pow(10.0, -setting_decimals(row));
  const double size = std::abs(number_in(row.preset_value));
  if (!(size > 0.0)) return shown;
  return std::max(shown, std::pow(10.0, std::floor(std::log10(size)) - 1.0));
}

std::string setting_text(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string why_refused(const SettingRow& row, const std::string& text) {
  RunOptions options;
  const auto set = set_option(options, row.name, text);
  if (set) return {};
  std::string_view why = set.error().message;
  for (const std::string& before : {"--" + row.name + ": ", row.name + ": "}) {
    if (why.starts_with(before)) why.remove_prefix(before.size());
  }
  const std::string unit = row.unit.empty() ? std::string() : " " + row.unit;
  return fmt::format("{}{}. The run keeps {}{}.", why, unit, row.value, unit);
}

bool fits_search(const SettingRow& row, std::string_view typed) {
  return has_words(fmt::format("{} {} {} {}", row.name, row.help, row.group, row.unit), typed);
}

}  // namespace nadir
