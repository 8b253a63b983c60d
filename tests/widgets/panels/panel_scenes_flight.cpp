// SPDX-License-Identifier: Apache-2.0
// Panels of a flight, with one that went wrong for a while.
#include <algorithm>
#include <cmath>

#include "tests/support/error_text.h"
#include "tests/widgets/panels/made_moment.h"
#include "tests/widgets/panels/panel_scene_parts.h"
#include "tests/widgets/panels/timeline_run.h"
#include "widgets/gl/view_texture.h"
#include "widgets/panels/bookmarks_panel.h"
#include "widgets/panels/camera_panel.h"
#include "widgets/panels/layers_panel.h"
#include "widgets/panels/map_view.h"
#include "widgets/panels/runs_panel.h"
#include "widgets/panels/scene_panel.h"
#include "widgets/panels/settings_panel.h"
#include "widgets/panels/topview_panel.h"
#include "widgets/panels/why_panel.h"

namespace nadir::scenes {
namespace {

const Eigen::Vector2d kColumn(340.0, 520.0);

/// Half a metre off, but for some seconds in the middle, and without anything between 26 and 29 s.
std::shared_ptr<const RunDocument> run_that_goes_wrong(double worst_m, std::uint64_t seed) {
  RunDocument run = made_run(400, [worst_m](RunStep& step) {
    const double along = (step.step - 180) / 25.0;
    const double error_m =
        0.4 + 0.2 * std::sin(0.21 * step.step) + worst_m * std::exp(-along * along);
    set_error_m(step, error_m);
    step.agreement = 0.92 - 0.04 * error_m;
    step.effective_sample_size = 900.0 / (1.0 + 0.4 * error_m);
    step.update_ms = 9.0 + 3.0 * std::cos(0.13 * step.step);
  });
  std::erase_if(run.steps, [](const RunStep& step) { return step.step > 260 && step.step < 290; });
  run.header.seed = seed;
  run.header.options = {{"seed", std::to_string(seed)}, {"position-noise", "0.5"}};
  return RunDocument::from_steps(std::move(run));
}

LayersModel layers() {
  LayersModel model;
  const MapLook look = default_map_look();
  for (auto layer = look.order.rbegin(); layer != look.order.rend(); ++layer) {
    model.rows.push_back({*layer, look.layer(*layer), ""});
  }
  model.rows[2].look.is_visible = false;
  model.rows[4].look.colour = "#D02060";
  model.rows[6].look.opacity = 0.4;
  model.classes = {{kRoad, 0.62}, {kTerrain, 0.3}, {kBuilding, 0.08}};
  return model;
}

RunsModel runs() {
  const auto row = [](int number, const std::string& name, auto document) {
    RunsModel::Row one;
    one.number = number;
    one.name = name;
    one.path = "/runs/" + name + ".nadir";
    one.colour = number - 1;
    one.document = std::move(document);
    return one;
  };
  RunsModel model;
  model.rows = {row(1, "loop", run_that_goes_wrong(6.0, 1)),
                row(2, "loop-2", run_that_goes_wrong(2.0, 2)), row(3, "loop-3", made_document(40))};
  model.rows[1].is_active = true;
  model.rows[2].is_live = true;
  model.rows[2].progress = 0.1;
  model.rows[2].progress_words = "2 min left";
  model.rows[2].job = 7;
  return model;
}

BookmarksModel bookmarks() {
  BookmarksModel model;
  model.has_run = true;
  model.time_s = 5.0;
  model.bookmarks = {{5.0, "odd turn at the crossing", {}}, {38.3, "", {}}};
  const auto run = run_that_goes_wrong(6.0, 1);
  model.moments = run->worst_moments;
  for (const WorstMoment& moment : model.moments) {
    model.values.push_back(moment_value(*run, moment));
  }
  return model;
}

TimelineModel timeline() {
  TimelineModel model = timeline_of(run_that_goes_wrong(6.0, 1));
  model.runs.insert(model.runs.begin(), timeline_run(run_that_goes_wrong(2.0, 2), false, 2));
  model.bookmarks = {{5.0, "odd turn", {}}, {31.0, "", {}}};
  model.time_s = 18.2;
  model.loop_from_s = 12.0;
  model.loop_to_s = 22.0;
  return model;
}

/// Flat ground to the horizon, a building at the left, a marking ahead.
std::shared_ptr<const CameraMoment> frame() {
  CameraMoment camera;
  constexpr int kWidth = 160, kHeight = 100, kHorizon = 36;
  camera.image = ColourRaster(kWidth, kHeight, Colour{150, 180, 215});
  camera.labels = Raster<ClassId>(kWidth, kHeight, kUnclassified);
  camera.depth_m = Raster<float>(kWidth, kHeight, 0.0F);
  for (int row = kHorizon; row < kHeight; ++row) {
    for (int column = 0; column < kWidth; ++column) {
      const int aside = std::abs(column - kWidth / 2);
      const bool is_road = aside < row - kHorizon + 8;
      const bool is_marking = aside * 14 < row - kHorizon;
      camera.labels.at(column, row) = is_marking ? kLaneMarking : is_road ? kRoad : kTerrain;
      camera.image.at(column, row) = is_marking ? Colour{225, 225, 215}
                                     : is_road  ? Colour{95, 95, 100}
                                                : Colour{105, 130, 80};
      camera.depth_m.at(column, row) = 120.0F / static_cast<float>(row - kHorizon + 1);
    }
  }
  for (int row = 12; row < 48; ++row) {
    for (int column = 6; column < 40; ++column) {
      camera.labels.at(column, row) = kBuilding;
      camera.image.at(column, row) = Colour{170, 140, 120};
      camera.depth_m.at(column, row) = 18.0F;
    }
  }
  return std::make_shared<const CameraMoment>(std::move(camera));
}

MomentModel moment_with_frame(const MadeMoment& made) {
  MomentModel model = made.moment();
  model.camera = frame();
  model.has_camera_frame = true;
  return model;
}

/// Two runs, a measured corner, and a particle that is looked at.
MapViewModel map_view(const MadeMoment& made) {
  MapViewModel model = made.map_view();
  MapRun other = model.runs.front();
  other.number = 2;
  other.name = "loop-2";
  other.colour = 1;
  other.is_active = false;
  model.runs.insert(model.runs.begin(), other);
  model.runs.back().bookmarks_in_enu_m = {{21.0, 26.0}};
  model.runs.back().bookmark_notes = {"odd turn"};
  model.look.tool = MapTool::kMeasure;
  model.look.measured_in_enu_m = {{12.0, 34.0}, {26.0, 35.0}, {31.0, 22.0}};
  model.selected_particle = 17;
  return model;
}

/// The same beside each other, where the vehicle is out of sight.
MapViewModel map_halves(const MadeMoment& made) {
  MapViewModel model = map_view(made);
  model.look.tool = MapTool::kPan;
  model.look.measured_in_enu_m.clear();
  model.selected_particle.reset();
  model.look.is_split = true;
  model.look.centre_in_enu_m += Eigen::Vector2d(-24.0, 9.0);
  return model;
}

WhyModel why(const MadeMoment& made) {
  MomentQuestion question;
  question.step = made.step;
  question.map = made.map;
  question.options_key = "defaults";
  const auto matcher = MapMatcher::create(question.map, question.options.localiser);
  WhyModel model;
  model.run_name = "loop";
  model.has_map = true;
  model.has_step = true;
  model.answer = std::make_shared<const MomentAnswer>(answer_moment(question, matcher.value()));
  model.is_answer_of_now = true;
  return model;
}

SettingsModel settings() {
  RunOptions draft;
  draft.localiser.particle_count = 2000;
  SettingsModel model;
  model.rows = setting_rows(draft, {});
  model.presets = {"default", "thesis"};
  model.preset = "default";
  model.changed_count = 1;
  model.running = {{1, "localising loop-3", 0.1, "step 40 of 400", 130.0}};
  return model;
}

/// What OpenGL would draw of the flight in space: here its frame, from the lowest row up as OpenGL draws.
SceneState space() {
  Raster<Rgba> picture = camera_picture(*frame(), 0.0);
  for (int row = 0; row < picture.height() / 2; ++row) {
    std::swap_ranges(picture.row(row).begin(), picture.row(row).end(),
                     picture.row(picture.height() - 1 - row).begin());
  }
  SceneState state;
  state.scene = [picture = std::move(picture), texture = std::make_shared<PictureTexture>()](
                    const SceneWish& /*wish*/) -> kit::TextureId {
    if (texture->texture() == 0) texture->show(picture, true);
    return texture->texture();
  };
  return state;
}

}  // namespace

void add_flight_scenes(std::vector<PanelScene>& scenes) {
  const MadeMoment made;
  const MomentModel moment = moment_with_frame(made);
  scenes.push_back(panel("layers", "layers_panel", kColumn, Room::kScrolled, layers(),
                         LayersState{}, draw_layers));
  scenes.push_back(
      panel("runs", "runs_panel", {340.0, 640.0}, Room::kScrolled, runs(), RunsState{}, draw_runs));
  scenes.push_back(panel("bookmarks", "bookmarks_panel", {340.0, 400.0}, Room::kScrolled,
                         bookmarks(), BookmarksState{}, draw_bookmarks));
  scenes.push_back(panel("moment", "moment_panel", {380.0, 860.0}, Room::kScrolled, moment,
                         MomentPanelState{}, draw_moment_panel));
  scenes.push_back(panel("why", "why_panel", {380.0, 860.0}, Room::kScrolled, why(made), WhyState{},
                         draw_why_panel));
  scenes.push_back(panel("settings", "settings_panel", {380.0, 560.0}, Room::kFilled, settings(),
                         SettingsState{}, draw_settings_panel));
  scenes.push_back(panel("camera", "camera_panel", {340.0, 320.0}, Room::kFilled, moment,
                         CameraPanelState{}, draw_camera_panel));
  scenes.push_back(panel("topview", "topview_panel", {340.0, 320.0}, Room::kFilled, moment,
                         TopviewPanelState{}, draw_topview_panel));
  scenes.push_back(panel("scene", "scene_panel", {340.0, 280.0}, Room::kFilled, moment, space(),
                         draw_scene_panel));
  scenes.push_back(panel("timeline", "timeline", {900.0, 380.0}, Room::kFilled, timeline(),
                         TimelineState{}, draw_timeline));
  PanelScene map = panel("map", "map_view", {640.0, 440.0}, Room::kBare, map_view(made),
                         MapViewState{}, draw_map_view);
  map.panels.insert(map.panels.end(), {"map_cards", "map_notes"});
  scenes.push_back(std::move(map));
  scenes.push_back(panel("map-halves", "map_vehicle", {760.0, 440.0}, Room::kBare, map_halves(made),
                         MapViewState{}, draw_map_view));
}

}  // namespace nadir::scenes
