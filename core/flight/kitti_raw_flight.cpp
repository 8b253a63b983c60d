// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/staged_output.h"
#include "core/flight/flight_formats.h"
#include "core/flight/kitti_raw_text.h"
#include "core/flight/text_fields.h"

namespace nadir {
namespace fs = std::filesystem;
namespace {

/// Height of the GPS/IMU unit above the ground: figure 3 of Geiger et al. 2013.
constexpr double kBodyHeightM = 0.93;
constexpr std::uintmax_t kLargestPackets = 64U << 20U;

struct NumberedFile {
  int number = 0;  ///< Of the frame; numbers have gaps where files were left out.
  fs::path path;
};

/// Files `0000000012.EXTENSION` of a folder by number; none where the folder is not there.
std::vector<NumberedFile> numbered_files(const fs::path& folder, std::string_view extension) {
  std::vector<NumberedFile> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const auto number = flight_text::whole_number(entry->path().stem().string());
    if (!number || entry->path().extension() != extension) continue;
    files.push_back({*number, entry->path()});
  }
  std::sort(files.begin(), files.end(), [](const NumberedFile& a, const NumberedFile& b) {
    return a.number != b.number ? a.number < b.number : a.path < b.path;
  });
  return files;
}

Result<std::vector<double>> times_of(const fs::path& stream) {
  const fs::path path = stream / "timestamps.txt";
  const auto text = read_text_file(path, kLargestPackets);
  if (!text) return forward_error(text);
  return parse_kitti_timestamps(*text, path.string());
}

Result<double> time_of(const NumberedFile& file, const std::vector<double>& times_s) {
  if (static_cast<std::size_t>(file.number) < times_s.size()) {
    return times_s[static_cast<std::size_t>(file.number)];
  }
  return fail(ErrorCode::kMalformed, "{}: is frame {}, but timestamps.txt has only {} lines",
              file.path.string(), file.number, times_s.size());
}

Result<std::vector<FlightFrame>> read_frames(const fs::path& stream) {
  std::vector<FlightFrame> frames;
  const auto files = numbered_files(stream / "data", ".png");
  if (files.empty()) return frames;
  const auto times_s = times_of(stream);
  if (!times_s) return forward_error(times_s);
  for (const NumberedFile& file : files) {
    const auto time_s = time_of(file, *times_s);
    if (!time_s) return forward_error(time_s);
    if (!frames.empty() && !(*time_s > frames.back().time_s)) {
      return fail(ErrorCode::kMalformed,
                  "{}: line {}: the time does not come after that of the frame before",
                  (stream / "timestamps.txt").string(), file.number + 1);
    }
    frames.push_back({*time_s, file.path, {}, {}});
  }
  return frames;
}

Result<std::vector<OxtsPacket>> read_packets(const fs::path& stream) {
  std::vector<OxtsPacket> packets;
  const auto files = numbered_files(stream / "data", ".txt");
  if (files.empty()) return packets;
  const auto times_s = times_of(stream);
  if (!times_s) return forward_error(times_s);
  packets.reserve(files.size());
  for (const NumberedFile& file : files) {
    const auto time_s = time_of(file, *times_s);
    if (!time_s) return forward_error(time_s);
    const auto text = read_text_file(file.path, kLargestPackets);
    if (!text) return forward_error(text);
    auto packet = parse_oxts_packet(*text, file.path.string());
    if (!packet) return forward_error(packet);
    packet->time_s = *time_s;
    packets.push_back(*packet);
  }
  return packets;
}

/// The calibration lies in the folder of the day, one above the drive; some copies have it in the
/// drive itself.
std::optional<fs::path> calibration_folder(const fs::path& drive) {
  std::error_code error;
  const fs::path day = fs::absolute(drive / "..", error).lexically_normal();
  for (const fs::path& folder : {drive, day}) {
    if (fs::exists(folder / "calib_cam_to_cam.txt", error)) return folder;
  }
  return {};
}

Result<CameraMount> read_camera(const fs::path& folder) {
  const auto read = [&](const char* name) -> Result<KittiCalibration> {
    const auto text = read_text_file(folder / name, kLargestPackets);
    if (!text) return forward_error(text);
    return parse_kitti_calibration(*text);
  };
  const auto cam_to_cam = read("calib_cam_to_cam.txt");
  if (!cam_to_cam) return forward_error(cam_to_cam);
  const auto velo_to_cam = read("calib_velo_to_cam.txt");
  if (!velo_to_cam) return forward_error(velo_to_cam);
  const auto imu_to_velo = read("calib_imu_to_velo.txt");
  if (!imu_to_velo) return forward_error(imu_to_velo);
  return camera_from_kitti(*cam_to_cam, *velo_to_cam, *imu_to_velo, folder.string());
}

}  // namespace

bool is_kitti_raw_flight(const fs::path& folder) {
  std::error_code error;
  return fs::is_directory(folder / "image_02", error) || fs::is_directory(folder / "oxts", error);
}

FlightResult open_kitti_raw_flight(const fs::path& folder) {
  FlightDescription flight;
  flight.name = folder_name(folder);
  flight.format = "KITTI raw drive";
  flight.path = folder;
  auto frames = read_frames(folder / "image_02");
  if (!frames) return forward_error(frames);
  flight.frames = *std::move(frames);

  const auto packets = read_packets(folder / "oxts");
  if (!packets) return forward_error(packets);
  if (!packets->empty()) {
    const std::string name = (folder / "oxts" / "timestamps.txt").string();
    auto truth = truth_from_oxts(*packets, name);
    if (!truth) return forward_error(truth);
    auto odometry = odometry_from_oxts(*packets, name);
    if (!odometry) return forward_error(odometry);
    flight.truth = *std::move(truth);
    flight.truth_origin = packets->front().position;
    flight.odometry = *std::move(odometry);
    flight.truth_source = folder / "oxts";
    flight.odometry_source = folder / "oxts";
  }
  if (const auto calibration = calibration_folder(folder)) {
    const auto mount = read_camera(*calibration);
    if (!mount) return forward_error(mount);
    flight.camera = mount->camera;
    flight.body_from_camera = mount->body_from_camera;
    flight.altitude_m = kBodyHeightM;
  }
  if (flight.frames.empty() && packets->empty()) {
    return fail(
        ErrorCode::kMalformed,
        "{}: is a KITTI raw drive without a picture in image_02/data or a packet in oxts/data",
        folder.string());
  }
  return std::make_unique<UnlabelledFlight>(std::move(flight));
}

}  // namespace nadir
