// SPDX-License-Identifier: Apache-2.0
// How much of a legend has room on a map, and its plate.
#include <fmt/format.h>

#include <algorithm>

#include "widgets/panels/map_lines.h"
#include "widgets/panels/picture_area.h"

namespace nadir {
namespace {

/// Rows of a legend, as draw_legend() breaks them.
struct LegendRows {
  double widest = 0.0;
  std::size_t count = 0;
};
LegendRows rows_within(const std::vector<double>& widths, double most, double px) {
  const double between = 12.0 * px;
  LegendRows rows;
  double row = 0.0;
  for (const double width : widths) {
    if (row > 0.0 && row + between + width > most) row = 0.0;
    if (row == 0.0) ++rows.count;
    row += (row > 0.0 ? between : 0.0) + width;
    rows.widest = std::max(rows.widest, row);
  }
  return rows;
}

double entry_width(const std::string& name, double px) {
  TextStyle style;
  style.size_px = kLegendTextPt * px;
  return 20.0 * px + measure_text(name, style).width;
}

std::string words_for_more(std::size_t left_out) { return fmt::format("and {} more", left_out); }

/// All of it, narrow if it can be, beside the scale bar, wider where it would be high; else as many entries as there is room
/// for, and how many there are more. No entries: not even the first one has room.
void fit_legend(LegendFit& fit, double padding) {
  constexpr double kWished = 0.28, kCut = 0.34, kMost = 0.45;  // of the map's height
  constexpr double kMostWidth = 0.72;
  const double px = fit.px_per_pt;
  std::vector<double> all;
  for (const std::string& name : fit.names) all.push_back(entry_width(name, px));
  for (fit.count = all.size(); fit.count > 0; --fit.count) {
    const std::size_t left_out = all.size() - fit.count;
    std::vector<double> widths(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(fit.count));
    if (left_out > 0) widths.push_back(entry_width(words_for_more(left_out), px));
    for (const double share : {0.5, 0.6, 0.7}) {
      fit.width = rows_within(widths, share * fit.map_width - 2.0 * padding, px).widest;
      fit.height = 13.0 * px * static_cast<double>(rows_within(widths, fit.width + px, px).count);
      if (fit.height <= kWished * fit.map_height) break;
    }
    // What is cut short is no reason to cover more of the map.
    const double most = left_out == 0 ? kMost : kCut;
    if (fit.height <= most * fit.map_height &&
        fit.width + 2.0 * padding <= kMostWidth * fit.map_width)
      return;
  }
}

constexpr double kLegendPadding = 5.0, kLegendMargin = 4.0;  // points

/// What is drawn: as many entries as there is room for, the last one counts the others.
std::vector<LegendEntry> entries_with_room(const std::vector<LegendEntry>& entries,
                                           std::size_t count) {
  std::vector<LegendEntry> shown(entries.begin(),
                                 entries.begin() + static_cast<std::ptrdiff_t>(count));
  if (count < entries.size()) {
    shown.push_back(
        {words_for_more(entries.size() - count), {0, 0, 0, 0}, LegendEntry::Kind::kBar});
  }
  return shown;
}

/// Keeps what is of the same names on a map of the same size.
void renew_fit(LegendFit& fit,
               const std::vector<LegendEntry>& entries,
               const MapFrame& frame,
               double padding) {
  const bool is_same =
      fit.map_width == frame.where.width && fit.map_height == frame.where.height &&
      fit.px_per_pt == frame.px_per_pt &&
      std::equal(
          entries.begin(), entries.end(), fit.names.begin(), fit.names.end(),
          [](const LegendEntry& entry, const std::string& name) { return entry.name == name; });
  if (is_same) return;
  fit = {};
  for (const LegendEntry& entry : entries) fit.names.push_back(entry.name);
  fit.map_width = frame.where.width;
  fit.map_height = frame.where.height;
  fit.px_per_pt = frame.px_per_pt;
  fit_legend(fit, padding);
  fit.layout = legend_layout(fit.width + fit.px_per_pt, entries_with_room(entries, fit.count),
                             fit.px_per_pt);
}

PageRect plate_of(const LegendFit& fit, const MapFrame& frame) {
  if (fit.count == 0) return {};
  const double px = frame.px_per_pt, padding = kLegendPadding * px;
  return {frame.where.right() - fit.width - 2.0 * padding - kLegendMargin * px,
          frame.where.bottom + kLegendMargin * px, fit.width + 2.0 * padding,
          fit.height + 2.0 * padding};
}

}  // namespace

PageRect draw_map_legend(Canvas& canvas,
                         const MapFrame& frame,
                         const std::vector<LegendEntry>& entries,
                         const Theme& theme,
                         LegendFit& fit) {
  const double px = frame.px_per_pt, padding = kLegendPadding * px;
  renew_fit(fit, entries, frame, padding);
  const PageRect plate = plate_of(fit, frame);
  if (fit.count == 0) return plate;
  canvas.fill(corners_of(plate), with_opacity(theme.page, 0.85));
  draw_legend(canvas, {plate.left + padding, plate.bottom + padding, fit.width + px, fit.height},
              entries_with_room(entries, fit.count), fit.layout, theme, px);
  return plate;
}

PageRect place_of_map_legend(const MapFrame& frame,
                             const std::vector<LegendEntry>& entries,
                             LegendFit& fit) {
  renew_fit(fit, entries, frame, kLegendPadding * frame.px_per_pt);
  return plate_of(fit, frame);
}

}  // namespace nadir
