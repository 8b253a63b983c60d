// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/flight_moments.h"

#include <algorithm>
#include <cmath>

#include "core/base/require.h"
#include "core/flight/colour_image.h"
#include "core/run/place_beside.h"
#include "widgets/views/raster_pictures.h"

namespace nadir {
namespace fs = std::filesystem;
namespace {

bool has_cloud(const FlightFrame& frame) {
  return frame.labels.has_value() && frame.depth.has_value();
}

}  // namespace

Result<FlightMoment> flight_moment(const FlightDescription& flight,
                                   double clock_s,
                                   const Raster<ClassId>& labels,
                                   const Raster<float>& depth_m,
                                   double max_depth_m,
                                   int every_nth_pixel) {
  NADIR_REQUIRE(flight.camera.has_value());
  FlightMoment moment;
  moment.camera = *flight.camera;
  const auto odom_from_body =
      flight.odometry ? flight.odometry->at(clock_s) : std::optional<Rigid3>();
  const Eigen::Quaterniond levelling =
      odom_from_body ? level_from_body(odom_from_body->rotation) : Eigen::Quaterniond::Identity();
  moment.level_from_camera = Rigid3{levelling, Eigen::Vector3d::Zero()} * flight.body_from_camera;
  const Eigen::Isometry3d transform = Eigen::Translation3d(moment.level_from_camera.translation_m) *
                                      moment.level_from_camera.rotation;
  auto cloud =
      build_semantic_cloud(labels, depth_m, moment.camera, transform, max_depth_m, every_nth_pixel);
  if (!cloud) return forward_error(cloud, flight.path.string());
  moment.cloud = std::move(*cloud);
  moment.level_height_m =
      flight.altitude_m > 0.0 ? flight.altitude_m : height_above_ground(moment.cloud);
  return moment;
}

Result<fs::path> find_flight_of(const FigureRun& run) {
  const fs::path named = run.reader->header().flight_path;
  if (auto place = place_beside(run.path, named)) return *place;
  return fail(ErrorCode::kNotFound,
              "{}: its flight {} is not there, and the figure shows what its camera saw",
              run.path.string(), named.string());
}

Result<FlightMoments> FlightMoments::open(const FigureRun& run) {
  const auto path = find_flight_of(run);
  if (!path) return forward_error(path);
  auto flight = open_flight(*path);
  if (!flight) return forward_error(flight);
  const FlightDescription& description = (*flight)->description();
  if (!description.camera) {
    return fail(ErrorCode::kUnsupported, "{}: no camera is described", path->string());
  }
  if (auto valid = validate(*description.camera); !valid) {
    return forward_error(valid, path->string());
  }
  if (std::none_of(description.frames.begin(), description.frames.end(), has_cloud)) {
    return fail(ErrorCode::kUnsupported, "{}: no frame has labels and depth", path->string());
  }
  return FlightMoments(std::move(*flight));
}

Result<FlightMoment> FlightMoments::at(double time_s,
                                       double max_depth_m,
                                       int every_nth_pixel) const {
  const FlightDescription& flight = flight_->description();
  const FlightFrame* const nearest = nearest_frame(flight, time_s, has_cloud);
  if (nearest == nullptr) {
    return fail(ErrorCode::kNotFound, "{}: has no labels and depth at {:.3f} s",
                flight.path.string(), time_s);
  }
  const auto frame = flight_->load(static_cast<std::size_t>(nearest - flight.frames.data()));
  if (!frame) return forward_error(frame);
  auto moment = flight_moment(flight, nearest->time_s, frame->labels, frame->depth_m, max_depth_m,
                              every_nth_pixel);
  if (!moment) return moment;
  if (nearest->image) {
    const auto picture = read_colour_image(*nearest->image);
    if (!picture) return forward_error(picture);
    moment->picture = colour_picture(*picture);
  } else {
    moment->picture = class_picture(frame->labels);
  }
  return moment;
}

double height_above_ground(const SemanticCloud& cloud) {
  std::vector<float> heights;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const ClassId id = cloud.labels[i];
    const float height = cloud.points_in_level_m[i].z();
    const bool is_ground = id == kRoad || id == kSidewalk || id == kLaneMarking || id == kTerrain;
    if (is_ground && std::isfinite(height)) heights.push_back(height);
  }
  if (heights.empty()) return 0.0;
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::nth_element(heights.begin(), middle, heights.end());
  return -double{*middle};
}

}  // namespace nadir
