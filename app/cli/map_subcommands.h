// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <ostream>
#include <string>

#include "core/map/map_import.h"

namespace CLI {
class App;
}

namespace nadir::cli {

/// What `nadir map import` was asked for.
struct MapImportArguments {
  std::string source, out, into;
  MapProvenance provenance;
  std::string anchor, anchor_at = "top-left", crs, remap, image, rules, as;
  std::optional<double> metres_per_pixel, resolution, building_contours_m;
  std::optional<int> inside;
  bool is_flipped = false;
  bool is_quiet = false;
};
CLI::App& add_map_import(CLI::App& map, MapImportArguments& given);
/// For a source that is a label raster. @errors kInvalidOptions where the command line is at fault, other codes where a file
/// is.
[[nodiscard]] Result<ImportOptions> raster_options(const MapImportArguments& given);
int run_map_import(const MapImportArguments& given, std::ostream& out, std::ostream& err);

/// What `nadir map export` was asked for.
struct MapExportArguments {
  std::string labels, out, format;
  MapProvenance provenance;
  std::optional<double> resolution;
  bool is_quiet = false;
};
CLI::App& add_map_export(CLI::App& map, MapExportArguments& given);
int run_map_export(const MapExportArguments& given, std::ostream& out, std::ostream& err);

/// What `nadir map check` was asked for.
struct MapCheckArguments {
  std::string package, labels;
  bool is_json = false;
  bool is_quiet = false;
};
CLI::App& add_map_check(CLI::App& map, MapCheckArguments& given);
int run_map_check(const MapCheckArguments& given, std::ostream& out, std::ostream& err);

/// --name, --source, --licence and --date of what is written.
void add_provenance_flags(CLI::App& app, MapProvenance& provenance);
/// --resolution: size of a cell [m]. @param otherwise  What it is where nobody says: "default: ...".
void add_resolution_flag(CLI::App& app,
                         std::optional<double>& metres_per_cell,
                         const std::string& otherwise);
/// @errors kInvalidOptions: not from 0.001 to 100000.
[[nodiscard]] Result<void> check_resolution(const std::optional<double>& metres_per_cell);

/// Who works, for the history of a labelling document.
[[nodiscard]] std::string author_name();

}  // namespace nadir::cli
