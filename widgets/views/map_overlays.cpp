// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/map_overlays.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

#include "widgets/views/theme.h"

namespace nadir {
namespace {

/// Draws the casing and then the line.
void stroke_cased(Canvas& canvas,
                  std::span<const Eigen::Vector2d> points_on_page,
                  const PathLook& look,
                  double px_per_pt) {
  StrokeStyle line{look.colour, look.width_pt * px_per_pt};
  if (look.casing.alpha > 0) {
    canvas.stroke(points_on_page,
                  {look.casing, (look.width_pt + 2.0 * look.casing_pt) * px_per_pt});
  }
  if (look.is_dashed) line.dashes_px = {4.0 * line.width_px, 2.0 * line.width_px};
  canvas.stroke(points_on_page, line);
}

void fill_cased(Canvas& canvas,
                std::vector<Eigen::Vector2d> outline,
                const PathLook& look,
                double px_per_pt) {
  canvas.fill(outline, look.colour);
  if (look.casing.alpha == 0) return;
  outline.push_back(outline.front());
  outline.push_back(outline[1]);  // so that the last corner is round like the others
  canvas.stroke(outline, {look.casing, look.casing_pt * px_per_pt});
}

std::vector<Eigen::Vector2d> circle(const Eigen::Vector2d& centre, double radius) {
  constexpr int kCorners = 32;
  std::vector<Eigen::Vector2d> outline;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kCorners;
    outline.emplace_back(centre.x() + radius * std::cos(angle),
                         centre.y() + radius * std::sin(angle));
  }
  return outline;
}

/// Direction on the page of a heading in enu.
Eigen::Vector2d on_page(const MapFrame& frame, double heading_rad) {
  const double angle = heading_rad - frame.camera.up_rad + std::numbers::pi / 2.0;
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

void draw_path(Canvas& canvas,
               const MapFrame& frame,
               std::span<const Eigen::Vector2d> points_in_enu_m,
               const PathLook& look) {
  constexpr double kLeastStepPx = 1.0 / 3.0;
  std::vector<Eigen::Vector2d> piece;
  const auto finish = [&] {
    if (piece.size() > 1) stroke_cased(canvas, piece, look, frame.px_per_pt);
    piece.clear();
  };
  for (std::size_t i = 0; i < points_in_enu_m.size(); ++i) {
    if (!points_in_enu_m[i].allFinite()) {
      finish();
      continue;
    }
    const Eigen::Vector2d point = frame.page(points_in_enu_m[i]);
    const bool is_last = i + 1 == points_in_enu_m.size();
    if (!is_last && !piece.empty() && (point - piece.back()).norm() < kLeastStepPx) continue;
    piece.push_back(point);
  }
  finish();
}

void draw_path_mark(Canvas& canvas,
                    const MapFrame& frame,
                    PathMark mark,
                    const Eigen::Vector2d& point_in_enu_m,
                    double heading_rad,
                    const PathLook& look) {
  if (!point_in_enu_m.allFinite()) return;
  const Eigen::Vector2d at = frame.page(point_in_enu_m);
  const double px = frame.px_per_pt;
  switch (mark) {
    case PathMark::kStart:
      fill_cased(canvas, circle(at, 3.2 * px), look, px);
      break;
    case PathMark::kEnd: {
      const double half = 2.9 * px;
      fill_cased(canvas,
                 {at + Eigen::Vector2d(-half, -half), at + Eigen::Vector2d(half, -half),
                  at + Eigen::Vector2d(half, half), at + Eigen::Vector2d(-half, half)},
                 look, px);
      break;
    }
    case PathMark::kTick: {
      const Eigen::Vector2d along = on_page(frame, heading_rad);
      const Eigen::Vector2d across(-along.y(), along.x());
      const std::array<Eigen::Vector2d, 2> ends = {at - 3.0 * px * across, at + 3.0 * px * across};
      PathLook thin = look;
      thin.is_dashed = false;
      thin.width_pt = 0.9;
      stroke_cased(canvas, ends, thin, px);
      break;
    }
  }
}

void draw_ellipses(Canvas& canvas,
                   const MapFrame& frame,
                   const Eigen::Vector2d& centre_in_enu_m,
                   const Eigen::Matrix2d& covariance_m2,
                   std::span<const double> sigmas,
                   const PathLook& look,
                   double outer_share) {
  if (!centre_in_enu_m.allFinite() || !covariance_m2.allFinite()) return;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
  axes.computeDirect(covariance_m2);
  if (axes.info() != Eigen::Success || axes.eigenvalues().minCoeff() <= 0.0) return;
  const Eigen::Matrix2d shape = axes.eigenvectors() * axes.eigenvalues().cwiseSqrt().asDiagonal();
  const double innermost = *std::min_element(sigmas.begin(), sigmas.end());
  for (const double sigma : sigmas) {
    std::vector<Eigen::Vector2d> outline = circle({0.0, 0.0}, sigma);
    for (Eigen::Vector2d& point : outline) point = frame.page(centre_in_enu_m + shape * point);
    const double share = look.colour.alpha / 255.0;
    if (sigma == innermost) canvas.fill(outline, with_opacity(look.colour, 0.15 * share));
    outline.push_back(outline.front());
    PathLook line = look;
    if (sigma > innermost) {
      line.colour = with_opacity(look.colour, outer_share * share);
      line.casing = with_opacity(look.casing, outer_share * 2.0 / 3.0 * look.casing.alpha / 255.0);
    }
    stroke_cased(canvas, outline, line, frame.px_per_pt);
  }
}

void draw_pose(Canvas& canvas,
               const MapFrame& frame,
               const Rigid2& pose_in_enu,
               double size_pt,
               const PathLook& look) {
  if (!pose_in_enu.translation_m().allFinite() || !std::isfinite(pose_in_enu.yaw_rad)) return;
  const Eigen::Vector2d at = frame.page(pose_in_enu.translation_m());
  const Eigen::Vector2d along = on_page(frame, pose_in_enu.yaw_rad) * size_pt * frame.px_per_pt;
  const Eigen::Vector2d across(-along.y(), along.x());
  fill_cased(canvas,
             {at + 0.65 * along, at - 0.35 * along + 0.38 * across, at - 0.15 * along,
              at - 0.35 * along - 0.38 * across},
             look, frame.px_per_pt);
}

PageRect plate_at(const Eigen::Vector2d& centre_on_page,
                  const std::string& line,
                  const TextStyle& style,
                  double px_per_pt) {
  const TextExtent extent = measure_text(line, style);
  const Eigen::Vector2d half(extent.width / 2.0 + 3.0 * px_per_pt,
                             extent.cap_height / 2.0 + 2.5 * px_per_pt);
  const Eigen::Vector2d corner = centre_on_page - half;
  return {corner.x(), corner.y(), 2.0 * half.x(), 2.0 * half.y()};
}

void draw_plate(Canvas& canvas,
                const Eigen::Vector2d& centre_on_page,
                const std::string& line,
                const TextStyle& style,
                Rgba plate,
                double px_per_pt) {
  TextStyle centred = style;
  centred.align = TextAlign::kCentre;
  const PageRect covered = plate_at(centre_on_page, line, centred, px_per_pt);
  const std::array<Eigen::Vector2d, 4> corners = {Eigen::Vector2d(covered.left, covered.bottom),
                                                  Eigen::Vector2d(covered.right(), covered.bottom),
                                                  Eigen::Vector2d(covered.right(), covered.top()),
                                                  Eigen::Vector2d(covered.left, covered.top())};
  canvas.fill(corners, plate);
  const double cap_height = measure_text(line, centred).cap_height;
  canvas.text(centre_on_page - Eigen::Vector2d(0.0, cap_height / 2.0), line, centred);
}

}  // namespace nadir
