// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
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

LegendEntry entry_of(const std::string& name, const PathLook& look) {
  return {name, look.colour, look.is_dashed ? LegendEntry::Kind::kDashed : LegendEntry::Kind::kLine,
          look.casing};
}

bool knows(const RunDocument& run, PoseSource source) {
  return std::any_of(run.steps.begin(), run.steps.end(),
                     [source](const RunStep& step) { return pose_of(step, source).has_value(); });
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
  std::vector<Eigen::Vector2d> places = points_in_enu_m;
  if (next_in_enu_m) {
    PathLook dashed = line;
    dashed.is_dashed = true;
    const std::array<Eigen::Vector2d, 2> leg = {points_in_enu_m.back(), *next_in_enu_m};
    draw_path(canvas, frame, leg, dashed);
    places.push_back(*next_in_enu_m);
  }
  for (const Eigen::Vector2d& point : points_in_enu_m) {
    draw_path_mark(canvas, frame, PathMark::kStart, point, 0.0, line);
  }
  TextStyle style;
  style.face = FontFace::kNumbers;
  style.size_px = 8.5 * px;
  style.colour = theme.text;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const std::string text = distance_text((places[i] - places[i - 1]).norm());
    const Eigen::Vector2d from = frame.page(places[i - 1]);
    const Eigen::Vector2d to = frame.page(places[i]);
    const PageRect plate = plate_at((from + to) / 2.0, text, style, px);
    if ((to - from).norm() < plate.width) continue;
    draw_plate(canvas, (from + to) / 2.0, text, style, with_opacity(theme.page, 0.85), px);
  }
}

void draw_selected_particle(Canvas& canvas,
                            const MapFrame& frame,
                            const Rigid2& pose,
                            const Theme& theme) {
  if (!pose.translation_m().allFinite()) return;
  const double px = frame.px_per_pt;
  const auto ring = ring_around(frame.page(pose.translation_m()), 7.0 * px);
  canvas.stroke(ring, {with_opacity(theme.page, 0.9), 3.2 * px});
  canvas.stroke(ring, {theme.accent, 1.6 * px});
  draw_pose(canvas, frame, pose, 9.0,
            {theme.accent, 1.0, false, with_opacity(theme.page, 0.9), 0.7});
}

std::vector<LegendEntry> map_legend(const MapViewModel& model,
                                    const std::vector<int>& shown,
                                    const Theme& theme) {
  std::vector<LegendEntry> entries;
  std::vector<const MapRun*> runs;
  for (const MapRun& run : model.runs) {
    if (run.document && std::find(shown.begin(), shown.end(), run.number) != shown.end()) {
      runs.push_back(&run);
    }
  }
  const auto is_on = [&](Layer layer) { return model.look.layer(layer).is_visible; };
  if (!runs.empty()) {
    const MapRun& leader = *runs.back();
    if (is_on(Layer::kTruth) && knows(*leader.document, PoseSource::kTruth)) {
      entries.push_back(entry_of("truth", run_path_look(model, leader, PoseSource::kTruth, theme)));
    }
    if (is_on(Layer::kOdometry) && knows(*leader.document, PoseSource::kOdometry)) {
      entries.push_back(
          entry_of("odometry", run_path_look(model, leader, PoseSource::kOdometry, theme)));
    }
    if (is_on(Layer::kEstimate)) {
      for (auto run = runs.rbegin(); run != runs.rend(); ++run) {
        entries.push_back(entry_of(runs.size() == 1 ? "estimate" : (*run)->name,
                                   run_path_look(model, **run, PoseSource::kEstimate, theme)));
      }
    }
    if (is_on(Layer::kEllipses)) {
      const PathLook look = run_path_look(model, leader, PoseSource::kEstimate, theme);
      entries.push_back({"1, 2, 3 sigma", look.colour, LegendEntry::Kind::kRings, look.casing});
    }
    if (is_on(Layer::kParticles) && model.step && model.step->particles) {
      entries.push_back(
          {"particles", value_colour(ValueColours::kViridis, 0.75), LegendEntry::Kind::kDot});
    }
  }
  const auto labels_show = [&] {
    return model.map && is_on(Layer::kLabels) && model.look.layer(Layer::kLabels).opacity > 0.0;
  };
  if (labels_show()) {
    for (ClassId id = 0; id < kClassCount; ++id) {
      if (model.map->statistics().cells.at(id) == 0) continue;
      entries.push_back(
          {std::string(class_info(id).name), class_colour(id), LegendEntry::Kind::kBar});
    }
  }
  return entries;
}

void draw_map_legend(Canvas& canvas,
                     const MapFrame& frame,
                     const std::vector<LegendEntry>& entries,
                     const Theme& theme) {
  const double px = frame.px_per_pt;
  if (entries.empty() || frame.where.width < 260.0 * px) return;
  // As narrow as its longest row needs: rows are broken at two thirds of the map at most.
  const double most = std::min(0.5 * frame.where.width, 300.0 * px);
  TextStyle style;
  style.size_px = 8.5 * px;
  double widest = 0.0;
  double row = 0.0;
  for (const LegendEntry& entry : entries) {
    const double width = 20.0 * px + measure_text(entry.name, style).width;
    if (row > 0.0 && row + 12.0 * px + width > most) row = 0.0;
    row += (row > 0.0 ? 12.0 * px : 0.0) + width;
    widest = std::max(widest, row);
  }
  const double padding = 5.0 * px;
  const double height = legend_height(widest + px, entries, px);
  if (height > 0.4 * frame.where.height) return;
  const PageRect plate{frame.where.right() - widest - 2.0 * padding - 4.0 * px,
                       frame.where.bottom + 4.0 * px, widest + 2.0 * padding,
                       height + 2.0 * padding};
  canvas.fill(corners_of(plate), with_opacity(theme.page, 0.85));
  draw_legend(canvas, {plate.left + padding, plate.bottom + padding, widest + px, height}, entries,
              theme, px);
}

}  // namespace nadir
