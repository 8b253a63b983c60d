// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "widgets/panels/timeline_parts.h"

namespace nadir::detail {
namespace {

constexpr double kSmallText = 11.0, kTwoLinesFrom = 34.0;  // of the design

/// The lines in their colours, those of other runs below; what is one point alone is a dot.
void draw_curve(const TimelineFrame& frame,
                Canvas& canvas,
                const kit::AreaInput& area,
                const StripPlot& plot,
                const StripCurve& curve) {
  const Theme& theme = frame.ui.theme();
  Rgba colour = frame.colour_of(curve.colour);
  if (curve.tone == StripCurve::Tone::kPale) colour = with_opacity(colour, 0.5);
  if (curve.tone == StripCurve::Tone::kMuted) colour = with_opacity(theme.muted, 0.7);
  if (curve.tone == StripCurve::Tone::kBad) colour = theme.bad;
  const double padding = frame.ui.px(kStripPadding);
  const double height = area.rect.height - 2.0 * padding;
  const double left = frame.axis.left_px - area.rect.left;
  const double px_per_s = frame.axis.px_per_s();
  const PointLine& line = curve.line;
  // Only what shows, and one point more at either end.
  const auto begin =
      std::lower_bound(line.x.begin(), line.x.end(), frame.axis.from_s) - line.x.begin();
  const auto end = std::upper_bound(line.x.begin(), line.x.end(), frame.axis.to_s) - line.x.begin();
  const auto first = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, begin - 1));
  const auto last = std::min(line.x.size(), static_cast<std::size_t>(end) + 1);
  std::vector<Eigen::Vector2d> points;
  points.reserve(last - std::min(first, last));
  for (std::size_t i = first; i < last; ++i) {
    points.emplace_back(left + (line.x[i] - frame.axis.from_s) * px_per_s,
                        padding + plot.height_of(line.y[i]) * height);
  }
  // Where there is a lowest and a highest point for nearly every pixel, thin lines show more.
  const bool is_dense = static_cast<double>(points.size()) > 0.8 * frame.axis.width_px;
  const bool is_main = curve.tone == StripCurve::Tone::kRun || curve.tone == StripCurve::Tone::kBad;
  const double width_px = frame.ui.px(is_dense || !is_main ? 1.0 : 1.5);
  canvas.stroke(points, {colour, width_px, {}});
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto is_drawn = [&](std::size_t k) { return k < points.size() && points[k].allFinite(); };
    if (!is_drawn(i) || (i > 0 && is_drawn(i - 1)) || is_drawn(i + 1)) continue;
    const double half = frame.ui.px(1.5);
    const Eigen::Vector2d at = points[i];
    const std::array<Eigen::Vector2d, 4> dot = {Eigen::Vector2d{at.x() - half, at.y() - half},
                                                {at.x() + half, at.y() - half},
                                                {at.x() + half, at.y() + half},
                                                {at.x() - half, at.y() + half}};
    canvas.fill(dot, colour);
  }
}

void draw_levels(const TimelineFrame& frame,
                 Canvas& canvas,
                 const kit::AreaInput& area,
                 const StripPlot& plot) {
  const double padding = frame.ui.px(kStripPadding);
  const double height = area.rect.height - 2.0 * padding;
  const double left = frame.axis.left_px - area.rect.left,
               right = frame.axis.right_px() - area.rect.left;
  for (const StripLevel& level : plot.levels) {
    const double share = plot.height_of(level.value);
    if (!(share >= 0.0 && share <= 1.0)) continue;
    const double y = std::floor(padding + share * height) + 0.5;
    const std::array<Eigen::Vector2d, 2> line = {Eigen::Vector2d{left, y}, {right, y}};
    const Rgba colour = level.is_bound ? frame.ui.theme().bad : frame.ui.theme().muted;
    canvas.stroke(line, {with_opacity(colour, 0.55), 1.0, {frame.ui.px(4.0), frame.ui.px(3.0)}});
  }
}

