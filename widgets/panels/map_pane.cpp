// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/map_pane.h"

#include <algorithm>
#include <cmath>

#include "core/session/map_parts.h"
#include "widgets/panels/map_cards.h"
#include "widgets/panels/map_lines.h"
#include "widgets/panels/map_notes.h"
#include "widgets/panels/map_vehicle.h"
#include "widgets/panels/picture_area.h"
#include "widgets/views/legend.h"
#include "widgets/views/map_furniture.h"

namespace nadir {
namespace {

constexpr double kBookmarkPx = 7.0;  ///< Of the design: how near the mouse must be to a bookmark.
/// Of the design: the size that the window's small text is made in, so that words on the map are as sharp.
constexpr double kSharpText = 12.0;

/// Bounds of all that the map could show at first: the runs, else the map.
GroundBounds all_bounds(const MapViewModel& model, RunPathsCache& cache) {
  GroundBounds all;
  for (const MapRun& run : model.runs) {
    if (!run.document) continue;
    const RunPaths& paths = cache.of(run.document);
    for (const auto* points : {&paths.truth, &paths.odometry, &paths.estimate}) {
      for (const Eigen::Vector2d& point : *points) all.include(point);
    }
  }
  if (all.empty() && model.map) {
    const OverheadMap& map = model.map->map();
    all.include(map.top_left_in_enu_m);
    all.include(map.top_left_in_enu_m + Eigen::Vector2d(map.width_m(), -map.height_m()));
  }
  return all;
}

}  // namespace

Actions MapPaneView::draw() {
  area_ = ui_.area(pane_.name, pane_.size);
  // Whole pixels, from the upper left corner, so that ground and window have the same ones.
  const double width = std::max(1.0, std::floor(area_.rect.width));
  const double height = std::max(1.0, std::floor(area_.rect.height));
  where_ = {0.0, area_.rect.height - height, width, height};
  const GroundBounds all =
      model_.look.width_m > 0.0 ? GroundBounds{} : all_bounds(model_, state_.paths);
  camera_ = map_camera(model_.look, where_, all);
  if (pane_.is_main) {
    state_.camera = camera_;
    state_.where = where_;
  }
  if (model_.labels != nullptr) {
    handle_label_gestures();
    draw_label_content();
  } else {
    handle_gestures();
    draw_content();
  }
  const std::string menu = pane_.is_main ? "Menu" : "Second menu";
  for (Action& action : draw_map_menu(ui_, menu, model_, state_.menu_in_enu_m)) {
    asked_.push_back(std::move(action));
  }
  return std::move(asked_);
}

void MapPaneView::draw_content() {
  ui_.canvas().fill(corners_of(area_.page()), ui_.theme().window);
  const MapFrame frame{where_, camera_, ui_.px(96.0 / 72.0)};
  const MapDrawing drawing{ui_.canvas(), frame, model_, pane_.shown, state_.paths, ui_.theme()};
  const bool is_plain = !model_.map && model_.reading.empty();
  if (is_plain && !is_in_sight(model_.look, Layer::kGraticule)) draw_map_grid(drawing, true);
  const std::vector<MapPart> parts = map_parts(model_.look);
  MapGround ground;
  ground.run = pane_.shown.empty() ? 0 : pane_.shown.back();
  ground.camera = camera_;
  ground.width_px = static_cast<int>(where_.width);
  ground.height_px = static_cast<int>(where_.height);
  ground.part_count = static_cast<int>(
      std::count_if(parts.begin(), parts.end(), [](const auto& part) { return part.is_ground; }));
  ground.is_second = !pane_.is_main;
  for (const MapPart& part : parts) {
    if (part.is_ground) {
      ground.layers = part.layers;
      ground.is_lowest = &part == &parts.front() && !is_plain;  // the grid lies below
      draw_ground(ground);
      ++ground.part;
    } else {
      for (const Layer layer : part.layers) draw_map_layer(drawing, layer);
    }
  }
  draw_map_poses(drawing);
  draw_doings(frame);
  draw_furniture(frame);
  if (pane_.is_main) point_to_vehicle(frame);
  name_bookmark();
}

void MapPaneView::draw_ground(const MapGround& ground) {
  if (!state_.ground) return;
  if (const kit::TextureId texture = state_.ground(ground); texture != 0) {
    ui_.image(texture, where_);
  }
}

/// What is measured and picked.
void MapPaneView::draw_doings(const MapFrame& frame) {
  Canvas& canvas = ui_.canvas();
  const Theme& theme = ui_.theme();
  std::optional<Eigen::Vector2d> next;
  if (area_.is_hovered && model_.look.tool == MapTool::kMeasure) next = under_mouse();
  draw_measured(canvas, frame, model_.look.measured_in_enu_m, next, theme);
  if (next && !model_.look.measured_in_enu_m.empty()) {
    ui_.mouse_tooltip(running_words(model_.look.measured_in_enu_m, *next));
  }
  if (!shows_active_run()) return;
  if (const auto selected = selected_particle(model_)) {
    draw_particle_ring(canvas, frame, model_.step->particles->pose(*selected), true, theme);
  }
  if (!area_.is_hovered || model_.look.tool != MapTool::kPick) return;
  const auto near = particle_under_mouse();
  if (!near || model_.selected_particle == near) return;
  const Rigid2 pose = model_.step->particles->pose(static_cast<std::size_t>(*near));
  draw_particle_ring(canvas, frame, pose, false, theme);
}

void MapPaneView::draw_furniture(const MapFrame& frame) {
  Canvas& canvas = ui_.canvas();
  const Theme& theme = ui_.theme();
  MapFrame sharp = frame;
  sharp.px_per_pt = ui_.px(kSharpText) / kScaleBarTextPt;
  draw_scale_bar(canvas, sharp, theme);
  draw_north_arrow(canvas, frame, theme);
  PageRect legend, lasting;
  if (model_.look.layer(Layer::kLegend).is_visible) {
    // Of two halves the second names the classes, which are those of both.
    const bool with_classes = !pane_.is_half || !pane_.is_main;
    sharp.px_per_pt = ui_.px(kSharpText) / kLegendTextPt;
    const auto entries = map_legend(model_, pane_.shown, state_.seen_classes, theme, with_classes);
    legend = draw_map_legend(canvas, sharp, entries, theme,
                             pane_.is_main ? state_.legend : state_.second_legend);
    if (pane_.is_main) {
      lasting =
          place_of_map_legend(sharp, lasting_map_legend(model_, pane_.shown, theme, with_classes),
                              state_.lasting_legend);
    }
  }
  if (legend.width > 0.0) {
    state_.legend_height_px = std::max(state_.legend_height_px, legend.top());
  }
  const double tools = pane_.is_main ? map_tools_width(ui_) : 0.0;
  if (pane_.is_half && model_.runs.size() >= 2) {
    const MapRun& active = model_.runs.back();
    const MapRun& second = model_.runs[model_.runs.size() - 2];
    const MapRun& run = pane_.is_main ? active : second;
    draw_pane_name(canvas, frame, model_, run, pane_.is_main ? &second : &active, tools, theme);
  }
  if (!pane_.is_main) return;
  const auto share = [](double part, double whole) { return std::clamp(part / whole, 0.0, 0.4); };
  state_.room.aspect = where_.width / where_.height;
  state_.room.left = share(tools, where_.width);
  state_.room.bottom =
      lasting.width > 0.0 ? share(lasting.top() - where_.bottom, where_.height) : 0.0;
  state_.room.top = pane_.is_half ? share(ui_.px(32.0), where_.height) : 0.0;
}

/// An arrow, where the vehicle is out of sight; its words lie over the map, and are drawn after it.
void MapPaneView::point_to_vehicle(const MapFrame& frame) {
  const double edge = ui_.px(8.0), above = ui_.px(48.0);  // the north arrow, names and notes
  const double left = state_.room.left * where_.width + edge;
  const double below = std::max(ui_.px(48.0), state_.room.bottom * where_.height + edge);
  const PageRect free{where_.left + left, where_.bottom + below,
                      std::max(1.0, where_.width - left - edge),
                      std::max(1.0, where_.height - below - above)};
  state_.away = vehicle_away(model_, frame, free);
  if (state_.away) draw_vehicle_arrow(ui_, *state_.away);
}

/// The note of the bookmark under the mouse.
void MapPaneView::name_bookmark() {
  if (!area_.is_hovered) return;
  for (const MapRun& run : model_.runs) {
    for (std::size_t i = 0; i < run.bookmarks_in_enu_m.size(); ++i) {
      const Eigen::Vector2d at = camera_.page_from_enu(run.bookmarks_in_enu_m[i], where_);
      if (!((at - middle_of_pixel(area_.mouse)).norm() <= ui_.px(kBookmarkPx))) continue;
      const std::vector<std::string> lines = {"Bookmark", run.bookmark_notes[i]};
      ui_.mouse_tooltip(std::span(lines).first(lines[1].empty() ? 1 : 2));
      return;
    }
  }
}

}  // namespace nadir
