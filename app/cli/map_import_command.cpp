// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdlib>
#include <tuple>

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "app/cli/console.h"
#include "app/cli/map_subcommands.h"
#include "core/base/staged_output.h"
#include "core/exchange/label_export.h"
#include "core/exchange/label_import.h"
#include "core/label/label_store.h"
#include "core/map/map_import.h"

namespace nadir::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kName = "nadir map import";
constexpr const char* kLabels = "labels.gpkg";

/// What the flags ask for must go with the kind of source. @errors kInvalidOptions.
Result<void> check_flags(const MapImportArguments& given, bool is_of_vectors) {
  const std::initializer_list<std::tuple<const char*, bool, bool>> flags{
      {"--rules", !given.rules.empty(), true},
      {"--as", !given.as.empty(), false},
      {"--anchor", !given.anchor.empty(), false},
      {"--metres-per-pixel", given.metres_per_pixel.has_value(), false},
      {"--flip", given.is_flipped, false},
      {"--remap", !given.remap.empty(), false},
      {"--inside", given.inside.has_value(), false},
      {"--building-contours", given.building_contours_m.has_value(), false},
      {"--image", !given.image.empty(), false}};
  for (const auto& [flag, is_given, goes_with_vectors] : flags) {
    if (is_given && goes_with_vectors != is_of_vectors) {
      return fail(ErrorCode::kInvalidOptions, "{}: goes with {}, which {} is not", flag,
                  goes_with_vectors ? "vectors" : "a label raster", given.source);
    }
  }
  if (!given.into.empty() && given.resolution && is_of_vectors) {
    return fail(ErrorCode::kInvalidOptions, "--resolution: is that of the document of --into");
  }
  return is_of_vectors ? check_resolution(given.resolution) : Result<void>();
}

fs::path find_rules(const std::string& name) {
  const fs::path path = find_bundled(name);
  std::error_code error;
  return fs::exists(path, error) ? path : find_bundled(fs::path("resources/rules") / name);
}

/// Says what an import did not take.
class ImportReport {
 public:
  ImportReport(const MapImportArguments& given, std::ostream& out, std::ostream& err)
      : given_(given), out_(out), err_(err) {}

  void tell(const std::vector<std::string>& notices) {
    if (given_.is_quiet) return;
    for (const std::string& notice : notices) err_ << "notice: " << notice << '\n';
  }
  /// @param taken  "32 objects", or nothing.
  void done(const std::string& target, const LabelDocument& document, const std::string& taken) {
    const LabelGrid& grid = document.grid();
    out_ << fmt::format("{}: {} x {} cells of {:.6g} m, centre {}{}\n", target, grid.width,
                        grid.height, grid.metres_per_cell,
                        geodetic_text(document.plane().geodetic_from_enu(
                            grid.enu_from_cells({0.5 * grid.width, 0.5 * grid.height}))),
                        taken.empty() ? "" : "; " + taken);
  }

 private:
  const MapImportArguments& given_;
  std::ostream& out_;
  std::ostream& err_;
};

/// A new file with all of a document; nothing is left of it where it cannot be written. @errors kIo.
Result<void> write_labels_file(const LabelDocument& document, const fs::path& path) {
  auto store = LabelStore::create(path, document, author_name());
  if (!store) return forward_error(store);
  return store->close();
}

/// A package with its labelling document, in a folder that is not there yet. @errors kIo, kCancelled.
Result<void> write_new_map(const LabelDocument& document,
                           const MapProvenance& provenance,
                           const fs::path& package,
                           const WorkContext& context) {
  // Also at the end: somebody may have begun to draw there meanwhile.
  const auto is_taken = [&](const fs::path&) -> Result<void> {
    return fail(ErrorCode::kIo,
                "{}: is there already; import into another folder, or with --into into its {}",
                package.string(), kLabels);
  };
  auto staged = StagedOutput::folder(package, "map.toml", {}, is_taken);
  if (!staged) return forward_error(staged);
  const auto written = export_labels(document, document.grid(), provenance,
                                     LabelFormat::kMapPackage, staged->path(), context);
  if (!written) return forward_error(written);
  const auto saved = write_labels_file(document, staged->path() / kLabels);
  if (!saved) return forward_error(saved);
  return staged->commit();
}

/// Adds an edit to the document of --into, as one step.
int commit_into(LabelStore& store, const LabelEdit& edit, std::ostream& err) {
  if (!store.why_read_only().empty()) {
    return report_error(err, {ErrorCode::kIo, store.why_read_only()});
  }
  if (const auto done = store.commit(edit); !done) return report_error(err, done.error());
  if (const auto closed = store.close(); !closed) return report_error(err, closed.error());
  return kDone;
}

std::string counted(const ImportedLabels& imported) {
  return fmt::format("{} objects of {} things", imported.taken, imported.read);
}

