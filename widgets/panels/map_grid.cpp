// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/panels/map_lines.h"

namespace nadir {
namespace {

struct GridLook {
  Rgba line, casing, text, plate;
};

GridLook grid_look(const MapDrawing& drawing, bool is_plain) {
  const Theme& theme = drawing.theme;
  const LayerLook& layer = drawing.model.look.layer(Layer::kGraticule);
  const double opacity = is_plain ? 1.0 : layer.opacity;
  const auto own = layer.colour && !is_plain ? colour_from_hex(*layer.colour) : std::nullopt;
  if (is_plain || !has_ground_picture(drawing.model)) {
    return {faded(own.value_or(theme.line), opacity),
            {0, 0, 0, 0},
            faded(theme.muted, opacity),
            with_opacity(theme.window, 0.8 * opacity)};
  }
  return {faded(own.value_or(Rgba{255, 255, 255}), 0.45 * opacity),
          faded(Rgba{0, 0, 0}, 0.35 * opacity), faded(theme.text, opacity),
          with_opacity(theme.page, 0.7 * opacity)};
}

Eigen::Vector2d farther_right(const std::array<Eigen::Vector2d, 2>& ends) {
  return ends[0].x() > ends[1].x() ? ends[0] : ends[1];
}

bool overlap(const PageRect& one, const PageRect& other) {
  return one.left < other.right() && other.left < one.right() && one.bottom < other.top() &&
         other.bottom < one.top();
}

/// As near to a point as a plate of half that size may lie within a page.
Eigen::Vector2d moved_inside(const Eigen::Vector2d& point,
                             const Eigen::Vector2d& half,
                             const PageRect& where) {
  const auto settled = [](double at, double low, double high) {
    return std::clamp(at, low, std::max(low, high));
  };
  return {settled(point.x(), where.left + half.x(), where.right() - half.x()),
          settled(point.y(), where.bottom + half.y(), where.top() - half.y())};
}

}  // namespace

void draw_map_grid(const MapDrawing& drawing, bool is_plain) {
  const MapFrame& frame = drawing.frame;
  const double px = frame.px_per_pt;
  const GridLook look = grid_look(drawing, is_plain);
  const auto lines = grid_lines(frame.camera, frame.where, 90.0 * px);
  for (const GridLine& line : lines) {
    if (look.casing.alpha > 0) drawing.canvas.stroke(line.ends, {look.casing, 1.2 * px});
    drawing.canvas.stroke(line.ends, {look.line, 0.6 * px});
  }
  TextStyle style;
  style.face = FontFace::kNumbers;
  style.size_px = 7.5 * px;
  style.colour = look.text;
  // Numbers lie where nothing else does: along the upper border east, along the right one north.
  std::vector<PageRect> taken;
  for (const GridLine& line : lines) {
    const std::string label =
        fmt::format("{} {}", line.is_east ? "E" : "N",
                    metres_text(line.value_m, line.value_m == std::round(line.value_m) ? 0 : 2));
    const Eigen::Vector2d end = line.is_east ? line.ends[1] : farther_right(line.ends);
    const PageRect wide = plate_at({0.0, 0.0}, label, style, px);
    const Eigen::Vector2d half(wide.width / 2.0 + 2.0 * px, wide.height / 2.0 + 2.0 * px);
    const Eigen::Vector2d at = moved_inside(end, half, frame.where);
    const PageRect plate = plate_at(at, label, style, px);
    const bool is_free = std::none_of(taken.begin(), taken.end(),
                                      [&](const PageRect& other) { return overlap(plate, other); });
    if (!is_free) continue;
    taken.push_back(plate);
    draw_plate(drawing.canvas, at, label, style, look.plate, px);
  }
}

}  // namespace nadir
