// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/chart_spec.h"

#include <algorithm>

namespace nadir {

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
  for (const LineSpec& line : spec.lines) list(line.name, line.colour, line_kind(line.is_dashed));
  for (const BandSpec& band : spec.bands) list(band.name, band.colour, LegendEntry::Kind::kBand);
  if (spec.bars) {
    for (const BarsSpec::Series& series : spec.bars->series) {
      list(series.name, series.colour, LegendEntry::Kind::kBar);
    }
  }
  for (const LevelSpec& level : spec.levels) {
    list(level.name, level.colour, line_kind(level.is_dashed));
  }
  return entries;
}

}  // namespace nadir
