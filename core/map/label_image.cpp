// SPDX-License-Identifier: Apache-2.0
#include <gdal_priv.h>

#include <array>
#include <utility>

#include "core/map/class_images.h"

namespace nadir {
namespace {

/// What the source calls its values, by value; empty where it has no name for one. GDAL knows the
/// names of a GeoTIFF only once its place was asked for. The labels of a map package that lost the
/// file beside them still have the names as metadata.
std::vector<std::string> value_names(GDALDataset& dataset) {
  GDALRasterBand& band = *dataset.GetRasterBand(1);
  std::vector<std::string> names;
  for (char** entry = band.GetCategoryNames(); entry != nullptr && *entry != nullptr; ++entry) {
    names.emplace_back(*entry);
  }
  if (!names.empty()) return names;
  for (int id = 0; id < kClassCount; ++id) {
    const char* name = band.GetMetadataItem(fmt::format("CLASS_{}", id).c_str());
    names.emplace_back(name == nullptr ? "" : name);
  }
  return names;
}

/// A sentence that says which values were taken as which classes; nothing where the source calls
/// each of them as we do.
std::optional<std::string> notice_of_meaning(const Raster<ClassId>& labels,
                                             std::span<const std::string> names,
                                             const std::string& file) {
  std::array<bool, kClassCount> is_present{};
  for (const ClassId id : labels.values()) {
    if (id < kClassCount) is_present.at(id) = true;
  }
  std::string meaning;
  bool is_certain = true;
  for (std::size_t id = 0; id < kClassCount; ++id) {
    if (!is_present.at(id)) continue;
    const std::string name = id < names.size() ? names[id] : "";
    const bool is_named_alike = class_from_name(name) == static_cast<ClassId>(id);
    is_certain = is_certain && is_named_alike;
    meaning += fmt::format("{}{}{} as {}", meaning.empty() ? "" : ", ", id,
                           name.empty() || is_named_alike ? "" : " (\"" + name + "\")",
                           class_info(static_cast<ClassId>(id)).name);
  }
  if (is_certain) return std::nullopt;
  return fmt::format("{}: without --remap its values were taken as this program's classes: {}",
                     file, meaning);
}

}  // namespace

Result<SourceLabels> read_label_image(const std::filesystem::path& path,
                                      const ImportOptions& options) {
  if (options.inside_value) {
    return fail(ErrorCode::kInvalidOptions, "--inside: {} is no folder of class images",
                path.string());
  }
  const GdalMessages messages;
  const std::string name = path.string();
  const auto dataset = open_raster(path, messages);
  if (!dataset) return forward_error(dataset);
  SourceLabels source;
  auto placement = placement_of(**dataset, options.crs, name, messages);
  if (!placement) return forward_error(placement);
  source.placement = std::move(*placement);
  auto ids = read_ids(**dataset, name, messages);
  if (!ids) return forward_error(ids);
  const std::vector<std::string> names = value_names(**dataset);
  if (options.remap) {
    source.labels = options.remap->with_names(names).apply(std::move(*ids));
    return source;
  }
  for (const ClassId id : ids->values()) {
    if (id < kClassCount || id == kUnclassified) continue;
    return fail(ErrorCode::kMalformed,
                "{}: id {} is no class; name the source's classes with --remap", name,
                static_cast<int>(id));
  }
  source.labels = std::move(*ids);
  if (auto notice = notice_of_meaning(source.labels, names, name)) {
    source.notices.push_back(std::move(*notice));
  }
  return source;
}

}  // namespace nadir
