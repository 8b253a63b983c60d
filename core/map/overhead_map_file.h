// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
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
/// overviews; same size as the labels).
/// @errors kIo.
[[nodiscard]] Result<void> write_overhead_map(const OverheadMap& map,
                                              const MapProvenance& provenance,
                                              const std::optional<ColourRaster>& image,
                                              const std::filesystem::path& package);

}  // namespace nadir
