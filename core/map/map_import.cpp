// SPDX-License-Identifier: Apache-2.0
#include "core/map/map_import.h"

#include <gdal_priv.h>

#include <algorithm>
#include <cmath>

#include "core/map/building_contours.h"
#include "core/map/class_images.h"
#include "core/map/crs.h"
#include "core/map/map_warp.h"

namespace nadir {
namespace {

namespace fs = std::filesystem;

Result<void> check_length(const std::optional<double>& length_m, std::string_view option) {
  constexpr double kSmallestMetres = 1e-3;
  constexpr double kLargestMetres = 1e5;
  if (!length_m || (*length_m >= kSmallestMetres && *length_m <= kLargestMetres)) return {};
  return fail(ErrorCode::kInvalidOptions, "{}: {} is not in [0.001, 100000] m", option, *length_m);
}

Result<void> check_options(const ImportOptions& options) {
  for (const auto& [length_m, option] :
       {std::pair(options.metres_per_pixel, "--metres-per-pixel"),
        std::pair(options.metres_per_cell, "--resolution"),
        std::pair(options.building_contours_m, "--building-contours")}) {
    if (const auto checked = check_length(length_m, option); !checked) {
      return forward_error(checked);
    }
  }
  if (options.anchor.has_value() != options.metres_per_pixel.has_value()) {
    return fail(ErrorCode::kInvalidOptions,
                "--anchor: needs --metres-per-pixel, and the other way round");
  }
  if (options.inside_value && *options.inside_value != 0 && *options.inside_value != 255) {
    return fail(ErrorCode::kInvalidOptions, "--inside: {} is not 0 or 255", *options.inside_value);
  }
  if (options.crs.empty()) return {};
  const GdalMessages messages;
  const auto crs = crs_from_text(options.crs, messages);
  if (!crs) return forward_error(crs);
  return {};
}

template <typename Pixel>
void flip_rows(Raster<Pixel>& raster) {
  for (int top = 0, bottom = raster.height() - 1; top < bottom; ++top, --bottom) {
    std::swap_ranges(raster.row(top).begin(), raster.row(top).end(), raster.row(bottom).begin());
  }
}

Result<void> check_has_one_place(const SourceLabels& source,
                                 const ImportOptions& options,
                                 const std::string& name) {
  if (source.placement && options.anchor) {
    return fail(ErrorCode::kInvalidOptions,
                "--anchor: {} has a georeference of its own, so it cannot be placed anew", name);
  }
  if (source.placement && options.flip_vertically) {
    return fail(ErrorCode::kInvalidOptions,
                "--flip: {} has a georeference of its own, which says where up is", name);
  }
  if (!source.placement && !options.anchor) {
    return fail(ErrorCode::kMalformed,
                "{}: has no georeference; place it with --anchor and --metres-per-pixel", name);
  }
  return {};
}

/// The source's own cells on a plane centred on them.
Result<MapGrid> anchored_grid(const Raster<ClassId>& labels, const ImportOptions& options) {
  const double cell_m = *options.metres_per_pixel;
  const Eigen::Vector2d half_m(0.5 * cell_m * labels.width(), 0.5 * cell_m * labels.height());
  const auto at_anchor = ProjectPlane::create(*options.anchor);
  if (!at_anchor)
    return fail(ErrorCode::kInvalidOptions, "--anchor: {}", at_anchor.error().message);
  MapGrid grid{*at_anchor, cell_m, {-half_m.x(), half_m.y()}, labels.width(), labels.height()};
  if (options.anchor_point == AnchorPoint::kCentre) return grid;
  const auto centred =
      ProjectPlane::create(at_anchor->geodetic_from_enu({half_m.x(), -half_m.y()}));
  if (!centred) return fail(ErrorCode::kInvalidOptions, "--anchor: {}", centred.error().message);
  // The corner stays where the anchor is to the last digit; the centre then is within centimetres
  // of the plane's origin.
  grid.plane = *centred;
  grid.top_left_in_enu_m = centred->enu_from_geodetic(*options.anchor);
  return grid;
}

/// Same plane, place and extent, other cells.
Result<MapGrid> resampled(const MapGrid& grid, double metres_per_cell, const std::string& name) {
  const double columns = std::ceil(grid.width * grid.metres_per_cell / metres_per_cell - 1e-6);
  const double rows = std::ceil(grid.height * grid.metres_per_cell / metres_per_cell - 1e-6);
  if (!(columns * rows <= static_cast<double>(kMaxMapCells))) {
    return fail(
        ErrorCode::kInvalidOptions,
        "--resolution: {:.4g} m makes {:.0f} x {:.0f} cells of {}, more than a map may have",
        metres_per_cell, columns, rows, name);
  }
  MapGrid finer = grid;
  finer.metres_per_cell = metres_per_cell;
  finer.width = std::max(1, static_cast<int>(columns));
  finer.height = std::max(1, static_cast<int>(rows));
  return finer;
}

Result<ColourRaster> import_image(const Placement& labels_placement,
                                  const MapGrid& grid,
                                  const ImportOptions& options,
                                  bool is_taken_cell_by_cell,
                                  const WorkContext& context) {
  const GdalMessages messages;
  const std::string name = options.image.string();
  const auto dataset = open_raster(options.image, messages);
  if (!dataset) return forward_error(dataset);
  // A world file without reference system is in the labels' one; anchored labels have none.
  std::string crs;
  if (!has_own_crs(**dataset)) crs = options.anchor ? options.crs : labels_placement.crs_wkt;
  const auto own_placement = placement_of(**dataset, crs, name, messages);
  if (!own_placement) return forward_error(own_placement);
  auto colours = read_colours(**dataset, name, messages);
  if (!colours) return forward_error(colours);
  if (own_placement->has_value()) {
    return warp_colours(*colours, **own_placement, grid, name, context);
  }
  if (colours->width() != labels_placement.width || colours->height() != labels_placement.height) {
    return fail(ErrorCode::kMalformed,
                "{}: has no georeference and its {} x {} pixels are not the labels' {} x {}", name,
                colours->width(), colours->height(), labels_placement.width,
                labels_placement.height);
  }
  if (options.flip_vertically) flip_rows(*colours);
  if (is_taken_cell_by_cell) return colours;
  return warp_colours(*colours, labels_placement, grid, name, context);
}

/// @returns how many cells were cleared.
std::int64_t clear_what_no_overhead_holds(Raster<ClassId>& labels) {
  std::int64_t count = 0;
  for (ClassId& id : labels.values()) {
    if (id == kUnclassified || (can_lie_in_overhead(id) && !is_movable(id))) continue;
    id = kUnclassified;
    ++count;
  }
  return count;
}

/// What a file or folder is called; only a file's name ends with its kind.
std::string default_name(const fs::path& source, bool is_folder) {
  const fs::path named = source.has_filename() ? source : source.parent_path();
  return (is_folder ? named.filename() : named.stem()).string();
}

Result<void> check_not_stopped(const WorkContext& context, const std::string& name) {
  if (context.is_stopped()) return fail(ErrorCode::kCancelled, "{}: import was cancelled", name);
  return {};
}

}  // namespace

Result<ImportedMap> import_map(const fs::path& path,
                               const ImportOptions& options,
                               const WorkContext& context) {
  if (const auto checked = check_options(options); !checked) return forward_error(checked);
  const std::string name = path.string();
  context.report(0.0, "reading labels");
  std::error_code error;
  const bool is_folder = fs::is_directory(path, error);
  auto source = is_folder ? read_class_images(path, options) : read_label_image(path, options);
  if (!source) return forward_error(source);
  if (const auto checked = check_not_stopped(context, name); !checked) {
    return forward_error(checked);
  }
  if (const auto checked = check_has_one_place(*source, options, name); !checked) {
    return forward_error(checked);
  }
  std::vector<std::string> notices = std::move(source->notices);
  if (options.flip_vertically) flip_rows(source->labels);

  // Where the source lies and which cells the map gets.
  std::optional<Placement> placement = source->placement;
  std::optional<MapGrid> grid;
  bool is_taken_cell_by_cell = false;
  if (options.anchor) {
    auto anchored = anchored_grid(source->labels, options);
    if (!anchored) return forward_error(anchored);
    placement = placement_on(*anchored);
    auto wanted =
        resampled(*anchored, options.metres_per_cell.value_or(anchored->metres_per_cell), name);
    if (!wanted) return forward_error(wanted);
    is_taken_cell_by_cell = wanted->metres_per_cell == anchored->metres_per_cell;
    grid = std::move(*wanted);
  } else if (auto own = own_grid(*placement);
             own &&
             options.metres_per_cell.value_or(own->metres_per_cell) == own->metres_per_cell) {
    is_taken_cell_by_cell = true;
    grid = std::move(*own);
  } else {
    auto planned = plan_grid(*placement, options.metres_per_cell, name);
    if (!planned) return forward_error(planned);
    for (const std::string& notice : planned->notices)
      notices.push_back(fmt::format("{}: {}", name, notice));
    grid = std::move(planned->grid);
  }

  Raster<ClassId> labels = std::move(source->labels);
  if (!is_taken_cell_by_cell) {
    auto warped = warp_labels(labels, *placement, *grid, name, context);
    if (!warped) return forward_error(warped);
    labels = std::move(*warped);
  }
  if (const std::int64_t cleared = clear_what_no_overhead_holds(labels); cleared > 0) {
    notices.push_back(fmt::format(
        "{} cells of car, pedestrian or sky were left unclassified, for no overhead holds them",
        cleared));
  }
  if (options.building_contours_m) {
    labels = with_building_contours(labels, grid->metres_per_cell, *options.building_contours_m);
  }
  std::optional<ColourRaster> image;
  if (!options.image.empty()) {
    auto imported = import_image(*placement, *grid, options, is_taken_cell_by_cell, context);
    if (!imported) return forward_error(imported);
    image = std::move(*imported);
  }
  if (const auto checked = check_not_stopped(context, name); !checked) {
    return forward_error(checked);
  }
  OverheadMap map{options.name.empty() ? default_name(path, is_folder) : options.name, grid->plane,
                  grid->metres_per_cell, grid->top_left_in_enu_m, std::move(labels)};
  return ImportedMap{std::move(map), std::move(image), std::move(notices)};
}

}  // namespace nadir
