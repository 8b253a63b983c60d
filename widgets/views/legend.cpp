// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/legend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "core/base/require.h"

namespace nadir {
namespace {

constexpr double kSamplePt = 16.0;
constexpr double kRowPt = 13.0;
constexpr double kBetweenPt = 12.0;  ///< One entry and the next.

void fill_rect(
    Canvas& canvas, double left, double bottom, double width, double height, Rgba colour) {
  const std::array<Eigen::Vector2d, 4> corners = {
      Eigen::Vector2d(left, bottom), Eigen::Vector2d(left + width, bottom),
      Eigen::Vector2d(left + width, bottom + height), Eigen::Vector2d(left, bottom + height)};
  canvas.fill(corners, colour);
}

std::vector<Eigen::Vector2d> ellipse(const Eigen::Vector2d& centre,
                                     const Eigen::Vector2d& radii,
                                     int corners) {
  std::vector<Eigen::Vector2d> outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners;
    outline.emplace_back(centre +
                         radii.cwiseProduct(Eigen::Vector2d(std::cos(angle), std::sin(angle))));
  }
  return outline;
}

void draw_striped_bar(Canvas& canvas, const LegendEntry& entry, const PageRect& bar, double px) {
  canvas.push_clip(bar);
  for (const double offset : {-3.5, 0.0, 3.5}) {
    const std::array<Eigen::Vector2d, 2> stripe = {
        Eigen::Vector2d(bar.left + (offset - 1.0) * px, bar.bottom - px),
        Eigen::Vector2d(bar.right() + (offset + 1.0) * px, bar.top() + px)};
    canvas.stroke(stripe, {entry.casing, 1.2 * px});
  }
  canvas.pop_clip();
}

/// As draw_ellipses() draws them: the inner one filled a little, the outer one faint.
void draw_rings(Canvas& canvas,
                const LegendEntry& entry,
                const Eigen::Vector2d& centre,
                double px) {
  const double width = 0.9 * px;
  for (const auto& [radii, opacity] :
       {std::pair(Eigen::Vector2d(7.5, 4.6), 0.6), {Eigen::Vector2d(3.2, 2.0), 1.0}}) {
    std::vector<Eigen::Vector2d> ring = ellipse(centre, px * radii, 36);
    if (opacity == 1.0) canvas.fill(ring, with_opacity(entry.colour, 0.15));
    ring.push_back(ring.front());
    if (entry.casing.alpha > 0) {
      canvas.stroke(ring, {with_opacity(entry.casing, opacity * entry.casing.alpha / 255.0),
                           width + 0.6 * px});
    }
    canvas.stroke(ring, {with_opacity(entry.colour, opacity), width});
  }
}

/// As ParticleView draws one that lies by itself.
void draw_particle(Canvas& canvas,
                   const LegendEntry& entry,
                   const Eigen::Vector2d& at,
                   double heading_px,
                   Rgba colour,
                   double px) {
  constexpr double kSidePt = 2.6;
  constexpr double kCasingPt = 0.8;
  const std::array<Eigen::Vector2d, 2> tick = {at, at + Eigen::Vector2d(heading_px, 0.0)};
  const auto square = [&](double side, Rgba of) {
    fill_rect(canvas, at.x() - side / 2.0, at.y() - side / 2.0, side, side, of);
  };
  if (entry.casing.alpha > 0) {
    if (heading_px > 0.0) canvas.stroke(tick, {entry.casing, (0.9 + 2.0 * kCasingPt) * px});
    square((kSidePt + 2.0 * kCasingPt) * px, entry.casing);
  }
  if (heading_px > 0.0) canvas.stroke(tick, {colour, 0.9 * px});
  square(kSidePt * px, colour);
}

void draw_ramp(Canvas& canvas, double left, double middle, double px) {
  constexpr int kSteps = 8;
  const double width = kSamplePt * px / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    fill_rect(canvas, left + i * width, middle - 3.5 * px, width + 0.5, 7.0 * px,
              value_colour(ValueColours::kViridis, (i + 0.5) / kSteps));
  }
}

