// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/raster.h"
#include "core/base/result.h"
#include "core/label/label_document.h"
#include "core/map/overhead_image.h"

namespace nadir {

/// Where the labels of what somebody names are kept, and how they begin.
struct LabelPlace {
  std::filesystem::path document;  ///< labels.gpkg; there or not.
  std::filesystem::path image;     ///< The picture below; empty where none is known.
  /// With what a document that is not there begins: its plane and grid, and nothing on it. Nothing where there is one.
  std::optional<LabelDocument> begins_as;
  /// What it takes over from elsewhere before anything is drawn; empty where that is nothing.
  LabelEdit takes_over;
  std::vector<std::string> notices;  ///< Each one sentence without full stop.
};

/// - A map package: PACKAGE/labels.gpkg. Where that is not there, the labels of labels.tif are taken over as paint.
/// - A labelling document, *.gpkg: itself, over the picture of the package that it lies in; over the picture IMAGE.tif, .png,
///   .jpg, ... beside it where it is called IMAGE.labels.gpkg.
/// - An overhead image that says, or of which `image` says, where it lies, in any format of open_overhead_image(): IMAGE.labels.gpkg beside it, IMAGE without its
///   ending; one that lies in a package means the package. A new document lies on a plane centred on the image, with the
///   image's resolution on the ground.
/// Nothing is written. @param image  Of an image without a reference: its system, or how it lies. @errors kNotFound; kMalformed:
/// neither, no georeference, labels.tif is damaged; kUnsupported.
[[nodiscard]] Result<LabelPlace> find_label_place(const std::filesystem::path& named,
                                                  const ImageOptions& image = {});

/// Cells as paint in the levels of their classes. @param cells  Of the document's grid. @returns an edit without title.
[[nodiscard]] LabelEdit paint_of_cells(const LabelDocument& document, const Raster<ClassId>& cells);

}  // namespace nadir
