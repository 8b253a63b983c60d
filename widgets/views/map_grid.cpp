// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/map_grid.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "widgets/views/map_colours.h"
#include "widgets/views/map_furniture.h"

namespace nadir {
namespace {

/// Where a straight line of the page crosses a rectangle: the two ends, or nothing. Liang and Barsky 1984.
std::optional<std::array<Eigen::Vector2d, 2>> ends_within(const Eigen::Vector2d& through,
                                                          const Eigen::Vector2d& along,
                                                          const PageRect& where) {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  const auto cut = [&](double at, double speed, double low, double high) {
    if (std::abs(speed) < 1e-12) return at >= low && at <= high;
    const double first = (low - at) / speed;
    const double second = (high - at) / speed;
    from = std::max(from, std::min(first, second));
    to = std::min(to, std::max(first, second));
    return true;
  };
  const bool is_crossed = cut(through.x(), along.x(), where.left, where.right()) &&
                          cut(through.y(), along.y(), where.bottom, where.top());
  if (!is_crossed || !(from < to)) return std::nullopt;
  return std::array<Eigen::Vector2d, 2>{through + from * along, through + to * along};
}

Eigen::Vector2d farther_right(const std::array<Eigen::Vector2d, 2>& ends) {
  return ends[0].x() > ends[1].x() ? ends[0] : ends[1];
}

bool plates_overlap(const PageRect& one, const PageRect& other) {
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

std::vector<GridLine> grid_lines(const MapCamera& camera, const PageRect& where, double least_px) {
  std::vector<GridLine> lines;
  const double least_m = least_px * camera.metres_per_px;
  if (!(least_m > 0.0) || !std::isfinite(least_m)) return lines;
  // The smallest round distance that is far enough: the largest one below 2.5 times it may be too large by a step only.
  double step_m = round_length(2.5 * least_m);
  if (step_m < least_m) step_m *= 2.0;
  Eigen::AlignedBox2d seen;
  for (const auto& corner :
       {Eigen::Vector2d(where.left, where.bottom), Eigen::Vector2d(where.right(), where.bottom),
        Eigen::Vector2d(where.right(), where.top()), Eigen::Vector2d(where.left, where.top())}) {
    const Eigen::Vector2d place = camera.enu_from_page(corner, where);
    if (!place.allFinite()) return lines;
    seen.extend(place);
  }
  if (seen.max().cwiseAbs().maxCoeff() + seen.min().cwiseAbs().maxCoeff() > 1e9 * step_m) {
    return lines;
  }
  for (const bool is_east : {true, false}) {
    const double low = is_east ? seen.min().x() : seen.min().y();
    const double high = is_east ? seen.max().x() : seen.max().y();
    for (double k = std::ceil(low / step_m); k * step_m <= high; k += 1.0) {
      const double value_m = k * step_m + 0.0;  // no negative zero
      const Eigen::Vector2d on_line = is_east
                                          ? Eigen::Vector2d(value_m, camera.centre_in_enu_m.y())
                                          : Eigen::Vector2d(camera.centre_in_enu_m.x(), value_m);
      const Eigen::Vector2d next =
          on_line + (is_east ? Eigen::Vector2d(0.0, 1.0) : Eigen::Vector2d(1.0, 0.0));
      const Eigen::Vector2d through = camera.page_from_enu(on_line, where);
      const Eigen::Vector2d along =
          (camera.page_from_enu(next, where) - through) * camera.metres_per_px;
      auto ends = ends_within(through, along, where);
      if (!ends) continue;
      const auto is_first = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return std::abs(a.y() - b.y()) > 1e-6 ? a.y() < b.y() : a.x() < b.x();
      };
      if (!is_first((*ends)[0], (*ends)[1])) std::swap((*ends)[0], (*ends)[1]);
      lines.push_back({is_east, value_m, *ends});
    }
  }
  return lines;
}

MapGridLook grid_look_on_imagery(const Theme& theme, Rgba line, double opacity) {
  return {faded(line, 0.45 * opacity), with_opacity(theme.casing_on_imagery, 0.35 * opacity),
          faded(theme.text, opacity), with_opacity(theme.page, 0.7 * opacity)};
}

void draw_grid_lines(Canvas& canvas, const MapFrame& frame, const MapGridLook& look) {
  const double px = frame.px_per_pt;
  const auto lines = grid_lines(frame.camera, frame.where, 90.0 * px);
  for (const GridLine& line : lines) {
    if (look.casing.alpha > 0) canvas.stroke(line.ends, {look.casing, 1.2 * px});
    canvas.stroke(line.ends, {look.line, 0.6 * px});
  }
  TextStyle style;
  style.face = FontFace::kNumbers;
  style.size_px = 7.5 * px;
  style.colour = look.text;
  // Numbers lie where nothing else does: along the upper border east, along the right one north.
  std::vector<PageRect> taken;
  for (const GridLine& line : lines) {
    const int decimals = line.value_m == std::round(line.value_m) ? 0 : 2;
    const std::string label =
        fmt::format("{} {:.{}f}", line.is_east ? "E" : "N", line.value_m, decimals);
    const Eigen::Vector2d end = line.is_east ? line.ends[1] : farther_right(line.ends);
    const PageRect wide = plate_at({0.0, 0.0}, label, style, px);
    const Eigen::Vector2d half(wide.width / 2.0 + 2.0 * px, wide.height / 2.0 + 2.0 * px);
    const Eigen::Vector2d at = moved_inside(end, half, frame.where);
    const PageRect plate = plate_at(at, label, style, px);
    const bool is_free = std::none_of(taken.begin(), taken.end(), [&](const PageRect& other) {
      return plates_overlap(plate, other);
    });
    if (!is_free) continue;
    taken.push_back(plate);
    draw_plate(canvas, at, label, style, look.plate, px);
  }
}

}  // namespace nadir
