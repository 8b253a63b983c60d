// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/map_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "widgets/panels/empty_state.h"
#include "widgets/panels/map_cards.h"
#include "widgets/panels/map_lines.h"
#include "widgets/panels/picture_area.h"
#include "widgets/views/map_furniture.h"

namespace nadir {
namespace {

constexpr double kMapZoomPerNotch = 1.25;
constexpr double kPickPx =
    14.0;  ///< Of the design: how near a click must be to a particle or a bookmark.
constexpr double kTurnDeg = 15.0;  ///< Of one press of R.
constexpr double kLeastMetresPerPx = 1e-3, kMostMetresPerPx = 1e4;

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

/// One map: the only one, or one of two beside each other.
struct MapPane {
  std::string name;  ///< Of its area.
  std::vector<int>
      shown;  ///< Numbers of the runs on it; the last one's particles lie on the ground.
  Eigen::Vector2d size;
};

class MapPaneView {
 public:
  MapPaneView(kit::Ui& ui, const MapViewModel& model, MapViewState& state, MapPane pane)
      : ui_(ui), model_(model), state_(state), pane_(std::move(pane)) {}

  Actions draw(bool is_main) {
    area_ = ui_.area(pane_.name, pane_.size);
    // Whole pixels, from the upper left corner, so that ground and window have the same ones.
    const double width = std::max(1.0, std::floor(area_.rect.width));
    const double height = std::max(1.0, std::floor(area_.rect.height));
    where_ = {0.0, area_.rect.height - height, width, height};
    const GroundBounds all =
        model_.look.width_m > 0.0 ? GroundBounds{} : all_bounds(model_, state_.paths);
    camera_ = map_camera(model_.look, where_, all);
    if (is_main) {
      state_.camera = camera_;
      state_.where = where_;
    }
    handle_gestures();
    draw_ground();
    draw_lines();
    append(draw_map_menu(ui_, model_, state_.menu_in_enu_m));
    return std::move(asked_);
  }

 private:
  void append(Actions more) {
    for (Action& action : more) asked_.push_back(std::move(action));
  }
  void look_at(const Eigen::Vector2d& centre_in_enu_m, std::optional<double> metres_per_px = {}) {
    std::optional<double> width_m;
    if (metres_per_px || model_.look.width_m <= 0.0) {
      width_m = metres_per_px.value_or(camera_.metres_per_px) * where_.width;
    }
    asked_.emplace_back(actions::LookAt{centre_in_enu_m.x(), centre_in_enu_m.y(), width_m});
  }
  [[nodiscard]] Eigen::Vector2d under_mouse() const {
    return camera_.enu_from_page(area_.mouse, where_);
  }

  void handle_gestures() {
    if (area_.is_hovered) {
      state_.readout = map_readout(under_mouse(), model_.map ? &model_.map->map() : nullptr,
                                   model_.plane ? &*model_.plane : nullptr);
      if (area_.wheel.y() != 0.0) zoom(std::pow(kMapZoomPerNotch, area_.wheel.y()));
      if (ui_.is_pressed("R", true)) asked_.emplace_back(actions::Rotate{kTurnDeg});
      if (ui_.is_pressed("Shift+R", true)) asked_.emplace_back(actions::Rotate{-kTurnDeg});
    }
    drag();
    if (area_.clicked == kit::MouseButton::kRight) state_.menu_in_enu_m = under_mouse();
    if (area_.double_clicked == kit::MouseButton::kLeft) {
      if (model_.look.tool == MapTool::kMeasure) {
        asked_.emplace_back(
            actions::UseTool{MapTool::kPan});  // its first click has set the last place
      } else {
        look_at(under_mouse());
      }
    } else if (area_.clicked == kit::MouseButton::kLeft) {
      click();
    }
  }

