// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/time_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace nadir {
namespace {

constexpr double kMinute = 60.0;

/// Distances between labels, each with the number of parts that small marks divide it into.
struct TickStep {
  double step_s;
  int parts;
};
constexpr std::array<TickStep, 22> kTickSteps = {
    {{0.01, 5},   {0.02, 4},   {0.05, 5},    {0.1, 5},    {0.2, 4},   {0.5, 5},
     {1.0, 5},    {2.0, 4},    {5.0, 5},     {10.0, 5},   {15.0, 3},  {30.0, 6},
     {60.0, 6},   {120.0, 4},  {300.0, 5},   {600.0, 5},  {900.0, 3}, {1800.0, 6},
     {3600.0, 6}, {7200.0, 4}, {21600.0, 6}, {86400.0, 4}}};

std::string tick_label(double moment_s, double step_s) {
  const int decimals = step_s >= 1.0 ? 0 : step_s >= 0.1 ? 1 : 2;
  const std::string sign = moment_s < -step_s / 2.0 ? "-" : "";
  const double size_s = std::abs(moment_s);
  const double minutes = std::floor((size_s + step_s / 4.0) / kMinute);
  const double seconds = std::max(0.0, size_s - minutes * kMinute);
  return fmt::format("{}{:.0f}:{:0{}.{}f}", sign, minutes, seconds,
                     decimals == 0 ? 2 : 3 + decimals, decimals);
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// A number of digits with at most one point; no sign, no exponent.
std::optional<double> plain_number(std::string_view text) {
  if (text.empty() || text.find_first_not_of("0123456789.") != std::string_view::npos)
    return std::nullopt;
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

double TimeAxis::seek_s(double at_px) const { return std::clamp(time_s(at_px), first_s, last_s); }

std::vector<TimeTick> time_ticks(const TimeAxis& axis, double least_px) {
  const auto wide = std::find_if(kTickSteps.begin(), kTickSteps.end(), [&](const TickStep& step) {
    return step.step_s * axis.px_per_s() >= least_px;
  });
  if (wide == kTickSteps.end()) return {};
  std::vector<TimeTick> ticks;
  const double part_s = wide->step_s / wide->parts;
  const double slack_s = part_s * 1e-6;
  const auto first = static_cast<long long>(std::ceil((axis.from_s - slack_s) / part_s));
  const auto last = static_cast<long long>(std::floor((axis.to_s + slack_s) / part_s));
  for (long long i = first; i <= last; ++i) {
    const double moment_s = static_cast<double>(i) * part_s;
    const bool is_labelled = i % wide->parts == 0;
    ticks.push_back({moment_s, is_labelled ? tick_label(moment_s, wide->step_s) : std::string()});
  }
  return ticks;
}

std::string clock_text(double moment_s) {
  if (!std::isfinite(moment_s)) return "--:--.-";
  const double tenths = std::round(std::abs(moment_s) * 10.0);
  const double minutes = std::floor(tenths / (10.0 * kMinute));
  const double seconds = (tenths - minutes * 10.0 * kMinute) / 10.0;
  return fmt::format("{}{:02.0f}:{:04.1f}", moment_s < 0.0 && tenths > 0.0 ? "-" : "", minutes,
                     seconds);
}

std::optional<double> parse_clock(std::string_view text) {
  text = trimmed(text);
  const bool is_negative = !text.empty() && text.front() == '-';
  if (is_negative) text.remove_prefix(1);
  if (!text.empty() && text.back() == 's') text = trimmed(text.substr(0, text.size() - 1));
  double whole_s = 0.0;
  for (int parts = 1;; ++parts) {
    const std::size_t colon = text.find(':');
    const auto part = plain_number(trimmed(text.substr(0, colon)));
    if (!part || parts > 3) return std::nullopt;
    whole_s = whole_s * kMinute + *part;
    if (colon == std::string_view::npos) break;
    text.remove_prefix(colon + 1);
  }
  return is_negative ? -whole_s : whole_s;
}

}  // namespace nadir
