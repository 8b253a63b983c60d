// SPDX-License-Identifier: Apache-2.0
#include "core/map/image_file.h"

#include <cpl_string.h>
#include <gdal_priv.h>
#include <gdal_utils.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "core/base/staged_output.h"
#include "core/map/crs.h"

namespace nadir {
namespace {

namespace fs = std::filesystem;

bool is_driver(GDALDataset& dataset, std::string_view name) {
  const GDALDriver* const driver = dataset.GetDriver();
  return driver != nullptr && name == driver->GetDescription();
}

/// Where the file ends before its pixels do. Reads none. @errors kMalformed.
Result<void> check_is_whole(GDALDataset& dataset, const fs::path& path) {
  // Of more blocks some are looked at, the last among them.
  constexpr std::int64_t kMostLooks = 100'000;
  if (!is_driver(dataset, "GTiff")) return {};
  std::error_code error;
  const auto size = fs::file_size(path, error);
  if (error) return {};
  const char* const interleave = dataset.GetMetadataItem("INTERLEAVE", "IMAGE_STRUCTURE");
  const bool is_by_band = interleave != nullptr && std::string_view(interleave) == "BAND";
  for (int number = 1; number <= (is_by_band ? dataset.GetRasterCount() : 1); ++number) {
    GDALRasterBand& band = *dataset.GetRasterBand(number);
    int width = 0, height = 0;
    band.GetBlockSize(&width, &height);
    const std::int64_t columns = (std::int64_t{band.GetXSize()} + width - 1) / width;
    const std::int64_t rows = (std::int64_t{band.GetYSize()} + height - 1) / height;
    const std::int64_t step = std::max<std::int64_t>(1, columns * rows / kMostLooks);
    std::int64_t looked = 0, beyond = 0;
    for (std::int64_t i = columns * rows - 1; i >= 0; i -= step, ++looked) {
      const auto item = [&](const char* what) {
        const auto key = fmt::format("BLOCK_{}_{}_{}", what, i % columns, i / columns);
        const char* const text = band.GetMetadataItem(key.c_str(), "TIFF");
        return text == nullptr ? 0ULL : std::strtoull(text, nullptr, 10);
      };
      beyond += item("OFFSET") + item("SIZE") > size ? 1 : 0;
    }
    if (beyond > 0) {
      return fail(ErrorCode::kMalformed,
                  "{}: is cut short: {} of {} blocks of pixels lie beyond its end", path.string(),
                  beyond, looked);
    }
  }
  return {};
}

/// Colours as red, green, blue and alpha instead of a palette. @errors kMalformed.
Result<GdalDataset> without_palette(GDALDataset& file,
                                    const std::string& name,
                                    const GdalMessages& messages) {
  CPLStringList words;
  for (const char* const word : {"-of", "VRT", "-expand", "rgba", "-a_nodata", "none"}) {
    words.AddString(word);
  }
  GDALTranslateOptions* const options = GDALTranslateOptionsNew(words.List(), nullptr);
  int fault = 0;
  GdalDataset view(
      GDALDataset::FromHandle(GDALTranslate("", GDALDataset::ToHandle(&file), options, &fault)));
  GDALTranslateOptionsFree(options);
  if (view == nullptr) {
    return fail(ErrorCode::kMalformed, "{}: its palette cannot be read ({})", name,
                messages.text());
  }
  return view;
}

/// Which bands are colours, by their interpretation, else by their order. @errors kUnsupported.
Result<void> find_bands(ImageFile& image, const std::string& name) {
  GDALDataset& dataset = *image.pixels;
  const int count = dataset.GetRasterCount();
  const auto band_of = [&](GDALColorInterp interpretation) {
    for (int i = 1; i <= count; ++i) {
      if (dataset.GetRasterBand(i)->GetColorInterpretation() == interpretation) return i;
    }
    return 0;
  };
  image.alpha = band_of(GCI_AlphaBand);
  image.channels = {band_of(GCI_RedBand), band_of(GCI_GreenBand), band_of(GCI_BlueBand)};
  if (std::count(image.channels.begin(), image.channels.end(), 0) > 0) {
    image.channels.clear();
    for (int i = 1; i <= count; ++i) {
      if (i != image.alpha) image.channels.push_back(i);
    }
    image.channels.resize(image.channels.size() < 3 ? 1 : 3);
  }
  for (const int channel : image.channels) {
    const GDALDataType type =
        channel > 0 ? dataset.GetRasterBand(channel)->GetRasterDataType() : GDT_Unknown;
    if (type == GDT_Unknown || GDALDataTypeIsComplex(type) != FALSE) {
      return fail(ErrorCode::kUnsupported, "{}: has no band of colours ({})", name,
                  GDALGetDataTypeName(type));
    }
  }
  return {};
}

/// Of compressed rows, and of blocks that are larger than anybody waits for.
bool is_sequential(const ImageFile& image) {
  GDALDataset& said = image.said();
  for (const char* const name : {"PNG", "JPEG", "WEBP"}) {
    if (is_driver(said, name)) return true;
  }
  int width = 0, height = 0;
  said.GetRasterBand(1)->GetBlockSize(&width, &height);
  return std::int64_t{width} * height > kQuickPixels;
}

ImageReadiness readiness_of(const ImageFile& image) {
  GDALRasterBand& band = *image.pixels->GetRasterBand(image.channels.front());
  if (std::int64_t{band.GetXSize()} * band.GetYSize() <= kQuickPixels) {
    return ImageReadiness::kReady;
  }
  // Averages of a palette's numbers would be none, and a mask gets no overviews.
  const int levels = band.GetOverviewCount();
  const bool has_mask = image.alpha == 0 && (band.GetMaskFlags() & GMF_PER_DATASET) != 0;
  if (image.is_sequential || image.file != nullptr || (has_mask && levels == 0)) {
    return ImageReadiness::kWantsCopy;
  }
  GDALRasterBand* const coarsest = levels > 0 ? band.GetOverview(levels - 1) : nullptr;
  const bool is_quick = coarsest != nullptr &&
                        std::int64_t{coarsest->GetXSize()} * coarsest->GetYSize() <= kQuickPixels;
  return is_quick ? ImageReadiness::kReady : ImageReadiness::kWantsOverviews;
}

std::string in_capitals(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char letter) {
    return letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter;
  });
  return text;
}

}  // namespace

