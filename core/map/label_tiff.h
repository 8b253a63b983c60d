// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "core/geo/project_plane.h"
#include "core/map/overhead_map_file.h"

class GDALDataset;
class GDALRasterBand;

namespace nadir {

/// The rasters of a map package. Private to this module; core/map/README.md has the format.

/// Where a raster of a package lies on the package's plane.
struct TiffPlace {
  double metres_per_cell = 0.0;
  Eigen::Vector2d top_left_in_enu_m = Eigen::Vector2d::Zero();
  int width = 0;
  int height = 0;
};

struct LabelTiff {
  TiffPlace place;
  Raster<ClassId> labels;
};

/// @errors kNotFound, kMalformed: no georeference, rotated, not square, another plane, an id that
/// is no class, truncated.
[[nodiscard]] Result<LabelTiff> read_label_tiff(const std::filesystem::path& path,
                                                const ProjectPlane& plane);
/// Place only, without the labels.
[[nodiscard]] Result<TiffPlace> read_tiff_place(const std::filesystem::path& path,
                                                const ProjectPlane& plane);
/// Whether the labels' no-data value, where they have one, is kUnclassified: another one would take a
/// class away without a word. @errors kMalformed.
[[nodiscard]] Result<void> check_no_data(GDALDataset& labels, const std::string& name);
/// @errors kNotFound, kMalformed: as above.
[[nodiscard]] Result<ColourRaster> read_image_tiff(const std::filesystem::path& path);

/// Names and colours of our classes, and what is no class.
void describe_classes(GDALRasterBand& band);

/// @errors kIo.
[[nodiscard]] Result<void> write_label_tiff(const OverheadMap& map,
                                            const std::filesystem::path& path);
/// The same strip by strip. @errors kIo; those of its rows.
[[nodiscard]] Result<void> write_label_tiff(const LabelStrips& labels,
                                            const std::filesystem::path& path);
[[nodiscard]] Result<void> write_image_tiff(const OverheadMap& map,
                                            const ColourRaster& image,
                                            const std::filesystem::path& path);

}  // namespace nadir
