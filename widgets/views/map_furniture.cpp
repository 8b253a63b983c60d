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

TextStyle small_text(const Theme& theme, double px_per_pt, FontFace face) {
  TextStyle style;
  style.face = face;
  style.size_px = kScaleBarTextPt * px_per_pt;
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

}  // namespace nadir
