// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/chart_spec.h"

#include <algorithm>

#include "widgets/views/chart_axis.h"

namespace nadir {
namespace {

bool has_points(const LineSpec& line) {
  for (std::size_t i = 0; i < std::min(line.x.size(), line.y.size()); ++i) {
    if (is_drawable(line.x[i]) && is_drawable(line.y[i])) return true;
  }
  return false;
}

/// An area needs two points beside each other.
bool has_area(const BandSpec& band) {
  std::size_t together = 0;
  for (std::size_t i = 0; i < std::min({band.x.size(), band.low.size(), band.high.size()}); ++i) {
    const bool is_known =
        is_drawable(band.x[i]) && is_drawable(band.low[i]) && is_drawable(band.high[i]);
    together = is_known ? together + 1 : 0;
    if (together == 2) return true;
  }
  return false;
}

bool has_bars(const BarsSpec& bars, const BarsSpec::Series& series) {
  const std::size_t count = std::min(bars.groups.size(), series.heights.size());
  return std::any_of(series.heights.begin(),
                     series.heights.begin() + static_cast<std::ptrdiff_t>(count),
                     [above_0 = bars.is_logarithmic](double height) {
                       return is_drawable(height) && (!above_0 || height > 0.0);
                     });
}

}  // namespace

std::vector<LegendEntry> legend_of(const ChartSpec& spec) {
  std::vector<LegendEntry> entries;
  const auto list = [&entries](const std::string& name, Rgba colour, LegendEntry::Kind kind) {
    const LegendEntry entry{name, colour, kind};
    if (name.empty() || std::find(entries.begin(), entries.end(), entry) != entries.end()) return;
    entries.push_back(entry);
  };
  const auto line_kind = [](bool is_dashed) {
    return is_dashed ? LegendEntry::Kind::kDashed : LegendEntry::Kind::kLine;
  };
  for (const LineSpec& line : spec.lines) {
    if (has_points(line)) list(line.name, line.colour, line_kind(line.is_dashed));
  }
  for (const BandSpec& band : spec.bands) {
    if (has_area(band)) list(band.name, band.colour, LegendEntry::Kind::kBand);
  }
  if (spec.bars) {
    for (const BarsSpec::Series& series : spec.bars->series) {
      if (has_bars(*spec.bars, series)) list(series.name, series.colour, LegendEntry::Kind::kBar);
    }
  }
  for (const LevelSpec& level : spec.levels) {
    if (is_drawable(level.y)) list(level.name, level.colour, line_kind(level.is_dashed));
  }
  return entries;
}

}  // namespace nadir
