// SPDX-License-Identifier: Apache-2.0
#include "core/flight/flight_settings.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/base/settings.h"

namespace nadir {
namespace {

constexpr double kHalfPixel = 0.5;  // From pixel centres at whole numbers to centres at +0.5.

using Keys = std::vector<std::string>;
const Keys& known_keys(std::string_view table) {
  static const Keys top{"flight", "camera", "truth"};
  static const Keys flight{"format_version", "name", "provenance", "generator", "altitude_m"};
  static const Keys camera{"width",       "height",      "focal_x_px",        "focal_y_px",
                           "centre_x_px", "centre_y_px", "depth_units_per_m", "body_from_camera"};
  static const Keys body_from_camera{"translation_m", "quaternion_xyzw"};
  static const Keys truth{"origin_latitude_deg", "origin_longitude_deg"};
  if (table == "flight") return flight;
  if (table == "camera") return camera;
  if (table == "camera.body_from_camera") return body_from_camera;
  return table == "truth" ? truth : top;
}

Result<void> check_keys(const Settings& settings, const std::string& table) {
  if (table.empty()) return settings.refuse_unknown(known_keys(table));
  const auto part = settings.table(table);
  return part ? part->refuse_unknown(known_keys(table)) : forward_error(part);
}

Result<void> read_number(const Settings& settings, std::string_view key, double& value) {
  const auto number = settings.number(key);
  if (!number) return forward_error(number);
  value = *number;
  return {};
}

Result<void> read_size(const Settings& settings, std::string_view key, int& value) {
  const auto number = settings.integer(key);
  if (!number) return forward_error(number);
  if (*number < 1 || *number > std::numeric_limits<int>::max()) {
    return fail(ErrorCode::kMalformed, "{}: {} is {}, not a number of pixels", settings.name(), key,
                *number);
  }
  value = static_cast<int>(*number);
  return {};
}

Result<Rigid3> read_body_from_camera(const Settings& settings) {
  const auto translation = settings.numbers("camera.body_from_camera.translation_m");
  if (!translation) return forward_error(translation);
  const auto quaternion = settings.numbers("camera.body_from_camera.quaternion_xyzw");
  if (!quaternion) return forward_error(quaternion);
  if (translation->size() != 3 || quaternion->size() != 4) {
    return fail(ErrorCode::kMalformed,
                "{}: camera.body_from_camera needs three numbers of translation_m and four of "
                "quaternion_xyzw",
                settings.name());
  }
  const std::vector<double>& q = *quaternion;
  const Eigen::Quaterniond rotation(q[3], q[0], q[1], q[2]);
  if (!(std::abs(rotation.norm() - 1.0) < 1e-3)) {
    return fail(ErrorCode::kMalformed,
                "{}: camera.body_from_camera.quaternion_xyzw has length {:.6g}, not 1",
                settings.name(), rotation.norm());
  }
  const std::vector<double>& t = *translation;
  return Rigid3{rotation.normalized(), {t[0], t[1], t[2]}};
}

Result<void> read_camera(const Settings& settings, FlightSettings& flight) {
  CameraModel camera;
  Result<void> done = read_size(settings, "camera.width", camera.width);
  if (done) done = read_size(settings, "camera.height", camera.height);
  if (done) done = read_number(settings, "camera.focal_x_px", camera.focal_x_px);
  if (done) done = read_number(settings, "camera.focal_y_px", camera.focal_y_px);
  if (done) done = read_number(settings, "camera.centre_x_px", camera.centre_x_px);
  if (done) done = read_number(settings, "camera.centre_y_px", camera.centre_y_px);
  if (!done) return forward_error(done);
  camera.centre_x_px += kHalfPixel;
  camera.centre_y_px += kHalfPixel;
  if (const auto valid = validate(camera); !valid) return forward_error(valid, settings.name());
  flight.camera = camera;

  const auto units = settings.number_or("camera.depth_units_per_m", flight.depth_units_per_m);
  if (!units) return forward_error(units);
  if (!(*units > 0.0)) {
    return fail(ErrorCode::kMalformed, "{}: camera.depth_units_per_m is {}, not positive",
                settings.name(), *units);
  }
  flight.depth_units_per_m = *units;
  if (!settings.has("camera.body_from_camera")) return {};
  if (const auto keys = check_keys(settings, "camera.body_from_camera"); !keys)
    return forward_error(keys);
  const auto body_from_camera = read_body_from_camera(settings);
  if (!body_from_camera) return forward_error(body_from_camera);
  flight.body_from_camera = *body_from_camera;
  return {};
}

Result<void> read_truth(const Settings& settings, FlightSettings& flight) {
  Geodetic origin;
  auto done = read_number(settings, "truth.origin_latitude_deg", origin.latitude_deg);
  if (done) done = read_number(settings, "truth.origin_longitude_deg", origin.longitude_deg);
  if (!done) return forward_error(done);
  const auto plane = ProjectPlane::create(origin);
  if (!plane) return forward_error(plane, settings.name() + ": truth");
  flight.truth_origin = origin;
  return {};
}

Result<void> check_version(const Settings& settings) {
  const auto version = settings.integer("flight.format_version");
  if (!version) return forward_error(version);
  if (*version > kFlightFormatVersion) {
    return fail(ErrorCode::kUnsupported,
                "{}: has format_version {}, but this program reads up to {}", settings.name(),
                *version, kFlightFormatVersion);
  }
  if (*version < 1) {
    return fail(ErrorCode::kMalformed, "{}: format_version {} has never existed", settings.name(),
                *version);
  }
  return {};
}

}  // namespace

Result<FlightSettings> parse_flight_settings(std::string_view text, const std::string& name) {
  const auto settings = Settings::parse(text, name);
  if (!settings) return forward_error(settings);
  if (const auto version = check_version(*settings); !version) return forward_error(version);
  for (const std::string table : {"", "flight", "camera", "truth"}) {
    if (!table.empty() && !settings->has(table)) continue;
    if (const auto keys = check_keys(*settings, table); !keys) return forward_error(keys);
  }

  FlightSettings flight;
  auto word = settings->text_or("flight.name", "");
  if (!word) return forward_error(word);
  flight.name = *std::move(word);
  word = settings->text_or("flight.provenance", "");
  if (!word) return forward_error(word);
  flight.provenance = *std::move(word);
  word = settings->text_or("flight.generator", "");
  if (!word) return forward_error(word);
  flight.generator = *std::move(word);
  const auto altitude_m = settings->number_or("flight.altitude_m", 0.0);
  if (!altitude_m) return forward_error(altitude_m);
  flight.altitude_m = *altitude_m;
  if (settings->has("camera")) {
    if (const auto read = read_camera(*settings, flight); !read) return forward_error(read);
  }
  if (settings->has("truth")) {
    if (const auto read = read_truth(*settings, flight); !read) return forward_error(read);
  }
  return flight;
}

std::string flight_settings_text(const FlightSettings& flight) {
  std::string text = fmt::format(
      "# A flight in Nadir's own format; core/flight/README.md describes it.\n\n"
      "[flight]\nformat_version = {}\nname = {}\nprovenance = {}\n",
      kFlightFormatVersion, toml_quoted(flight.name), toml_quoted(flight.provenance));
  if (!flight.generator.empty()) {
    text += fmt::format("generator = {}\n", toml_quoted(flight.generator));
  }
  text += fmt::format("altitude_m = {}\n", flight.altitude_m);
  if (flight.camera) {
    const Eigen::Vector3d& t = flight.body_from_camera.translation_m;
    const Eigen::Quaterniond& q = flight.body_from_camera.rotation;
    text += fmt::format(
        "\n[camera]  # Pixel centres at whole numbers, as in OpenCV and ROS.\n"
        "width = {}\nheight = {}\nfocal_x_px = {}\nfocal_y_px = {}\n"
        "centre_x_px = {}\ncentre_y_px = {}\ndepth_units_per_m = {}\n",
        flight.camera->width, flight.camera->height, flight.camera->focal_x_px,
        flight.camera->focal_y_px, flight.camera->centre_x_px - kHalfPixel,
        flight.camera->centre_y_px - kHalfPixel, flight.depth_units_per_m);
    text += fmt::format(
        "\n[camera.body_from_camera]\ntranslation_m = [{}, {}, {}]\n"
        "quaternion_xyzw = [{}, {}, {}, {}]\n",
        t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w());
  }
  if (flight.truth_origin) {
    text += fmt::format("\n[truth]\norigin_latitude_deg = {}\norigin_longitude_deg = {}\n",
                        flight.truth_origin->latitude_deg, flight.truth_origin->longitude_deg);
  }
  return text;
}

}  // namespace nadir
