// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/chart_panel.h"

#include <algorithm>

#include "widgets/figures/page_layout.h"
#include "widgets/views/no_canvas.h"

namespace nadir {
namespace {

constexpr double kRowGapPt = 8.0;
constexpr double kColumnGapPt = 12.0;
constexpr double kLeastPanelPt = 90.0;  ///< Width below which a row takes fewer charts ...
constexpr double kLeastRowPt = 60.0;    ///< ... unless its rows then were lower than this.
constexpr double kLeastShownPt = 24.0;  ///< Rows lower than this are left out, the last ones first.

std::size_t rows_needed(std::size_t count, std::size_t across) {
  return (count + across - 1) / across;
}

double piece_length(double length, std::size_t pieces, double gap) {
  return (length - gap * static_cast<double>(pieces - 1)) / static_cast<double>(pieces);
}

std::size_t columns_that_fit(const PageRect& where,
                             std::size_t count,
                             std::size_t wanted,
                             double px_per_pt) {
  const std::size_t most = std::max<std::size_t>(1, std::min(wanted, count));
  for (std::size_t across = most; across > 1; --across) {
    const std::size_t fewer = across - 1;
    const bool is_wide =
        piece_length(where.width, across, kColumnGapPt * px_per_pt) >= kLeastPanelPt * px_per_pt;
    const bool would_be_low = piece_length(where.height, rows_needed(count, fewer),
                                           kRowGapPt * px_per_pt) < kLeastRowPt * px_per_pt;
    if (is_wide || would_be_low) return across;
  }
  return 1;
}

}  // namespace

ChartGrid::ChartGrid(std::vector<CaptionedChart> charts, std::size_t columns_wanted)
    : charts_(std::move(charts)),
      columns_wanted_(columns_wanted),
      legend_(legend_of_all(charts_)) {}

void ChartGrid::lay_out(const PageFormat& format, const PageRect& where) {
  const double px = format.px_per_pt();
  if (where_ == where && px_per_pt_ == px && theme_ == format.theme) return;
  where_ = where;
  px_per_pt_ = px;
  theme_ = format.theme;
  panels_.clear();
  drawn_.clear();
  if (charts_.empty()) return;
  const std::size_t across = columns_that_fit(where, charts_.size(), columns_wanted_, px);
  std::size_t down = rows_needed(charts_.size(), across);
  while (down > 1 && piece_length(where.height, down, kRowGapPt * px) < kLeastShownPt * px) {
    --down;
  }
  const std::size_t shown = std::min(charts_.size(), down * across);
  const auto strips = rows(where, std::vector<double>(down, 1.0), kRowGapPt * px);
  // Captions are drawn with each page; here they only take their room.
  NoCanvas nowhere;
  double left_margin_px = 0.0;
  for (std::size_t i = 0; i < shown; ++i) {
    PageRect panel = columns(strips[i / across], std::vector<double>(across, 1.0),
                             kColumnGapPt * px)[i % across];
    panels_.push_back(panel);
    if (!charts_[i].caption.empty()) draw_caption(nowhere, format, panel, charts_[i].caption);
    const XyChart chart(charts_[i].chart, format.colours(), px);
    left_margin_px = std::max(left_margin_px, chart.needed_left_margin_px(panel));
  }
  for (std::size_t i = 0; i < shown; ++i) {
    ChartSpec spec = charts_[i].chart;
    if (down > 1) spec.left_margin_px = left_margin_px;
    drawn_.emplace_back(std::move(spec), format.colours(), px);
  }
}

void ChartGrid::draw(Canvas& canvas, const PageFormat& format, const PageRect& where) {
  lay_out(format, where);
  for (std::size_t i = 0; i < drawn_.size(); ++i) {
    PageRect panel = panels_[i];
    if (!charts_[i].caption.empty()) draw_caption(canvas, format, panel, charts_[i].caption);
    drawn_[i].draw(canvas, panel, format.width, format.height);
  }
}

void ChartGrid::mark_x(std::optional<double> x) {
  for (CaptionedChart& captioned : charts_) captioned.chart.marked_x = x;
  for (XyChart& chart : drawn_) chart.mark_x(x);
}

void draw_charts(Canvas& canvas,
                 const PageFormat& format,
                 const PageRect& where,
                 std::span<const CaptionedChart> charts,
                 std::size_t columns_wanted) {
  ChartGrid({charts.begin(), charts.end()}, columns_wanted).draw(canvas, format, where);
}

std::vector<LegendEntry> legend_of_all(std::span<const CaptionedChart> charts) {
  std::vector<LegendEntry> entries;
  for (const CaptionedChart& captioned : charts) {
    for (const LegendEntry& entry : legend_of(captioned.chart)) {
      if (std::find(entries.begin(), entries.end(), entry) == entries.end()) {
        entries.push_back(entry);
      }
    }
  }
  return entries;
}

}  // namespace nadir
