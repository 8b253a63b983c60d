// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/chart_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "core/base/require.h"

namespace nadir {
namespace {

constexpr double kLargest = 1e100;
constexpr double kLeastSpan =
    1e-9;  ///< Of an axis, as a share of its values: below, doubles run out of digits.
constexpr double kYMargin = 0.05;
constexpr int kMostTicks = 8;
constexpr int kWantedTicks = 4;

/// The range of what it has seen.
class Extent {
 public:
  void include(double value) {
    if (!is_drawable(value)) return;
    low_ = std::min(low_, value);
    high_ = std::max(high_, value);
  }
  [[nodiscard]] bool is_empty() const { return low_ > high_; }
  [[nodiscard]] AxisRange range() const { return {low_, high_}; }

 private:
  double low_ = std::numeric_limits<double>::infinity();
  double high_ = -std::numeric_limits<double>::infinity();
};

/// Opens a range that is too short to be drawn, around its middle; around 0 to one side.
AxisRange opened(AxisRange range) {
  const double magnitude = std::max(std::abs(range.low), std::abs(range.high));
  if (magnitude < 1.0 / kLargest) return {0.0, 1.0};
  if (range.span() > kLeastSpan * magnitude) return range;
  return {range.low - 0.1 * magnitude, range.high + 0.1 * magnitude};
}

/// Puts the ends in place that were asked for; the other end gives way where the data lie beyond.
AxisRange with_asked_ends(AxisRange fitted, const AxisSpec& asked) {
  NADIR_REQUIRE(!asked.low || is_drawable(*asked.low));
  NADIR_REQUIRE(!asked.high || is_drawable(*asked.high));
  NADIR_REQUIRE(!asked.low || !asked.high || *asked.low < *asked.high);
  const double length = fitted.span();
  if (asked.low) fitted.low = *asked.low;
  if (asked.high) fitted.high = *asked.high;
  if (!(fitted.low < fitted.high)) {
    if (asked.low) {
      fitted.high = fitted.low + length;
    } else {
      fitted.low = fitted.high - length;
    }
  }
  return opened(fitted);
}

bool is_logarithmic(const ChartSpec& spec) { return spec.bars && spec.bars->is_logarithmic; }

/// Of everything that is drawn between the ends of the x axis.
Extent y_extent(const ChartSpec& spec) {
  Extent extent;
  const AxisRange shown = x_range_of(spec);
  const auto is_shown = [&shown](double x) { return shown.low <= x && x <= shown.high; };
  const auto include = [&extent, above_0 = is_logarithmic(spec)](double value) {
    if (!above_0 || value > 0.0) extent.include(value);
  };
  for (const LineSpec& line : spec.lines) {
    for (std::size_t i = 0; i < line.y.size(); ++i) {
      if (is_shown(line.x.at(i))) include(line.y[i]);
    }
  }
  for (const BandSpec& band : spec.bands) {
    for (std::size_t i = 0; i < band.x.size(); ++i) {
      if (!is_shown(band.x[i])) continue;
      include(band.low.at(i));
      include(band.high.at(i));
    }
  }
  for (const LevelSpec& level : spec.levels) include(level.y);
  if (spec.bars) {
    for (const BarsSpec::Series& series : spec.bars->series) {
      for (const double height : series.heights) include(height);
    }
    include(0.0);
  }
  return extent;
}

AxisRange fitted_logarithmic(const Extent& extent) {
  if (extent.is_empty()) return {0.1, 10.0};
  const double low = std::log10(extent.range().low);
  const double high = std::log10(extent.range().high);
  double floor = std::floor(low);
  if (low - floor < 0.1) floor -= 1.0;  // else the lowest bar would have no height
  // The next power of ten, so that a tick is above the highest bar too, with room for its value.
  constexpr double kRoomAbove = 0.08;
  const double ceiling = std::ceil(high + kRoomAbove * std::max(1.0, high - floor));
  return {std::pow(10.0, floor), std::pow(10.0, ceiling)};
}

AxisRange fitted_linear(const Extent& extent) {
  if (extent.is_empty()) return {0.0, 1.0};
  const AxisRange data = opened(extent.range());
  const double margin = kYMargin * data.span();
  const AxisRange values = extent.range();
  const bool begins_at_0 = values.low >= 0.0 && data.low < 0.5 * data.high;
  const bool ends_at_0 = values.low < 0.0 && values.high <= 0.0 && data.high > 0.5 * data.low;
  return {begins_at_0 ? 0.0 : data.low - margin, ends_at_0 ? 0.0 : data.high + margin};
}

}  // namespace

bool is_drawable(double value) { return std::abs(value) <= kLargest; }

double ValueScale::plotted(double value) const {
  if (!is_drawable(value)) return std::numeric_limits<double>::quiet_NaN();
  if (!is_logarithmic) return value;
  if (!(value > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  return std::log10(value) - log10_at_low;
}

AxisRange x_range_of(const ChartSpec& spec) {
  if (spec.bars) {
    const double groups = std::max(1.0, static_cast<double>(spec.bars->groups.size()));
    return {-0.5, groups - 0.5};
  }
  Extent extent;
  for (const LineSpec& line : spec.lines) {
    for (const double x : line.x) extent.include(x);
  }
  for (const BandSpec& band : spec.bands) {
    for (const double x : band.x) extent.include(x);
  }
  const AxisRange fitted = extent.is_empty() ? AxisRange{} : opened(extent.range());
  return with_asked_ends(fitted, spec.x);
}

AxisRange y_range_of(const ChartSpec& spec) {
  const Extent extent = y_extent(spec);
  if (!is_logarithmic(spec)) return with_asked_ends(fitted_linear(extent), spec.y);
  AxisRange range = fitted_logarithmic(extent);
  if (spec.y.high && *spec.y.high > 0.0) range.high = *spec.y.high;
  if (spec.y.low && *spec.y.low > 0.0) range.low = *spec.y.low;
  if (!(range.low < range.high)) range.low = range.high / 10.0;
  return range;
}

namespace {

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
