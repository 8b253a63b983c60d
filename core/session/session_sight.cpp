// SPDX-License-Identifier: Apache-2.0
// Which part of the ground the map shows so that something is seen: all of a flight, particles, a moment.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/session/map_sight.h"
#include "core/session/session_core.h"
#include "core/session/shared_ground.h"

namespace nadir {
namespace {

constexpr double kSightNorthRad = std::numbers::pi / 2.0;
constexpr double kLeastFitM = 20.0;
constexpr double kRoomAround = 1.16;
constexpr double kInside = 0.94;  // of the free part: what lies at its very edge is not seen well

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

/// The ground that points lie on, as a view has it.
struct Footprint {
  Eigen::Vector2d middle_in_enu_m;
  double width_m = 0.0;  ///< Of a view whose free part they just fill.
};
Footprint footprint_of(const std::vector<Eigen::Vector2d>& points,
                       const FreeView& view,
                       const MapRoom& room) {
  const Eigen::Vector2d &up = view.up, &right = view.right;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Eigen::Vector2d least = Eigen::Vector2d::Constant(kInfinity), most = -least;
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d in_view(point.dot(right), point.dot(up));
    least = least.cwiseMin(in_view);
    most = most.cwiseMax(in_view);
  }
  const Eigen::Vector2d middle = 0.5 * (least + most), size = most - least;
  return {middle.x() * right + middle.y() * up,
          std::max(size.x() / view.width, size.y() * room.aspect / view.height)};
}

/// Centre and width such that all points are seen in the free part of a view, with its up as it is.
void fit_points(MapLook& look, const std::vector<Eigen::Vector2d>& points, const MapRoom& room) {
  const FreeView view(look, room);
  const Footprint place = footprint_of(points, view, room);
  look.width_m = std::clamp(kRoomAround * place.width_m, kLeastFitM, double{kMostMapWidthM});
  look.centre_in_enu_m = view.centre_for(place.middle_in_enu_m, look.width_m);
}

/// Whether all points are seen well in the free part of a view.
bool shows_all(const MapLook& look,
               const std::vector<Eigen::Vector2d>& points,
               const FreeView& view,
               const MapRoom& room) {
  const Eigen::Vector2d middle = view.centre_for(look.centre_in_enu_m, -look.width_m);
  return std::all_of(points.begin(), points.end(), [&](const Eigen::Vector2d& point) {
    const Eigen::Vector2d away = point - middle;
    return std::abs(away.dot(view.right)) <= 0.5 * kInside * view.width * look.width_m &&
           std::abs(away.dot(view.up)) <= 0.5 * kInside * view.height * look.width_m / room.aspect;
  });
}

/// Estimate and truth of a step, where they are known.
std::vector<Eigen::Vector2d> poses_of_moment(const RunStep& step) {
  std::vector<Eigen::Vector2d> points;
  const Rigid2& mean = step.estimate.moments.mean;
  if (is_finite(mean)) points.push_back(mean.translation_m());
  if (step.truth_in_enu) points.push_back(step.truth_in_enu->translation_m());
  return points;
}

/// Corners of the ground that the particles lie on: three standard deviations to each side, but nothing that is off the map.
/// Told by what every step holds, so that it is known before particles are decoded. None are added where nobody knows.
void add_corners_of_particles(const RunStep& step,
                              const OverheadMap* map,
                              std::vector<Eigen::Vector2d>& points) {
  constexpr double kSigmas = 3.0;  // then hardly one is missing
  const PoseMoments& moments = step.estimate.moments;
  const Eigen::Vector2d spread =
      kSigmas * moments.covariance.diagonal().head<2>().cwiseMax(0.0).cwiseSqrt();
  if (!is_finite(moments.mean) || !spread.allFinite()) return;
  const Eigen::Vector2d middle = moments.mean.translation_m();
  Eigen::Vector2d least = middle - spread, most = middle + spread;
  if (map != nullptr && map->contains(middle)) {
    const Eigen::Vector2d& corner = map->top_left_in_enu_m;
    least = least.cwiseMax(Eigen::Vector2d(corner.x(), corner.y() - map->height_m()));
    most = most.cwiseMin(Eigen::Vector2d(corner.x() + map->width_m(), corner.y()));
  }
  points.push_back(least);
  points.push_back(most);
  points.emplace_back(least.x(), most.y());
  points.emplace_back(most.x(), least.y());
}

/// Whether a map lies on another plane than the run's poses: then it is of another place.
bool is_elsewhere(const OpenMap& map, const RunDocument& run) {
  return map.index && !is_on_plane(run.header, map.index->map().plane);
}

}  // namespace

