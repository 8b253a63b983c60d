// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/flight/colour_image.h"
#include "core/flight/flight_recording.h"
#include "core/flight/flight_settings.h"
#include "core/flight/frame_image.h"
#include "core/flight/frame_list.h"
#include "core/flight/kitti_raw_text.h"
#include "tests/fuzz/fuzz_check.h"

// The bytes are given to every reader of a flight's files in turn: flight.toml, the lists, the
// images, and KITTI's texts. Bytes that begin with "--- NAME" and a new line, once a file, are a
// whole flight in a folder as well.
namespace {

using nadir::fuzz_check;
using nadir::fuzz_check_error;

constexpr const char* kName = "fuzzed";
constexpr nadir::ImageSize kSize{8, 6};

void check_settings(std::string_view text) {
  const auto settings = nadir::parse_flight_settings(text, kName);
  fuzz_check_error(settings, kName);
  if (!settings) return;
  fuzz_check(settings->depth_units_per_m > 0.0, "depth has a positive unit");
  const auto again = nadir::parse_flight_settings(nadir::flight_settings_text(*settings), kName);
  fuzz_check(again.has_value(), "written settings can be read");
  fuzz_check(again->name == settings->name, "and have the same name");
  fuzz_check(again->camera.has_value() == settings->camera.has_value(), "and the same camera");
}

void check_list(std::string_view text) {
  const auto files = nadir::parse_frame_list(text, kName);
  fuzz_check_error(files, kName);
  if (!files) return;
  double previous_s = -HUGE_VAL;
  for (const nadir::ListedFile& file : *files) {
    fuzz_check(std::isfinite(file.time_s) && previous_s < file.time_s, "times are increasing");
    previous_s = file.time_s;
    fuzz_check(!file.file.empty(), "every entry names a file");
    const auto path = nadir::path_inside("/flight", file.file);
    if (path) {
      const std::string normal = path->lexically_normal().string();
      fuzz_check(normal.starts_with("/flight/"), "no file lies outside the folder");
    }
    const auto nearest = nadir::nearest_in_time(*files, file.time_s, 0.0);
    fuzz_check(nearest && (*files)[*nearest].time_s == file.time_s, "an entry is its own nearest");
  }
  fuzz_check(nadir::association_tolerance_s(*files) <= 0.02, "20 ms at most");
}

void check_images(std::span<const std::uint8_t> bytes) {
  const auto labels = nadir::decode_label_image(bytes, kName, kSize);
  fuzz_check_error(labels, kName);
  if (labels) {
    const auto png = nadir::encode_label_png(*labels);
    const auto again = nadir::decode_label_image(png.value(), kName, kSize);
    fuzz_check(again && *again == *labels, "labels are read back as written");
  }
  const auto depth_m = nadir::decode_depth_image(bytes, kName, kSize, 1000.0);
  fuzz_check_error(depth_m, kName);
  if (depth_m) {
    const auto is_depth = [](float depth) { return depth >= 0.0F && depth <= 65.535F; };
    fuzz_check(std::all_of(depth_m->values().begin(), depth_m->values().end(), is_depth),
               "depth is in range");
  }
  const auto colours = nadir::decode_colour_image(bytes, kName);
  fuzz_check_error(colours, kName);
  if (colours) fuzz_check(!colours->empty(), "a picture has pixels");
}

void check_kitti(std::string_view text) {
  const auto times_s = nadir::parse_kitti_timestamps(text, kName);
  fuzz_check_error(times_s, kName);
  auto packet = nadir::parse_oxts_packet(text, kName);
  fuzz_check_error(packet, kName);
  if (packet) {
    std::vector<nadir::OxtsPacket> packets(2, *packet);
    packets[1].time_s = 0.1;
    fuzz_check_error(nadir::truth_from_oxts(packets, kName), kName);
    fuzz_check_error(nadir::odometry_from_oxts(packets, kName), kName);
  }
  const auto calibration = nadir::parse_kitti_calibration(text);
  const auto mount = nadir::camera_from_kitti(calibration, calibration, calibration, kName);
  fuzz_check_error(mount, kName);
  if (mount) fuzz_check(nadir::validate(mount->camera).has_value(), "a camera is possible");
}

namespace fs = std::filesystem;

/// One folder a process, in memory where the system has a folder for that.
fs::path fuzzed_folder() {
  const std::string name = "nadir-flight-fuzz-" + std::to_string(::getpid());
  return (fs::is_directory("/dev/shm") ? fs::path("/dev/shm") : fs::temp_directory_path()) / name;
}

/// Writes the file that `name`, a new line and its bytes stand for, where that is inside the
/// folder.
void write_part(const fs::path& folder, std::string_view part) {
  const std::size_t end = part.find('\n');
  if (end == std::string_view::npos || end > 100) return;
  const fs::path name(part.substr(0, end));
  for (const fs::path& step : name) {
    if (step == ".." || name.is_absolute() || name.string().find('\0') != std::string::npos) return;
  }
  std::error_code ignored;  // A name may be a folder already, or too long.
  fs::create_directories((folder / name).parent_path(), ignored);
  std::ofstream(folder / name, std::ios::binary) << part.substr(end + 1);
}

void check_flight(std::string_view text) {
  constexpr std::string_view kMark = "--- ";
  if (!text.starts_with(kMark)) return;
  const fs::path folder = fuzzed_folder();
  fs::create_directory(folder);
  for (std::size_t at = kMark.size(); at < text.size();) {
    const std::size_t next = std::min(text.find("\n--- ", at), text.size());
    write_part(folder, text.substr(at, next - at));
    at = next + 1 + kMark.size();
  }
  const auto flight = nadir::open_flight(folder);
  fuzz_check_error(flight, folder.string());
  if (flight && !(*flight)->description().frames.empty()) {
    const auto frame = (*flight)->load(0);
    fuzz_check_error(frame, folder.string());
    if (frame) {
      fuzz_check(frame->labels.width() == frame->depth_m.width(), "depth is as wide as labels");
      fuzz_check(frame->labels.height() == frame->depth_m.height(), "and as high");
    }
  }
  fs::remove_all(folder);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = nadir::text_of(data, size);
  check_settings(text);
  check_list(text);
  check_images({data, size});
  check_kitti(text);
  check_flight(text);
  return 0;
}