void draw_sample(Canvas& canvas, const LegendEntry& entry, double left, double middle, double px) {
  const std::array<Eigen::Vector2d, 2> line = {Eigen::Vector2d(left, middle),
                                               Eigen::Vector2d(left + kSamplePt * px, middle)};
  const double width = 2.0 * px;
  const bool is_line =
      entry.kind == LegendEntry::Kind::kLine || entry.kind == LegendEntry::Kind::kDashed;
  if (is_line && entry.casing.alpha > 0) canvas.stroke(line, {entry.casing, width + 1.4 * px});
  const PageRect bar{left + 4.5 * px, middle - 3.5 * px, 7.0 * px, 7.0 * px};
  const Eigen::Vector2d centre(left + kSamplePt / 2.0 * px, middle);
  switch (entry.kind) {
    case LegendEntry::Kind::kLine:
      canvas.stroke(line, {entry.colour, width});
      break;
    case LegendEntry::Kind::kDashed:
      canvas.stroke(line, {entry.colour, width, {4.0 * px, 2.0 * px}});
      break;
    case LegendEntry::Kind::kBand:
      fill_rect(canvas, left, middle - 3.5 * px, kSamplePt * px, 7.0 * px, entry.colour);
      break;
    case LegendEntry::Kind::kBar:
      fill_rect(canvas, bar.left, bar.bottom, bar.width, bar.height, entry.colour);
      break;
    case LegendEntry::Kind::kOutlinedBar: {
      fill_rect(canvas, bar.left, bar.bottom, bar.width, bar.height, entry.colour);
      const std::array<Eigen::Vector2d, 5> outline = {
          Eigen::Vector2d(bar.left, bar.bottom), Eigen::Vector2d(bar.right(), bar.bottom),
          Eigen::Vector2d(bar.right(), bar.top()), Eigen::Vector2d(bar.left, bar.top()),
          Eigen::Vector2d(bar.left, bar.bottom)};
      canvas.stroke(outline, {entry.casing, 0.75 * px});
      break;
    }
    case LegendEntry::Kind::kStripedBar:
      fill_rect(canvas, bar.left, bar.bottom, bar.width, bar.height, entry.colour);
      draw_striped_bar(canvas, entry, bar, px);
      break;
    case LegendEntry::Kind::kRings:
      draw_rings(canvas, entry, centre, px);
      break;
    case LegendEntry::Kind::kParticle:
      draw_particle(canvas, entry, centre - Eigen::Vector2d(3.0 * px, 0.0), 7.0 * px, entry.colour,
                    px);
      break;
    case LegendEntry::Kind::kParticles:
      for (const double place : {-1.0, 0.0, 1.0}) {
        draw_particle(canvas, entry, centre + Eigen::Vector2d(5.0 * place * px, 0.0), 0.0,
                      value_colour(ValueColours::kViridis, 0.55 + 0.4 * place), px);
      }
      break;
    case LegendEntry::Kind::kRamp:
      draw_ramp(canvas, left, middle, px);
      break;
    case LegendEntry::Kind::kDot: {
      constexpr int kCorners = 24;
      if (entry.casing.alpha > 0) {
        canvas.fill(ellipse(centre, Eigen::Vector2d::Constant(3.2 * px), kCorners), entry.casing);
      }
      canvas.fill(ellipse(centre, Eigen::Vector2d::Constant(2.5 * px), kCorners), entry.colour);
      break;
    }
  }
}

bool are_hardly_apart(Rgba one, Rgba other) {
  constexpr int kHardlyApart = 50;  // of 255, in every channel
  return std::max({std::abs(one.red - other.red), std::abs(one.green - other.green),
                   std::abs(one.blue - other.blue)}) < kHardlyApart;
}

}  // namespace

LegendEntry legible_entry(LegendEntry entry, const Theme& theme) {
  if (entry.kind == LegendEntry::Kind::kBar && are_hardly_apart(entry.colour, theme.page)) {
    entry.kind = LegendEntry::Kind::kOutlinedBar;
    entry.casing = theme.muted;
  }
  return entry;
}

LegendLayout legend_layout(double width_px,
                           std::span<const LegendEntry> entries,
                           double px_per_pt) {
  LegendLayout layout;
  if (entries.empty()) return layout;
  TextStyle style;
  style.size_px = kLegendTextPt * px_per_pt;
  layout.cap_height_px = measure_text("0", style).cap_height;
  double left = 0.0, down = 0.0;
  layout.places.reserve(entries.size());
  for (const LegendEntry& entry : entries) {
    const double width = (kSamplePt + 4.0) * px_per_pt + measure_text(entry.name, style).width;
    if (left > 0.0 && left + width > width_px) {
      left = 0.0;
      down += kRowPt * px_per_pt;
    }
    layout.places.emplace_back(left, down);
    left += width + kBetweenPt * px_per_pt;
  }
  layout.height_px = down + kRowPt * px_per_pt;
  return layout;
}

double draw_legend(Canvas& canvas,
                   const PageRect& where,
                   std::span<const LegendEntry> entries,
                   const LegendLayout& layout,
                   const Theme& theme,
                   double px_per_pt) {
  NADIR_REQUIRE(layout.places.size() == entries.size());
  TextStyle style;
  style.size_px = kLegendTextPt * px_per_pt;
  style.colour = theme.text;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const double left = where.left + layout.places[i].x();
    const double middle = where.top() - layout.places[i].y() - kRowPt / 2.0 * px_per_pt;
    if (middle - kRowPt / 2.0 * px_per_pt < where.bottom - 0.5) break;
    draw_sample(canvas, entries[i], left, middle, px_per_pt);
    canvas.text({left + (kSamplePt + 4.0) * px_per_pt, middle - layout.cap_height_px / 2.0},
                entries[i].name, style);
  }
  return std::min(layout.height_px, where.height);
}

double draw_legend(Canvas& canvas,
                   const PageRect& where,
                   std::span<const LegendEntry> entries,
                   const Theme& theme,
                   double px_per_pt) {
  return draw_legend(canvas, where, entries, legend_layout(where.width, entries, px_per_pt), theme,
                     px_per_pt);
}

}  // namespace nadir