int import_vectors(const MapImportArguments& given,
                   const WorkContext& context,
                   ImportReport& report,
                   std::ostream& err) {
  const auto source = ImportSource::read(given.source, given.crs, context);
  if (!source) return report_flags_error(err, kName, source.error());
  const auto rules =
      ImportRules::read(find_rules(given.rules.empty() ? source->usual_rules() : given.rules));
  if (!rules) return report_error(err, rules.error());
  if (!given.into.empty()) {
    auto store = LabelStore::open(given.into, author_name());
    if (!store) return report_error(err, store.error());
    auto imported = source->objects(*rules, store->document(), context);
    if (!imported) return report_error(err, imported.error());
    imported->edit.title = "Import " + fs::path(given.source).filename().string();
    if (const int status = commit_into(*store, imported->edit, err); status != kDone) return status;
    report.tell(imported->notices);
    report.done(given.into, store->document(), counted(*imported));
    return kDone;
  }
  auto document = source->plan_document(*rules, given.resolution);
  if (!document) return report_flags_error(err, kName, document.error());
  const auto imported = source->objects(*rules, *document, context);
  if (!imported) return report_error(err, imported.error());
  document->apply(imported->edit);
  const fs::path target = given.out;
  MapProvenance provenance = given.provenance;
  if (provenance.name.empty()) provenance.name = fs::path(given.source).stem().string();
  const auto written = target.extension() == ".gpkg"
                           ? write_labels_file(*document, target)
                           : write_new_map(*document, provenance, target, context);
  if (!written) return report_error(err, written.error());
  report.tell(imported->notices);
  report.done(given.out, *document, counted(*imported));
  return kDone;
}

/// The raster's own cells, as an empty document.
LabelDocument document_under(const OverheadMap& map) {
  return {map.plane, LabelGrid{map.metres_per_cell, map.top_left_in_enu_m, map.labels.width(),
                               map.labels.height()}};
}

int import_labels(const MapImportArguments& given,
                  const WorkContext& context,
                  ImportReport& report,
                  std::ostream& err) {
  const auto options = raster_options(given);
  if (!options) return report_flags_error(err, kName, options.error());
  const fs::path labels_path = fs::path(given.out) / kLabels;
  std::error_code error;
  if (!given.as.empty() && given.into.empty() && fs::exists(labels_path, error)) {
    return report_error(
        err, {ErrorCode::kIo, labels_path.string() + ": is there already; import with --into it"});
  }
  const auto imported = import_map(given.source, *options, context);
  if (!imported) return report_flags_error(err, kName, imported.error());
  const OverheadMap& map = imported->map;
  const RasterAs as = given.as == "areas" ? RasterAs::kAreas : RasterAs::kPaint;
  if (!given.into.empty()) {
    auto store = LabelStore::open(given.into, author_name());
    if (!store) return report_error(err, store.error());
    const auto labels = import_raster(map, as, store->document(), context);
    if (!labels) return report_error(err, labels.error());
    if (const int status = commit_into(*store, labels->edit, err); status != kDone) return status;
    report.tell(imported->notices);
    report.done(given.into, store->document(), "");
    return kDone;
  }
  MapProvenance provenance = given.provenance;
  provenance.name = map.name;
  const auto written = write_overhead_map(map, provenance, imported->image, given.out);
  if (!written) return report_error(err, written.error());
  LabelDocument document = document_under(map);
  if (!given.as.empty()) {
    const auto labels = import_raster(map, as, document, context);
    if (!labels) return report_error(err, labels.error());
    document.apply(labels->edit);
    if (const auto saved = write_labels_file(document, labels_path); !saved) {
      return report_error(err, saved.error());
    }
  }
  report.tell(imported->notices);
  const auto usable = check_usable_for_localising(map);
  if (!usable) report.tell({usable.error().message});
  report.done(given.out, document, "");
  return kDone;
}

}  // namespace

std::string author_name() {
  const char* const name = std::getenv("USER");  // NOLINT(concurrency-mt-unsafe): nobody sets it.
  return name != nullptr && *name != '\0' ? name : "unknown";
}

int run_map_import(const MapImportArguments& given, std::ostream& out, std::ostream& err) {
  if (given.out.empty() == given.into.empty()) {
    return report_misuse(err, kName, "one of --out and --into says where it goes");
  }
  const bool is_of_vectors = ImportSource::holds_vectors(given.source);
  if (const auto flags = check_flags(given, is_of_vectors); !flags) {
    return report_flags_error(err, kName, flags.error());
  }
  const Interrupt interrupt;
  ProgressBar bar(err, given.is_quiet);
  WorkContext context;
  context.stop = interrupt.token();
  context.progress = [&](double fraction, const std::string& activity) {
    bar.show(fraction, activity);
  };
  ImportReport report(given, out, err);
  return is_of_vectors ? import_vectors(given, context, report, err)
                       : import_labels(given, context, report, err);
}

}  // namespace nadir::cli
