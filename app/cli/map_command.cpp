// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <tuple>
#include <variant>

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "app/cli/console.h"
#include "app/cli/map_report.h"
#include "core/map/map_import.h"

namespace nadir::cli {
namespace {

constexpr const char* kInfoName = "nadir map info";
constexpr const char* kImportName = "nadir map import";

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

/// The place that --at or --at-enu names, if one does.
using AskedPlace = std::variant<std::monostate, Geodetic, Eigen::Vector2d>;

/// @errors kInvalidOptions.
Result<AskedPlace> asked_place(const InfoArguments& given) {
  if (!given.at.empty()) {
    const auto place = parse_place("--at", given.at);
    if (!place) return forward_error(place);
    return *place;
  }
  if (given.at_enu.empty()) return AskedPlace();
  const auto numbers = parse_list("--at-enu", given.at_enu, 2);
  if (!numbers) return forward_error(numbers);
  return Eigen::Vector2d((*numbers)[0], (*numbers)[1]);
}

std::optional<MapPlace> place_on(const OverheadMap& map, const AskedPlace& asked) {
  if (const auto* geodetic = std::get_if<Geodetic>(&asked)) {
    return describe_place(map, map.plane.enu_from_geodetic(*geodetic));
  }
  if (const auto* point = std::get_if<Eigen::Vector2d>(&asked)) return describe_place(map, *point);
  return std::nullopt;
}

int run_info(const InfoArguments& given, std::ostream& out, std::ostream& err) {
  const auto asked = asked_place(given);
  if (!asked) return report_flags_error(err, kInfoName, asked.error());
  const std::filesystem::path path = find_bundled(given.map);
  const auto map = read_overhead_map(path);
  if (!map) return report_error(err, map.error());
  const auto provenance = read_map_provenance(path);
  if (!provenance) return report_error(err, provenance.error());
  const std::optional<MapPlace> place = place_on(*map, *asked);
  const MapSummary summary = summarise_map(*map, *provenance);
  if (given.is_json) {
    out << map_json(path.string(), summary, place);
  } else if (given.is_quiet && place) {
    out << place_text(*place);
  } else {
    out << map_text(summary, place);
  }
  return kDone;
}

/// @errors kInvalidOptions where the command line is at fault, other codes where a file is.
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
    const auto place = parse_place("--anchor", given.anchor);
    if (!place) return forward_error(place);
    options.anchor = *place;
  }
  if (!given.remap.empty()) {
    auto remap = ClassRemap::read(find_bundled(given.remap));
    if (!remap) return tl::unexpected(blame_file(remap.error()));
    options.remap = std::move(*remap);
  }
  return options;
}

int run_import(const ImportArguments& given, std::ostream& out, std::ostream& err) {
  const auto options = import_options(given);
  if (!options) return report_flags_error(err, kImportName, options.error());
  const Interrupt interrupt;
  ProgressBar bar(err, given.is_quiet);
  WorkContext context;
  context.stop = interrupt.token();
  context.progress = [&](double fraction, const std::string& activity) {
    bar.show(fraction, activity);
  };
  const auto imported = import_map(given.source, *options, context);
  if (!imported) return report_flags_error(err, kImportName, imported.error());
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
  info.add_option("MAP", given.map,
                  "A map package (a folder with map.toml), or a bundled one by its name")
      ->required();
  CLI::Option* at =
      info.add_option("--at", given.at, "Also tell about this place [deg], north and east positive")
          ->type_name("LAT,LON");
  info.add_option("--at-enu", given.at_enu, "Also tell about this place on the map's plane [m]")
      ->type_name("EAST,NORTH")
      ->excludes(at);
  info.add_flag("--json", given.is_json, "One JSON object with SI units in its key names");
  info.add_flag("--quiet", given.is_quiet, "With --at or --at-enu: that place alone");
  info.footer("Example: nadir map info maps/proving-ground --at-enu 10,-20");
  return info;
}

void add_placement_flags(CLI::App& import, ImportArguments& given) {
  import
      .add_option("--crs", given.crs,
                  "Coordinate reference system of a source that is placed but names none, such as "
                  "EPSG:25832")
      ->type_name("EPSG|WKT");
  import
      .add_option("--anchor", given.anchor,
                  "Where a source without georeference lies [deg], north and east positive (after "
                  "--flip); its first row is taken to be its northernmost")
      ->type_name("LAT,LON");
  const std::vector<std::string> points = {"top-left", "centre"};
  import
      .add_option("--anchor-at", given.anchor_at,
                  "Point of the source that --anchor names: outer corner of its first pixel, or "
                  "centre of the image; default top-left")
      ->type_name(choices_text(points))
      ->check(is_one_of(points));
  import
      .add_option("--metres-per-pixel", given.metres_per_pixel,
                  "Size of a pixel of a source without georeference [m], 0.001 to 100000; goes "
                  "with --anchor")
      ->type_name("NUMBER")
      ->check(is_number());
  import.add_flag("--flip", given.is_flipped,
                  "The first row of a source without georeference is its southernmost");
}

CLI::App& add_import(CLI::App& app, ImportArguments& given) {
  CLI::App& import =
      *app.add_subcommand("import", "Make a map package from labels that are there already");
  import
      .add_option("SOURCE", given.source,
                  "A label raster (GeoTIFF, PNG with world file, ...) or a folder of class images "
                  "(class<N>.png or <class name>.png)")
      ->required();
  import.add_option("--out", given.out, "Folder of the map package to write")
      ->type_name("FOLDER")
      ->required();
  for (const auto& [flag, value, help] :
       {std::tuple("--name", &given.provenance.name, "Name of the map; default: the source's"),
        std::tuple("--source", &given.provenance.source, "Who made it from what, in a sentence"),
        std::tuple("--licence", &given.provenance.licence, "SPDX identifier or a sentence"),
        std::tuple("--date", &given.provenance.date, "Date of the imagery, YYYY-MM-DD")}) {
    import.add_option(flag, *value, help)->type_name("TEXT");
  }
  import
      .add_option("--remap", given.remap,
                  "TOML file that turns the source's classes into those of Nadir")
      ->type_name("FILE");
  add_placement_flags(import, given);
  import
      .add_option("--inside", given.inside,
                  "Value in class images that means \"belongs to the class\", default 255")
      ->type_name("{0|255}")
      ->check(is_one_of({"0", "255"}));
  import
      .add_option("--resolution", given.resolution,
                  "Size of a cell of the map [m], 0.001 to 100000; default: the source's on the "
                  "ground")
      ->type_name("NUMBER")
      ->check(is_number());
  import
      .add_option("--building-contours", given.building_contours_m,
                  "Turn filled buildings into walls of this thickness [m], 0.001 to 100000; what "
                  "is inside becomes unclassified. Default: left as they are")
      ->type_name("NUMBER")
      ->check(is_number());
  import.add_option("--image", given.image, "Picture of the same place, to go into the package")
      ->type_name("FILE");
  import.add_flag("--quiet", given.is_quiet, "No progress and no notices");
  import.footer(
      "Examples: nadir map import labels.tif --out town\n"
      "          nadir map import labels.png --anchor 33.45,-83.9\n"
      "            --metres-per-pixel 0.1 --out town");
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
