// SPDX-License-Identifier: Apache-2.0
#include "core/map/map_warp.h"

#include <cpl_string.h>
#include <gdal_alg.h>
#include <gdal_priv.h>
#include <gdalwarper.h>

#include <array>
#include <memory>

#include "core/base/require.h"

namespace nadir {
namespace {

struct TransformerCloser {
  void operator()(void* transformer) const { GDALDestroyTransformer(transformer); }
};
using Transformer = std::unique_ptr<void, TransformerCloser>;

struct WarpOptionsCloser {
  void operator()(GDALWarpOptions* options) const { GDALDestroyWarpOptions(options); }
};

/// How bytes are warped.
struct WarpKind {
  int channels = 1;
  GDALResampleAlg resampling = GRA_NearestNeighbour;
  std::optional<double>
      nothing;  ///< Source value that is no value; also what empty cells become, otherwise 0.
};

/// A dataset over memory that belongs to the caller: `channels` interleaved bytes a pixel.
GdalDataset dataset_over(void* bytes, const Placement& placement, int channels) {
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
  NADIR_REQUIRE(driver != nullptr);
  GdalDataset dataset(driver->Create("", placement.width, placement.height, 0, GDT_Byte, nullptr));
  NADIR_REQUIRE(dataset != nullptr);
  for (int channel = 0; channel < channels; ++channel) {
    std::array<char, 64> pointer{};
    const int length = CPLPrintPointer(pointer.data(), static_cast<std::uint8_t*>(bytes) + channel,
                                       static_cast<int>(pointer.size()) - 1);
    pointer.at(static_cast<std::size_t>(length)) = '\0';
    CPLStringList options;
    options.SetNameValue("DATAPOINTER", pointer.data());
    options.SetNameValue("PIXELOFFSET", fmt::format("{}", channels).c_str());
    options.SetNameValue("LINEOFFSET",
                         fmt::format("{}", std::int64_t{channels} * placement.width).c_str());
    NADIR_REQUIRE(dataset->AddBand(GDT_Byte, options.List()) == CE_None);
  }
  set_placement(*dataset, placement);
  return dataset;
}

int CPL_STDCALL report_progress(double fraction, const char*, void* context) {
  const auto& work = *static_cast<const WorkContext*>(context);
  work.report(fraction, "warping onto the map's plane");
  return work.is_stopped() ? FALSE : TRUE;
}

Result<void> warp(GDALDataset& source,
                  GDALDataset& target,
                  const WarpKind& kind,
                  const std::string& name,
                  const WorkContext& context,
                  const GdalMessages& messages) {
  constexpr double kMaxErrorPixels = 0.02;
  const Transformer exact(GDALCreateGenImgProjTransformer2(&source, &target, nullptr));
  if (exact == nullptr) {
    return fail(ErrorCode::kMalformed, "{}: cannot be warped ({})", name, messages.text());
  }
  const Transformer fast(
      GDALCreateApproxTransformer(GDALGenImgProjTransform, exact.get(), kMaxErrorPixels));
  const std::unique_ptr<GDALWarpOptions, WarpOptionsCloser> options(GDALCreateWarpOptions());
  options->hSrcDS = &source;
  options->hDstDS = &target;
  options->eResampleAlg = kind.resampling;
  options->pfnTransformer = GDALApproxTransform;
  options->pTransformerArg = fast.get();
  options->pfnProgress = report_progress;
  options->pProgressArg = const_cast<WorkContext*>(&context);
  GDALWarpInitDefaultBandMapping(options.get(), kind.channels);
  if (kind.nothing) {
    GDALWarpInitSrcNoDataReal(options.get(), *kind.nothing);
    GDALWarpInitDstNoDataReal(options.get(), *kind.nothing);
  }
  options->papszWarpOptions = CSLSetNameValue(options->papszWarpOptions, "INIT_DEST",
                                              fmt::format("{}", kind.nothing.value_or(0)).c_str());
  GDALWarpOperation operation;
  const bool is_done = operation.Initialize(options.get()) == CE_None &&
                       operation.ChunkAndWarpImage(0, 0, target.GetRasterXSize(),
                                                   target.GetRasterYSize()) == CE_None;
  if (context.is_stopped()) return fail(ErrorCode::kCancelled, "{}: import was cancelled", name);
  if (!is_done) {
    return fail(ErrorCode::kMalformed, "{}: cannot be warped ({})", name, messages.text());
  }
  return {};
}

template <typename Pixel>
Result<Raster<Pixel>> warp_raster(const Raster<Pixel>& source,
                                  const Placement& placement,
                                  const MapGrid& grid,
                                  const WarpKind& kind,
                                  const std::string& name,
                                  const WorkContext& context) {
  static_assert(sizeof(Pixel) == 1 || sizeof(Pixel) == 3);
  NADIR_REQUIRE(source.width() == placement.width && source.height() == placement.height);
  const GdalMessages messages;
  Raster<Pixel> target(grid.width, grid.height);
  {
    // GDAL's interface for reading and writing is one, hence the cast; the source is only read.
    const GdalDataset from =
        dataset_over(const_cast<Pixel*>(source.data()), placement, kind.channels);
    const GdalDataset to = dataset_over(target.data(), placement_on(grid), kind.channels);
    const auto done = warp(*from, *to, kind, name, context, messages);
    if (!done) return forward_error(done);
  }
  return target;
}

}  // namespace

Result<Raster<ClassId>> warp_labels(const Raster<ClassId>& source,
                                    const Placement& placement,
                                    const MapGrid& grid,
                                    const std::string& name,
                                    const WorkContext& context) {
  const WarpKind kind{1, GRA_NearestNeighbour, double{kUnclassified}};
  return warp_raster(source, placement, grid, kind, name, context);
}

Result<ColourRaster> warp_colours(const ColourRaster& source,
                                  const Placement& placement,
                                  const MapGrid& grid,
                                  const std::string& name,
                                  const WorkContext& context) {
  const WarpKind kind{3, GRA_Bilinear, std::nullopt};
  return warp_raster(source, placement, grid, kind, name, context);
}

}  // namespace nadir
