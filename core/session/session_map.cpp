// SPDX-License-Identifier: Apache-2.0
// What the map shows: layers, tools, and where it is looked at by hand.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/session/place_text.h"
#include "core/session/session_core.h"

namespace nadir {
namespace {

constexpr double kNorthRad = std::numbers::pi / 2.0;

Result<void> check_place(const std::optional<double>& east_m,
                         const std::optional<double>& north_m) {
  const bool is_finite_place =
      (!east_m || std::isfinite(*east_m)) && (!north_m || std::isfinite(*north_m));
  if (is_finite_place && east_m.has_value() == north_m.has_value()) return {};
  return fail(ErrorCode::kInvalidOptions, "a place has an east and a north");
}

}  // namespace

Result<ProjectPlane> Session::Implementation::plane() const {
  if (labels_elsewhere() && labels && labels->desk) return labels->desk->sheet().now().plane();
  if (map && map->index) return map->index->map().plane;
  if (const RunDocument* const run = active_document()) {
    return ProjectPlane::create({run->header.plane_latitude_deg, run->header.plane_longitude_deg});
  }
  return fail(ErrorCode::kInvalidOptions, "no map is open: open a map or a run first");
}

Result<void> Session::Implementation::perform(const actions::LookAt& action) {
  if (auto checked = check_place(action.east_m, action.north_m); !checked) return checked;
  MapLook look = resolved_look();
  if (action.width_m) {
    if (!(*action.width_m >= kLeastMapWidthM && *action.width_m <= kMostMapWidthM)) {
      return fail(ErrorCode::kInvalidOptions, "a width of {:g} m is not in [{:g}, {:g}]",
                  *action.width_m, double{kLeastMapWidthM}, double{kMostMapWidthM});
    }
    look.width_m = *action.width_m;
  }
  look.centre_in_enu_m = {action.east_m, action.north_m};
  look.is_following = false;
  kept.view.map = std::move(look);
  return {};
}

Result<void> Session::Implementation::perform(const actions::Zoom& action) {
  if (!(action.factor > 0.0) || !std::isfinite(action.factor)) {
    return fail(ErrorCode::kInvalidOptions, "a map cannot be shown {:g} times larger",
                action.factor);
  }
  if (auto checked = check_place(action.east_m, action.north_m); !checked) return checked;
  MapLook look = resolved_look();
  const double width_m =
      std::clamp(look.width_m / action.factor, double{kLeastMapWidthM}, double{kMostMapWidthM});
  if (action.east_m && !look.is_following) {
    const Eigen::Vector2d stays(*action.east_m, *action.north_m);
    look.centre_in_enu_m = stays + (width_m / look.width_m) * (look.centre_in_enu_m - stays);
  }
  look.width_m = width_m;
  if (look.is_following) look.centre_in_enu_m = kept.view.map.centre_in_enu_m;
  kept.view.map = std::move(look);
  return {};
}

Result<void> Session::Implementation::perform(const actions::Rotate& action) {
  if (!std::isfinite(action.angle_deg)) {
    return fail(ErrorCode::kInvalidOptions, "the angle is not a number");
  }
  // The map turns counter-clockwise under a view whose up then points the other way round on it.
  MapLook look = resolved_look();
  look.up_rad = wrap_rad(look.up_rad - Angle::degrees(action.angle_deg).radians());
  look.up = MapUp::kFree;
  kept.view.map = std::move(look);
  return {};
}

Result<void> Session::Implementation::perform(const actions::Follow& action) {
  MapLook look = resolved_look();  // where it stops following, it stays
  look.is_following = switched(look.is_following, action.to);
  kept.view.map = std::move(look);
  return {};
}

Result<void> Session::Implementation::perform(const actions::SetUp& action) {
  kept.view.map.up_rad = resolved_look().up_rad;
  kept.view.map.up = action.up;
  if (action.up == MapUp::kNorth) kept.view.map.up_rad = kNorthRad;
  return {};
}

Result<void> Session::Implementation::perform(const actions::GoToPlace& action) {
  const auto on = plane();
  if (!on) return forward_error(on);
  const auto place = parse_place_text(action.text, *on);
  if (!place) return forward_error(place);
  return perform(actions::LookAt{place->x(), place->y(), std::nullopt});
}

Result<void> Session::Implementation::perform(const actions::LayTopview& action) {
  kept.view.map.topview_at = action.at;
  return {};
}

Result<void> Session::Implementation::perform(const actions::SelectParticle& action) {
  if (action.index) {
    const auto run = need_run();
    if (!run) return forward_error(run);
    const auto index = (*run)->document->index_at(playback.time_s);
    const int count = (*run)->document->steps[*index].particle_count;
    if (*action.index < 0 || *action.index >= count) {
      return fail(ErrorCode::kInvalidOptions, "there is no particle {}: this moment has {}",
                  *action.index, count);
    }
  }
  kept.view.selected_particle = action.index;
  return {};
}

void Session::Implementation::let_go_of_particle() {
  if (!kept.view.selected_particle) {
    particle_step.reset();
    return;
  }
  const OpenRun* const run = active();
  if (run == nullptr || !run->document) return;
  const auto index = run->document->index_at(playback.time_s);
  if (!index) return;
  const std::pair here(run->path.string(), run->document->steps[*index].step);
  if (!particle_step) particle_step = here;
  if (*particle_step == here) return;
  // Resampling numbers particles anew, so the number means another one now; no way back leads to it either.
  particle_step.reset();
  amend([](KeptState& state) { state.view.selected_particle.reset(); });
}

Result<void> Session::Implementation::perform(const actions::MeasurePoint& action) {
  if (auto checked = check_place(action.east_m, action.north_m); !checked) return checked;
  auto& points = kept.view.map.measured_in_enu_m;
  if (action.east_m) {
    points.emplace_back(*action.east_m, *action.north_m);
  } else {
    points.clear();
  }
  return {};
}

Result<void> Session::Implementation::perform(const actions::UseTool& action) {
  kept.view.map.tool = action.tool;
  return {};
}

Result<void> Session::Implementation::perform(const actions::ShowLayer& action) {
  LayerLook& look = kept.view.map.layer(action.layer);
  look.is_visible = switched(look.is_visible, action.to);
  return {};
}

Result<void> Session::Implementation::perform(const actions::SetLayerOpacity& action) {
  if (!(action.opacity >= 0.0 && action.opacity <= 1.0)) {
    return fail(ErrorCode::kInvalidOptions, "an opacity of {:g} is not in [0, 1]", action.opacity);
  }
  kept.view.map.layer(action.layer).opacity = action.opacity;
  return {};
}

Result<void> Session::Implementation::perform(const actions::SetLayerColour& action) {
  if (action.colour && !is_colour_text(*action.colour)) {
    return fail(ErrorCode::kInvalidOptions, "'{}' is no colour: write #RRGGBB", *action.colour);
  }
  kept.view.map.layer(action.layer).colour = action.colour;
  return {};
}

Result<void> Session::Implementation::perform(const actions::MoveLayer& action) {
  if (action.layer == Layer::kLegend) {
    return fail(ErrorCode::kInvalidOptions, "the legend always lies on top");
  }
  std::vector<Layer>& order = kept.view.map.order;
  const auto from = std::find(order.begin(), order.end(), action.layer) - order.begin();
  const std::int64_t to = std::clamp<std::int64_t>(std::int64_t{from} + action.places, 0,
                                                   static_cast<std::int64_t>(order.size()) - 2);
  order.erase(order.begin() + from);
  order.insert(order.begin() + to, action.layer);
  return {};
}

}  // namespace nadir
