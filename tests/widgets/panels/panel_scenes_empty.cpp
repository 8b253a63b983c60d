// SPDX-License-Identifier: Apache-2.0
// Panels of a flight without one, while it is read, or without a part of it.
#include "tests/widgets/panels/made_moment.h"
#include "tests/widgets/panels/panel_scene_parts.h"
#include "tests/widgets/panels/timeline_run.h"
#include "widgets/panels/bookmarks_panel.h"
#include "widgets/panels/camera_panel.h"
#include "widgets/panels/empty_state.h"
#include "widgets/panels/layers_panel.h"
#include "widgets/panels/map_view.h"
#include "widgets/panels/runs_panel.h"
#include "widgets/panels/scene_panel.h"
#include "widgets/panels/settings_panel.h"
#include "widgets/panels/topview_panel.h"
#include "widgets/panels/why_panel.h"

namespace nadir::scenes {
namespace {

const Eigen::Vector2d kSmall(320.0, 260.0);

LayersModel layers_without_data() {
  LayersModel model;
  const MapLook look = default_map_look();
  for (auto layer = look.order.rbegin(); layer != look.order.rend(); ++layer) {
    model.rows.push_back({*layer, look.layer(*layer), "no run"});
  }
  return model;
}

/// A run whose flight knows no truth and that has met no map.
MomentModel moment_without_truth() {
  MomentModel model;
  model.run_name = "loop";
  model.document = made_document(20, [](RunStep& step) {
    step.truth_in_enu.reset();
    step.agreement.reset();
  });
  model.index = 8;
  return model;
}

MomentModel being_read() {
  MomentModel model;
  model.run_name = "loop medium 7";
  model.is_reading = true;
  return model;
}

WhyModel why(bool has_map, bool is_computing) {
  WhyModel model;
  model.run_name = "loop";
  model.has_step = true;
  model.has_map = has_map;
  model.is_computing = is_computing;
  return model;
}

SettingsModel settings_that_fit_nothing() {
  SettingsModel model;
  model.rows = setting_rows({}, {});
  model.presets = {"default"};
  model.preset = "default";
  model.fault = "particles 200 is below min-particles 500";
  model.why_not_from_start = model.fault;
  model.why_not_from_cursor = "open a run first";
  return model;
}

MapViewModel map_being_read() {
  MapViewModel model;
  model.look = default_map_look();
  model.reading = "proving-ground";
  return model;
}

TimelineModel timeline_being_read() {
  TimelineModel model;
  model.reading = "loop medium 7";
  return model;
}

}  // namespace

void add_empty_scenes(std::vector<PanelScene>& scenes) {
  const auto add = [&scenes](PanelScene scene) {
    scenes.push_back(without_data(std::move(scene)));
  };
  const auto draw_state = [](kit::Ui& ui, const EmptyState& state, Nothing& /*kept*/) {
    return draw_empty_state(ui, state);
  };
  add(panel("no-run", "empty_state", kSmall, Room::kFilled, no_run_state("its errors over time"),
            Nothing(), draw_state));
  add(panel("layers-empty", "layers_panel", {320.0, 480.0}, Room::kScrolled, layers_without_data(),
            LayersState{}, draw_layers));
  add(panel("runs-empty", "runs_panel", kSmall, Room::kScrolled, RunsModel{}, RunsState{},
            draw_runs));
  add(panel("bookmarks-empty", "bookmarks_panel", kSmall, Room::kScrolled, BookmarksModel{},
            BookmarksState{}, draw_bookmarks));
  BookmarksModel unmarked;
  unmarked.has_run = true;
  add(panel("bookmarks-none", "bookmarks_panel", kSmall, Room::kScrolled, unmarked,
            BookmarksState{}, draw_bookmarks));
  add(panel("moment-empty", "moment_panel", kSmall, Room::kScrolled, MomentModel{},
            MomentPanelState{}, draw_moment_panel));
  add(panel("moment-reading", "moment_panel", kSmall, Room::kScrolled, being_read(),
            MomentPanelState{}, draw_moment_panel));
  add(panel("moment-without-truth", "moment_panel", {380.0, 640.0}, Room::kScrolled,
            moment_without_truth(), MomentPanelState{}, draw_moment_panel));
  add(panel("why-empty", "why_panel", kSmall, Room::kScrolled, WhyModel{}, WhyState{},
            draw_why_panel));
  add(panel("why-without-map", "why_panel", kSmall, Room::kScrolled, why(false, false), WhyState{},
            draw_why_panel));
  add(panel("why-computing", "why_panel", kSmall, Room::kScrolled, why(true, true), WhyState{},
            draw_why_panel));
  add(panel("settings-fault", "settings_panel", {380.0, 420.0}, Room::kFilled,
            settings_that_fit_nothing(), SettingsState{}, draw_settings_panel));
  add(panel("camera-empty", "camera_panel", kSmall, Room::kFilled, MomentModel{},
            CameraPanelState{}, draw_camera_panel));
  add(panel("camera-without-flight", "camera_panel", kSmall, Room::kFilled, moment_without_truth(),
            CameraPanelState{}, draw_camera_panel));
  add(panel("topview-empty", "topview_panel", kSmall, Room::kFilled, MomentModel{},
            TopviewPanelState{}, draw_topview_panel));
  add(panel("scene-empty", "scene_panel", kSmall, Room::kFilled, MomentModel{}, SceneState{},
            draw_scene_panel));
  add(panel("timeline-empty", "timeline", {700.0, 200.0}, Room::kFilled, TimelineModel{},
            TimelineState{}, draw_timeline));
  add(panel("timeline-reading", "timeline", {700.0, 200.0}, Room::kFilled, timeline_being_read(),
            TimelineState{}, draw_timeline));
  add(panel("map-empty", "map_view", {420.0, 300.0}, Room::kBare, MapViewModel{}, MapViewState{},
            draw_map_view));
  add(panel("map-reading", "map_view", {420.0, 300.0}, Room::kBare, map_being_read(),
            MapViewState{}, draw_map_view));
}

}  // namespace nadir::scenes
