// SPDX-License-Identifier: Apache-2.0
#include "core/run/localise_flight.h"

#include <chrono>
#include <future>
#include <limits>

#include "core/run/run_start.h"

namespace nadir {
namespace {

using Clock = std::chrono::steady_clock;

double elapsed_ms(Clock::time_point since) {
  return std::chrono::duration<double, std::milli>(Clock::now() - since).count();
}

/// A frame that will be used, with the odometry at its time.
struct UsedFrame {
  std::size_t index = 0;
  double time_s = 0.0;
  Rigid3 odom_from_body;
};

struct FramePlan {
  std::vector<UsedFrame> frames;
  LocaliseSummary summary;  ///< Only the counts of frames that are left out.
};

FramePlan plan_frames(const FlightDescription& flight, const LocaliseRequest& request) {
  FramePlan plan;
  std::size_t seen = 0;
  std::optional<double> last_s;
  if (request.resume_after) last_s = request.resume_after->after.time_s;
  const double begin_s = last_s.value_or(-std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < flight.frames.size(); ++i) {
    if (!flight.frames[i].labels || !flight.frames[i].depth) continue;
    const double time_s = flight.frames[i].time_s;
    if (time_s <= begin_s) continue;
    if (request.most_frames && seen >= *request.most_frames) break;
    ++seen;
    const double interval_s = request.options.localiser.min_update_interval_s;
    // A millisecond of tolerance: time stamps of a nominal rate are rounded.
    if (last_s && time_s - *last_s < interval_s - 1e-3) {
      ++plan.summary.frames_passed_over;
      continue;
    }
    const auto odom_from_body = flight.odometry->at(time_s);
    if (!odom_from_body) {
      ++plan.summary.frames_without_odometry;
      continue;
    }
    plan.frames.push_back({i, time_s, *odom_from_body});
    last_s = time_s;
  }
  return plan;
}

Result<void> check_streams(const FlightDescription& flight) {
  if (!flight.camera) {
    return fail(ErrorCode::kUnsupported, "{}: no camera is described", flight.path.string());
  }
  if (auto valid = validate(*flight.camera); !valid) {
    return forward_error(valid, flight.path.string());
  }
  if (!flight.odometry || flight.odometry->empty()) {
    return fail(ErrorCode::kUnsupported, "{}: holds no odometry", flight.path.string());
  }
  return {};
}

/// Turns one frame into the topview that the filter compares with the map.
Result<SemanticTopview> topview_of(const SemanticFrame& frame,
                                   const FlightDescription& flight,
                                   const Rigid3& odom_from_body,
                                   double metres_per_cell,
                                   const TopviewOptions& options) {
  const Eigen::Quaterniond levelling = level_from_body(odom_from_body.rotation);
  const Rigid3 level_from_camera =
      Rigid3{levelling, Eigen::Vector3d::Zero()} * flight.body_from_camera;
  const Eigen::Isometry3d transform =
      Eigen::Translation3d(level_from_camera.translation_m) * level_from_camera.rotation;
  // No limit of depth here: the range is one on the ground, and the topview keeps it.
  constexpr double kAnyDepthM = std::numeric_limits<float>::max();
  auto cloud =
      build_semantic_cloud(frame.labels, frame.depth_m, *flight.camera, transform, kAnyDepthM);
  if (!cloud) return forward_error(cloud);
  return build_semantic_topview(*cloud, metres_per_cell, options);
}

}  // namespace

Result<std::optional<Trajectory>> truth_in_plane(const FlightDescription& flight,
                                                 const ProjectPlane& plane) {
  if (!flight.truth || !flight.truth_origin) return flight.truth;
  const auto source = ProjectPlane::create(*flight.truth_origin);
  if (!source) return forward_error(source, flight.path.string());
  if (*source == plane) return flight.truth;
  std::vector<TimedPose> poses = flight.truth->poses();
  for (TimedPose& timed : poses) {
    const Eigen::Vector2d position_in_source = timed.pose.translation_m.head<2>();
    const Eigen::Vector2d position_in_enu =
        plane.enu_from_geodetic(source->geodetic_from_enu(position_in_source));
    timed.pose.translation_m.head<2>() = position_in_enu;
    const Angle turn = Angle::degrees(source->convergence_deg(position_in_source) -
                                      plane.convergence_deg(position_in_enu));
    timed.pose.rotation =
        (Eigen::AngleAxisd(turn.radians(), Eigen::Vector3d::UnitZ()) * timed.pose.rotation)
            .normalized();
  }
  auto moved = Trajectory::create(std::move(poses), flight.path.string() + ": truth on the map");
  if (!moved) return forward_error(moved);
  return std::optional(std::move(*moved));
}

Result<LocaliseSummary> localise_flight(const FlightRecording& flight,
                                        const std::shared_ptr<const MapIndex>& map,
                                        const LocaliseRequest& request,
                                        const std::function<Result<void>(const RunStep&)>& record,
                                        const WorkContext& context) {
  const FlightDescription& description = flight.description();
  if (const auto valid = validate_run(request.options); !valid) return forward_error(valid);
  if (const auto streams = check_streams(description); !streams) return forward_error(streams);
  const auto& resumed = request.resume_after;
  if (resumed) {
    const auto checked = detail::check_resume(request, description, map->map().plane);
    if (!checked) return forward_error(checked);
  }
  FramePlan plan = plan_frames(description, request);
  if (plan.frames.empty() && resumed) {
    return fail(ErrorCode::kInvalidOptions,
                "{}: has no frame to use after the {:.3f} s of {} from which to go on",
                description.path.string(), resumed->elapsed_s, resumed->run);
  }
  if (plan.frames.empty()) {
    return fail(ErrorCode::kUnsupported, "{}: no frame has labels, depth and odometry",
                description.path.string());
  }
  const double metres_per_cell = map->map().metres_per_cell;
  const auto placed_truth = truth_in_plane(description, map->map().plane);
  if (!placed_truth) return forward_error(placed_truth);
  const std::optional<Trajectory>& truth = *placed_truth;
  auto start =
      resumed ? detail::start_after(*resumed, map, request.options.localiser)
              : detail::start_at(plan.frames.front().time_s, plan.frames.front().odom_from_body,
                                 request, description, truth, map);
  if (!start) return forward_error(start);
  Localiser& localiser = start->localiser;
  double before_s = start->time_s;
  Rigid2 odom_from_body_before = start->odom_from_body;

  const auto load = [&flight](std::size_t frame) { return flight.load(frame); };
  auto next = std::async(std::launch::async, load, plan.frames.front().index);
  for (std::size_t i = 0; i < plan.frames.size(); ++i) {
    const UsedFrame& used = plan.frames[i];
    const auto frame = next.get();
    if (context.is_stopped()) return fail(ErrorCode::kCancelled, "localising was stopped");
    if (!frame) return forward_error(frame);
    if (i + 1 < plan.frames.size()) {
      next = std::async(std::launch::async, load, plan.frames[i + 1].index);
    }
    const auto began = Clock::now();
    auto topview = topview_of(*frame, description, used.odom_from_body, metres_per_cell,
                              request.options.topview);
    if (!topview) return forward_error(topview, description.path.string());
    const Rigid2 odom_from_body = planar(used.odom_from_body);
    const OdometryStep odometry{odom_from_body_before.inverse() * odom_from_body,
                                used.time_s - before_s};
    const LocaliserUpdate update = localiser.update(odometry, *topview);
    odom_from_body_before = odom_from_body;
    before_s = used.time_s;

    RunStep step;
    step.update_ms = elapsed_ms(began);
    step.step = start->first_step + plan.summary.steps;
    step.time_s = used.time_s;
    step.odom_from_body = odom_from_body;
    if (start->enu_from_odom) step.odometry_in_enu = *start->enu_from_odom * odom_from_body;
    const auto true_pose = truth ? truth->at(used.time_s) : std::nullopt;
    if (true_pose) step.truth_in_enu = planar(*true_pose);
    step.estimate = update.estimate;
    step.effective_sample_size = update.effective_sample_size;
    step.particle_count = static_cast<int>(localiser.particles().size());
    step.was_resampled = update.was_resampled;
    step.agreement = update.agreement;
    step.topview_cells = static_cast<int>(topview->cells.size());
    if (request.record_particles) step.particles = localiser.particles();
    if (request.record_topviews) step.topview = std::move(*topview);
    if (const auto recorded = record(step); !recorded) return forward_error(recorded);
    ++plan.summary.steps;
    if (!update.was_weighted) ++plan.summary.steps_without_evidence;
    context.report(static_cast<double>(i + 1) / static_cast<double>(plan.frames.size()),
                   "localising");
  }
  if (!resumed && plan.summary.steps_without_evidence == plan.summary.steps) {
    return fail(ErrorCode::kUnsupported,
                "{}: no topview holds a class of map '{}' within range, so nothing was localised",
                description.path.string(), map->map().name);
  }
  return plan.summary;
}

}  // namespace nadir
