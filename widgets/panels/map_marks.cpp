// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <numbers>

#include "widgets/panels/map_lines.h"
#include "widgets/panels/picture_area.h"

namespace nadir {
namespace {

std::vector<Eigen::Vector2d> ring_around(const Eigen::Vector2d& centre, double radius) {
  constexpr int kRingCorners = 32;
  std::vector<Eigen::Vector2d> ring;
  for (int i = 0; i <= kRingCorners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kRingCorners;
    ring.emplace_back(centre + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

}  // namespace

void draw_measured(Canvas& canvas,
                   const MapFrame& frame,
                   const std::vector<Eigen::Vector2d>& points_in_enu_m,
                   const std::optional<Eigen::Vector2d>& next_in_enu_m,
                   const Theme& theme) {
  if (points_in_enu_m.empty()) return;
  const double px = frame.px_per_pt;
  const PathLook line{theme.accent, 1.5, false, with_opacity(theme.page, 0.9), 0.8};
  if (points_in_enu_m.size() >= 3) {
    std::vector<Eigen::Vector2d> inside;
    inside.reserve(points_in_enu_m.size());
    for (const Eigen::Vector2d& point : points_in_enu_m) inside.push_back(frame.page(point));
    canvas.fill(inside, with_opacity(theme.accent, 0.15));
  }
  draw_path(canvas, frame, points_in_enu_m, line);
  if (next_in_enu_m) {
    PathLook dashed = line;
    dashed.is_dashed = true;
    const std::array<Eigen::Vector2d, 2> leg = {points_in_enu_m.back(), *next_in_enu_m};
    draw_path(canvas, frame, leg, dashed);
  }
  for (const Eigen::Vector2d& point : points_in_enu_m) {
    draw_path_mark(canvas, frame, PathMark::kStart, point, 0.0, line);
  }
  TextStyle style;
  style.face = FontFace::kNumbers;
  style.size_px = 8.5 * px;
  style.colour = theme.text;
  for (std::size_t i = 1; i < points_in_enu_m.size(); ++i) {
    const std::string text = distance_text((points_in_enu_m[i] - points_in_enu_m[i - 1]).norm());
    const Eigen::Vector2d from = frame.page(points_in_enu_m[i - 1]);
    const Eigen::Vector2d to = frame.page(points_in_enu_m[i]);
    const PageRect plate = plate_at((from + to) / 2.0, text, style, px);
    if ((to - from).norm() < plate.width) continue;
    draw_plate(canvas, (from + to) / 2.0, text, style, with_opacity(theme.page, 0.85), px);
  }
}

std::vector<std::string> running_words(const std::vector<Eigen::Vector2d>& points_in_enu_m,
                                       const Eigen::Vector2d& next_in_enu_m) {
  if (points_in_enu_m.empty()) return {};
  std::vector<Eigen::Vector2d> places = points_in_enu_m;
  places.push_back(next_in_enu_m);
  const Measured measured = measure(places);
  std::vector<std::string> words = {distance_text(*measured.last_leg_m)};
  if (measured.bearing_deg) words[0] += "  " + bearing_text(*measured.bearing_deg);
  if (places.size() > 2) words.push_back(distance_text(measured.length_m) + " in all");
  return words;
}

void draw_particle_ring(Canvas& canvas,
                        const MapFrame& frame,
                        const Rigid2& pose,
                        bool is_selected,
                        const Theme& theme) {
  if (!pose.translation_m().allFinite()) return;
  const double px = frame.px_per_pt;
  const auto ring = ring_around(frame.page(pose.translation_m()), 7.0 * px);
  const Rgba plate = with_opacity(theme.page, 0.9);
  if (is_selected) canvas.fill(ring, with_opacity(theme.accent, 0.25));
  canvas.stroke(ring, {plate, (is_selected ? 4.4 : 2.8) * px});
  canvas.stroke(ring, {theme.accent, (is_selected ? 2.2 : 1.2) * px});
  if (is_selected) draw_pose(canvas, frame, pose, 9.0, {theme.accent, 1.0, false, plate, 0.7});
}

}  // namespace nadir