Result<ImageFile> open_image_file(const fs::path& path, const GdalMessages& messages) {
  const std::string name = path.string();
  std::error_code error;
  if (!fs::exists(path, error)) return fail(ErrorCode::kNotFound, "{}: no such file", name);
  if (fs::is_directory(path, error)) {
    return fail(ErrorCode::kMalformed, "{}: is a folder, not an image", name);
  }
  const char* const drivers[] = {"GTiff", "PNG", "JPEG", "WEBP", "JP2OpenJPEG", "MBTiles", nullptr};
  ImageFile image;
  image.pixels.reset(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers));
  if (image.pixels == nullptr) {
    return fail(ErrorCode::kMalformed,
                "{}: is no readable GeoTIFF, PNG, JPEG, WebP, JPEG 2000 or MBTiles image ({})",
                name, messages.text());
  }
  const std::int64_t width = image.pixels->GetRasterXSize();
  const std::int64_t height = image.pixels->GetRasterYSize();
  if (width < 1 || height < 1 || image.pixels->GetRasterCount() < 1) {
    return fail(ErrorCode::kMalformed, "{}: holds no pixel", name);
  }
  if (width * height > kMaxImageCells) {
    return fail(ErrorCode::kUnsupported,
                "{}: {} x {} pixels are more than the {} that can be shown", name, width, height,
                kMaxImageCells);
  }
  if (const auto whole = check_is_whole(*image.pixels, path); !whole) return forward_error(whole);
  if (image.pixels->GetRasterBand(1)->GetColorTable() != nullptr) {
    image.file = std::move(image.pixels);
    auto view = without_palette(*image.file, name, messages);
    if (!view) return forward_error(view);
    image.pixels = std::move(*view);
  }
  if (const auto found = find_bands(image, name); !found) return forward_error(found);
  image.is_sequential = is_sequential(image);
  image.readiness = readiness_of(image);
  return image;
}

Result<ImageFile> open_prepared_pixels(const fs::path& pixels, const GdalMessages& messages) {
  const char* const drivers[] = {"GTiff", "VRT", nullptr};
  ImageFile image;
  image.pixels.reset(GDALDataset::Open(pixels.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers));
  if (image.pixels == nullptr) {
    return fail(ErrorCode::kMalformed, "{}: cannot be read ({})", pixels.string(), messages.text());
  }
  if (const auto found = find_bands(image, pixels.string()); !found) return forward_error(found);
  return image;
}

std::optional<fs::path> world_file_beside(const fs::path& image) {
  const std::string extension = image.extension().string();  // ".png"
  std::vector<std::string> endings{".wld"};
  if (extension.size() > 2) {
    endings.push_back({'.', extension[1], extension.back(), 'w'});
    endings.push_back(extension + "w");
  }
  for (const std::string& ending : endings) {
    for (const std::string& written : {ending, in_capitals(ending)}) {
      const fs::path beside = fs::path(image).replace_extension(written);
      std::error_code error;
      if (fs::is_regular_file(beside, error)) return beside;
    }
  }
  return std::nullopt;
}

Result<std::string> crs_beside(const fs::path& image, const GdalMessages& messages) {
  constexpr std::uintmax_t kMostBytes = 65'536;
  for (const char* const ending : {".prj", ".PRJ"}) {
    const fs::path beside = fs::path(image).replace_extension(ending);
    std::error_code error;
    if (!fs::is_regular_file(beside, error)) continue;
    auto text = read_text_file(beside, kMostBytes);
    if (!text) return forward_error(text);
    const auto crs = crs_from_text(*text, messages);
    if (!crs) {
      return fail(ErrorCode::kMalformed, "{}: holds no coordinate reference system",
                  beside.string());
    }
    return text;
  }
  return std::string();
}

}  // namespace nadir