std::vector<Eigen::Vector2d> Session::Implementation::corners_of_labels() const {
  if (!labels || !labels->desk) return {};
  const LabelGrid& grid = labels->desk->sheet().now().grid();
  const double right = grid.width, bottom = grid.height;
  return {grid.enu_from_cells({0.0, 0.0}), grid.enu_from_cells({right, 0.0}),
          grid.enu_from_cells({0.0, bottom}), grid.enu_from_cells({right, bottom})};
}

MapLook Session::Implementation::fitted(MapLook look, FitTo to) const {
  std::vector<Eigen::Vector2d> points;
  const bool is_elsewhere_labelled = labels_elsewhere();
  const RunDocument* const run = is_elsewhere_labelled ? nullptr : active_document();
  if (is_elsewhere_labelled) points = corners_of_labels();
  if (to == FitTo::kFlight && run != nullptr) points = run->outline_in_enu_m;
  if (to == FitTo::kFlight && run == nullptr &&
      !is_elsewhere_labelled) {  // one that is being read: another of its flight shows the place
    const auto read = std::find_if(runs.begin(), runs.end(),
                                   [](const OpenRun& open) { return open.document != nullptr; });
    if (read != runs.end()) points = read->document->outline_in_enu_m;
  }
  if (run != nullptr && map && is_elsewhere(*map, *run)) points.clear();
  if (points.empty() && !is_elsewhere_labelled && map && map->index)
    points = corners_of_map(map->index->map());
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
  const bool is_elsewhere = labels_elsewhere();
  if (is_elsewhere) {
    look.centre_in_enu_m = label.elsewhere.centre_in_enu_m;
    look.width_m = label.elsewhere.width_m;
    look.is_following = false;
    if (look.up == MapUp::kHeading) look.up = MapUp::kFree;
  }
  const RunDocument* const run = is_elsewhere ? nullptr : active_document();
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

std::optional<HeldView> Session::Implementation::hold_view_for(const std::string& run) {
  if (kept.view.map.width_m > 0.0) return std::nullopt;
  const MapLook seen = resolved_look();
  const HeldView held{kept.view.map.centre_in_enu_m, seen.centre_in_enu_m, seen.width_m};
  amend([&](KeptState& state) {
    const std::vector<RunLook>& all = state.view.runs;
    const bool is_of_it = std::any_of(all.begin(), all.end(),
                                      [&run](const RunLook& look) { return look.path == run; });
    if (!is_of_it || state.view.map.width_m > 0.0) return;
    state.view.map.centre_in_enu_m = held.centre_in_enu_m;
    state.view.map.width_m = held.width_m;
  });
  return held;
}

void Session::Implementation::let_go_of_view(const HeldView& held) {
  amend([&held](KeptState& state) {
    MapLook& look = state.view.map;
    if (look.width_m != held.width_m || look.centre_in_enu_m != held.centre_in_enu_m) return;
    look.centre_in_enu_m = held.centre_before_in_enu_m;
    look.width_m = 0.0;
  });
}

void Session::Implementation::let_go_of_view_unseen(const HeldView& held) {
  constexpr double kUnseen = 0.02;  // of the view
  MapLook look = kept.view.map;
  look.width_m = 0.0;
  look = fitted(std::move(look), FitTo::kFlight);
  const double away_m = (look.centre_in_enu_m - held.centre_in_enu_m).norm();
  const double wider_m = std::abs(look.width_m - held.width_m);
  if (std::max(away_m, wider_m) < kUnseen * held.width_m) let_go_of_view(held);
}

Result<void> Session::Implementation::perform(const actions::Fit& action) {
  MapLook look = resolved_look();
  const bool shows_labels = label.workspace == Workspace::kLabel;
  if (action.to == FitTo::kMap && !(map && map->index) && !shows_labels) {
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
  if (labels_elsewhere()) return;
  const MapLook look = resolved_look();
  const RunDocument* const run = active_document();
  const auto index = run != nullptr ? run->index_at(playback.time_s) : std::nullopt;
  if (!index || (map && is_elsewhere(*map, *run))) return;
  const RunStep& step = run->steps[*index];
  std::vector<Eigen::Vector2d> seen = poses_of_moment(step);
  if (seen.empty()) return;
  add_corners_of_particles(step, map && map->index ? &map->index->map() : nullptr, seen);
  constexpr double kFarTooWide = 6.0, kRoomAroundMoment = 2.0;
  const FreeView view(look, map_room);
  const Footprint place = footprint_of(seen, view, map_room);
  const double nearest_m =
      std::clamp(kRoomAround * place.width_m, kLeastFitM, double{kMostMapWidthM});
  const bool is_tiny = look.width_m > kFarTooWide * nearest_m;
  // Of a map that follows, the estimate is in the middle, and its scale was chosen for what is around it.
  const bool has_no_room = !look.is_following && place.width_m > kInside * look.width_m;
  const double width_m = has_no_room ? nearest_m
                         : is_tiny   ? kRoomAroundMoment * nearest_m
                                     : look.width_m;
  const bool is_wide_enough = width_m == look.width_m;
  if (is_wide_enough && (look.is_following || shows_all(look, seen, view, map_room))) return;
  const Eigen::Vector2d centre_in_enu_m = view.centre_for(place.middle_in_enu_m, width_m);
  if (width_m != kept.view.map.width_m) {  // somebody may want the scale back
    const KeptState before = kept;
    kept.view.map.centre_in_enu_m = centre_in_enu_m;
    kept.view.map.width_m = width_m;
    settle(before, "Bring the moment into view", "");
    return;
  }
  move_view_to(centre_in_enu_m);
}

void Session::Implementation::move_view_to(const Eigen::Vector2d& centre_in_enu_m) {
  amend([&, before = kept.view.map](KeptState& state) {
    MapLook& now = state.view.map;
    if (now.centre_in_enu_m != before.centre_in_enu_m || now.width_m != before.width_m) return;
    now.centre_in_enu_m = centre_in_enu_m;
  });
}

std::optional<Eigen::Vector2d> Session::Implementation::vehicle_in_enu_m() const {
  const RunDocument* const run = active_document();
  const auto index = run != nullptr ? run->index_at(playback.time_s) : std::nullopt;
  if (!index || labels_elsewhere() || (map && is_elsewhere(*map, *run))) return std::nullopt;
  const Rigid2& mean = run->steps[*index].estimate.moments.mean;
  return is_finite(mean) ? std::optional<Eigen::Vector2d>(mean.translation_m()) : std::nullopt;
}

bool Session::Implementation::is_vehicle_in_view() const {
  const MapLook look = resolved_look();
  const auto vehicle = vehicle_in_enu_m();
  return look.is_following || !vehicle ||
         MapPage{look.centre_in_enu_m, look.width_m, look.up_rad, map_room.aspect}.shows(*vehicle);
}

void Session::Implementation::keep_vehicle_in_view() {
  if (!(kept.view.map.width_m > 0.0) || is_vehicle_in_view()) return;
  const MapLook look = resolved_look();
  move_view_to(FreeView(look, map_room).centre_for(*vehicle_in_enu_m(), look.width_m));
}

}  // namespace nadir
