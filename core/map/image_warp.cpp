// SPDX-License-Identifier: Apache-2.0
#include "core/map/image_warp.h"

#include <cpl_string.h>
#include <gdal_alg.h>
#include <gdal_priv.h>
#include <gdalwarper.h>

#include <array>
#include <cmath>
#include <cstdlib>

#include "core/map/crs.h"

namespace nadir {
namespace {

struct ImageWarpOptionsCloser {
  void operator()(GDALWarpOptions* options) const { GDALDestroyWarpOptions(options); }
};

/// From the image's pixels to the grid's cells. Null where there is no way.
GdalTransformer transformer_onto(const Placement& placement, const MapGrid& grid) {
  const std::array<double, 6> from = placement.crs_from_pixel.to_gdal();
  const std::array<double, 6> to = placement_on(grid).crs_from_pixel.to_gdal();
  OGRSpatialReference crs = crs_from_wkt(placement.crs_wkt);
  OGRSpatialReference plane = crs_from_wkt(grid.plane.wkt());
  return GdalTransformer(
      GDALCreateGenImgProjTransformer4(OGRSpatialReference::ToHandle(&crs), from.data(),
                                       OGRSpatialReference::ToHandle(&plane), to.data(), nullptr));
}

/// Says which values of the channels stand for nothing, if all of them have one.
void set_no_data(GDALWarpOptions& options, const ImageFile& image) {
  std::vector<double> values;
  for (const int channel : image.channels) {
    int has_value = FALSE;
    const double value = image.pixels->GetRasterBand(channel)->GetNoDataValue(&has_value);
    if (has_value == FALSE) return;
    values.push_back(value);
  }
  GDALWarpInitSrcNoDataReal(&options, 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) options.padfSrcNoDataReal[i] = values[i];
  options.papszWarpOptions = CSLSetNameValue(options.papszWarpOptions, "UNIFIED_SRC_NODATA", "YES");
}

/// A view of the image on the grid; its last band is alpha, up to 255.
GdalDataset warped_view(const ImageFile& image,
                        const Placement& placement,
                        const MapGrid& grid,
                        bool is_same) {
  // Pixels of an edge that bends are this far from where they belong, at most.
  constexpr double kMaxErrorPixels = 0.02;
  GdalTransformer exact = transformer_onto(placement, grid);
  if (exact == nullptr) return nullptr;
  const std::unique_ptr<GDALWarpOptions, ImageWarpOptionsCloser> options(GDALCreateWarpOptions());
  options->hSrcDS = image.pixels.get();
  options->eResampleAlg = is_same ? GRA_NearestNeighbour : GRA_Bilinear;
  const int count = static_cast<int>(image.channels.size());
  GDALWarpInitDefaultBandMapping(options.get(), count);
  for (int i = 0; i < count; ++i) {
    options->panSrcBands[i] = image.channels[static_cast<std::size_t>(i)];
  }
  options->nSrcAlphaBand = image.alpha;
  options->nDstAlphaBand = count + 1;
  if (image.alpha == 0) {
    set_no_data(*options, image);
  } else if (image.pixels->GetRasterBand(image.alpha)->GetRasterDataType() == GDT_UInt16) {
    options->papszWarpOptions =
        CSLSetNameValue(options->papszWarpOptions, "SRC_ALPHA_MAX", "65535");
  }
  options->papszWarpOptions = CSLSetNameValue(options->papszWarpOptions, "DST_ALPHA_MAX", "255");
  options->papszWarpOptions = CSLSetNameValue(options->papszWarpOptions, "INIT_DEST", "0");
  void* const fast =
      GDALCreateApproxTransformer(GDALGenImgProjTransform, exact.release(), kMaxErrorPixels);
  GDALApproxTransformerOwnsSubtransformer(fast, TRUE);
  options->pfnTransformer = GDALApproxTransform;
  options->pTransformerArg = fast;  // the view's, from now on
  std::array<double, 6> geotransform = placement_on(grid).crs_from_pixel.to_gdal();
  return GdalDataset(GDALDataset::FromHandle(GDALCreateWarpedVRT(
      image.pixels.get(), grid.width, grid.height, geotransform.data(), options.get())));
}

/// Of what is no byte, or has fewer bits than one. Empty where bytes are colours.
Result<std::vector<Stretch>> stretches_of(const ImageFile& image,
                                          const std::string& name,
                                          const GdalMessages& messages) {
  std::vector<Stretch> stretches;
  for (const int channel : image.channels) {
    GDALRasterBand& band = *image.pixels->GetRasterBand(channel);
    const char* const bits = band.GetMetadataItem("NBITS", "IMAGE_STRUCTURE");
    const int count = bits == nullptr ? 8 : std::atoi(bits);
    if (band.GetRasterDataType() == GDT_Byte) {
      if (count < 1 || count >= 8) return std::vector<Stretch>();
      stretches.push_back({0.0, std::ldexp(1.0, count) - 1.0});
    } else if (image.is_sequential && image.readiness != ImageReadiness::kReady) {
      stretches.push_back({0.0, 65535.0});  // nothing is shown yet
    } else {
      const auto stretch = stretch_of_band(*image.pixels, channel, name, messages);
      if (!stretch) return forward_error(stretch);
      stretches.push_back(*stretch);
    }
  }
  return stretches;
}

}  // namespace

Result<std::unique_ptr<TileSource>> tiles_on_plane(ImageFile image,
                                                   const Placement& placement,
                                                   const MapGrid& grid,
                                                   bool is_same,
                                                   const std::string& name) {
  const GdalMessages messages;
  auto stretches = stretches_of(image, name, messages);
  if (!stretches) return forward_error(stretches);
  auto source = std::make_unique<TileSource>();
  source->name = name;
  source->place = {grid.metres_per_cell, grid.top_left_in_enu_m, grid.width, grid.height};
  source->on_plane = warped_view(image, placement, grid, is_same);
  source->on_plane_from_pixels = transformer_onto(placement, grid);
  if (source->on_plane == nullptr || source->on_plane_from_pixels == nullptr) {
    return fail(ErrorCode::kMalformed, "{}: cannot be warped onto the plane ({})", name,
                messages.text());
  }
  source->stretch = std::move(*stretches);
  source->is_waiting = image.is_sequential && image.readiness != ImageReadiness::kReady;
  source->file_channels = image.channels;
  for (int i = 1; i <= static_cast<int>(image.channels.size()); ++i) source->channels.push_back(i);
  source->alpha = static_cast<int>(image.channels.size()) + 1;
  source->file = std::move(image.file);
  source->pixels = std::move(image.pixels);
  return source;
}

}  // namespace nadir
