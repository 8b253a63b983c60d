// SPDX-License-Identifier: Apache-2.0
// Labels into files of other programs, and out of them. All of it is work in the background.
#include <algorithm>
#include <system_error>

#include "core/exchange/label_export.h"
#include "core/exchange/label_import.h"
#include "core/label/label_store.h"
#include "core/map/map_import.h"
#include "core/session/session_core.h"

namespace nadir {
namespace fs = std::filesystem;

namespace {

/// What the package around a document says of itself; without one, the name of what is labelled.
Result<MapProvenance> provenance_of_labels(const fs::path& labelled) {
  std::error_code error;
  if (fs::exists(labelled / "map.toml", error)) return read_map_provenance(labelled);
  MapProvenance provenance;
  provenance.name = labelled.stem().string();
  return provenance;
}

Result<ImportedLabels> imported_labels(const fs::path& file,
                                       const fs::path& rules_folder,
                                       const LabelDocument& document,
                                       const WorkContext& context) {
  if (!ImportSource::holds_vectors(file)) {
    const auto raster = import_map(file, {}, context);
    if (!raster) return forward_error(raster);
    return import_raster(raster->map, RasterAs::kPaint, document, context);
  }
  const auto source = ImportSource::read(file, {}, context);
  if (!source) return forward_error(source);
  const auto rules = ImportRules::read(rules_folder / source->usual_rules());
  if (!rules) return forward_error(rules);
  return source->objects(*rules, document, context);
}

}  // namespace

Result<void> Session::Implementation::perform(const actions::ExportLabels& action) {
  const auto desk = need_desk();
  if (!desk) return forward_error(desk);
  if (action.path.empty()) return fail(ErrorCode::kInvalidOptions, "no file is named");
  const fs::path target = absolute_path(action.path);
  auto provenance = provenance_of_labels(label.path);
  if (!provenance) return forward_error(provenance);
  small_works.push_back(
      {++last_number, "writing " + target.filename().string(),
       Job<int, std::string>(
           [document = (*desk)->sheet().document(), format = action.format, target,
            about = std::move(*provenance)](const WorkContext& context,
                                            const auto& /*publish*/) -> Result<std::string> {
             const LabelGrid grid = export_grid(*document, std::nullopt);
             const auto written = export_labels(*document, grid, about, format, target, context);
             if (!written) return forward_error(written);
             return target.string();
           }),
       [this](const std::string& made) {
         add_notice(Notice::Kind::kInfo, made + " was written");
       }});
  return {};
}

Result<void> Session::Implementation::perform(const actions::ImportLabels& action) {
  const auto desk = need_desk();
  if (!desk) return forward_error(desk);
  const fs::path file = absolute_path(action.path);
  std::error_code error;
  if (!fs::exists(file, error)) {
    return fail(ErrorCode::kNotFound, "{}: does not exist", file.string());
  }
  auto imported = std::make_shared<ImportedLabels>();
  small_works.push_back({++last_number, "importing " + file.filename().string(),
                         Job<int, std::string>([document = (*desk)->sheet().document(), file,
                                                imported, rules = places.resources / "rules"](
                                                   const WorkContext& context,
                                                   const auto& /*publish*/) -> Result<std::string> {
                           auto read = imported_labels(file, rules, *document, context);
                           if (!read) return forward_error(read);
                           *imported = std::move(*read);
                           imported->edit.title = "Import " + file.filename().string();
                           return file.string();
                         }),
                         [this, imported, into = label.path](const std::string& made) {
                           take_import(made, *imported, into);
                         }});
  return {};
}

void Session::Implementation::take_import(const std::string& file,
                                          const ImportedLabels& imported,
                                          const std::string& into) {
  const auto desk = need_desk();
  if (!desk || label.path != into) return;  // those labels have been closed meanwhile
  // Where somebody has drawn meanwhile, numbers may have been given twice: that is refused, and nothing is changed.
  if (const auto done = (*desk)->commit(imported.edit); !done) {
    add_notice(Notice::Kind::kError,
               fmt::format("{} was not imported: {}", file, done.error().message));
    return;
  }
  Notice notice;
  notice.text =
      fmt::format("{}: {} objects of {} things were taken", file, imported.taken, imported.read);
  for (const std::string& told : imported.notices) {
    notice.details += (notice.details.empty() ? "" : "\n") + told;
  }
  add_notice(notice);
}

Result<void> Session::Implementation::perform(const actions::SaveLabelsCopy& action) {
  const auto desk = need_desk();
  if (!desk) return forward_error(desk);
  const fs::path target = absolute_path(action.path);
  std::error_code error;
  if (target.extension() != ".gpkg") {
    return fail(ErrorCode::kInvalidOptions, "{}: does not end in .gpkg", target.string());
  }
  if (fs::exists(target, error)) {
    return fail(ErrorCode::kIo, "{}: is there already", target.string());
  }
  small_works.push_back(
      {++last_number, "writing " + target.filename().string(),
       Job<int, std::string>(
           [document = (*desk)->sheet().document(), target, author = places.author](
               const WorkContext& /*context*/, const auto& /*publish*/) -> Result<std::string> {
             auto store = LabelStore::create(target, *document, author);
             if (!store) return forward_error(store);
             if (const auto closed = store->close(); !closed) return forward_error(closed);
             return target.string();
           }),
       [this](const std::string& made) {
         add_notice(Notice::Kind::kInfo, made + " was written");
       }});
  return {};
}

}  // namespace nadir
