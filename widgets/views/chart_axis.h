// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "widgets/views/chart_spec.h"

namespace nadir {

/// From low to high, low < high.
struct AxisRange {
  double low = 0.0, high = 1.0;
  [[nodiscard]] double span() const { return high - low; }
  friend bool operator==(const AxisRange&, const AxisRange&) = default;
};

/// What an axis can show: finite, and not so large that the arithmetic around it overflows.
[[nodiscard]] bool is_drawable(double value);

/// How values become heights on the y axis: as they are, or by the logarithm to base 10 above the axis's low end, since
/// VTK's bars stand on 0 and would hang from 1 on its own logarithmic axis.
struct ValueScale {
  bool is_logarithmic = false;
  double log10_at_low = 0.0;
  /// NaN for what cannot be shown.
  [[nodiscard]] double plotted(double value) const;
};

/// The ends that the spec asks for, else those of the data: x without a margin, or half a group beside the bars.
[[nodiscard]] AxisRange x_range_of(const ChartSpec& spec);

/// The ends that the spec asks for, else those of the data with a twentieth of their span as margin, and from 0 where
/// they lie close above it. In values, also on a logarithmic axis, which goes from one power of ten to another.
[[nodiscard]] AxisRange y_range_of(const ChartSpec& spec);

/// Places along an axis with what is written there, in rising order.
struct Ticks {
  std::vector<double> at;
  std::vector<std::string> labels;
};

/// With three digits that count, two below 0.1: "1230", "0.0017", "4.5×10⁻⁶". @param value  Above 0.
[[nodiscard]] std::string short_number(double value);

/// Says whether labels have room beside each other.
using TicksFit = std::function<bool(const Ticks&)>;

/// Ticks at multiples of 1, 2, 2.5 or 5 times a power of ten: up to 8, and 4 or more where they fit; always one or more
/// where the range holds a round number. @param is_whole  No parts of 1 where the range is 2 or longer.
[[nodiscard]] Ticks round_ticks(const AxisRange& range, bool is_whole, const TicksFit& fit);

/// Ticks at 1, 2 and 5 times powers of ten, or only at powers, of a range of values above 0. A range between two powers
/// has ticks at both ends, unless not even those fit. `at` is the logarithm to base 10.
[[nodiscard]] Ticks logarithmic_ticks(const AxisRange& range, const TicksFit& fit);

}  // namespace nadir
