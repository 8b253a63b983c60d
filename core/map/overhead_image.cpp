// SPDX-License-Identifier: Apache-2.0
#include "core/map/overhead_image.h"

#include <gdal_priv.h>

#include <array>
#include <utility>

#include "core/base/require.h"
#include "core/base/staged_output.h"
#include "core/geo/world_file.h"
#include "core/map/crs.h"
#include "core/map/image_file.h"
#include "core/map/image_warp.h"
#include "core/map/map_warp.h"

namespace nadir {
namespace {

namespace fs = std::filesystem;

constexpr double kFarthestImageM = 1e6;

/// Where an image says it lies, and how it comes to say so.
struct SaidPlace {
  ImagePlace place = ImagePlace::kNone;
  Placement placement;
};

/// What GDAL makes of a world file is looked at once more, for it takes "12 feet" for twelve and passes over what is cut short.
/// @errors kMalformed.
Result<void> check_world_file(GDALDataset& dataset, const fs::path& path, bool has_place) {
  const auto beside = world_file_beside(path);
  if (!beside) return {};
  bool is_used = !has_place;
  char** const files = dataset.GetFileList();
  for (char** file = files; file != nullptr && *file != nullptr; ++file) {
    is_used = is_used || fs::path(*file).filename() == beside->filename();
  }
  CSLDestroy(files);
  if (!is_used) return {};
  const auto text = read_text_file(*beside, 65'536);
  if (!text) return forward_error(text);
  const auto parsed = parse_world_file(*text, beside->string());
  if (!parsed) return forward_error(parsed);
  if (has_place) return {};
  return fail(ErrorCode::kMalformed, "{}: is no world file as other programs read them",
              beside->string());
}

/// By the file itself and what lies beside it. @errors as open_overhead_image.
Result<SaidPlace> said_place(GDALDataset& dataset,
                             const fs::path& path,
                             const std::string& asked_crs,
                             const GdalMessages& messages) {
  const std::string name = path.string();
  std::array<double, 6> geotransform{};
  const bool has_place =
      dataset.GetGeoTransform(geotransform.data()) == CE_None || dataset.GetGCPCount() >= 3;
  if (const auto checked = check_world_file(dataset, path, has_place); !checked) {
    return forward_error(checked);
  }
  if (!has_place) return SaidPlace{};
  std::string crs = asked_crs;
  if (crs.empty() && !has_own_crs(dataset)) {
    auto beside = crs_beside(path, messages);
    if (!beside) return forward_error(beside);
    crs = std::move(*beside);
    if (crs.empty()) return SaidPlace{ImagePlace::kWithoutSystem, {}};
  }
  auto placement = placement_of(dataset, crs, name, messages);
  if (!placement) return forward_error(placement);
  if (!*placement) return SaidPlace{};
  return SaidPlace{ImagePlace::kOwn, std::move(**placement)};
}

/// The days that a file may say, the likeliest to be the picture's own first.
std::optional<ImageDate> date_of(GDALDataset& dataset, const fs::path& path) {
  struct Tag {
    const char *key, *domain, *words;
  };
  for (const Tag& tag : {Tag{"ACQUISITIONDATETIME", "IMAGERY", "its acquisition time"},
                         Tag{"ACQUISITIONDATETIME", "", "its acquisition time"},
                         Tag{"EXIF_DateTimeOriginal", "", "its camera"},
                         Tag{"TIFFTAG_DATETIME", "", "its TIFF date"}}) {
    const char* const text = dataset.GetMetadataItem(tag.key, tag.domain);
    const auto day = text != nullptr ? day_of(text) : std::nullopt;
    if (day) return ImageDate{*day, tag.words};
  }
  const auto day = day_in_name(path.filename().string());
  return day ? std::optional(ImageDate{*day, "its name"}) : std::nullopt;
}

/// A grid, and whether its cells are the image's own pixels.
struct ImageGrid {
  PlannedGrid planned;
  bool is_same = false;
};

/// A metre a pixel from the origin. The plane is there for want of another.
ImageGrid grid_without_place(const ImageFile& image, const std::optional<ProjectPlane>& plane) {
  const ProjectPlane any = plane.value_or(ProjectPlane::create({0.0, 0.0}).value());
  return {{MapGrid{any, 1.0, Eigen::Vector2d::Zero(), image.pixels->GetRasterXSize(),
                   image.pixels->GetRasterYSize()},
           Eigen::Vector2d::Ones(),
           {}},
          true};
}

/// @errors as open_overhead_image.
Result<ImageGrid> grid_of(const Placement& placement,
                          const std::optional<ProjectPlane>& asked,
                          const std::string& name) {
  if (const auto own = own_grid(placement, kMaxImageCells);
      own && (!asked || *asked == own->plane)) {
    return ImageGrid{{*own, Eigen::Vector2d::Constant(own->metres_per_cell), {}}, true};
  }
  std::optional<ProjectPlane> plane = asked;
  // Looks at the coordinates too.
  const auto centred = plane_centred_on(placement, name);
  if (!centred) return forward_error(centred);
  if (!plane) plane = *centred;
  const double distance_m = plane->enu_from_geodetic(centred->origin()).norm();
  if (!(distance_m <= kFarthestImageM)) {
    return fail(ErrorCode::kUnsupported, "{}: lies {:.0f} km from the map", name,
                distance_m / 1000.0);
  }
  auto planned = plan_grid_on(*plane, placement, std::nullopt, name, kMaxImageCells);
  if (!planned) return forward_error(planned);
  return ImageGrid{std::move(*planned), false};
}

}  // namespace

Result<OpenedImage> open_overhead_image(const fs::path& path, const ImageOptions& options) {
  const std::string name = path.string();
  NADIR_REQUIRE(!options.enu_from_pixels || options.plane);
  const GdalMessages messages;
  auto file = open_image_file(path, messages);
  if (!file) return forward_error(file);
  OverheadImage image;
  image.path = path;
  image.width = file->pixels->GetRasterXSize();
  image.height = file->pixels->GetRasterYSize();
  image.plane = options.plane;
  image.date = date_of(file->said(), path);
  image.readiness = file->readiness;

  SaidPlace said;
  if (options.enu_from_pixels) {
    if (const auto inverse = options.enu_from_pixels->inverse(); !inverse) {
      return forward_error(inverse, name);
    }
    said = {ImagePlace::kByHand,
            {*options.enu_from_pixels, options.plane->wkt(), image.width, image.height}};
  } else {
    auto found = said_place(file->said(), path, options.crs, messages);
    if (!found) return forward_error(found);
    said = std::move(*found);
  }
  image.place = said.place;
  const bool is_placed = image.place == ImagePlace::kOwn || image.place == ImagePlace::kByHand;
  auto grid = is_placed ? grid_of(said.placement, options.plane, name)
                        : Result<ImageGrid>(grid_without_place(*file, options.plane));
  if (!grid) return forward_error(grid);
  if (!is_placed) {
    said.placement = placement_on(grid->planned.grid);
  } else {
    image.plane = grid->planned.grid.plane;
    image.ground_m_per_pixel = grid->planned.ground_m_per_pixel;
    image.notices = std::move(grid->planned.notices);
  }
  if (image.place == ImagePlace::kOwn) {
    const OGRSpatialReference crs = crs_from_wkt(said.placement.crs_wkt);
    image.crs_name = crs.GetName() != nullptr ? crs.GetName() : "";
  }

  if (image.readiness != ImageReadiness::kReady) {
    if (const auto prepared = prepared_pixels(path, options.cache)) {
      auto cached = open_prepared_pixels(*prepared, messages);
      if (cached && cached->pixels->GetRasterXSize() == image.width &&
          cached->pixels->GetRasterYSize() == image.height) {
        file = std::move(cached);
        image.readiness = ImageReadiness::kReady;
      }
    }
  }
  auto source =
      tiles_on_plane(std::move(*file), said.placement, grid->planned.grid, grid->is_same, name);
  if (!source) return forward_error(source);
  return OpenedImage{std::move(image), OverheadTiles(std::move(*source))};
}

}  // namespace nadir
