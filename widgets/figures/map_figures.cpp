// SPDX-License-Identifier: Apache-2.0
// Figures of a map alone: overhead-pair, route, labels.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/map/class_statistics.h"
#include "core/map/overhead_map_file.h"
#include "core/sim/route.h"
#include "widgets/figures/figures.h"
#include "widgets/figures/map_panel.h"
#include "widgets/figures/page_layout.h"

namespace nadir {
namespace {

/// Classes that a map holds, by falling share, with the share in words.
std::vector<LegendEntry> class_legend(const OverheadMap& map, bool with_shares) {
  const ClassStatistics statistics = class_statistics(map.labels);
  std::vector<ClassId> ids;
  for (ClassId id = 0; id < kClassCount; ++id) {
    if (statistics.cells[id] > 0) ids.push_back(id);
  }
  std::sort(ids.begin(), ids.end(), [&](ClassId a, ClassId b) {
    return statistics.cells[a] != statistics.cells[b] ? statistics.cells[a] > statistics.cells[b]
                                                      : a < b;
  });
  std::vector<LegendEntry> entries;
  for (const ClassId id : ids) {
    std::string name(class_info(id).name);
    if (with_shares) name += fmt::format(" {:.1f} %", 100.0 * statistics.share_of_all(id));
    entries.push_back({name, class_colour(id), LegendEntry::Kind::kBar});
  }
  return entries;
}

std::string provenance_text(const MapProvenance& provenance) {
  std::string text = provenance.name;
  if (!provenance.date.empty()) text += " · " + provenance.date;
  if (!provenance.licence.empty()) text += " · " + provenance.licence;
  return text;
}

class OverheadPair : public Figure {
 public:
  OverheadPair(std::unique_ptr<MapPanel> picture,
               std::unique_ptr<MapPanel> labels,
               std::vector<LegendEntry> legend,
               std::string foot)
      : picture_(std::move(picture)),
        labels_(std::move(labels)),
        legend_(std::move(legend)),
        foot_(std::move(foot)) {
    picture_->include_map();
    labels_->include_map();
  }

  Result<void> draw(Canvas& canvas, FigureContext& context) override {
    const PageFormat& format = context.format();
    PageRect rest = page_inside(format);
    draw_foot(canvas, format, rest, foot_);
    draw_page_legend(canvas, format, rest, legend_);
    const std::vector<PageRect> panels = arranged(rest, format);
    const std::array<const char*, 2> captions = {
        picture_->shows_picture() ? "(a) overhead picture" : "(a) labels, for want of a picture",
        "(b) labels"};
    for (std::size_t i = 0; i < 2; ++i) {
      if (!least_map(format).fits_in(panels[i])) continue;
      MapPanel& map = i == 0 ? *picture_ : *labels_;
      PageRect panel = map.part_filled(panels[i], kCaptionPt * format.px_per_pt(), format);
      draw_caption(canvas, format, panel, captions.at(i));
      const auto frame = map.draw_ground(canvas, context, panel);
      if (!frame) return forward_error(frame);
      map.draw_furniture(canvas, format, *frame);
    }
    return {};
  }

 private:
  /// Beside or below each other, whichever shows the map larger.
  [[nodiscard]] std::vector<PageRect> arranged(const PageRect& whole,
                                               const PageFormat& format) const {
    const double gap = 10.0 * format.px_per_pt();
    const Eigen::Vector2d size_m = picture_->map_bounds_in_enu_m().sizes();
    const auto scale_in = [&size_m](const std::vector<PageRect>& panels) {
      return std::min(panels[0].width / size_m.x(), panels[0].height / size_m.y());
    };
    auto beside = fitting_columns(whole, {1.0, 1.0}, gap, least_map(format));
    auto below = fitting_rows(whole, {1.0, 1.0}, gap, least_map(format));
    const bool has_both_beside = beside[1].width > 0.0;
    const bool has_both_below = below[1].width > 0.0;
    if (has_both_beside != has_both_below) return has_both_beside ? beside : below;
    return scale_in(beside) >= scale_in(below) ? beside : below;
  }

  std::unique_ptr<MapPanel> picture_, labels_;
  std::vector<LegendEntry> legend_;
  std::string foot_;
};

class RouteFigure : public Figure {
 public:
  RouteFigure(std::unique_ptr<MapPanel> map, Route route, std::string foot)
      : map_(std::move(map)), route_(std::move(route)), foot_(std::move(foot)) {
    map_->include(route_.waypoints_in_enu_m);
  }

  Result<void> draw(Canvas& canvas, FigureContext& context) override {
    const PageFormat& format = context.format();
    const Theme& theme = format.colours();
    PageRect rest = page_inside(format);
    draw_foot(canvas, format, rest, foot_);
    if (!least_map(format).fits_in(rest)) return {};
    const auto frame = map_->draw_ground(canvas, context, rest);
    if (!frame) return forward_error(frame);
    canvas.push_clip(frame->where);
    std::vector<Eigen::Vector2d> points = route_.waypoints_in_enu_m;
    if (route_.is_closed) points.push_back(points.front());
    draw_path(canvas, *frame, points, estimate_look(theme));
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const Eigen::Vector2d way = points[i + 1] - points[i];
      draw_pose(canvas, *frame,
                {points[i].x() + way.x() / 2.0, points[i].y() + way.y() / 2.0,
                 std::atan2(way.y(), way.x())},
                9.0, estimate_look(theme));
    }
    const std::vector<PageRect> plates = draw_waypoints(canvas, *frame, theme);
    canvas.pop_clip();
    map_->draw_furniture(canvas, format, *frame, plates);
    return {};
  }

