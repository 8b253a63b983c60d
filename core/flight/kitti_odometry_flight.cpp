// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>
#include <vector>

#include "core/base/require.h"
#include "core/flight/flight_formats.h"
#include "core/geo/trajectory_file.h"

namespace nadir {
namespace fs = std::filesystem;
namespace {

/// poses*.txt of a folder by name.
std::vector<fs::path> pose_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const fs::path& path = entry->path();
    if (path.extension() == ".txt" && path.filename().string().starts_with("poses")) {
      files.push_back(path);
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

bool is_kitti_odometry_flight(const fs::path& folder) {
  std::error_code error;
  return fs::is_regular_file(folder / "times.txt", error) && !pose_files(folder).empty();
}

FlightResult open_kitti_odometry_flight(const fs::path& folder) {
  const std::vector<fs::path> files = pose_files(folder);
  NADIR_REQUIRE(!files.empty());
  const auto is_truth = [&](const fs::path& path) {
    return files.size() == 1 || path.filename() == "poses_gt.txt";
  };
  const auto truth_file = std::find_if(files.begin(), files.end(), is_truth);
  const auto odometry_file = std::find_if_not(files.begin(), files.end(), is_truth);

  FlightDescription flight;
  flight.name = folder_name(folder);
  flight.format = "KITTI odometry";
  flight.path = folder;
  if (truth_file != files.end()) {
    auto truth = read_trajectory(*truth_file, folder / "times.txt");
    if (!truth) return forward_error(truth);
    flight.truth = *std::move(truth);
    flight.truth_source = *truth_file;
  }
  if (odometry_file != files.end()) {
    auto odometry = read_trajectory(*odometry_file, folder / "times.txt");
    if (!odometry) return forward_error(odometry);
    flight.odometry = *std::move(odometry);
    flight.odometry_source = *odometry_file;
    std::copy_if(odometry_file + 1, files.end(), std::back_inserter(flight.other_odometry),
                 [&](const fs::path& path) { return !is_truth(path); });
  }
  return std::make_unique<UnlabelledFlight>(std::move(flight));
}

}  // namespace nadir
