// SPDX-License-Identifier: Apache-2.0
#include "core/run/run_start.h"

#include <cmath>
#include <utility>

#include "core/eval/evaluated_step.h"

namespace nadir::detail {
namespace {

Result<Prior> choose_prior(const LocaliseRequest& request,
                           const FlightDescription& flight,
                           const std::optional<Trajectory>& truth,
                           double time_s) {
  if (request.prior) return *request.prior;
  const auto start = truth ? truth->at(time_s) : std::nullopt;
  if (!start) {
    return fail(ErrorCode::kInvalidOptions,
                "{}: holds no truth at its first frame, so say where it starts (--prior E,N,YAW) "
                "or that nobody knows (--global)",
                flight.path.string());
  }
  return GaussianPrior{.mean_in_enu = planar(*start)};
}

/// Where dead reckoning is laid down: at the truth of the first frame, else at the mean of the
/// prior; nowhere where neither is known.
std::optional<Rigid2> start_of(const Prior& prior,
                               const std::optional<Trajectory>& truth,
                               double time_s) {
  const auto start = truth ? truth->at(time_s) : std::nullopt;
  if (start) return planar(*start);
  if (const auto* gaussian = std::get_if<GaussianPrior>(&prior)) return gaussian->mean_in_enu;
  return std::nullopt;
}

}  // namespace

Result<void> check_resume(const LocaliseRequest& request,
                          const FlightDescription& flight,
                          const ProjectPlane& plane) {
  constexpr double kSameM = 1e-3, kSameRad = 1e-3;
  const ResumePoint& from = *request.resume_after;
  const RunStep& after = from.after;
  const std::string name = flight.path.string();
  if (request.prior) {
    return fail(ErrorCode::kInvalidOptions, "prior: there is none for a run that goes on from {}",
                from.run);
  }
  if (!after.particles || after.particles->empty()) {
    return fail(ErrorCode::kInvalidOptions,
                "{}: holds no particles of step {}, so nothing can go on from there", from.run,
                after.step);
  }
  if (from.plane_origin) {
    const Geodetic& origin = plane.origin();
    if (origin.latitude_deg != from.plane_origin->latitude_deg ||
        origin.longitude_deg != from.plane_origin->longitude_deg) {
      return fail(ErrorCode::kInvalidOptions,
                  "{}: was made on a map of another plane, so its particles mean other places here",
                  from.run);
    }
  }
  const auto odom_from_body = flight.odometry->at(after.time_s);
  const bool is_same_odometry = odom_from_body && [&] {
    const Rigid2 apart = after.odom_from_body.inverse() * planar(*odom_from_body);
    return is_finite(apart) && apart.translation_m().norm() < kSameM &&
           std::abs(apart.yaw_rad) < kSameRad;
  }();
  if (!is_same_odometry || (!from.flight_hash.empty() && from.flight_hash != flight_hash(flight))) {
    return fail(ErrorCode::kInvalidOptions, "{}: is not the flight that {} was made on", name,
                from.run);
  }
  return {};
}

Result<RunStart> start_after(const ResumePoint& from,
                             const std::shared_ptr<const MapIndex>& map,
                             const LocaliserOptions& options) {
  const RunStep& after = from.after;
  const int first_step = after.step + 1;
  auto localiser =
      Localiser::resume(map, options, *after.particles, static_cast<std::uint32_t>(first_step));
  if (!localiser) return forward_error(localiser);
  RunStart start{std::move(*localiser), first_step, after.time_s, after.odom_from_body,
                 std::nullopt};
  if (after.odometry_in_enu) {
    start.enu_from_odom = *after.odometry_in_enu * after.odom_from_body.inverse();
  }
  return start;
}

Result<RunStart> start_at(double time_s,
                          const Rigid3& first_odom_from_body,
                          const LocaliseRequest& request,
                          const FlightDescription& flight,
                          const std::optional<Trajectory>& truth,
                          const std::shared_ptr<const MapIndex>& map) {
  const auto prior = choose_prior(request, flight, truth, time_s);
  if (!prior) return forward_error(prior);
  auto localiser = Localiser::create(map, request.options.localiser, *prior);
  if (!localiser) return forward_error(localiser);
  const Rigid2 odom_from_body = planar(first_odom_from_body);
  RunStart start{std::move(*localiser), 0, time_s, odom_from_body, std::nullopt};
  if (const auto known = start_of(*prior, truth, time_s)) {
    start.enu_from_odom = *known * odom_from_body.inverse();
  }
  return start;
}

}  // namespace nadir::detail