 private:
  /// Numbers on plates inside the map; a waypoint whose plate would cover another one is a dot. @returns the plates.
  [[nodiscard]] std::vector<PageRect> draw_waypoints(Canvas& canvas,
                                                     const MapFrame& frame,
                                                     const Theme& theme) const {
    const double px = frame.px_per_pt;
    TextStyle style;
    style.size_px = 9.0 * px;
    style.is_bold = true;
    style.colour = theme.text;
    std::vector<PageRect> plates;
    for (std::size_t i = 0; i < route_.waypoints_in_enu_m.size(); ++i) {
      const Eigen::Vector2d& point = route_.waypoints_in_enu_m[i];
      const std::string& name = route_.waypoint_names[i];
      const PageRect size = plate_at({0.0, 0.0}, name, style, px);
      const Eigen::Vector2d half(size.width / 2.0, size.height / 2.0);
      const Eigen::Vector2d low = Eigen::Vector2d(frame.where.left, frame.where.bottom) + half;
      const Eigen::Vector2d high = Eigen::Vector2d(frame.where.right(), frame.where.top()) - half;
      // A waypoint on the way between two that have a name has none.
      const bool has_room = !name.empty() && (low.array() <= high.array()).all();
      const Eigen::Vector2d at = frame.page(point).cwiseMax(low).cwiseMin(high);
      const PageRect plate = plate_at(at, name, style, px);
      const auto covers = [&plate](const PageRect& other) { return overlap(plate, other); };
      if (!has_room || std::any_of(plates.begin(), plates.end(), covers)) {
        draw_path_mark(canvas, frame, PathMark::kStart, point, 0.0, estimate_look(theme));
        continue;
      }
      draw_plate(canvas, at, name, style, with_opacity(theme.page, 0.9), px);
      plates.push_back(plate);
    }
    return plates;
  }

  std::unique_ptr<MapPanel> map_;
  Route route_;
  std::string foot_;
};

class LabelsFigure : public Figure {
 public:
  LabelsFigure(std::unique_ptr<MapPanel> map, std::vector<LegendEntry> legend, std::string foot)
      : map_(std::move(map)), legend_(std::move(legend)), foot_(std::move(foot)) {
    map_->include_map();
  }

  Result<void> draw(Canvas& canvas, FigureContext& context) override {
    const PageFormat& format = context.format();
    PageRect rest = page_inside(format);
    draw_foot(canvas, format, rest, foot_);
    draw_page_legend(canvas, format, rest, legend_);
    if (!least_map(format).fits_in(rest)) return {};
    const auto frame = map_->draw_ground(canvas, context, map_->part_filled(rest, 0.0, format));
    if (!frame) return forward_error(frame);
    map_->draw_furniture(canvas, format, *frame);
    return {};
  }

 private:
  std::unique_ptr<MapPanel> map_;
  std::vector<LegendEntry> legend_;
  std::string foot_;
};

}  // namespace

Result<std::unique_ptr<Figure>> make_overhead_pair(
    FigureInputs inputs) {  // NOLINT(performance-unnecessary-value-param): as all
  const auto map = read_overhead_map(inputs.map);
  if (!map) return forward_error(map);
  const auto provenance = read_map_provenance(inputs.map);
  if (!provenance) return forward_error(provenance);
  auto picture = MapPanel::create(inputs.map, MapPanel::Ground::kPicture, inputs.options);
  if (!picture) return forward_error(picture);
  auto labels = MapPanel::create(inputs.map, MapPanel::Ground::kLabels, inputs.options);
  if (!labels) return forward_error(labels);
  return std::make_unique<OverheadPair>(std::move(*picture), std::move(*labels),
                                        class_legend(*map, false), provenance_text(*provenance));
}

Result<std::unique_ptr<Figure>> make_labels(
    FigureInputs inputs) {  // NOLINT(performance-unnecessary-value-param): as all
  const auto map = read_overhead_map(inputs.map);
  if (!map) return forward_error(map);
  const auto provenance = read_map_provenance(inputs.map);
  if (!provenance) return forward_error(provenance);
  auto panel = MapPanel::create(inputs.map, MapPanel::Ground::kLabels, inputs.options);
  if (!panel) return forward_error(panel);
  return std::make_unique<LabelsFigure>(std::move(*panel), class_legend(*map, true),
                                        provenance_text(*provenance) + " · share of all cells");
}

Result<std::unique_ptr<Figure>> make_route(
    FigureInputs inputs) {  // NOLINT(performance-unnecessary-value-param): as all
  const std::filesystem::path file =
      inputs.route.empty() ? inputs.map / "routes" / "loop.toml" : inputs.route;
  auto route = read_route(file);
  if (!route) return forward_error(route);
  auto panel = MapPanel::create(inputs.map, MapPanel::Ground::kPicture, inputs.options);
  if (!panel) return forward_error(panel);
  double length_m = 0.0;
  const auto& points = route->waypoints_in_enu_m;
  for (std::size_t i = 0; i + 1 < points.size() + (route->is_closed ? 1U : 0U); ++i) {
    length_m += (points[(i + 1) % points.size()] - points[i]).norm();
  }
  const std::string foot = fmt::format(
      "{}: {:.0f} m{}, {:g} m above ground, at most {:g} m/s", route->name, length_m * route->laps,
      route->laps > 1 ? fmt::format(" in {} laps", route->laps) : std::string(), route->altitude_m,
      route->speed_mps);
  return std::make_unique<RouteFigure>(std::move(*panel), std::move(*route), foot);
}

}  // namespace nadir
