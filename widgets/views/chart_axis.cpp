// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/chart_axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/require.h"

namespace nadir {
namespace {

constexpr double kLargest = 1e100;
constexpr double kLeastSpan =
    1e-9;  ///< Of an axis, as a share of its values: below, doubles run out of digits.
constexpr double kYMargin = 0.05;

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

}  // namespace nadir
