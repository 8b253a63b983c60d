// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/map/overhead_map.h"

namespace nadir {

/// What map.toml says beside the labels.
struct MapProvenance {
  std::string name = {};
  std::string source = {};   ///< Who made it from what, in a sentence.
  std::string licence = {};  ///< SPDX identifier or a sentence.
  std::string date = {};  ///< Of the imagery, ISO 8601, because overheads go stale. May be empty.
};

/// Red, green, blue, eight bits each.
using ColourRaster = Raster<Colour>;

/// Reads a map package: the folder with map.toml and labels.tif (see core/map/README.md for the
/// format).
/// @errors kNotFound, kMalformed (no georeference, truncated, ids that are no class, not north-up
/// square cells), kUnsupported.
[[nodiscard]] Result<OverheadMap> read_overhead_map(const std::filesystem::path& package);
[[nodiscard]] Result<MapProvenance> read_map_provenance(const std::filesystem::path& package);
/// The plane that the package lies on. @errors as read_overhead_map.
[[nodiscard]] Result<ProjectPlane> read_map_plane(const std::filesystem::path& package);
/// The overhead picture (image.tif), or nothing where the package has none; it has the labels' size
/// and place.
[[nodiscard]] Result<std::optional<ColourRaster>> read_overhead_image(
    const std::filesystem::path& package);

/// Writes a map package by way of a staged folder: map.toml, labels.tif (paletted, deflate, class
/// names, overviews by nearest) and, where given, image.tif (JPEG-in-TIFF quality 85 with
/// overviews; same size as the labels). A package that holds nothing else is replaced in one step. In one with other files,
/// such as a labelling document, each file of the map is replaced by itself, so that who has others open may go on.
/// @errors kIo.
[[nodiscard]] Result<void> write_overhead_map(const OverheadMap& map,
                                              const MapProvenance& provenance,
                                              const std::optional<ColourRaster>& image,
                                              const std::filesystem::path& package);

/// Labels that are made as they are written, so that a map may be larger than the memory.
struct LabelStrips {
  std::string name;
  ProjectPlane plane;
  double metres_per_cell = 0.1;
  Eigen::Vector2d top_left_in_enu_m = Eigen::Vector2d::Zero();
  int width = 0, height = 0;
  /// Of rows [first, first + count): as wide as the map. Asked for once each, from the top. Its errors end the writing.
  std::function<Result<Raster<ClassId>>(int first, int count)> rows;
};

/// Writes the labels and map.toml of a package, new or there already. In one that is there each file is replaced by itself,
/// and picture, labelling document and all others stay where they are, so that who has them open may go on.
/// @errors kIo: cannot be written, the folder holds something else, or a map on another plane or with a picture of other
/// cells, which is then left alone; those of `rows`.
[[nodiscard]] Result<void> write_labels_of_map(const LabelStrips& labels,
                                               const MapProvenance& provenance,
                                               const std::filesystem::path& package);

}  // namespace nadir
