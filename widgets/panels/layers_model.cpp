// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/session/session.h"
#include "widgets/panels/layers_panel.h"
#include "widgets/panels/map_lines.h"

namespace nadir {
namespace {

/// What the reasons are told from.
struct Scene {
  const OpenRun* run = nullptr;
  const RunStep* step = nullptr;     ///< With particles and topview; null until decoded.
  const RunStep* summary = nullptr;  ///< The same without them; null without a run.
  bool has_map = false, is_map_read = false, is_playing = false;
};

std::string why_no_map(const Scene& scene) {
  if (!scene.has_map) return "no map";
  return scene.is_map_read ? "" : "being read";
}

std::string why_no_step(const Scene& scene) {
  if (scene.run == nullptr) return "no run";
  if (scene.run->document == nullptr) return scene.run->is_live ? "no steps yet" : "being read";
  return scene.summary == nullptr ? "no steps yet" : "";
}

std::string why_no_particles(const Scene& scene) {
  if (std::string why = why_no_step(scene); !why.empty()) return why;
  if (scene.step == nullptr) return "being decoded";
  return scene.step->particles && !scene.step->particles->empty() ? "" : "not recorded";
}

std::string why_no_topview(const Scene& scene) {
  if (std::string why = why_no_step(scene); !why.empty()) return why;
  if (scene.summary->topview_cells == 0) return "nothing seen";
  if (scene.step == nullptr) return "being decoded";
  return scene.step->topview ? "" : "not recorded";
}

/// It is made from the topviews that the run has recorded up to now.
std::string why_no_reconstruction(const Scene& scene) {
  if (std::string why = why_no_step(scene); !why.empty()) return why;
  const std::vector<RunStep>& steps = scene.run->document->steps;
  const auto is_seen = [](const RunStep& step) { return step.topview_cells > 0; };
  const bool is_unrecorded =
      scene.step != nullptr && is_seen(*scene.summary) && !scene.step->topview;
  if (is_unrecorded) return "not recorded";
  if (std::any_of(steps.data(), scene.summary + 1, is_seen)) return "";
  return std::any_of(steps.begin(), steps.end(), is_seen) ? "nothing seen yet" : "no topviews";
}

/// It takes too long for each step while a run plays.
std::string why_no_surface(const Scene& scene) { return scene.is_playing ? "when paused" : ""; }

std::string why_no_ellipses(const Scene& scene) {
  if (std::string why = why_no_step(scene); !why.empty()) return why;
  return scene.summary->estimate.moments.covariance.allFinite() ? "" : "no covariance";
}

std::string first_of(const std::string& one, const std::string& other) {
  return one.empty() ? other : one;
}

std::string why_empty(Layer layer, const Scene& scene) {
  std::string no_step = why_no_step(scene);
  switch (layer) {
    case Layer::kPicture:
    case Layer::kLabels:
      return why_no_map(scene);
    case Layer::kLegend:
      return scene.has_map || scene.run != nullptr ? "" : "no map";
    case Layer::kReconstruction:
      return why_no_reconstruction(scene);
    case Layer::kTopview:
      return why_no_topview(scene);
    case Layer::kErrorSurface:
      return first_of(first_of(why_no_map(scene), why_no_topview(scene)), why_no_surface(scene));
    case Layer::kDisagreement:
      return first_of(why_no_map(scene), why_no_topview(scene));
    case Layer::kParticles:
      return why_no_particles(scene);
    case Layer::kOdometry:
      return !no_step.empty() || scene.summary->odometry_in_enu ? no_step : "start unknown";
    case Layer::kTruth:
      return !no_step.empty() || scene.run->document->has_truth() ? no_step : "no truth";
    case Layer::kEstimate:
      return no_step;
    case Layer::kEllipses:
      return why_no_ellipses(scene);
    case Layer::kModes:
      return !no_step.empty() || !scene.summary->estimate.modes.empty() ? no_step : "none here";
    case Layer::kGraticule:
      return scene.has_map || scene.run != nullptr ? "" : "no map";
  }
  return {};
}

}  // namespace

LayersModel layers_model(const Session& session) {
  Scene scene;
  scene.run = session.active_run();
  const auto step = session.step();
  scene.step = step.get();
  const auto index = session.step_index();
  if (index && scene.run != nullptr && scene.run->document != nullptr) {
    scene.summary = &scene.run->document->steps[*index];
  }
  scene.has_map = session.map() != nullptr;
  scene.is_map_read = scene.has_map && session.map()->index != nullptr;
  scene.is_playing = session.playback().is_playing;

  LayersModel model;
  const MapLook& look = session.view().map;
  model.topview_at = look.topview_at;
  model.is_on_picture = has_ground_picture(look, scene.is_map_read);
  if (const int active = session.view().active_run; active > 0) {
    const RunLook& run = session.view().runs[static_cast<std::size_t>(active - 1)];
    model.run_colour = static_cast<std::size_t>(std::max(0, run.colour));
  }
  for (auto layer = look.order.rbegin(); layer != look.order.rend(); ++layer) {
    model.rows.push_back({*layer, look.layer(*layer), why_empty(*layer, scene)});
  }
  if (scene.is_map_read) {
    const ClassStatistics& statistics = session.map()->index->statistics();
    for (int id = 0; id < kClassCount; ++id) {
      const double share = statistics.share_of_classified(static_cast<ClassId>(id));
      if (share > 0.0) model.classes.push_back({static_cast<ClassId>(id), share});
    }
    std::stable_sort(model.classes.begin(), model.classes.end(),
                     [](const LayersModel::ClassShare& a, const LayersModel::ClassShare& b) {
                       return a.share > b.share;
                     });
  }
  return model;
}

}  // namespace nadir
