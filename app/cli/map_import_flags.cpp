// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>

#include "app/cli/arguments.h"
#include "app/cli/map_subcommands.h"
#include "core/map/map_import.h"

namespace nadir::cli {
namespace {

void add_placement_flags(CLI::App& import, MapImportArguments& given) {
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

void add_label_flags(CLI::App& import, MapImportArguments& given) {
  import
      .add_option("--rules", given.rules,
                  "TOML file that says what tags become; default: osm.toml, lanelet2.toml or "
                  "classes.toml of the program's own, as the source is")
      ->type_name("FILE");
  import
      .add_option("--into", given.into,
                  "Labelling document that takes what is imported, as one step that can be undone; "
                  "instead of --out")
      ->type_name("LABELS");
  const std::vector<std::string> kinds = {"paint", "areas"};
  import
      .add_option("--as", given.as,
                  "Also make a labelling document of a label raster: its cells as paint, or as "
                  "areas; with --into paint unless said")
      ->type_name(choices_text(kinds))
      ->check(is_one_of(kinds));
}

}  // namespace

CLI::App& add_map_import(CLI::App& map, MapImportArguments& given) {
  CLI::App& import = *map.add_subcommand(
      "import", "Make a map package from labels or maps that are there already");
  import
      .add_option(
          "SOURCE", given.source,
          "A label raster (GeoTIFF, PNG with world file, ...), a folder of class images "
          "(class<N>.png or <class name>.png), or vectors: OpenStreetMap (.osm, .osm.gz, "
          ".osm.pbf), Lanelet2 (.osm), GeoJSON, GeoPackage, Shapefile, FlatGeobuf, KML, GML")
      ->required();
  import
      .add_option(
          "--out", given.out,
          "Folder of the map package to write, with labels.gpkg where vectors are imported; "
          "or a new NAME.gpkg alone")
      ->type_name("FOLDER");
  add_label_flags(import, given);
  add_provenance_flags(import, given.provenance);
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
  add_resolution_flag(import, given.resolution,
                      "the source's on the ground; of vectors 0.1, or what keeps the map under 100 "
                      "million cells");
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
      "            --metres-per-pixel 0.1 --out town\n"
      "          nadir map import town.osm --out town\n"
      "          nadir map import lanes.osm --into town/labels.gpkg");
  return import;
}

Result<ImportOptions> raster_options(const MapImportArguments& given) {
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

}  // namespace nadir::cli
