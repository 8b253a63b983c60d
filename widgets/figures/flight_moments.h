// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/flight/flight_recording.h"
#include "core/flight/nearest_frame.h"
#include "core/topview/semantic_cloud.h"
#include "widgets/canvas/canvas.h"
#include "widgets/figures/figure_run.h"

namespace nadir {

/// What the camera of a run's flight knew at one moment.
struct FlightMoment {
  CameraModel camera;
  Rigid3 level_from_camera;     ///< Roll and pitch by the odometry, as the localiser took them.
  double level_height_m = 0.0;  ///< Of the body above the ground, which is flat here.
  SemanticCloud cloud;
  Raster<Rgba> picture;  ///< What it saw, else its classes; of any size.
};

/// What a camera knew whose labels and depth these are, without a picture. Points farther than `max_depth_m` and all but every
/// n-th pixel are left out. @param flight  Describes a camera. @param clock_s  The recording's, of the frame.
/// @errors kMalformed: labels or depth are not of the camera's size.
[[nodiscard]] Result<FlightMoment> flight_moment(const FlightDescription& flight,
                                                 double clock_s,
                                                 const Raster<ClassId>& labels,
                                                 const Raster<float>& depth_m,
                                                 double max_depth_m,
                                                 int every_nth_pixel);

/// The recording that a run was localised on, moment by moment.
class FlightMoments {
 public:
  /// @errors kNotFound: "R.nadir: its flight PATH is not there, and the figure shows what its camera saw"; kUnsupported: no
  /// camera is described, or no frame has labels and depth; as open_flight.
  [[nodiscard]] static Result<FlightMoments> open(const FigureRun& run);

  /// Points farther than that and all but every n-th pixel are left out. @errors kNotFound: no labels and depth within a
  /// tenth of a second of the time; as FlightRecording::load and read_colour_image.
  [[nodiscard]] Result<FlightMoment> at(double time_s,
                                        double max_depth_m,
                                        int every_nth_pixel) const;

 private:
  explicit FlightMoments(std::unique_ptr<FlightRecording> flight) : flight_(std::move(flight)) {}
  std::unique_ptr<FlightRecording> flight_;
};

/// The recording that a run was localised on: where the run says it was, or beside the run under the same name.
/// @errors kNotFound, as above.
[[nodiscard]] Result<std::filesystem::path> find_flight_of(const FigureRun& run);

/// Height of the body above the ground by the points of a cloud that lie on it: the median of roads, sidewalks, lane markings
/// and terrain. 0 where there are none.
[[nodiscard]] double height_above_ground(const SemanticCloud& cloud);

}  // namespace nadir
