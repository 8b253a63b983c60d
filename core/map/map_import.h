// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/geo/project_plane.h"
#include "core/map/class_remap.h"
#include "core/map/overhead_map_file.h"

namespace nadir {

/// Which point of the raster (of the flipped one, where it is flipped) an anchor names.
enum class AnchorPoint { kTopLeftCorner, kCentre };

/// How labels from elsewhere become a map. Error messages name the options as the command line
/// does.
struct ImportOptions {
  std::string name{};  ///< Of the map; where empty the source's file or folder name.

  /// For a source that has no place of its own: where it lies. Axes are then east and south. Both
  /// or neither.
  std::optional<Geodetic> anchor{};
  std::optional<double> metres_per_pixel{};
  AnchorPoint anchor_point = AnchorPoint::kTopLeftCorner;
  bool flip_vertically = false;  ///< The source's first row is its southernmost.

  /// "EPSG:25832" or WKT for a source that has coordinates but no reference system, such as a PNG
  /// with a world file.
  std::string crs{};

  /// Of the map; where empty the source's resolution on the ground.
  std::optional<double> metres_per_cell{};
  std::optional<ClassRemap> remap{};
  /// Of class images, and of nothing else: 0 or 255 means "belongs to the class"; where empty 255.
  std::optional<int> inside_value{};
  /// Thickness of the walls that are left of filled buildings; nothing leaves buildings as they
  /// are.
  std::optional<double> building_contours_m{};
  /// Picture of the same place: georeferenced, or of the source's size. Empty where there is none.
  std::filesystem::path image{};
};

struct ImportedMap {
  OverheadMap map;
  std::optional<ColourRaster> image;  ///< Of the map's size.
  std::vector<std::string>
      notices;  ///< What the user should know, each one sentence without full stop.
};

/// Makes a map from a label raster (GeoTIFF, PNG with world file, ...) or from a folder of class
/// images; core/map/README.md has the rules. The plane is centred on the map, cells are square and
/// north is up. A source with anchor keeps its cells as they are, and so do, plane and all, the labels
/// of a map package; any other is warped once, labels by nearest neighbour.
///
/// Without a remap the source's values are taken as our classes; a notice says which became what,
/// unless the source itself calls all of them as we do.
///
/// Cars, pedestrians and sky become unclassified, for no overhead may hold them.
///
/// @errors kNotFound, kMalformed (truncated, no place, coordinates that contradict their CRS, ids
/// that are no class, images of different sizes or places), kUnsupported, kInvalidOptions,
/// kCancelled. The message starts with the file or the option.
[[nodiscard]] Result<ImportedMap> import_map(const std::filesystem::path& source,
                                             const ImportOptions& options,
                                             const WorkContext& context = {});

}  // namespace nadir
