// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "core/flight/flight_recording.h"
#include "core/flight/flight_summary.h"

namespace nadir::cli {
namespace {

using Json = nlohmann::ordered_json;

double horizontal_view_deg(const CameraModel& camera) {
  const double left_rad = std::atan(camera.centre_x_px / camera.focal_x_px);
  const double right_rad = std::atan((camera.width - camera.centre_x_px) / camera.focal_x_px);
  return (left_rad + right_rad) * 180.0 / std::numbers::pi;
}

template <typename T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json json_of(const TimeSpan& span) {
  return {{"start_s", span.start_s}, {"end_s", span.end_s}, {"length_s", span.length_s()}};
}

Json json_of(const StreamSummary& stream) {
  Json gaps = Json::array();
  for (const TimeSpan& gap : stream.gaps) gaps.push_back(json_of(gap));
  return {{"name", stream.name},
          {"count", stream.count},
          {"start_s", stream.span.start_s},
          {"end_s", stream.span.end_s},
          {"rate_hz", or_null(stream.rate_hz)},
          {"jitter_s", or_null(stream.jitter_s)},
          {"duplicates", stream.duplicates},
          {"source", stream.source.empty() ? Json(nullptr) : Json(stream.source)},
          {"gaps", gaps}};
}

Json json_of(const CameraModel& camera, const Rigid3& body_from_camera) {
  const Eigen::Vector3d& t = body_from_camera.translation_m;
  const Eigen::Quaterniond& q = body_from_camera.rotation;
  return {{"width_px", camera.width},
          {"height_px", camera.height},
          {"focal_x_px", camera.focal_x_px},
          {"focal_y_px", camera.focal_y_px},
          {"centre_x_px", camera.centre_x_px},
          {"centre_y_px", camera.centre_y_px},
          {"pixel_centre_offset_px", 0.5},
          {"horizontal_view_deg", horizontal_view_deg(camera)},
          {"body_from_camera_translation_m", {t.x(), t.y(), t.z()}},
          {"body_from_camera_quaternion_xyzw", {q.x(), q.y(), q.z(), q.w()}}};
}

Json json_of(const FlightDescription& flight, const FlightSummary& summary) {
  Json streams = Json::array();
  for (const StreamSummary& stream : summary.streams) streams.push_back(json_of(stream));
  Json json{
      {"flight", flight.path.string()},
      {"name", flight.name},
      {"format", flight.format},
      {"frames", flight.frames.size()},
      {"streams", streams},
      {"overlap", summary.overlap ? json_of(*summary.overlap) : Json(nullptr)},
      {"camera", flight.camera ? json_of(*flight.camera, flight.body_from_camera) : Json(nullptr)},
      {"altitude_m", flight.altitude_m},
      {"odometry_length_m", or_null(summary.odometry_length_m)},
      {"odometry_summed_m", or_null(summary.odometry_summed_m)},
      {"truth_length_m", or_null(summary.truth_length_m)},
      {"truth_origin", nullptr},
      {"are_times_sane", summary.are_times_sane},
      {"notices", summary.notices}};
  if (flight.truth_origin) {
    json["truth_origin"] = {{"latitude_deg", flight.truth_origin->latitude_deg},
                            {"longitude_deg", flight.truth_origin->longitude_deg}};
  }
  return json;
}

void print_streams(const FlightSummary& summary, std::ostream& out) {
  out << fmt::format("\n{:<10}{:>8}{:>16}{:>16}{:>10}{:>11}{:>7}\n", "stream", "samples", "start s",
                     "end s", "rate Hz", "jitter ms", "gaps");
  for (const StreamSummary& stream : summary.streams) {
    const auto number = [](const std::optional<double>& value, double scale) {
      return value ? fmt::format("{:.2f}", *value * scale) : std::string("-");
    };
    out << fmt::format("{:<10}{:>8}{:>16.3f}{:>16.3f}{:>10}{:>11}{:>7}\n", stream.name,
                       stream.count, stream.span.start_s, stream.span.end_s,
                       number(stream.rate_hz, 1.0), number(stream.jitter_s, 1e3),
                       stream.gaps.size());
  }
}

void print_camera(const FlightDescription& flight, std::ostream& out) {
  if (!flight.camera) {
    out << "camera    not known\n";
    return;
  }
  const CameraModel& camera = *flight.camera;
  const Eigen::Vector3d& mount_m = flight.body_from_camera.translation_m;
  out << fmt::format(
      "camera    {} x {} px, {:.2f} deg wide, focal length {:.2f} x {:.2f} px\n"
      "          centre {}\n          at ({:.3f}, {:.3f}, {:.3f}) m in body (forward, left, up)\n",
      camera.width, camera.height, horizontal_view_deg(camera), camera.focal_x_px,
      camera.focal_y_px, centre_text(camera), mount_m.x(), mount_m.y(), mount_m.z());
}

void print_text(const FlightDescription& flight,
                const FlightSummary& summary,
                bool is_quiet,
                std::ostream& out) {
  out << fmt::format("{} ({})\n{}\n", flight.name, flight.format, flight.path.string());
  print_streams(summary, out);
  out << '\n';
  for (const StreamSummary& stream : summary.streams) {
    if (!stream.source.empty())
      out << fmt::format("source    {} from {}\n", stream.name, stream.source);
  }
  if (summary.overlap) {
    out << fmt::format("overlap   {:.3f} s, from {:.3f} s to {:.3f} s\n",
                       summary.overlap->length_s(), summary.overlap->start_s,
                       summary.overlap->end_s);
  } else {
    out << "overlap   none\n";
  }
  out << fmt::format("times     {}\n", summary.are_times_sane ? "sane" : "not sane");
  if (summary.truth_length_m) {
    out << fmt::format("truth     {:.1f} m, all steps summed\n", *summary.truth_length_m);
  }
  if (summary.odometry_length_m) {
    out << fmt::format(
        "odometry  {:.1f} m between places {:g} m apart; its steps sum to {:.1f} m, noise "
        "included\n",
        *summary.odometry_length_m, kWayPieceM, *summary.odometry_summed_m);
  }
  if (flight.truth_origin) out << "origin    " << geodetic_text(*flight.truth_origin) << '\n';
  if (flight.altitude_m > 0.0) out << fmt::format("altitude  {:.2f} m\n", flight.altitude_m);
  print_camera(flight, out);
  for (const StreamSummary& stream : summary.streams) {
    for (const TimeSpan& gap : stream.gaps) {
      out << fmt::format("gap       {:.3f} s of {} at {:.3f} s\n", gap.length_s(), stream.name,
                         gap.start_s);
    }
  }
  if (is_quiet) return;
  for (const std::string& notice : summary.notices) out << "notice    " << notice << '\n';
}

}  // namespace

int run_flight(std::span<const std::string> arguments, std::ostream& out, std::ostream& err) {
  CLI::App app("Tells what is in a recorded flight", "nadir flight");
  app.require_subcommand(1);
  CLI::App& info =
      *app.add_subcommand("info", "Streams, rates, gaps, camera and whether time stamps are sane");
  std::string path;
  bool is_json = false;
  bool is_quiet = false;
  info.add_option("FLIGHT", path,
                  "A folder with flight.toml, a KITTI raw drive, a KITTI odometry folder or a "
                  "trajectory file (TUM)")
      ->required();
  info.add_flag("--json", is_json, "One JSON object with SI units in its key names");
  info.add_flag("--quiet", is_quiet, "No notices, only facts");
  if (const auto status = parse_arguments(app, arguments, out, err)) return *status;

  const auto flight = open_flight(path);
  if (!flight) return report_error(err, flight.error());
  const FlightDescription& description = (*flight)->description();
  const FlightSummary summary = summarise_flight(description);
  if (is_json) {
    // Names of files are bytes; what is no UTF-8 is replaced and not a reason to fail.
    out << json_of(description, summary).dump(2, ' ', false, Json::error_handler_t::replace)
        << '\n';
  } else {
    print_text(description, summary, is_quiet, out);
  }
  return kDone;
}

}  // namespace nadir::cli
