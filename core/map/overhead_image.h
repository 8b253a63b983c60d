// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/geo/affine2.h"
#include "core/geo/project_plane.h"
#include "core/map/image_date.h"
#include "core/map/overhead_tiles.h"

namespace nadir {

/// How an image came to lie where it lies.
enum class ImagePlace {
  kOwn,     ///< By its file: georeference, world file or ground control points.
  kByHand,  ///< By ImageOptions::enu_from_pixels.
  kWithoutSystem,  ///< The file has coordinates, but nobody says of which system: ask for ImageOptions::crs.
  kNone,           ///< The file says nothing: ask for control points or a known distance.
};

/// Whether coarse tiles can be had quickly.
enum class ImageReadiness {
  kReady,
  kWantsOverviews,  ///< Until prepare_image has been there, a coarse tile is a few sample places.
  kWantsCopy,  ///< The same; of what can only be read from its beginning (PNG, JPEG) all tiles are clear until then.
};

struct ImageOptions {
  /// That the tiles are to lie on. Where empty one that is centred on the image.
  std::optional<ProjectPlane> plane = {};
  /// "EPSG:25832" or WKT for a file with coordinates and without reference system.
  std::string crs = {};
  /// From control points or a known distance, on `plane`, which it needs: in place of whatever the file says.
  std::optional<Affine2> enu_from_pixels = {};
  /// Where prepare_image has put what it made; empty: it was never there.
  std::filesystem::path cache = {};
};

/// What is known of an image without reading its pixels.
struct OverheadImage {
  std::filesystem::path path;
  int width = 0, height = 0;  ///< Pixels of the file.
  ImagePlace place = ImagePlace::kNone;
  /// That the tiles lie on. Nothing where it is not known where the image lies and no plane was asked for: tiles then are as if
  /// on one, a metre a pixel, the image's upper-left corner at the origin and its rows along east.
  std::optional<ProjectPlane> plane;
  std::string crs_name;  ///< Of the file, "WGS 84 / Pseudo-Mercator"; empty where it has none.
  /// Of the centre pixel along its row and column, as measured on the ground; nothing where it is not known.
  std::optional<Eigen::Vector2d> ground_m_per_pixel;
  std::optional<ImageDate> date;
  ImageReadiness readiness = ImageReadiness::kReady;
  std::vector<std::string>
      notices;  ///< Each a sentence without full stop, such as Web Mercator's true resolution.
};

struct OpenedImage {
  OverheadImage image;
  OverheadTiles tiles;
};

/// Opens a GeoTIFF, COG, PNG, JPEG, WebP, JPEG 2000 or MBTiles image of any size, for looking at it on a plane. Any reference
/// system, rotation, shear, south-up rows and oblong pixels are warped onto north-up square cells, as fine as the finer side
/// of the centre pixel, whenever a tile is read; an image that lies like that already keeps its pixels. One to four bands of any
/// real type, palettes, alpha, masks and no-data values are understood; more than eight bits are stretched from 2 to 98 %.
/// World files (.wld, .pgw, .jgw, ...), .prj and .aux.xml beside the file count. Takes well under a second at any size.
///
/// @errors one sentence, naming the file: kNotFound; kMalformed (no image, cut short, a bad world file, coordinates that
/// contradict their system); kUnsupported (more than 1000 km, or that far from `plane`; complex numbers; a system without
/// relation to the Earth); kInvalidOptions (bad `crs`, or the file has another; `enu_from_pixels` singular).
[[nodiscard]] Result<OpenedImage> open_overhead_image(const std::filesystem::path& path,
                                                      const ImageOptions& options = {});

/// Makes what open_overhead_image then finds in `cache`: overviews, or a tiled copy with overviews, in a folder named after
/// the image's path; an image that has changed replaces its own. Nothing is written beside the image, and an image that is ready
/// costs nothing. Minutes for gigapixels; to be done in a Job.
/// @errors as open_overhead_image; kIo (cache not writable, disk full); kCancelled. What was in the cache then stays.
[[nodiscard]] Result<void> prepare_image(const std::filesystem::path& path,
                                         const std::filesystem::path& cache,
                                         const WorkContext& context = {});

/// The user's own folder for it: $XDG_CACHE_HOME/nadir/images or ~/.cache/nadir/images; empty where there is no home.
[[nodiscard]] std::filesystem::path usual_image_cache();

}  // namespace nadir
