// SPDX-License-Identifier: Apache-2.0
#include "core/flight/flight_writer.h"

#include <array>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <string_view>
#include <system_error>

#include "core/base/settings.h"
#include "core/base/staged_output.h"
#include "core/flight/colour_image.h"
#include "core/flight/flight_settings.h"
#include "core/flight/frame_image.h"
#include "core/flight/grey_image.h"
#include "core/geo/trajectory_file.h"

namespace nadir {
namespace fs = std::filesystem;
namespace {

/// The folder is staged as a whole, so that its files need no staging of their own. A full disk
/// shows at the latest when the file is closed. `shown` is the name that the file will have.
Result<void> write_file(const fs::path& path, const fs::path& shown, std::string_view bytes) {
  errno = 0;
  std::ofstream stream(path, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (stream) return {};
  return fail(ErrorCode::kIo, "{}: cannot be written: {}", shown.string(),
              errno != 0 ? std::generic_category().message(errno) : "the disk may be full");
}

std::string_view as_text(const std::vector<std::uint8_t>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Whether a flight may give way to one of this generator; `shown` is what its folder is called in
/// messages.
Result<void> check_generator(const fs::path& folder,
                             const std::string& shown,
                             const std::string& generator) {
  constexpr std::uintmax_t kLargestText = 1U << 20U;
  const auto text = read_text_file(folder / "flight.toml", kLargestText);
  if (!text) return forward_error(text);
  const auto settings = parse_flight_settings(*text, (folder / "flight.toml").string());
  if (!settings) {
    return fail(ErrorCode::kIo, "{}: is left alone; name a new folder ({})", shown,
                settings.error().message);
  }
  if (!generator.empty() && settings->generator == generator) return {};
  return fail(
      ErrorCode::kIo, "{}: holds a flight that {}, so it is left alone; name a new folder", shown,
      settings->generator.empty() ? "may be a recording" : "was made by " + settings->generator);
}

}  // namespace

Result<EncodedFrame> encode_frame(const SemanticFrame& frame,
                                  const std::optional<ColourRaster>& image) {
  const auto wrong = [&](std::string_view fault) {
    return fail(ErrorCode::kMalformed, "frame at {} s: {}", frame.time_s, fault);
  };
  const Raster<ClassId>& labels = frame.labels;
  const Raster<float>& depth_m = frame.depth_m;
  if (!std::isfinite(frame.time_s)) return wrong("its time is not finite");
  if (labels.empty()) return wrong("it has no labels");
  if (labels.width() != depth_m.width() || labels.height() != depth_m.height()) {
    return wrong(fmt::format("its labels are {} x {} pixels and its depth {} x {}", labels.width(),
                             labels.height(), depth_m.width(), depth_m.height()));
  }
  for (const ClassId id : labels.values()) {
    if (id < kClassCount || id == kUnclassified) continue;
    return wrong(fmt::format("its labels have id {}, which is no class", static_cast<int>(id)));
  }
  auto labels_png = encode_label_png(labels);
  if (!labels_png) return forward_error(labels_png);
  auto depth_png = encode_depth_png(depth_m);
  if (!depth_png) return forward_error(depth_png);
  EncodedFrame encoded{frame.time_s, *std::move(labels_png), *std::move(depth_png)};
  if (!image) return encoded;
  if (image->empty()) return wrong("its image has no pixels");
  auto image_jpeg = encode_colour_jpeg(*image);
  if (!image_jpeg) return forward_error(image_jpeg);
  encoded.image_jpeg = *std::move(image_jpeg);
  return encoded;
}

struct FlightWriter::Implementation {
  StagedOutput output;
  fs::path folder;  ///< The name that the flight will have.
  FlightSettings settings;
  std::string label_list = "# time_s file: class ids, 8 bit, 255 = unclassified\n";
  std::string depth_list = "# time_s file: along the optical axis, 16 bit, 0 = none\n";
  std::string image_list = {};  ///< Empty until a frame has an image.
  std::size_t frame_count = 0;
  double last_time_s = 0.0;

  [[nodiscard]] Result<void> write_text(const char* name, std::string_view text) const {
    return write_file(output.path() / name, folder / name, text);
  }
  [[nodiscard]] Result<void> make_folder(const char* name) const {
    std::error_code error;
    fs::create_directory(output.path() / name, error);
    if (!error) return {};
    return fail(ErrorCode::kIo, "{}: {}", (folder / name).string(), error.message());
  }
  [[nodiscard]] Result<void> write_image(const std::string& name,
                                         const std::vector<std::uint8_t>& png) const;
  [[nodiscard]] Result<void> write_colours(const EncodedFrame& frame);
};

Result<void> FlightWriter::Implementation::write_image(const std::string& name,
                                                       const std::vector<std::uint8_t>& png) const {
  const fs::path shown = folder / name;
  const auto header = check_png(png, shown.string());
  if (!header) return forward_error(header);
  if (settings.camera &&
      (header->width != settings.camera->width || header->height != settings.camera->height)) {
    return fail(ErrorCode::kMalformed, "{}: is {} x {} pixels, but the camera has {} x {}",
                shown.string(), header->width, header->height, settings.camera->width,
                settings.camera->height);
  }
  return write_file(output.path() / name, shown, as_text(png));
}

Result<void> FlightWriter::Implementation::write_colours(const EncodedFrame& frame) {
  if (frame.image_jpeg.empty()) return {};
  const std::string name = fmt::format("rgb/{:06}.jpg", frame_count);
  if (!is_jpeg(frame.image_jpeg)) {
    return fail(ErrorCode::kMalformed, "{}: is no JPEG", (folder / name).string());
  }
  if (image_list.empty()) {
    if (const auto made = make_folder("rgb"); !made) return forward_error(made);
    image_list = "# time_s file: what the camera saw\n";
  }
  auto done = write_file(output.path() / name, folder / name, as_text(frame.image_jpeg));
  if (done) image_list += fmt::format("{} {}\n", frame.time_s, name);
  return done;
}

FlightWriter::FlightWriter(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
FlightWriter::FlightWriter(FlightWriter&&) noexcept = default;
FlightWriter::~FlightWriter() = default;

Result<FlightWriter> FlightWriter::create(const fs::path& folder,
                                          const FlightDescription& description,
                                          const std::string& provenance,
                                          const std::string& generator) {
  FlightSettings settings;
  settings.name = description.name;
  settings.provenance = provenance;
  settings.generator = generator;
  settings.altitude_m = description.altitude_m;
  settings.camera = description.camera;
  settings.body_from_camera = description.body_from_camera;
  settings.truth_origin = description.truth_origin;
  // What is written must be readable: a wrong camera is found now and not after an hour of frames.
  const auto readable = parse_flight_settings(flight_settings_text(settings), folder.string());
  if (!readable) return forward_error(readable);

  static constexpr std::array<std::string_view, 9> kEntries = {
      "flight.toml", "labels",  "depth",        "rgb",      "labels.txt",
      "depth.txt",   "rgb.txt", "odometry.txt", "truth.txt"};
  auto output =
      StagedOutput::folder(folder, kEntries.front(), kEntries,
                           [shown = folder.string(), generator](const fs::path& standing) {
                             return check_generator(standing, shown, generator);
                           });
  if (!output) return forward_error(output);
  FlightWriter writer(std::make_unique<Implementation>(
      Implementation{*std::move(output), folder, std::move(settings)}));
  for (const char* name : {"labels", "depth"}) {
    if (const auto made = writer.implementation_->make_folder(name); !made) {
      return forward_error(made);
    }
  }
  return writer;
}

Result<void> FlightWriter::write(const EncodedFrame& frame) {
  Implementation& flight = *implementation_;
  if (!std::isfinite(frame.time_s) ||
      (flight.frame_count > 0 && !(frame.time_s > flight.last_time_s))) {
    return fail(ErrorCode::kMalformed, "{}: frame {} at {} s does not come after {} s",
                flight.folder.string(), flight.frame_count, frame.time_s, flight.last_time_s);
  }
  const std::string labels = fmt::format("labels/{:06}.png", flight.frame_count);
  const std::string depth = fmt::format("depth/{:06}.png", flight.frame_count);
  if (const auto done = flight.write_image(labels, frame.labels_png); !done)
    return forward_error(done);
  if (const auto done = flight.write_image(depth, frame.depth_png); !done)
    return forward_error(done);
  if (const auto done = flight.write_colours(frame); !done) return forward_error(done);
  flight.label_list += fmt::format("{} {}\n", frame.time_s, labels);
  flight.depth_list += fmt::format("{} {}\n", frame.time_s, depth);
  flight.last_time_s = frame.time_s;
  ++flight.frame_count;
  return {};
}

Result<void> FlightWriter::finish(const std::optional<Trajectory>& odometry,
                                  const std::optional<Trajectory>& truth) {
  Implementation& flight = *implementation_;
  Result<void> done = flight.write_text("labels.txt", flight.label_list);
  if (done) done = flight.write_text("depth.txt", flight.depth_list);
  if (done && !flight.image_list.empty()) done = flight.write_text("rgb.txt", flight.image_list);
  if (done && odometry && !odometry->empty()) {
    done = flight.write_text("odometry.txt",
                             tum_text(*odometry, "odom_from_body: time_s x y z qx qy qz qw"));
  }
  if (done && truth && !truth->empty()) {
    done =
        flight.write_text("truth.txt", tum_text(*truth, "enu_from_body: time_s x y z qx qy qz qw"));
  }
  if (done) done = flight.write_text("flight.toml", flight_settings_text(flight.settings));
  return done ? flight.output.commit() : done;
}

}  // namespace nadir
