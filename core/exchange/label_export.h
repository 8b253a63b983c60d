// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/exchange/label_format.h"
#include "core/label/label_document.h"
#include "core/map/overhead_map_file.h"

namespace nadir {

/// The cells of a document's map at another resolution: the same upper left corner, and as many as cover it all.
/// @param metres_per_cell  > 0; where empty the document's own.
[[nodiscard]] LabelGrid export_grid(const LabelDocument& document,
                                    std::optional<double> metres_per_cell);

/// Writes a document as others read it, aside and renamed when it is whole. Rasters are made by strips, so that memory does
/// not grow with the map. Where paint goes into a file of vectors it becomes areas.
/// @param grid  Of rasters; vectors do not ask. @param picture  The image below the labels, which COCO names; empty: none.
/// @errors kIo: cannot be written, or something else stands there (see write_labels_of_map()); kUnsupported: COCO of more
/// than 100 million cells; kCancelled.
[[nodiscard]] Result<void> export_labels(const LabelDocument& document,
                                         const LabelGrid& grid,
                                         const MapProvenance& provenance,
                                         LabelFormat format,
                                         const std::filesystem::path& target,
                                         const WorkContext& context = {},
                                         const std::filesystem::path& picture = {});

/// What a class covers.
struct ClassArea {
  ClassId id = kUnclassified;
  double drawn_m2 =
      0.0;  ///< By the objects: measured on cells of a quarter of the size, or of half in large maps.
  double exported_m2 = 0.0;  ///< By the cells of the package.
};

struct ExportCheck {
  std::vector<ClassArea> areas;  ///< Of the classes that are there.
  std::vector<std::string>
      faults;  ///< What is wrong with the package, each one sentence. Empty: nothing.
  std::vector<std::string>
      notices;  ///< What is as it must be, but may surprise: classes too thin for the cells.
};

/// Reads a map package again and compares it with its document: plane and corners (within 1e-6 of a cell), every cell, palette
/// and no-data value, no class in any overview that nobody drew, and the area of each class with that of the objects, which
/// may differ by 0.1 % before it is told. O(cells of a quarter of the size).
/// @errors kNotFound, kMalformed: the package cannot be read at all; kCancelled.
[[nodiscard]] Result<ExportCheck> check_export(const LabelDocument& document,
                                               const std::filesystem::path& package,
                                               const WorkContext& context = {});

}  // namespace nadir
