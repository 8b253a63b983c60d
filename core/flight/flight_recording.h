// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/raster.h"
#include "core/base/result.h"
#include "core/geo/project_plane.h"
#include "core/geo/trajectory.h"
#include "core/map/semantic_classes.h"
#include "core/topview/camera_model.h"

namespace nadir {

/// One instant of the camera: where its files are. Small; the pixels are read by
/// FlightRecording::load when they are needed.
/// An image is for people (read_colour_image); depth and labels are what is localised with.
struct FlightFrame {
  double time_s = 0.0;
  std::optional<std::filesystem::path> image, depth, labels;
};

/// Pixels of one instant. Labels and depth have the camera's size.
struct SemanticFrame {
  double time_s = 0.0;
  Raster<ClassId> labels;
  Raster<float>
      depth_m;  ///< Along the optical axis. 0, negative, NaN and infinite all mean "no depth here".
};

/// What a recording holds. Memory grows with the number of frames only by their file names.
struct FlightDescription {
  std::string name;
  std::string format;  ///< "nadir flight", "KITTI raw drive", "KITTI odometry", "TUM trajectory".
  std::filesystem::path path;
  std::optional<CameraModel> camera;
  Rigid3 body_from_camera;
  double altitude_m = 0.0;          ///< Of the body above ground, where known, else 0.
  std::vector<FlightFrame> frames;  ///< In order of time.
  std::optional<Trajectory>
      odometry;  ///< odom_from_body: drifts, but roll and pitch are those of the vehicle.
  std::optional<Trajectory> truth;  ///< enu_from_body.
  std::optional<Geodetic>
      truth_origin;  ///< Origin of the project plane that `truth` is given in, where known.
  /// Where odometry and truth were read from: a file, or a folder of packets. Empty without them.
  std::filesystem::path odometry_source = {}, truth_source = {};
  /// Files that could be the odometry as well, and were left aside.
  std::vector<std::filesystem::path> other_odometry = {};
};

/// A recorded flight, read lazily by time.
class FlightRecording {
 public:
  virtual ~FlightRecording() = default;
  [[nodiscard]] const FlightDescription& description() const { return description_; }
  /// Reads labels and depth of frame i. @errors kNotFound, kMalformed (truncated, wrong size),
  /// kUnsupported (no labels).
  [[nodiscard]] virtual Result<SemanticFrame> load(std::size_t frame) const = 0;

 protected:
  explicit FlightRecording(FlightDescription description) : description_(std::move(description)) {}

 private:
  FlightDescription description_;
};

/// Opens a folder or file of any known format, told by what is in it.
/// @errors kNotFound, kUnsupported ("PATH: is not a flight: no flight.toml, ..."), kMalformed.
[[nodiscard]] Result<std::unique_ptr<FlightRecording>> open_flight(
    const std::filesystem::path& path);

}  // namespace nadir
