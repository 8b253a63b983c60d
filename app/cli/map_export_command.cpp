// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "app/cli/console.h"
#include "app/cli/map_subcommands.h"
#include "core/desk/label_place.h"
#include "core/exchange/label_export.h"
#include "core/label/label_store.h"

namespace nadir::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kExportName = "nadir map export";
constexpr const char* kLabelsName = "labels.gpkg";

/// labels.gpkg, or the folder that holds it.
fs::path labels_file(const std::string& given) {
  const fs::path path = find_bundled(given);
  std::error_code error;
  return fs::is_directory(path, error) ? path / kLabelsName : path;
}

/// @errors as LabelStore::open(); kMalformed: it is damaged, and what is left of it is not what was drawn.
Result<LabelStore> open_whole(const fs::path& path) {
  auto store = LabelStore::open(path, author_name(), LabelAccess::kRead);
  if (store && store->is_damaged()) {
    return fail(ErrorCode::kMalformed,
                "{}: is damaged, and what could be read of it is not all that was drawn",
                path.string());
  }
  return store;
}

std::vector<std::string> format_names() {
  const auto& names = EnumNames<LabelFormat>::kNames;
  return {names.begin(), names.end()};
}

/// By its name, or by the target's extension.
LabelFormat format_of(const MapExportArguments& given) {
  const auto& names = EnumNames<LabelFormat>::kNames;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (given.format == names.at(i)) return static_cast<LabelFormat>(i);
  }
  const std::string extension = fs::path(given.out).extension().string();
  if (extension == ".geojson") return LabelFormat::kGeoJson;
  if (extension == ".png") return LabelFormat::kIndexedPng;
  if (extension == ".json") return LabelFormat::kCoco;
  return LabelFormat::kMapPackage;
}

/// What the flags say, else what the package around the document says. @errors kMalformed.
Result<MapProvenance> provenance_of(const MapExportArguments& given, const fs::path& labels) {
  MapProvenance provenance = given.provenance;
  const fs::path folder = fs::absolute(labels).parent_path();
  std::error_code error;
  if (fs::exists(folder / "map.toml", error)) {
    const auto around = read_map_provenance(folder);
    if (!around) return forward_error(around);
    for (std::string MapProvenance::*const field :
         {&MapProvenance::name, &MapProvenance::source, &MapProvenance::licence,
          &MapProvenance::date}) {
      if ((provenance.*field).empty()) provenance.*field = (*around).*field;
    }
  }
  if (provenance.name.empty()) provenance.name = fs::path(given.out).stem().string();
  return provenance;
}

double difference_percent(const ClassArea& area) {
  return area.drawn_m2 > 0.0 ? 100.0 * (area.exported_m2 - area.drawn_m2) / area.drawn_m2 : 100.0;
}

std::string check_text(const std::string& package, const ExportCheck& check) {
  std::string text =
      fmt::format("{:<15}{:>15}{:>15}{:>12}\n", "class", "objects m2", "cells m2", "difference");
  for (const ClassArea& area : check.areas) {
    text += fmt::format("{:<15}{:>15.1f}{:>15.1f}{:>10.3f} %\n", class_info(area.id).name,
                        area.drawn_m2, area.exported_m2, difference_percent(area));
  }
  return text +
         fmt::format("{}: {}\n", package,
                     check.faults.empty() ? "is as its document is" : "is not as its document is");
}

std::string check_json(const std::string& package,
                       const std::string& labels,
                       const ExportCheck& check) {
  Json json{{"package", package}, {"labels", labels}, {"classes", Json::array()}};
  for (const ClassArea& area : check.areas) {
    json["classes"].push_back({{"id", area.id},
                               {"name", class_info(area.id).name},
                               {"drawn_m2", area.drawn_m2},
                               {"exported_m2", area.exported_m2}});
  }
  json["faults"] = check.faults;
  json["notices"] = check.notices;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// A bar and Ctrl+C for one piece of work.
class Work {
 public:
  Work(std::ostream& err, bool is_quiet) : bar_(err, is_quiet) {
    context_.stop = interrupt_.token();
    context_.progress = [this](double fraction, const std::string& activity) {
      bar_.show(fraction, activity);
    };
  }
  [[nodiscard]] const WorkContext& context() const { return context_; }

 private:
  Interrupt interrupt_;
  ProgressBar bar_;
  WorkContext context_;
};

}  // namespace

void add_provenance_flags(CLI::App& app, MapProvenance& provenance) {
  for (const auto& [flag, value, help] :
       {std::tuple("--name", &provenance.name, "Name of the map; default: the source's"),
        std::tuple("--source", &provenance.source, "Who made it from what, in a sentence"),
        std::tuple("--licence", &provenance.licence, "SPDX identifier or a sentence"),
        std::tuple("--date", &provenance.date, "Date of the imagery, YYYY-MM-DD")}) {
    app.add_option(flag, *value, help)->type_name("TEXT");
  }
}

void add_resolution_flag(CLI::App& app,
                         std::optional<double>& metres_per_cell,
                         const std::string& otherwise) {
  app.add_option("--resolution", metres_per_cell,
                 "Size of a cell of the map [m], 0.001 to 100000; default: " + otherwise)
      ->type_name("NUMBER")
      ->check(is_number());
}

