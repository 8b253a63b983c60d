// SPDX-License-Identifier: Apache-2.0
#include "core/run/localise_flight.h"

#include <chrono>
#include <future>
#include <limits>
#include <system_error>

#include "core/base/hash.h"
#include "core/base/version.h"
#include "core/mcl/localiser.h"

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
  for (std::size_t i = 0; i < flight.frames.size(); ++i) {
    if (!flight.frames[i].labels || !flight.frames[i].depth) continue;
    if (request.most_frames && seen >= *request.most_frames) break;
    ++seen;
    const double time_s = flight.frames[i].time_s;
    const double interval_s = request.options.localiser.min_update_interval_s;
    // A millisecond of tolerance: time stamps of a nominal rate are rounded.
    if (!plan.frames.empty() && time_s - plan.frames.back().time_s < interval_s - 1e-3) {
      ++plan.summary.frames_passed_over;
      continue;
    }
    const auto odom_from_body = flight.odometry->at(time_s);
    if (!odom_from_body) {
      ++plan.summary.frames_without_odometry;
      continue;
    }
    plan.frames.push_back({i, time_s, *odom_from_body});
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

Result<Prior> choose_prior(const LocaliseRequest& request,
                           const FlightDescription& flight,
                           const std::optional<Trajectory>& truth,
                           const UsedFrame& first) {
  if (request.prior) return *request.prior;
  const auto start = truth ? truth->at(first.time_s) : std::nullopt;
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

void add_pose(Hash& hash, const Rigid3& pose) {
  hash.add(pose.translation_m.data(), 3 * sizeof(double));
  hash.add(pose.rotation.coeffs().data(), 4 * sizeof(double));
}

/// Everything about a flight but its pixels, for which names and sizes of their files stand.
std::string hash_of(const FlightDescription& flight) {
  Hash hash;
  if (flight.camera) {
    const CameraModel& camera = *flight.camera;
    hash.add_number(camera.width).add_number(camera.height);
    hash.add_number(camera.focal_x_px).add_number(camera.focal_y_px);
    hash.add_number(camera.centre_x_px).add_number(camera.centre_y_px);
  }
  add_pose(hash, flight.body_from_camera);
  for (const FlightFrame& frame : flight.frames) {
    hash.add_number(frame.time_s);
    for (const auto& file : {frame.labels, frame.depth}) {
      std::error_code missing;
      if (!file) continue;
      hash.add(file->filename().string()).add_number(std::filesystem::file_size(*file, missing));
    }
  }
  for (const auto* trajectory : {&flight.odometry, &flight.truth}) {
    if (!*trajectory) continue;
    for (const TimedPose& timed : (*trajectory)->poses()) {
      hash.add_number(timed.time_s);
      add_pose(hash, timed.pose);
    }
  }
  return hash.text();
}

/// The start as text, so that the run can be made again.
std::string prior_text(const std::optional<Prior>& prior) {
  if (!prior) return "truth of the first frame";
  const auto* gaussian = std::get_if<GaussianPrior>(&*prior);
  if (gaussian == nullptr) return "global";
  return fmt::format("{} m east, {} m north, yaw {} rad; sigma {} m, {} rad",
                     gaussian->mean_in_enu.x_m, gaussian->mean_in_enu.y_m,
                     gaussian->mean_in_enu.yaw_rad, gaussian->position_sigma_m,
                     gaussian->yaw_sigma_rad);
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

RunHeader run_header(const FlightRecording& flight,
                     const OverheadMap& map,
                     const std::string& map_path,
                     const std::string& preset,
                     const LocaliseRequest& request) {
  const FlightDescription& description = flight.description();
  RunHeader header;
  header.program_version = kVersion;
  header.flight = description.name;
  header.flight_path = description.path.string();
  header.map = map.name;
  header.map_path = map_path;
  header.preset = preset;
  header.seed = request.options.localiser.seed;
  header.plane_latitude_deg = map.plane.origin().latitude_deg;
  header.plane_longitude_deg = map.plane.origin().longitude_deg;
  header.map_hash = content_hash(map);
  header.flight_hash = hash_of(description);
  for (const OptionText& option : option_texts(request.options)) {
    header.options[option.name] = option.value;
  }
  header.options["prior"] = prior_text(request.prior);
  if (request.most_frames) header.options["frames"] = std::to_string(*request.most_frames);
  return header;
}

Result<LocaliseSummary> localise_flight(const FlightRecording& flight,
                                        const std::shared_ptr<const MapIndex>& map,
                                        const LocaliseRequest& request,
                                        const std::function<Result<void>(const RunStep&)>& record,
                                        const WorkContext& context) {
  const FlightDescription& description = flight.description();
  if (const auto valid = validate_run(request.options); !valid) return forward_error(valid);
  if (const auto streams = check_streams(description); !streams) return forward_error(streams);
  FramePlan plan = plan_frames(description, request);
  if (plan.frames.empty()) {
    return fail(ErrorCode::kUnsupported, "{}: no frame has labels, depth and odometry",
                description.path.string());
  }
  const double metres_per_cell = map->map().metres_per_cell;
  const auto placed_truth = truth_in_plane(description, map->map().plane);
  if (!placed_truth) return forward_error(placed_truth);
  const std::optional<Trajectory>& truth = *placed_truth;
  const auto prior = choose_prior(request, description, truth, plan.frames.front());
  if (!prior) return forward_error(prior);
  auto localiser = Localiser::create(map, request.options.localiser, *prior);
  if (!localiser) return forward_error(localiser);
  const auto start = start_of(*prior, truth, plan.frames.front().time_s);
  const Rigid2 start_from_odom = planar(plan.frames.front().odom_from_body).inverse();

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
    const UsedFrame& before = plan.frames[i > 0 ? i - 1 : 0];
    const auto began = Clock::now();
    auto topview = topview_of(*frame, description, used.odom_from_body, metres_per_cell,
                              request.options.topview);
    if (!topview) return forward_error(topview, description.path.string());
    const Rigid2 odom_from_body = planar(used.odom_from_body);
    const OdometryStep odometry{planar(before.odom_from_body).inverse() * odom_from_body,
                                used.time_s - before.time_s};
    const LocaliserUpdate update = localiser->update(odometry, *topview);

    RunStep step;
    step.update_ms = elapsed_ms(began);
    step.step = plan.summary.steps;
    step.time_s = used.time_s;
    step.odom_from_body = odom_from_body;
    if (start) step.odometry_in_enu = *start * start_from_odom * odom_from_body;
    const auto true_pose = truth ? truth->at(used.time_s) : std::nullopt;
    if (true_pose) step.truth_in_enu = planar(*true_pose);
    step.estimate = update.estimate;
    step.effective_sample_size = update.effective_sample_size;
    step.particle_count = static_cast<int>(localiser->particles().size());
    step.was_resampled = update.was_resampled;
    step.agreement = update.agreement;
    step.topview_cells = static_cast<int>(topview->cells.size());
    if (request.record_particles) step.particles = localiser->particles();
    if (request.record_topviews) step.topview = std::move(*topview);
    if (const auto recorded = record(step); !recorded) return forward_error(recorded);
    ++plan.summary.steps;
    if (!update.was_weighted) ++plan.summary.steps_without_evidence;
    context.report(static_cast<double>(i + 1) / static_cast<double>(plan.frames.size()),
                   "localising");
  }
  if (plan.summary.steps_without_evidence == plan.summary.steps) {
    return fail(ErrorCode::kUnsupported,
                "{}: no topview holds a class of map '{}' within range, so nothing was localised",
                description.path.string(), map->map().name);
  }
  return plan.summary;
}

}  // namespace nadir
