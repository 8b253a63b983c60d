// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/geo/project_plane.h"
#include "core/geo/rigid3.h"
#include "core/topview/camera_model.h"

namespace nadir {

/// What flight.toml says; core/flight/README.md lists its keys.
struct FlightSettings {
  std::string name;
  std::string provenance;  ///< One sentence: where the recording comes from.
  /// The program that made the flight up and can make it again; empty for recordings, which are
  /// never replaced.
  std::string generator = {};
  double altitude_m = 0.0;
  std::optional<CameraModel> camera;
  Rigid3 body_from_camera{forward_body_from_camera(), Eigen::Vector3d::Zero()};
  double depth_units_per_m = 1000.0;  ///< What a depth of one metre is in a depth image.
  std::optional<Geodetic> truth_origin;
};

/// Newest `format_version` that is read, and the one that is written.
inline constexpr int kFlightFormatVersion = 1;

/// Parses the text of a flight.toml; `name` stands for the file in messages.
///
/// The file has the principal point as OpenCV and ROS calibrations do, with pixel centres at whole
/// numbers; CameraModel has them at +0.5. The half pixel is added here, and taken off in
/// flight_settings_text(), and nowhere else.
/// @errors kMalformed: not TOML, a key that is missing, unknown or of another type, a quaternion
/// that is not of unit length,
///   an origin that is nowhere. kUnsupported: a newer format_version. kInvalidOptions: an
///   impossible camera.
[[nodiscard]] Result<FlightSettings> parse_flight_settings(std::string_view text,
                                                           const std::string& name);

/// The text of a flight.toml, with enough digits to read back the same numbers.
[[nodiscard]] std::string flight_settings_text(const FlightSettings& settings);

}  // namespace nadir
