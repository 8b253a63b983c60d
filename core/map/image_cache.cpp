// SPDX-License-Identifier: Apache-2.0
#include <cpl_string.h>
#include <gdal_priv.h>
#include <gdal_utils.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "core/base/hash.h"
#include "core/base/staged_output.h"
#include "core/map/image_file.h"
#include "core/map/overhead_image.h"

namespace nadir {
namespace {

namespace fs = std::filesystem;

// An image's folder in the cache holds one of the two kinds of pixels. A view's overviews lie beside it.
constexpr std::string_view kCacheNote = "image.txt";
constexpr std::string_view kCopiedPixels = "pixels.tif";
constexpr std::string_view kViewedPixels = "pixels.vrt";
constexpr std::string_view kViewOverviews = "pixels.vrt.ovr";

fs::path absolute_path(const fs::path& image) {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(image, error);
  return error ? fs::absolute(image, error) : whole;
}

fs::path folder_in_cache(const fs::path& image, const fs::path& cache) {
  return cache / Hash().add(absolute_path(image).string()).text();
}

/// What tells a state of an image's file from others.
std::string note_of(const fs::path& image) {
  std::error_code error;
  const auto bytes = fs::file_size(image, error);
  const auto changed = fs::last_write_time(image, error).time_since_epoch().count();
  return fmt::format("{}\n{} bytes, written at {}\n", absolute_path(image).string(), bytes,
                     changed);
}

/// A part of the work, for GDAL.
struct WorkPart {
  const WorkContext& context;
  double from, to;
  const char* activity;
};

int CPL_STDCALL report_part(double fraction, const char*, void* argument) {
  const auto& part = *static_cast<const WorkPart*>(argument);
  part.context.report(part.from + fraction * (part.to - part.from), part.activity);
  return part.context.is_stopped() ? FALSE : TRUE;
}

tl::unexpected<Error> failed_preparing(const std::string& name,
                                       const WorkContext& context,
                                       const GdalMessages& messages) {
  if (context.is_stopped()) {
    return fail(ErrorCode::kCancelled, "{}: making its overviews was cancelled", name);
  }
  return fail(ErrorCode::kIo, "{}: its overviews cannot be made ({})", name, messages.text());
}

bool has_holes(const ImageFile& image) {
  return image.pixels->GetRasterBand(image.channels.front())->GetMaskFlags() != GMF_ALL_VALID;
}

/// Tiled, lossless; holes become alpha where they are a mask.
bool copy_tiled(const ImageFile& image, const fs::path& target, WorkPart part) {
  GDALRasterBand& band = *image.pixels->GetRasterBand(image.channels.front());
  std::vector<std::string> words{
      "-of", "GTiff",    "-co", "TILED=YES",       "-co", "COMPRESS=DEFLATE",
      "-co", "ZLEVEL=1", "-co", "BIGTIFF=IF_SAFER"};
  const GDALDataType type = band.GetRasterDataType();
  if (band.GetMetadataItem("NBITS", "IMAGE_STRUCTURE") == nullptr &&
      (type == GDT_Byte || type == GDT_UInt16 || type == GDT_Int16)) {
    words.insert(words.end(), {"-co", "PREDICTOR=2"});
  }
  for (const int channel : image.channels) {
    words.insert(words.end(), {"-b", fmt::format("{}", channel)});
  }
  const bool has_mask = (band.GetMaskFlags() & GMF_PER_DATASET) != 0;
  if (image.alpha > 0 || has_mask) {
    words.insert(words.end(), {"-b", image.alpha > 0 ? fmt::format("{}", image.alpha) : "mask"});
    words.insert(words.end(), {fmt::format("-colorinterp_{}", image.channels.size() + 1), "alpha"});
  }
  CPLStringList list;
  for (const std::string& word : words) list.AddString(word.c_str());
  GDALTranslateOptions* const options = GDALTranslateOptionsNew(list.List(), nullptr);
  if (options == nullptr) return false;
  GDALTranslateOptionsSetProgress(options, report_part, &part);
  int fault = 0;
  const GdalDataset made(GDALDataset::FromHandle(
      GDALTranslate(target.c_str(), GDALDataset::ToHandle(image.pixels.get()), options, &fault)));
  GDALTranslateOptionsFree(options);
  return made != nullptr && fault == 0;
}

/// Down to one that a tile holds. @param access  GA_Update puts them into the file, GA_ReadOnly beside it.
bool build_overviews(const fs::path& pixels, GDALAccess access, bool is_picture, WorkPart part) {
  const GdalDataset dataset(GDALDataset::Open(
      pixels.c_str(), GDAL_OF_RASTER | (access == GA_Update ? GDAL_OF_UPDATE : GDAL_OF_READONLY)));
  if (dataset == nullptr) return false;
  std::vector<int> levels;
  const int side = std::max(dataset->GetRasterXSize(), dataset->GetRasterYSize());
  for (int level = 2; side / level >= kTileSide / 2; level *= 2) levels.push_back(level);
  CPLStringList options;
  if (access == GA_ReadOnly) {
    options.SetNameValue("BIGTIFF", "IF_SAFER");
    options.SetNameValue("SPARSE_OK", "TRUE");
    options.SetNameValue("INTERLEAVE", "PIXEL");
    options.SetNameValue("COMPRESS", is_picture ? "JPEG" : "DEFLATE");
    if (is_picture) {
      options.SetNameValue("JPEG_QUALITY", "85");
      options.SetNameValue("PHOTOMETRIC", "YCBCR");
    }
  }
  return dataset->BuildOverviews("AVERAGE", static_cast<int>(levels.size()), levels.data(), 0,
                                 nullptr, report_part, &part, options.List()) == CE_None;
}

/// A file that points to the image, so that overviews can lie beside it and not beside the image.
bool write_view(const ImageFile& image, const fs::path& target) {
  GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName("VRT");
  if (driver == nullptr) return false;
  const GdalDataset made(
      driver->CreateCopy(target.c_str(), image.pixels.get(), FALSE, nullptr, nullptr, nullptr));
  return made != nullptr;
}

}  // namespace

std::optional<fs::path> prepared_pixels(const fs::path& image, const fs::path& cache) {
  if (cache.empty()) return std::nullopt;
  const fs::path folder = folder_in_cache(image, cache);
  const auto note = read_text_file(folder / kCacheNote, 65'536);
  if (!note || *note != note_of(image)) return std::nullopt;
  std::error_code error;
  for (const std::string_view kind : {kCopiedPixels, kViewedPixels}) {
    if (fs::exists(folder / kind, error)) return folder / kind;
  }
  return std::nullopt;
}

Result<void> prepare_image(const fs::path& path,
                           const fs::path& cache,
                           const WorkContext& context) {
  const std::string name = path.string();
  const GdalMessages messages;
  const auto image = open_image_file(absolute_path(path), messages);
  if (!image) return forward_error(image);
  if (image->readiness == ImageReadiness::kReady || prepared_pixels(path, cache)) return {};
  std::error_code error;
  fs::create_directories(cache, error);
  const std::array<std::string_view, 4> entries{kCacheNote, kCopiedPixels, kViewedPixels,
                                                kViewOverviews};
  auto staged = StagedOutput::folder(folder_in_cache(path, cache), kCacheNote, entries);
  if (!staged) return forward_error(staged);
  // Of the state that is read now: one that changes meanwhile is prepared again.
  const std::string note = note_of(path);
  bool is_done = false;
  if (image->readiness == ImageReadiness::kWantsCopy) {
    const fs::path target = staged->path() / kCopiedPixels;
    is_done = copy_tiled(*image, target, {context, 0.0, 0.6, "copying the image"}) &&
              build_overviews(target, GA_Update, false, {context, 0.6, 1.0, "making overviews"});
  } else {
    const fs::path target = staged->path() / kViewedPixels;
    const bool is_picture = image->pixels->GetRasterCount() == 3 && !has_holes(*image) &&
                            image->pixels->GetRasterBand(1)->GetRasterDataType() == GDT_Byte;
    is_done =
        write_view(*image, target) &&
        build_overviews(target, GA_ReadOnly, is_picture, {context, 0.0, 1.0, "making overviews"});
  }
  if (!is_done || context.is_stopped()) return failed_preparing(name, context, messages);
  if (const auto written = write_text_file(staged->path() / kCacheNote, note); !written) {
    return forward_error(written);
  }
  return staged->commit();
}

fs::path usual_image_cache() {
  for (const auto& [variable, below] :
       {std::pair("XDG_CACHE_HOME", ""), std::pair("HOME", ".cache")}) {
    const char* const value =
        std::getenv(variable);  // NOLINT(concurrency-mt-unsafe): nobody sets any
    if (value != nullptr && fs::path(value).is_absolute()) {
      return fs::path(value) / below / "nadir" / "images";
    }
  }
  return {};
}

}  // namespace nadir
