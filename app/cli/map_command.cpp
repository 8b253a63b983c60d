// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "app/cli/console.h"
#include "app/cli/map_report.h"
#include "core/map/map_import.h"

namespace nadir::cli {
namespace {

int misused(std::ostream& err, const Error& error) {
  report_error(err, error);
  return error.code == ErrorCode::kInvalidOptions ? kMisused : kFailed;
}

struct InfoArguments {
  std::string map;
  std::string at, at_enu;
  bool is_json = false;
  bool is_quiet = false;
};

struct ImportArguments {
  std::string source, out;
  MapProvenance provenance;
  std::string anchor, anchor_at = "top-left", crs, remap, image;
  std::optional<double> metres_per_pixel, resolution, building_contours_m;
  std::optional<int> inside;
  bool is_flipped = false;
  bool is_quiet = false;
};

/// The place that --at or --at-enu names, if one does. @errors kInvalidOptions.
Result<std::optional<MapPlace>> asked_place(const OverheadMap& map, const InfoArguments& given) {
  if (!given.at.empty()) {
    const auto numbers = parse_list("--at", given.at, 2);
    if (!numbers) return forward_error(numbers);
    // The plane checks latitude and longitude as it would check an origin.
    const Geodetic geodetic{(*numbers)[0], (*numbers)[1]};
    if (const auto checked = ProjectPlane::create(geodetic); !checked) {
      return fail(ErrorCode::kInvalidOptions, "--at: {}", checked.error().message);
    }
    return describe_place(map, map.plane.enu_from_geodetic(geodetic));
  }
  if (!given.at_enu.empty()) {
    const auto numbers = parse_list("--at-enu", given.at_enu, 2);
    if (!numbers) return forward_error(numbers);
    return describe_place(map, {(*numbers)[0], (*numbers)[1]});
  }
  return std::nullopt;
}

int run_info(const InfoArguments& given, std::ostream& out, std::ostream& err) {
  const std::filesystem::path path = find_bundled(given.map);
  const auto map = read_overhead_map(path);
  if (!map) return report_error(err, map.error());
  const auto provenance = read_map_provenance(path);
  if (!provenance) return report_error(err, provenance.error());
  const auto asked = asked_place(*map, given);
  if (!asked) return misused(err, asked.error());
  const MapSummary summary = summarise_map(*map, *provenance);
  if (given.is_json) {
    out << map_json(path.string(), summary, *asked);
  } else if (given.is_quiet && *asked) {
    out << place_text(**asked);
  } else {
    out << map_text(summary, *asked);
  }
  return kDone;
}

Result<ImportOptions> import_options(const ImportArguments& given) {
  ImportOptions options;
  options.name = given.provenance.name;
  options.metres_per_pixel = given.metres_per_pixel;
  options.metres_per_cell = given.resolution;
  options.building_contours_m = given.building_contours_m;
  options.anchor_point =
      given.anchor_at == "centre" ? AnchorPoint::kCentre : AnchorPoint::kTopLeftCorner;
  options.flip_vertically = given.is_flipped;
  options.inside_value = given.inside;
  options.crs = given.crs;
  options.image = given.image;
  if (!given.anchor.empty()) {
    const auto numbers = parse_list("--anchor", given.anchor, 2);
    if (!numbers) return forward_error(numbers);
    options.anchor = Geodetic{(*numbers)[0], (*numbers)[1]};
  }
  if (!given.remap.empty()) {
    auto remap = ClassRemap::read(find_bundled(given.remap));
    if (!remap) return forward_error(remap);
    options.remap = std::move(*remap);
  }
  return options;
}

int run_import(const ImportArguments& given, std::ostream& out, std::ostream& err) {
  const auto options = import_options(given);
  if (!options) return misused(err, options.error());
  const Interrupt interrupt;
  ProgressBar bar(err, given.is_quiet);
  WorkContext context;
  context.stop = interrupt.token();
  context.progress = [&](double fraction, const std::string& activity) {
    bar.show(fraction, activity);
  };
  const auto imported = import_map(given.source, *options, context);
  if (!imported) return misused(err, imported.error());
  MapProvenance provenance = given.provenance;
  provenance.name = imported->map.name;
  const auto written = write_overhead_map(imported->map, provenance, imported->image, given.out);
  if (!written) return report_error(err, written.error());
  if (!given.is_quiet) {
    for (const std::string& notice : imported->notices) err << "notice: " << notice << '\n';
    const auto usable = check_usable_for_localising(imported->map);
    if (!usable) err << "notice: " << usable.error().message << '\n';
  }
  const OverheadMap& map = imported->map;
  out << fmt::format("{}: {} x {} cells of {:.6g} m, centre {}\n", given.out, map.labels.width(),
                     map.labels.height(), map.metres_per_cell,
                     geodetic_text(map.plane.geodetic_from_enu(map.enu_from_overhead(
                         {0.5 * map.labels.width(), 0.5 * map.labels.height()}))));
  return kDone;
}

CLI::App& add_info(CLI::App& app, InfoArguments& given) {
  CLI::App& info = *app.add_subcommand("info", "What a map package holds and where it lies");
  info.add_option("MAP", given.map, "A map package, a folder with map.toml")->required();
  CLI::Option* at = info.add_option("--at", given.at, "Also tell about this place: LAT,LON");
  info.add_option("--at-enu", given.at_enu, "Also tell about this place: EAST,NORTH in metres")
      ->excludes(at);
  info.add_flag("--json", given.is_json, "One JSON object with SI units in its key names");
  info.add_flag("--quiet", given.is_quiet, "With --at or --at-enu: that place alone");
  return info;
}

CLI::App& add_import(CLI::App& app, ImportArguments& given) {
  CLI::App& import =
      *app.add_subcommand("import", "Make a map package from labels that are there already");
  import
      .add_option("SOURCE", given.source,
                  "A label raster (GeoTIFF, PNG with world file, ...) or a folder of class images "
                  "(class<N>.png or <class name>.png)")
      ->required();
  import.add_option("--out", given.out, "Folder of the map package to write")->required();
  import.add_option("--name", given.provenance.name, "Name of the map (else the source's)");
  import.add_option("--source", given.provenance.source, "Who made it from what, in a sentence");
  import.add_option("--licence", given.provenance.licence, "SPDX identifier or a sentence");
  import.add_option("--date", given.provenance.date, "Date of the imagery, YYYY-MM-DD");
  import.add_option("--remap", given.remap, "TOML file that turns the source's classes into ours");
  import.add_option("--crs", given.crs,
                    "Coordinate reference system of a source without one: EPSG:25832 or WKT");
  import.add_option("--anchor", given.anchor,
                    "LAT,LON of a source without georeference (after --flip)");
  import.add_option("--anchor-at", given.anchor_at, "What the anchor names: top-left or centre")
      ->check(CLI::IsMember({"top-left", "centre"}))
      ->capture_default_str();
  import.add_option("--metres-per-pixel", given.metres_per_pixel,
                    "Of a source without georeference");
  import.add_flag("--flip", given.is_flipped, "The source's first row is its southernmost");
  import.add_option(
      "--inside", given.inside,
      "Value of class images that means \"belongs to the class\": 0 or 255 (else 255)");
  import.add_option("--resolution", given.resolution,
                    "Metres per cell of the map (else the source's on the ground)");
  import.add_option("--building-contours", given.building_contours_m,
                    "Leave walls of this thickness of filled buildings, in metres");
  import.add_option("--image", given.image, "Picture of the same place, to go into the package");
  import.add_flag("--quiet", given.is_quiet, "No progress and no notices");
  return import;
}

}  // namespace

int run_map(std::span<const std::string> arguments, std::ostream& out, std::ostream& err) {
  CLI::App app("Tells about labelled overheads and makes them", "nadir map");
  app.require_subcommand(1);
  InfoArguments info;
  ImportArguments import;
  const CLI::App& info_command = add_info(app, info);
  add_import(app, import);
  if (const auto status = parse_arguments(app, arguments, out, err)) return *status;
  return info_command.parsed() ? run_info(info, out, err) : run_import(import, out, err);
}

}  // namespace nadir::cli
