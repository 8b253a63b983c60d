// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <variant>

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "app/cli/map_report.h"
#include "app/cli/map_subcommands.h"
#include "core/map/overhead_map_file.h"

namespace nadir::cli {
namespace {

constexpr const char* kInfoName = "nadir map info";

struct InfoArguments {
  std::string map;
  std::string at, at_enu;
  bool is_json = false;
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

}  // namespace

int run_map(std::span<const std::string> arguments, std::ostream& out, std::ostream& err) {
  CLI::App app("Tells about labelled overheads and makes them", "nadir map");
  app.require_subcommand(1);
  InfoArguments info;
  MapImportArguments import;
  MapExportArguments exported;
  MapCheckArguments check;
  const CLI::App& info_command = add_info(app, info);
  const CLI::App& import_command = add_map_import(app, import);
  const CLI::App& export_command = add_map_export(app, exported);
  add_map_check(app, check);
  if (const auto status = parse_arguments(app, arguments, out, err)) return *status;
  if (info_command.parsed()) return run_info(info, out, err);
  if (import_command.parsed()) return run_map_import(import, out, err);
  if (export_command.parsed()) return run_map_export(exported, out, err);
  return run_map_check(check, out, err);
}

}  // namespace nadir::cli