Result<void> check_resolution(const std::optional<double>& metres_per_cell) {
  if (!metres_per_cell || (*metres_per_cell >= 0.001 && *metres_per_cell <= 1e5)) return {};
  return fail(ErrorCode::kInvalidOptions, "--resolution: {} is not in [0.001, 100000] m",
              *metres_per_cell);
}

CLI::App& add_map_export(CLI::App& map, MapExportArguments& given) {
  CLI::App& app = *map.add_subcommand("export", "Write a labelling document as others read it");
  app.add_option("LABELS", given.labels, "A labelling document (labels.gpkg), or its folder")
      ->required();
  app.add_option("--out", given.out,
                 "What to write: a folder (package, shapefile, class-images) or a file (geojson, "
                 "indexed-png, coco)")
      ->type_name("PATH")
      ->required();
  app.add_option("--format", given.format,
                 "package: a map for the localiser. geojson, shapefile: the objects. class-images: "
                 "a PNG a class. indexed-png: one with palette and world file. coco: regions as "
                 "annotations. Default: by the ending of --out, else package")
      ->type_name(choices_text(format_names()))
      ->check(is_one_of(format_names()));
  add_resolution_flag(app, given.resolution, "the document's");
  add_provenance_flags(app, given.provenance);
  app.add_flag("--quiet", given.is_quiet, "No progress and no notices");
  app.footer(
      "Examples: nadir map export town/labels.gpkg --out town\n"
      "          nadir map export town --out town.geojson\n"
      "          nadir map export town --format class-images --out masks");
  return app;
}

int run_map_export(const MapExportArguments& given, std::ostream& out, std::ostream& err) {
  if (const auto sound = check_resolution(given.resolution); !sound) {
    return report_flags_error(err, kExportName, sound.error());
  }
  const fs::path path = labels_file(given.labels);
  const auto store = open_whole(path);
  if (!store) return report_error(err, store.error());
  if (std::error_code error; fs::equivalent(path, given.out, error)) {
    return report_error(err, {ErrorCode::kInvalidOptions,
                              fmt::format("{}: is the labelling document itself; --out must name "
                                          "another file",
                                          given.out)});
  }
  // Of another map, say: nobody means to have an afternoon's work replaced by a picture of it.
  if (std::error_code error;
      fs::path(given.out).extension() == ".gpkg" && fs::exists(given.out, error)) {
    return report_error(err, {ErrorCode::kInvalidOptions,
                              fmt::format("{}: is a GeoPackage, which no export replaces; --out "
                                          "must name another file",
                                          given.out)});
  }
  const auto provenance = provenance_of(given, path);
  if (!provenance) return report_error(err, provenance.error());
  if (!given.is_quiet) {
    for (const std::string& notice : store->notices()) err << "notice: " << notice << '\n';
  }
  const LabelFormat format = format_of(given);
  const LabelDocument& document = store->document();
  const LabelGrid grid = export_grid(document, given.resolution);
  const auto place = find_label_place(path);
  if (!place) return report_error(err, place.error());
  const Work work(err, given.is_quiet);
  const auto written =
      export_labels(document, grid, *provenance, format, given.out, work.context(), place->image);
  if (!written) return report_error(err, written.error());
  const bool is_of_vectors = format == LabelFormat::kGeoJson || format == LabelFormat::kShapefile;
  out << given.out << ": "
      << (is_of_vectors ? fmt::format("{} objects", document.objects().size())
                        : fmt::format("{} x {} cells of {:.6g} m", grid.width, grid.height,
                                      grid.metres_per_cell))
      << '\n';
  return kDone;
}

CLI::App& add_map_check(CLI::App& map, MapCheckArguments& given) {
  CLI::App& app = *map.add_subcommand(
      "check", "Compare a map package with the labelling document that it was made of");
  app.add_option("PACKAGE", given.package, "A map package (a folder with map.toml)")->required();
  app.add_option("--labels", given.labels, "The labelling document; default: PACKAGE/labels.gpkg")
      ->type_name("LABELS");
  app.add_flag("--json", given.is_json, "One JSON object with SI units in its key names");
  app.add_flag("--quiet", given.is_quiet, "No progress, no notices and no table: faults alone");
  app.footer(
      "Looks at plane and corners, every cell, palette, overviews, and the area of\n"
      "each class. Faults go to standard error, one a line; exit status 1.\n"
      "Example: nadir map check town");
  return app;
}

int run_map_check(const MapCheckArguments& given, std::ostream& out, std::ostream& err) {
  const fs::path package = find_bundled(given.package);
  const fs::path labels = labels_file(given.labels.empty() ? package.string() : given.labels);
  const auto store = open_whole(labels);
  if (!store) return report_error(err, store.error());
  const Work work(err, given.is_quiet);
  const auto check = check_export(store->document(), package, work.context());
  if (!check) return report_error(err, check.error());
  if (given.is_json) {
    out << check_json(given.package, labels.string(), *check);
  } else if (!given.is_quiet) {
    out << check_text(given.package, *check);
  }
  if (!given.is_quiet) {
    for (const std::string& notice : check->notices) err << "notice: " << notice << '\n';
  }
  for (const std::string& fault : check->faults) {
    err << "nadir: " << given.package << ": " << fault << '\n';
  }
  return check->faults.empty() ? kDone : kFailed;
}

}  // namespace nadir::cli
