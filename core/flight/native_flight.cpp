// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <span>

#include "core/base/require.h"
#include "core/base/staged_output.h"
#include "core/flight/flight_formats.h"
#include "core/flight/flight_settings.h"
#include "core/flight/frame_image.h"
#include "core/flight/frame_list.h"
#include "core/geo/trajectory_file.h"

namespace nadir {
namespace fs = std::filesystem;
namespace {

constexpr std::uintmax_t kLargestList = 256U << 20U;
constexpr std::uintmax_t kLargestImage = 1U << 30U;

/// A list of the folder with its files' names made whole; empty where the flight has no such list.
struct FrameStream {
  std::vector<ListedFile> files;
  std::vector<fs::path> paths;

  [[nodiscard]] std::optional<fs::path> near(double time_s, double tolerance_s) const {
    const auto index = nearest_in_time(files, time_s, tolerance_s);
    if (!index) return {};
    return paths[*index];
  }
};

Result<FrameStream> read_stream(const fs::path& folder, const char* list_name) {
  const fs::path list = folder / list_name;
  std::error_code error;
  if (!fs::exists(list, error)) return FrameStream{};
  const auto text = read_text_file(list, kLargestList);
  if (!text) return forward_error(text);
  auto files = parse_frame_list(*text, list.string());
  if (!files) return forward_error(files);

  FrameStream stream{*std::move(files), {}};
  stream.paths.reserve(stream.files.size());
  for (const ListedFile& listed : stream.files) {
    const auto path = path_inside(folder, listed.file);
    if (!path) {
      return forward_error(path, fmt::format("{}: line {}", list.string(), listed.line));
    }
    if (!fs::is_regular_file(*path, error)) {
      return fail(ErrorCode::kNotFound, "{}: line {}: {} does not exist", list.string(),
                  listed.line, listed.file);
    }
    stream.paths.push_back(*path);
  }
  return stream;
}

Result<std::optional<Trajectory>> read_poses(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) return std::optional<Trajectory>();
  const auto text = read_text_file(path, kLargestList);
  if (!text) return forward_error(text);
  auto trajectory = parse_tum_trajectory(*text, path.string());
  if (!trajectory) return forward_error(trajectory);
  return std::optional<Trajectory>(*std::move(trajectory));
}

/// The frames are those of the first list that is there; the others are looked up by time.
std::vector<FlightFrame> associate(const FrameStream& images,
                                   const FrameStream& depth,
                                   const FrameStream& labels) {
  const FrameStream& leading = !labels.files.empty()   ? labels
                               : !images.files.empty() ? images
                                                       : depth;
  const double tolerance_s = association_tolerance_s(leading.files);
  std::vector<FlightFrame> frames;
  frames.reserve(leading.files.size());
  for (const ListedFile& file : leading.files) {
    frames.push_back({file.time_s, images.near(file.time_s, tolerance_s),
                      depth.near(file.time_s, tolerance_s), labels.near(file.time_s, tolerance_s)});
  }
  return frames;
}

std::span<const std::uint8_t> as_bytes(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

class NativeFlight final : public FlightRecording {
 public:
  NativeFlight(FlightDescription description, double depth_units_per_m)
      : FlightRecording(std::move(description)), depth_units_per_m_(depth_units_per_m) {
    const auto& frames = this->description().frames;
    has_depth_ = std::any_of(frames.begin(), frames.end(),
                             [](const FlightFrame& f) { return f.depth.has_value(); });
  }

  [[nodiscard]] Result<SemanticFrame> load(std::size_t index) const override;

 private:
  double depth_units_per_m_;
  bool has_depth_;
};

Result<SemanticFrame> NativeFlight::load(std::size_t index) const {
  NADIR_REQUIRE(index < description().frames.size());
  const FlightFrame& frame = description().frames[index];
  const std::string name = description().path.string();
  if (!frame.labels) {
    return fail(ErrorCode::kUnsupported,
                "{}: has {} but no label images, so there is nothing to localise with", name,
                frame.image ? "images" : "depth");
  }
  if (!has_depth_) {
    return fail(ErrorCode::kUnsupported,
                "{}: has label images but no depth, so nobody knows where the labels lie", name);
  }
  if (!description().camera) {
    return fail(ErrorCode::kUnsupported,
                "{}: has label images but flight.toml has no [camera], so nobody knows where they "
                "look",
                name);
  }
  const ImageSize size{description().camera->width, description().camera->height};
  const auto label_bytes = read_text_file(*frame.labels, kLargestImage);
  if (!label_bytes) return forward_error(label_bytes);
  auto labels = decode_label_image(as_bytes(*label_bytes), frame.labels->string(), size);
  if (!labels) return forward_error(labels);
  // A single lost depth image is no reason to stop: nothing of this frame is seen.
  if (!frame.depth) {
    return SemanticFrame{frame.time_s, *std::move(labels),
                         Raster<float>(size.width, size.height, 0.0F)};
  }
  const auto depth_bytes = read_text_file(*frame.depth, kLargestImage);
  if (!depth_bytes) return forward_error(depth_bytes);
  auto depth_m =
      decode_depth_image(as_bytes(*depth_bytes), frame.depth->string(), size, depth_units_per_m_);
  if (!depth_m) return forward_error(depth_m);
  return SemanticFrame{frame.time_s, *std::move(labels), *std::move(depth_m)};
}

}  // namespace

bool is_native_flight(const fs::path& folder) {
  std::error_code error;
  return fs::exists(folder / "flight.toml", error);
}

FlightResult open_native_flight(const fs::path& given) {
  const fs::path folder = given.empty() ? fs::path(".") : given;
  const fs::path settings_path = folder / "flight.toml";
  const auto text = read_text_file(settings_path, kLargestList);
  if (!text) return forward_error(text);
  const auto settings = parse_flight_settings(*text, settings_path.string());
  if (!settings) return forward_error(settings);
  const auto images = read_stream(folder, "rgb.txt");
  if (!images) return forward_error(images);
  const auto depth = read_stream(folder, "depth.txt");
  if (!depth) return forward_error(depth);
  const auto labels = read_stream(folder, "labels.txt");
  if (!labels) return forward_error(labels);
  auto odometry = read_poses(folder / "odometry.txt");
  if (!odometry) return forward_error(odometry);
  auto truth = read_poses(folder / "truth.txt");
  if (!truth) return forward_error(truth);

  FlightDescription flight;
  flight.name = settings->name.empty() ? folder_name(folder) : settings->name;
  flight.format = "nadir flight";
  flight.path = folder;
  flight.camera = settings->camera;
  flight.body_from_camera = settings->body_from_camera;
  flight.altitude_m = settings->altitude_m;
  flight.frames = associate(*images, *depth, *labels);
  flight.odometry = *std::move(odometry);
  flight.truth = *std::move(truth);
  flight.truth_origin = settings->truth_origin;
  if (flight.odometry) flight.odometry_source = folder / "odometry.txt";
  if (flight.truth) flight.truth_source = folder / "truth.txt";
  return std::make_unique<NativeFlight>(std::move(flight), settings->depth_units_per_m);
}

}  // namespace nadir
