// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/base/progress.h"
#include "core/label/label_document.h"
#include "core/map/overhead_map_file.h"

namespace nadir {

/// The writers behind export_labels(). Private to this module.

/// What they all write.
struct ExportTask {
  const LabelDocument& document;
  LabelGrid grid;
  const MapProvenance& provenance;
  const WorkContext& context;
  std::filesystem::path picture;  ///< Empty: none.
};

/// A strip of the task's raster. @errors kCancelled.
[[nodiscard]] Result<Raster<ClassId>> exported_rows(const ExportTask& task, int first, int count);

[[nodiscard]] Result<void> export_geojson(const ExportTask& task,
                                          const std::filesystem::path& target);
[[nodiscard]] Result<void> export_shapefile(const ExportTask& task,
                                            const std::filesystem::path& target);
[[nodiscard]] Result<void> export_class_images(const ExportTask& task,
                                               const std::filesystem::path& target);
[[nodiscard]] Result<void> export_indexed_png(const ExportTask& task,
                                              const std::filesystem::path& target);
[[nodiscard]] Result<void> export_coco(const ExportTask& task, const std::filesystem::path& target);

}  // namespace nadir
