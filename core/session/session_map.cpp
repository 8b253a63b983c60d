// SPDX-License-Identifier: Apache-2.0
// What the map shows.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/session/place_text.h"
#include "core/session/session_core.h"

namespace nadir {
namespace {

constexpr double kNorthRad = std::numbers::pi / 2.0;
constexpr double kLeastFitM = 20.0;
constexpr double kRoomAround = 1.16;

Result<void> check_place(const std::optional<double>& east_m,
                         const std::optional<double>& north_m) {
  const bool is_finite_place =
      (!east_m || std::isfinite(*east_m)) && (!north_m || std::isfinite(*north_m));
  if (is_finite_place && east_m.has_value() == north_m.has_value()) return {};
  return fail(ErrorCode::kInvalidOptions, "a place has an east and a north");
}

/// Everything that fitting a flight has to show.
std::vector<Eigen::Vector2d> points_of_run(const RunDocument& run) {
  std::vector<Eigen::Vector2d> points;
  for (const RunStep& step : run.steps) {
    const Rigid2& estimate = step.estimate.moments.mean;
    if (is_finite(estimate)) points.push_back(estimate.translation_m());
    if (step.truth_in_enu) points.push_back(step.truth_in_enu->translation_m());
  }
  return points;
}

std::vector<Eigen::Vector2d> corners_of_map(const OverheadMap& map) {
  const Eigen::Vector2d corner = map.top_left_in_enu_m;
  const Eigen::Vector2d across(map.width_m(), 0.0), down(0.0, -map.height_m());
  return {corner, corner + across, corner + down, corner + across + down};
}

std::vector<Eigen::Vector2d> points_of_particles(const ParticleSet& particles) {
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    points.emplace_back(particles.x_in_enu_m[i], particles.y_in_enu_m[i]);
  }
  return points;
}

/// Centre and width such that all points are seen in a view of this shape, with its up as it is.
void fit_points(MapLook& look, const std::vector<Eigen::Vector2d>& points, double aspect) {
  const double up_rad = look.up == MapUp::kNorth ? kNorthRad : look.up_rad;
  const Eigen::Vector2d up(std::cos(up_rad), std::sin(up_rad)), right(up.y(), -up.x());
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Eigen::Vector2d least = Eigen::Vector2d::Constant(kInfinity), most = -least;
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d in_view(point.dot(right), point.dot(up));
    least = least.cwiseMin(in_view);
    most = most.cwiseMax(in_view);
  }
  const Eigen::Vector2d middle = 0.5 * (least + most), size = most - least;
  look.centre_in_enu_m = middle.x() * right + middle.y() * up;
  look.width_m = std::clamp(kRoomAround * std::max(size.x(), size.y() * aspect), kLeastFitM,
                            double{kMostMapWidthM});
}

}  // namespace

MapLook Session::Implementation::fitted(MapLook look, FitTo to) const {
  std::vector<Eigen::Vector2d> points;
  const RunDocument* const run = active_document();
  if (to == FitTo::kFlight && run != nullptr) points = points_of_run(*run);
  if (to == FitTo::kFlight &&
      run == nullptr) {  // one that is being read: another of its flight shows the place
    const auto read = std::find_if(runs.begin(), runs.end(),
                                   [](const OpenRun& open) { return open.document != nullptr; });
    if (read != runs.end()) points = points_of_run(*read->document);
  }
  if (points.empty() && map && map->index) points = corners_of_map(map->index->map());
  if (points.empty()) {
    look.centre_in_enu_m.setZero();
    look.width_m = 100.0;
    return look;
  }
  fit_points(look, points, map_aspect);
  return look;
}

MapLook Session::Implementation::resolved_look() const {
  MapLook look = kept.view.map;
  const RunDocument* const run = active_document();
  const auto index = run != nullptr ? run->index_at(playback.time_s) : std::nullopt;
  std::optional<Rigid2> estimate;
  if (index && is_finite(run->steps[*index].estimate.moments.mean)) {
    estimate = run->steps[*index].estimate.moments.mean;
  }
  if (look.up == MapUp::kNorth) look.up_rad = kNorthRad;
  if (look.up == MapUp::kHeading && estimate) look.up_rad = estimate->yaw_rad;
  if (!(look.width_m > 0.0)) look = fitted(std::move(look), FitTo::kFlight);
  if (look.is_following && estimate) look.centre_in_enu_m = estimate->translation_m();
  return look;
}

Result<ProjectPlane> Session::Implementation::plane() const {
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

Result<void> Session::Implementation::perform(const actions::Fit& action) {
  MapLook look = resolved_look();
  if (action.to == FitTo::kMap && !(map && map->index)) {
    return fail(ErrorCode::kInvalidOptions, "{}",
                map ? "the map is still being read" : "no map is open: open one first");
  }
  if (action.to == FitTo::kParticles) {
    const auto run = need_run();
    if (!run) return forward_error(run);
    const auto index = (*run)->document->index_at(playback.time_s);
    const auto step = (*run)->cache->step(*index);
    if (!step) {
      return fail(ErrorCode::kInvalidOptions, "the particles of this moment are still being read");
    }
    if (!step->particles || step->particles->empty()) {
      return fail(ErrorCode::kInvalidOptions, "{}: no particles were recorded at this moment",
                  (*run)->name);
    }
    fit_points(look, points_of_particles(*step->particles), map_aspect);
  } else {
    look = fitted(std::move(look), action.to);
  }
  look.is_following = false;
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
  std::vector<Layer>& order = kept.view.map.order;
  const auto from = std::find(order.begin(), order.end(), action.layer) - order.begin();
  const std::int64_t to = std::clamp<std::int64_t>(std::int64_t{from} + action.places, 0,
                                                   static_cast<std::int64_t>(order.size()) - 1);
  order.erase(order.begin() + from);
  order.insert(order.begin() + to, action.layer);
  return {};
}

}  // namespace nadir
