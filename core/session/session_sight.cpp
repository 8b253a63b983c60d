// SPDX-License-Identifier: Apache-2.0
// Which part of the ground the map shows so that something is seen: all of a flight, particles, a moment.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/session/session_core.h"
#include "core/session/shared_ground.h"

namespace nadir {
namespace {

constexpr double kSightNorthRad = std::numbers::pi / 2.0;
constexpr double kLeastFitM = 20.0;
constexpr double kRoomAround = 1.16;

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

/// The two directions of a view on the ground, and its part that nothing covers.
struct FreeView {
  Eigen::Vector2d up, right;
  double width = 1.0, height = 1.0;  ///< In widths and heights of the view.
  Eigen::Vector2d middle;            ///< From the view's own: to the right and up, in widths of it.

  FreeView(const MapLook& look, const MapRoom& room) {
    const double up_rad = look.up == MapUp::kNorth ? kSightNorthRad : look.up_rad;
    up = {std::cos(up_rad), std::sin(up_rad)};
    right = {up.y(), -up.x()};
    width = 1.0 - room.left - room.right;
    height = 1.0 - room.bottom - room.top;
    middle = {0.5 * (room.left - room.right), 0.5 * (room.bottom - room.top) / room.aspect};
  }
  /// The centre that puts a place into the middle of the free part.
  [[nodiscard]] Eigen::Vector2d centre_for(const Eigen::Vector2d& place, double width_m) const {
    return place - width_m * (middle.x() * right + middle.y() * up);
  }
};

/// Centre and width such that all points are seen in the free part of a view, with its up as it is.
void fit_points(MapLook& look, const std::vector<Eigen::Vector2d>& points, const MapRoom& room) {
  const FreeView view(look, room);
  const Eigen::Vector2d &up = view.up, &right = view.right;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Eigen::Vector2d least = Eigen::Vector2d::Constant(kInfinity), most = -least;
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d in_view(point.dot(right), point.dot(up));
    least = least.cwiseMin(in_view);
    most = most.cwiseMax(in_view);
  }
  const Eigen::Vector2d middle = 0.5 * (least + most), size = most - least;
  look.width_m = std::clamp(
      kRoomAround * std::max(size.x() / view.width, size.y() * room.aspect / view.height),
      kLeastFitM, double{kMostMapWidthM});
  look.centre_in_enu_m = view.centre_for(middle.x() * right + middle.y() * up, look.width_m);
}

/// Whether a map lies on another plane than the run's poses: then it is of another place.
bool is_elsewhere(const OpenMap& map, const RunDocument& run) {
  return map.index && !is_on_plane(run.header, map.index->map().plane);
}

}  // namespace

MapLook Session::Implementation::fitted(MapLook look, FitTo to) const {
  std::vector<Eigen::Vector2d> points;
  const RunDocument* const run = active_document();
  if (to == FitTo::kFlight && run != nullptr) points = run->outline_in_enu_m;
  if (to == FitTo::kFlight &&
      run == nullptr) {  // one that is being read: another of its flight shows the place
    const auto read = std::find_if(runs.begin(), runs.end(),
                                   [](const OpenRun& open) { return open.document != nullptr; });
    if (read != runs.end()) points = read->document->outline_in_enu_m;
  }
  if (run != nullptr && map && is_elsewhere(*map, *run)) points.clear();
  if (points.empty() && map && map->index) points = corners_of_map(map->index->map());
  if (points.empty()) {
    look.centre_in_enu_m.setZero();
    look.width_m = 100.0;
    return look;
  }
  fit_points(look, points, map_room);
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
  if (look.up == MapUp::kNorth) look.up_rad = kSightNorthRad;
  if (look.up == MapUp::kHeading && estimate) look.up_rad = estimate->yaw_rad;
  if (!(look.width_m > 0.0)) look = fitted(std::move(look), FitTo::kFlight);
  if (look.is_following && estimate) look.centre_in_enu_m = estimate->translation_m();
  return look;
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
    fit_points(look, points_of_particles(*step->particles), map_room);
  } else {
    look = fitted(std::move(look), action.to);
  }
  look.is_following = false;
  kept.view.map = std::move(look);
  return {};
}

void Session::Implementation::bring_moment_into_view() {
  const MapLook look = resolved_look();
  const RunDocument* const run = active_document();
  const auto index = run != nullptr ? run->index_at(playback.time_s) : std::nullopt;
  const bool is_looked_at = kept.view.map.width_m > 0.0 && !look.is_following;
  if (!index || !is_looked_at || (map && is_elsewhere(*map, *run))) return;
  std::vector<Eigen::Vector2d> seen;
  const RunStep& step = run->steps[*index];
  if (is_finite(step.estimate.moments.mean)) {
    seen.push_back(step.estimate.moments.mean.translation_m());
  }
  if (step.truth_in_enu) seen.push_back(step.truth_in_enu->translation_m());
  if (seen.empty()) return;
  constexpr double kInside = 0.94;  // of the free part: what lies at its very edge is not seen well
  const FreeView view(look, map_room);
  const auto is_in_view = [&](const Eigen::Vector2d& place, const Eigen::Vector2d& centre) {
    const Eigen::Vector2d away = place - view.centre_for(centre, -look.width_m);
    return std::abs(away.dot(view.right)) <= 0.5 * kInside * view.width * look.width_m &&
           std::abs(away.dot(view.up)) <=
               0.5 * kInside * view.height * look.width_m / map_room.aspect;
  };
  const auto shows_all = [&](const Eigen::Vector2d& centre) {
    return std::all_of(seen.begin(), seen.end(),
                       [&](const Eigen::Vector2d& place) { return is_in_view(place, centre); });
  };
  if (shows_all(look.centre_in_enu_m)) return;
  // Both where they fit, else the estimate.
  Eigen::Vector2d centre = view.centre_for(0.5 * (seen.front() + seen.back()), look.width_m);
  if (!shows_all(centre)) centre = view.centre_for(seen.front(), look.width_m);
  amend([&, before = kept.view.map.centre_in_enu_m](KeptState& state) {
    MapLook& map_look = state.view.map;
    if (map_look.centre_in_enu_m == before) map_look.centre_in_enu_m = centre;
  });
}

}  // namespace nadir