  void zoom(double factor) {
    const double metres_per_px = camera_.metres_per_px / factor;
    if (metres_per_px < kLeastMetresPerPx || metres_per_px > kMostMetresPerPx) return;
    if (model_.look.width_m <= 0.0) {  // nobody has chosen one yet that could be multiplied
      look_at(zoomed_at(camera_, factor, area_.mouse, where_).centre_in_enu_m, metres_per_px);
      return;
    }
    if (model_.look.is_following) {  // the estimate stays in the middle
      asked_.emplace_back(actions::Zoom{factor, {}, {}});
      return;
    }
    const Eigen::Vector2d stays = under_mouse();
    asked_.emplace_back(actions::Zoom{factor, stays.x(), stays.y()});
  }

  void drag() {
    const bool pans = area_.drag && area_.drag->button != kit::MouseButton::kRight;
    if (!pans && state_.grabbing_pane == pane_.name) state_.grabbing_pane.clear();
    if (!area_.drag || area_.drag->delta.isZero()) return;
    if (!pans) {
      const double angle_deg = turned_deg(area_.mouse - area_.drag->delta, area_.mouse, where_);
      if (angle_deg != 0.0) asked_.emplace_back(actions::Rotate{angle_deg});
      return;
    }
    // What was under the mouse stays under it, however long the way.
    if (area_.drag->was_started || state_.grabbing_pane != pane_.name) {
      state_.grabbing_pane = pane_.name;
      state_.grabbed_in_enu_m = camera_.enu_from_page(area_.drag->start, where_);
    }
    look_at(with_ground_at(camera_, state_.grabbed_in_enu_m, area_.mouse, where_).centre_in_enu_m);
  }

  void click() {
    if (model_.look.tool == MapTool::kMeasure) {
      const Eigen::Vector2d place = under_mouse();
      asked_.emplace_back(actions::MeasurePoint{place.x(), place.y()});
    }
    if (model_.look.tool == MapTool::kPick) {
      std::optional<int> picked;
      if (model_.step && model_.step->particles) {
        picked = nearest_particle(*model_.step->particles, camera_, where_, area_.mouse,
                                  ui_.px(kPickPx));
      }
      if (picked != model_.selected_particle) asked_.emplace_back(actions::SelectParticle{picked});
    }
  }

  void draw_ground() {
    ui_.canvas().fill(corners_of(area_.page()), ui_.theme().window);
    if (!state_.ground) return;
    const MapGround ground{pane_.shown.empty() ? 0 : pane_.shown.back(), camera_,
                           static_cast<int>(where_.width), static_cast<int>(where_.height)};
    if (const kit::TextureId texture = state_.ground(ground); texture != 0) {
      ui_.image(texture, where_);
    }
  }

  void draw_lines() {
    Canvas& canvas = ui_.canvas();
    const Theme& theme = ui_.theme();
    const MapFrame frame{where_, camera_, ui_.px(96.0 / 72.0)};
    draw_map_lines(canvas, frame, model_, pane_.shown, state_.paths, theme);
    std::optional<Eigen::Vector2d> next;
    if (area_.is_hovered && model_.look.tool == MapTool::kMeasure) next = under_mouse();
    draw_measured(canvas, frame, model_.look.measured_in_enu_m, next, theme);
    if (const auto index = selected_particle(model_)) {
      draw_selected_particle(canvas, frame, model_.step->particles->pose(*index), theme);
    }
    draw_scale_bar(canvas, frame, theme);
    draw_north_arrow(canvas, frame, theme);
    if (model_.look.layer(Layer::kLegend).is_visible) {
      draw_map_legend(canvas, frame, map_legend(model_, pane_.shown, theme), theme);
    }
    name_bookmark();
  }

  /// The note of the bookmark under the mouse.
  void name_bookmark() {
    if (!area_.is_hovered) return;
    for (const MapRun& run : model_.runs) {
      for (std::size_t i = 0; i < run.bookmarks_in_enu_m.size(); ++i) {
        const Eigen::Vector2d at = camera_.page_from_enu(run.bookmarks_in_enu_m[i], where_);
        if (!((at - area_.mouse).norm() <= ui_.px(kPickPx / 2.0))) continue;
        const std::vector<std::string> lines = {"Bookmark", run.bookmark_notes[i]};
        ui_.mouse_tooltip(std::span(lines).first(lines[1].empty() ? 1 : 2));
        return;
      }
    }
  }

