// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/map/gdal_raster.h"
#include "core/map/map_import.h"

namespace nadir {

/// The readers behind import_map. Private to this module.

/// Labels as a source has them, already in our classes.
struct SourceLabels {
  Raster<ClassId> labels;
  std::optional<Placement> placement;  ///< Where the source says it lies, if it does.
  std::vector<std::string> notices;
};

/// One raster of class ids (label_image.cpp). @errors those of import_map.
[[nodiscard]] Result<SourceLabels> read_label_image(const std::filesystem::path& path,
                                                    const ImportOptions& options);

/// A folder of class<N>.png or <class name>.png, one a class. Where several classes claim a cell,
/// the one of the higher drawing_level() wins. @errors those of import_map.
[[nodiscard]] Result<SourceLabels> read_class_images(const std::filesystem::path& folder,
                                                     const ImportOptions& options);

}  // namespace nadir
