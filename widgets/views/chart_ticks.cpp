// SPDX-License-Identifier: Apache-2.0
// Round values along an axis, and numbers in words.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "core/base/require.h"
#include "widgets/views/chart_axis.h"

namespace nadir {
namespace {

constexpr int kMostTicks = 8;
constexpr int kWantedTicks = 4;

/// tenths / 10 * 10^exponent, kept apart so that multiples have no rounding in them.
struct Step {
  int tenths = 10, exponent = 0;

  [[nodiscard]] int decimals() const { return std::max(0, (tenths == 25 ? 1 : 0) - exponent); }
  [[nodiscard]] double size() const { return multiple(1.0); }
  [[nodiscard]] double multiple(double n) const {
    const double power = std::pow(10.0, std::abs(exponent - 1));
    return exponent >= 1 ? n * tenths * power : n * tenths / power;
  }
};

std::string superscript(int number) {
  static constexpr std::array<std::string_view, 10> kDigits = {"⁰", "¹", "²", "³", "⁴",
                                                               "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string raised;
  for (const char letter : std::to_string(number)) {
    raised += letter == '-' ? "⁻" : kDigits.at(static_cast<std::size_t>(letter - '0'));
  }
  return raised;
}

/// With a true minus sign, which is as wide as a plus.
std::string fixed(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", std::abs(value), decimals);
  const bool is_zero = text.find_first_not_of("0.") == std::string::npos;
  return value < 0.0 && !is_zero ? "−" + text : text;
}

std::vector<std::string> labels_of(const std::vector<double>& ticks, const Step& step) {
  double largest = step.size();
  for (const double tick : ticks) largest = std::max(largest, std::abs(tick));
  const int magnitude = static_cast<int>(std::floor(std::log10(largest) + 1e-9));
  const int finest = step.exponent - (step.tenths == 25 ? 1 : 0);
  const bool is_short = magnitude <= 5 && step.decimals() <= 4;
  // Long numbers whose last digits matter, such as time stamps, are not shortened by powers either.
  const bool is_long_anyway = magnitude >= 0 && magnitude - finest > 4 && magnitude < 15;
  std::vector<std::string> labels;
  for (const double tick : ticks) {
    if (is_short || is_long_anyway) {
      labels.push_back(fixed(tick, step.decimals()));
    } else if (tick == 0.0) {
      labels.emplace_back("0");
    } else {
      const double mantissa = tick / std::pow(10.0, magnitude);
      labels.push_back(fixed(mantissa, std::max(0, magnitude - finest)) + "×10" +
                       superscript(magnitude));
    }
  }
  return labels;
}

Ticks ticks_at(const AxisRange& range, const Step& step) {
  Ticks ticks;
  const double first = std::ceil(range.low / step.size() - 1e-9);
  const double last = std::floor(range.high / step.size() + 1e-9);
  for (double n = first; n <= last; n += 1.0) {
    ticks.at.push_back(n == 0.0 ? 0.0 : step.multiple(n));
    if (ticks.at.size() > 3 * kMostTicks) break;  // too many anyway
  }
  ticks.labels = labels_of(ticks.at, step);
  // VTK leaves out a tick that rounding has put outside.
  for (double& tick : ticks.at) tick = std::clamp(tick, range.low, range.high);
  return ticks;
}

}  // namespace

Ticks round_ticks(const AxisRange& range, bool is_whole, const TicksFit& fit) {
  NADIR_REQUIRE(range.low < range.high);
  const int magnitude = static_cast<int>(std::floor(std::log10(range.span())));
  const bool no_parts = is_whole && range.span() >= 2.0;
  const auto is_good = [&fit](const Ticks& ticks) {
    return !ticks.at.empty() && ticks.at.size() <= kMostTicks && fit(ticks);
  };
  Ticks sparse;
  for (int exponent = magnitude - 2; exponent <= magnitude + 1; ++exponent) {
    if (no_parts && exponent < 0) continue;
    for (const int tenths : {10, 20, 50}) {
      Ticks ticks = ticks_at(range, {tenths, exponent});
      if (!ticks.at.empty() && ticks.at.size() <= kMostTicks) sparse = ticks;
      if (!is_good(ticks)) continue;
      if (tenths == 50 && ticks.at.size() < kWantedTicks && !(no_parts && exponent < 1)) {
        Ticks between = ticks_at(range, {25, exponent});
        if (between.at.size() > ticks.at.size() && is_good(between)) return between;
      }
      return ticks;
    }
  }
  // Not even two labels fit beside each other: one alone always does.
  if (sparse.at.size() > 1) {
    sparse.at.resize(1);
    sparse.labels.resize(1);
  }
  return sparse;
}

Ticks logarithmic_ticks(const AxisRange& range, const TicksFit& fit) {
  NADIR_REQUIRE(range.low > 0.0 && range.low < range.high);
  const double low = std::log10(range.low);
  const double high = std::log10(range.high);
  const auto ticks_with = [low, high](std::initializer_list<int> factors, int stride,
                                      int from = 0) {
    Ticks ticks;
    for (int power = static_cast<int>(std::floor(low)); power <= high + 1e-9; ++power) {
      if ((power - from) % stride != 0) continue;
      for (const int factor : factors) {
        const double at = power + std::log10(factor);
        if (at < low - 1e-9 || at > high + 1e-9) continue;
        ticks.at.push_back(std::clamp(at, low, high));
        ticks.labels.push_back(std::abs(power) <= 4
                                   ? fixed(factor * std::pow(10.0, power), std::max(0, -power))
                                   : (factor == 1 ? "" : std::to_string(factor) + "×") + "10" +
                                         superscript(power));
      }
    }
    return ticks;
  };
  Ticks ticks = ticks_with({1, 2, 5}, 1);
  if (ticks.at.size() <= kMostTicks && fit(ticks)) return ticks;
  // Between powers of ten, both ends have a tick.
  const int first = static_cast<int>(std::lround(low));
  const int last = static_cast<int>(std::lround(high));
  const bool has_round_ends = std::abs(low - first) < 1e-9 && std::abs(high - last) < 1e-9;
  for (int stride = 1; has_round_ends && stride <= last - first; ++stride) {
    if ((last - first) % stride != 0) continue;
    ticks = ticks_with({1}, stride, first);
    if (ticks.at.size() <= kMostTicks && fit(ticks)) return ticks;
  }
  for (int stride = 1; stride < 200; ++stride) {
    ticks = ticks_with({1}, stride);
    if (ticks.at.size() <= kMostTicks && fit(ticks)) break;
  }
  if (!ticks.at.empty()) return ticks;
  // No power of ten, and the others have no room beside each other: one alone has.
  ticks = ticks_with({1, 2, 5}, 1);
  if (ticks.at.size() > 1) {
    ticks.at.resize(1);
    ticks.labels.resize(1);
  }
  return ticks;
}

std::string short_number(double value) {
  NADIR_REQUIRE(value > 0.0 && is_drawable(value));
  constexpr double kPlain = 1e-3;
  constexpr double kPlainBelow = 99'999.5;
  const auto exponent_of = [](double number) {
    return static_cast<int>(std::floor(std::log10(number) + 1e-12));
  };
  if (value < kPlain || value >= kPlainBelow) {
    const int exponent = exponent_of(value);
    std::string mantissa = fixed(value * std::pow(10.0, -exponent), 1);
    if (mantissa == "10.0") return "1.0×10" + superscript(exponent + 1);
    return mantissa + "×10" + superscript(exponent);
  }
  const int digits = value < 0.1 ? 2 : 3;
  return fixed(value, std::max(0, digits - 1 - exponent_of(value)));
}

}  // namespace nadir