void draw_streams(const TimelineFrame& frame,
                  Canvas& canvas,
                  const kit::AreaInput& area,
                  const std::vector<StreamBar>& streams) {
  if (streams.empty()) return;
  const Theme& theme = frame.ui.theme();
  const double padding = frame.ui.px(kStripPadding);
  const double pitch = (area.rect.height - 2.0 * padding) / static_cast<double>(streams.size());
  const double thick = std::max(1.0, std::min(pitch - frame.ui.px(2.0), frame.ui.px(5.0)));
  const double left = frame.axis.left_px - area.rect.left,
               right = frame.axis.right_px() - area.rect.left;
  for (std::size_t i = 0; i < streams.size(); ++i) {
    const double y = area.rect.height - padding - (static_cast<double>(i) + 0.5) * pitch;
    if (streams[i].samples == 0) {  // it is missing from beginning to end
      const std::array<Eigen::Vector2d, 2> none = {Eigen::Vector2d{left, y}, {right, y}};
      const double dash = frame.ui.px(2.0);
      canvas.stroke(none, {with_opacity(theme.warning, 0.5), 1.0, {dash, 3.0 * dash}});
    }
    for (const TimeSpan& span : streams[i].spans) {
      const double from = std::max(left, frame.axis.x_px(span.from_s) - area.rect.left);
      const double to =
          std::min(right, std::max(from + 1.0, frame.axis.x_px(span.to_s) - area.rect.left));
      if (!(from < to)) continue;
      const std::array<Eigen::Vector2d, 2> bar = {Eigen::Vector2d{from, y}, {to, y}};
      canvas.stroke(bar, {with_opacity(theme.good, 0.8), thick, {}});
    }
  }
}

/// Dots on the lines where the cursor is.
void draw_values_at_cursor(const TimelineFrame& frame,
                           Canvas& canvas,
                           const kit::AreaInput& area,
                           Strip strip,
                           const StripPlot& plot) {
  const TimeAxis& axis = frame.axis;
  if (frame.model.time_s < axis.from_s || frame.model.time_s > axis.to_s) return;
  const double padding = frame.ui.px(kStripPadding);
  const double x = std::floor(axis.x_px(frame.model.time_s) - area.rect.left) + 0.5;
  for (const TimelineRun& run : frame.model.runs) {
    const double share = plot.height_of(strip_numbers(strip, run, frame.model.time_s).main);
    if (!(share >= 0.0 && share <= 1.0)) continue;
    const double y = padding + share * (area.rect.height - 2.0 * padding);
    constexpr int kCorners = 12;
    std::array<Eigen::Vector2d, kCorners> dot;
    for (int i = 0; i < kCorners; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kCorners;
      dot.at(static_cast<std::size_t>(i)) =
          Eigen::Vector2d(x, y) +
          frame.ui.px(3.0) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }
    canvas.fill(dot, frame.colour_of(run.colour));
  }
}

}  // namespace

void draw_strip_picture(const TimelineFrame& frame,
                        Canvas& canvas,
                        const kit::AreaInput& area,
                        Strip strip,
                        const StripPlot& plot) {
  kit::Ui& ui = frame.ui;
  draw_ground(frame, canvas, area);
  canvas.push_clip(
      {frame.axis.left_px - area.rect.left, 0.0, frame.axis.width_px, area.rect.height});
  if (strip == Strip::kStreams) {
    draw_streams(frame, canvas, area, *frame.state.streams);
  } else {
    draw_levels(frame, canvas, area, plot);
    for (const StripCurve& curve : plot.curves) draw_curve(frame, canvas, area, plot, curve);
  }
  draw_ends(frame, canvas, area);
  draw_moments(frame, canvas, area);
  if (strip != Strip::kStreams) draw_values_at_cursor(frame, canvas, area, strip, plot);
  canvas.pop_clip();
  draw_gutter(frame, canvas, area, strip, plot);
  if (!plot.cut_off || area.rect.height < ui.px(kTwoLinesFrom)) return;
  TextStyle style;
  style.face = FontFace::kNumbers;
  style.size_px = ui.px(kSmallText);
  style.colour = ui.theme().muted;
  style.align = TextAlign::kRight;
  const double x = frame.axis.right_px() - area.rect.left - ui.px(4.0);
  canvas.text({std::floor(x), std::floor(area.rect.height - ui.px(12.0))},
              fmt::format("max {:.3g}", *plot.cut_off), style);
}

}  // namespace nadir::detail
