// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/field.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/geo/trajectory.h"
#include "core/map/overhead_map.h"
#include "core/map/overhead_map_file.h"
#include "core/sim/world.h"
#include "core/topview/camera_model.h"

namespace nadir {

enum class SimulationLevel { kEasy, kMedium, kHard };

template <>
struct EnumNames<SimulationLevel> {
  static constexpr std::array<std::string_view, 3> kNames = {"easy", "medium", "hard"};
};

/// What a level means (thesis 4.2). The odometry is calibrated to the input errors that the thesis
/// *measured*, as means over many flights, because its noise figures do not reproduce them.
struct LevelNoise {
  double odometry_position_mse_m2 = 0.0;
  double odometry_yaw_mse_rad2 = 0.0;
  double inverse_depth_sigma = 0.0;  ///< 1/m.
  double depth_range_m = 20.0;
};
[[nodiscard]] LevelNoise level_noise(SimulationLevel level);

struct SimulationOptions {
  SimulationLevel level = SimulationLevel::kMedium;
  std::uint64_t seed = 1;
  double frame_rate_hz =
      4.0;  ///< Of planned flights; on a recorded path every true pose is a frame.
  bool has_label_noise = true;   ///< false: labels are perfect.
  bool has_colour = true;        ///< Also what the camera sees in colour, for people.
  double camera_height_m = 2.0;  ///< On a recorded path; a planned flight knows its altitude.
  int image_width_px = 640;
  int image_height_px = 480;
  double view_deg = 59.95;  ///< Horizontal.
  WorldOptions world;
};

template <typename Options, typename Visitor>
requires std::same_as<std::remove_const_t<Options>, SimulationOptions>
void visit_fields(Options& options, Visitor&& visit) {
  visit(options.level, Field{"level", "", "Difficulty: odometry drift, depth noise and range"});
  visit(options.seed, Field{"seed", "", "Root of every random draw", 0});
  visit(options.frame_rate_hz, Field{"frame-rate", "1/s", "Frames on a route", 0.1, 20});
  visit(options.has_label_noise, Field{"label-noise", "", "Segmentation errors like a network's"});
  visit(options.has_colour, Field{"colour", "", "Also camera images in colour, for people"});
  visit(options.camera_height_m,
        Field{"camera-height", "m", "Camera above ground on a recorded path", 0.2, 50});
  visit(options.image_width_px, Field{"image-width", "px", "Camera image", 16, 4096});
  visit(options.image_height_px, Field{"image-height", "px", "Camera image", 16, 4096});
  visit(options.view_deg, Field{"view", "deg", "Horizontal field of view", 5, 170});
  visit_fields(options.world, std::forward<Visitor>(visit));
}

/// A path to observe a map along.
struct FlownPath {
  std::string name;
  Trajectory truth;  ///< enu_from_body; the camera looks straight ahead from the body.
  std::optional<Trajectory>
      odometry;  ///< As recorded; else it is made from the truth and the level.
  std::optional<double> frame_rate_hz;  ///< Else every true pose is a frame.
};

/// A recorded true path as a path over a map: heights are replaced by `camera_height_m`. With a
/// start, the first pose is laid on it: places turn with the path, and attitudes are relative to
/// the first pose, whose roll and pitch count as level. Without one, poses are in `enu` already and
/// keep their attitudes.
/// @param recorded  world_from_body, any level world.
[[nodiscard]] Trajectory place_recorded_path(const Trajectory& recorded,
                                             const std::optional<Rigid2>& start_in_enu,
                                             double camera_height_m);

struct SimulatedFlight {
  std::filesystem::path folder;
  std::size_t frames = 0;
  std::size_t frames_off_map =
      0;  ///< With the camera outside the map: they see unclassified ground there.
  double duration_s = 0.0;
  double length_m = 0.0;
};

/// Flies a path through a world raised from a map and writes what the vehicle records as a native
/// flight: labels with segmentation errors, depth, odometry, truth, and camera images in colour
/// (world_colours.h) where the options ask for them. Frames are made several at a
/// time and written in order, so that memory does not grow with the flight. The same arguments give
/// the same files on any number of threads.
///
/// @param picture  The overhead picture, of the size of the map's labels, whose colours the ground
///         takes in camera images; without it the ground is in the colours of its classes.
/// @errors kInvalidOptions: an option out of range, a path that starts off the map, odometry and
///         truth at different times, a picture of another size;
///         kMalformed: a map without classes; kCancelled; kIo. Nothing is left under `folder` then.
[[nodiscard]] Result<SimulatedFlight> simulate_flight(
    const OverheadMap& map,
    const FlownPath& path,
    const SimulationOptions& options,
    const std::filesystem::path& folder,
    const WorkContext& work,
    const std::optional<ColourRaster>& picture = std::nullopt);

}  // namespace nadir