  kit::Ui& ui_;
  const MapViewModel& model_;
  MapViewState& state_;
  MapPane pane_;
  kit::AreaInput area_;
  PageRect where_;
  MapCamera camera_;
  Actions asked_;
};

/// Escape ends what is being done, one thing after the other.
void handle_escape(kit::Ui& ui, const MapViewModel& model, Actions& asked) {
  if (!model.takes_keys || !ui.is_pressed("Escape")) return;
  if (model.look.tool == MapTool::kMeasure) {
    asked.emplace_back(actions::UseTool{MapTool::kPan});
  } else if (model.selected_particle) {
    asked.emplace_back(actions::SelectParticle{});
  } else if (!model.look.measured_in_enu_m.empty()) {
    asked.emplace_back(actions::MeasurePoint{});
  }
}

/// What is not there yet, in a line at the middle of the lower border.
void draw_map_note(kit::Ui& ui, const MapViewModel& model, const kit::Rect& map) {
  std::string words;
  if (!model.reading.empty()) {
    words = fmt::format("Reading {}…", model.reading);
  } else if (model.look.is_split && model.runs.size() < 2) {
    words = "Open a second run to see two maps";
  } else if (!model.map) {
    words = "No map is open: drop one on the window";
  }
  if (words.empty()) return;
  const double width = ui.text_width(words) + ui.px(24.0);
  const kit::Rect place{map.centre().x() - width / 2.0, map.bottom() - ui.px(44.0), width,
                        ui.px(32.0)};
  if (width > map.width) return;
  const auto note = ui.region("Note", place,
                              {.surface = kit::Surface::kPlate,
                               .padding = ui.px(6.0),
                               .is_above = true,
                               .takes_input = false});
  ui.text(words, kit::TextLook::kMuted);
}

}  // namespace

Actions draw_map_view(kit::Ui& ui, const MapViewModel& model, MapViewState& state) {
  const auto scope = ui.scope("Map");
  state.readout.reset();
  std::vector<std::shared_ptr<const RunDocument>> documents;
  for (const MapRun& run : model.runs) documents.push_back(run.document);
  state.paths.keep_only(documents);
  const bool has_something = model.map || std::any_of(documents.begin(), documents.end(),
                                                      [](const auto& d) { return d != nullptr; });
  if (!has_something) {
    if (!model.reading.empty()) return draw_empty_state(ui, reading_state(model.reading));
    return draw_empty_state(ui,
                            {kit::Icon::kMap,
                             "No map is open",
                             "Drop a run, a map or a flight on the window, or begin with the demo.",
                             "Open the demo",
                             {},
                             actions::OpenDemo{}});
  }
  Actions asked;
  const kit::Rect room = ui.room();
  std::vector<int> all;
  for (const MapRun& run : model.runs) all.push_back(run.number);
  if (model.look.is_split && all.size() >= 2) {
    const double half = std::floor((room.width - ui.px(2.0)) / 2.0);
    const Eigen::Vector2d size(half, room.height);
    MapPaneView left(ui, model, state, {"Ground", {all.back()}, size});
    asked = left.draw(true);
    ui.same_line(ui.px(2.0));
    MapPaneView right(ui, model, state, {"Second ground", {all[all.size() - 2]}, size});
    for (Action& action : right.draw(false)) asked.push_back(std::move(action));
  } else {
    MapPaneView only(ui, model, state, {"Ground", all, {room.width, room.height}});
    asked = only.draw(true);
  }
  for (Action& action : draw_map_tools(ui, model, room)) asked.push_back(std::move(action));
  for (Action& action : draw_map_cards(ui, model, room)) asked.push_back(std::move(action));
  draw_map_note(ui, model, room);
  handle_escape(ui, model, asked);
  return asked;
}

}  // namespace nadir
