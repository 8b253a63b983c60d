// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/map_furniture.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/base/require.h"

namespace nadir {
namespace {

constexpr double kPlateOpacity = 0.85;
constexpr double kSmallTextPt = 8.0;

TextStyle small_text(const Theme& theme, double px_per_pt, FontFace face) {
  TextStyle style;
  style.face = face;
  style.size_px = kSmallTextPt * px_per_pt;
  style.colour = theme.text;
  return style;
}

void fill_rect(Canvas& canvas, const PageRect& rect, Rgba colour) {
  const std::array<Eigen::Vector2d, 4> corners = {
      Eigen::Vector2d(rect.left, rect.bottom), Eigen::Vector2d(rect.right(), rect.bottom),
      Eigen::Vector2d(rect.right(), rect.top()), Eigen::Vector2d(rect.left, rect.top())};
  canvas.fill(corners, colour);
}

std::string length_text(double length_m) {
  if (length_m >= 1000.0) return fmt::format("{:g} km", length_m / 1000.0);
  if (length_m >= 1.0) return fmt::format("{:g} m", length_m);
  return fmt::format("{:g} cm", length_m * 100.0);
}

}  // namespace

double round_length(double largest) {
  NADIR_REQUIRE(largest > 0.0 && std::isfinite(largest));
  const double power = std::pow(10.0, std::floor(std::log10(largest) + 1e-12));
  for (const double step : {5.0, 2.0}) {
    if (step * power <= largest * (1.0 + 1e-12)) return step * power;
  }
  return power;
}

void draw_scale_bar(Canvas& canvas, const MapFrame& frame, const Theme& theme) {
  const double px = frame.px_per_pt;
  const double length_m = round_length(frame.where.width / 4.0 * frame.camera.metres_per_px);
  const double length_px = length_m / frame.camera.metres_per_px;
  const TextStyle style = small_text(theme, px, FontFace::kNumbers);
  const std::string text = length_text(length_m);
  const TextExtent extent = measure_text(text, style);
  const double margin = 4.0 * px;
  const double thickness = 2.0 * px;
  const PageRect plate{frame.where.left + margin, frame.where.bottom + margin,
                       std::max(length_px, extent.width) + 2.0 * margin,
                       extent.cap_height + thickness + 2.8 * margin};
  fill_rect(canvas, plate, with_opacity(theme.page, kPlateOpacity));
  fill_rect(canvas, {plate.left + margin, plate.bottom + margin, length_px, thickness}, theme.text);
  canvas.text({plate.left + margin, plate.bottom + thickness + 1.8 * margin}, text, style);
}

void draw_north_arrow(Canvas& canvas, const MapFrame& frame, const Theme& theme) {
  const double px = frame.px_per_pt;
  const double radius = 11.0 * px;
  const Eigen::Vector2d at(frame.where.right() - radius - 4.0 * px,
                           frame.where.top() - radius - 4.0 * px);
  std::vector<Eigen::Vector2d> plate;
  for (int i = 0; i < 48; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 48.0;
    plate.emplace_back(at + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  canvas.fill(plate, with_opacity(theme.page, kPlateOpacity));
  // North on the page, whichever way the map is turned.
  const Eigen::Vector2d north =
      (frame.page(frame.camera.centre_in_enu_m + Eigen::Vector2d(0.0, 1.0)) -
       frame.page(frame.camera.centre_in_enu_m))
          .normalized();
  const Eigen::Vector2d east(north.y(), -north.x());
  const std::array<Eigen::Vector2d, 4> arrow = {
      at + 8.0 * px * north, at - 1.5 * px * north + 3.6 * px * east, at + 0.4 * px * north,
      at - 1.5 * px * north - 3.6 * px * east};
  canvas.fill(arrow, theme.text);
  TextStyle style = small_text(theme, px, FontFace::kText);
  style.size_px = 7.0 * px;
  style.is_bold = true;
  style.align = TextAlign::kCentre;
  const TextExtent extent = measure_text("N", style);
  canvas.text(at - 5.5 * px * north - Eigen::Vector2d(0.0, extent.cap_height / 2.0), "N", style);
}

Eigen::Vector2d graticule_margin_px(Graticule kind, double px_per_pt) {
  switch (kind) {
    case Graticule::kMetres:
      return {30.0 * px_per_pt, 14.0 * px_per_pt};
    case Graticule::kDegrees:
      return {46.0 * px_per_pt, 14.0 * px_per_pt};
    case Graticule::kNone:
      break;
  }
  return {0.0, 0.0};
}

namespace {

/// Degrees with as many digits as the step between ticks needs.
std::string degrees_text(double degrees, double step) {
  const int digits = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
  return fmt::format("{:.{}f}°", degrees, digits);
}

/// Ticks of one axis: coordinate of each on the plane, metres, and its text.
struct Tick {
  double at_m = 0.0;
  std::string text;
};

std::vector<Tick> metre_ticks(double low_m, double high_m) {
  const double step_m = round_length((high_m - low_m) / 3.0);
  std::vector<Tick> ticks;
  for (double value = std::ceil(low_m / step_m) * step_m; value <= high_m; value += step_m) {
    const double clean = std::round(value / step_m) * step_m;
    ticks.push_back({clean, fmt::format("{:g}", clean == 0.0 ? 0.0 : clean)});
  }
  return ticks;
}

/// Meridians or parallels are straight on the small area of a map; each is placed where it crosses its middle.
std::vector<Tick> degree_ticks(const MapFrame& frame,
                               const ProjectPlane& plane,
                               bool is_longitude,
                               double low_m,
                               double high_m) {
  const Eigen::Vector2d middle = frame.camera.centre_in_enu_m;
  const auto degrees_at = [&](double metres) {
    const Eigen::Vector2d point =
        is_longitude ? Eigen::Vector2d(metres, middle.y()) : Eigen::Vector2d(middle.x(), metres);
    const Geodetic place = plane.geodetic_from_enu(point);
    return is_longitude ? place.longitude_deg : place.latitude_deg;
  };
  const double low = degrees_at(low_m);
  const double high = degrees_at(high_m);
  if (!(high > low)) return {};
  const double step = round_length((high - low) / 2.0);
  std::vector<Tick> ticks;
  for (double value = std::ceil(low / step) * step; value <= high; value += step) {
    ticks.push_back(
        {low_m + (value - low) / (high - low) * (high_m - low_m), degrees_text(value, step)});
  }
  return ticks;
}

}  // namespace

void draw_graticule(Canvas& canvas,
                    const MapFrame& frame,
                    Graticule kind,
                    const ProjectPlane& plane,
                    const Theme& theme) {
  // A turned map has no border along which one coordinate alone changes.
  if (kind == Graticule::kNone || std::abs(frame.camera.up_rad - std::numbers::pi / 2.0) > 1e-9) {
    return;
  }
  const double px = frame.px_per_pt;
  const PageRect& where = frame.where;
  const Eigen::Vector2d low = frame.camera.enu_from_page({where.left, where.bottom}, where);
  const Eigen::Vector2d high = frame.camera.enu_from_page({where.right(), where.top()}, where);
  const bool is_metres = kind == Graticule::kMetres;
  const auto east = is_metres ? metre_ticks(low.x(), high.x())
                              : degree_ticks(frame, plane, true, low.x(), high.x());
  const auto north = is_metres ? metre_ticks(low.y(), high.y())
                               : degree_ticks(frame, plane, false, low.y(), high.y());
  TextStyle style = small_text(theme, px, FontFace::kNumbers);
  style.size_px = 7.0 * px;
  style.colour = theme.muted;
  const StrokeStyle tick_line{theme.muted, 0.75 * px};
  style.align = TextAlign::kCentre;
  const double cap_height = measure_text("0", style).cap_height;
  for (const Tick& tick : east) {
    const double x = frame.page({tick.at_m, low.y()}).x();
    const std::array<Eigen::Vector2d, 2> ends = {Eigen::Vector2d(x, where.bottom),
                                                 Eigen::Vector2d(x, where.bottom - 3.0 * px)};
    canvas.stroke(ends, tick_line);
    const double half = measure_text(tick.text, style).width / 2.0;
    // A number that would reach over the border moves in.
    const double inside = std::min(std::max(x, where.left + half), where.right() - half);
    canvas.text({inside, where.bottom - 4.5 * px - cap_height}, tick.text, style);
  }
  style.align = TextAlign::kRight;
  for (const Tick& tick : north) {
    const double y = frame.page({low.x(), tick.at_m}).y();
    const std::array<Eigen::Vector2d, 2> ends = {Eigen::Vector2d(where.left, y),
                                                 Eigen::Vector2d(where.left - 3.0 * px, y)};
    canvas.stroke(ends, tick_line);
    canvas.text({where.left - 4.5 * px, y - cap_height / 2.0}, tick.text, style);
  }
}

}  // namespace nadir
