// SPDX-License-Identifier: Apache-2.0
#include "core/base/require.h"
#include "core/flight/flight_formats.h"

namespace nadir {
namespace fs = std::filesystem;

Result<std::unique_ptr<FlightRecording>> open_flight(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) {
    return fail(ErrorCode::kNotFound, "{}: does not exist", path.string());
  }
  if (!fs::is_directory(path, error)) {
    if (path.filename() == "flight.toml") return open_native_flight(path.parent_path());
    if (is_trajectory_file(path)) return open_trajectory_flight(path);
    return fail(ErrorCode::kUnsupported,
                "{}: is not a flight: its first line is neither a TUM pose (8 numbers) nor a KITTI "
                "pose (12 numbers)",
                path.string());
  }
  if (is_native_flight(path)) return open_native_flight(path);
  if (is_kitti_raw_flight(path)) return open_kitti_raw_flight(path);
  if (is_kitti_odometry_flight(path)) return open_kitti_odometry_flight(path);
  return fail(
      ErrorCode::kUnsupported,
      "{}: is not a flight: no flight.toml (native), no image_02 or oxts (KITTI raw drive), "
      "no times.txt with poses*.txt (KITTI odometry)",
      path.string());
}

std::string folder_name(const fs::path& folder) {
  std::error_code error;
  return (fs::absolute(folder, error) / "").lexically_normal().parent_path().filename().string();
}

Result<SemanticFrame> UnlabelledFlight::load(std::size_t frame) const {
  NADIR_REQUIRE(frame < description().frames.size());
  return fail(ErrorCode::kUnsupported,
              "{}: has images but no label images, so there is nothing to localise with",
              description().path.string());
}

}  // namespace nadir
