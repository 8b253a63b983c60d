// SPDX-License-Identifier: Apache-2.0
#include "core/map/class_images.h"

#include <gdal_priv.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>

namespace nadir {
namespace {

namespace fs = std::filesystem;

struct ClassImage {
  fs::path path;
  ClassId id = kUnclassified;
};

/// "class3" or "class_3" -> 3.
std::optional<int> number_in(const std::string& plain_stem) {
  constexpr std::string_view kPrefix = "class";
  if (plain_stem.rfind(kPrefix, 0) != 0) return std::nullopt;
  const char* first = plain_stem.data() + kPrefix.size();
  const char* last = plain_stem.data() + plain_stem.size();
  int number = 0;
  const auto [end, error] = std::from_chars(first, last, number);
  if (error != std::errc() || end != last || number < 0 || number > 255) return std::nullopt;
  return number;
}

/// The class that a file's name stands for; nothing where it stands for none.
std::optional<ClassId> class_of(const fs::path& path, const std::optional<ClassRemap>& remap) {
  const std::string stem = path.stem().string();
  if (const auto number = number_in(plain_class_name(stem))) {
    if (remap) return remap->find_id(*number).value_or(remap->unknown());
    return *number < kClassCount ? std::optional<ClassId>(static_cast<ClassId>(*number))
                                 : std::nullopt;
  }
  if (remap) {
    if (const auto id = remap->find_name(stem)) return id;
  }
  return class_from_name(stem);
}

Result<std::vector<fs::path>> sorted_pngs(const fs::path& folder) {
  std::vector<fs::path> paths;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::string extension = entry->path().extension().string();
    for (char& letter : extension) {
      if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    }
    if (extension == ".png") paths.push_back(entry->path());
  }
  if (error) return fail(ErrorCode::kIo, "{}: {}", folder.string(), error.message());
  std::sort(paths.begin(), paths.end());
  return paths;
}

int position_in_painting_order(ClassId id) {
  const auto* const found = std::find(kPaintingOrder.begin(), kPaintingOrder.end(), id);
  return static_cast<int>(found - kPaintingOrder.begin());
}

/// Brightness of each pixel in [0, 255], whatever the number of bits.
Result<Raster<std::uint8_t>> read_mask(GDALDataset& dataset,
                                       const std::string& name,
                                       const GdalMessages& messages) {
  auto mask = read_ids(dataset, name, messages);
  if (!mask) return mask;
  GDALRasterBand& band = *dataset.GetRasterBand(1);
  const GDALColorTable* table = band.GetColorTable();
  const char* bits_text = band.GetMetadataItem("NBITS", "IMAGE_STRUCTURE");
  const int bits = bits_text != nullptr ? std::atoi(bits_text) : 8;  // NOLINT(cert-err34-c)
  std::array<std::uint8_t, 256> brightness{};
  for (int value = 0; value < 256; ++value) {
    int level = value;
    if (table != nullptr) {
      GDALColorEntry entry{};
      table->GetColorEntryAsRGB(value, &entry);
      level = (entry.c1 + entry.c2 + entry.c3) / 3;
    } else if (bits >= 1 && bits < 8) {
      level = std::min(255, value * 255 / ((1 << bits) - 1));
    }
    brightness.at(static_cast<std::size_t>(value)) = static_cast<std::uint8_t>(level);
  }
  for (std::uint8_t& value : mask->values()) value = brightness[value];
  return mask;
}

/// Paints one class. @returns how many cells belong to it. @errors kMalformed: another size than
/// the images before.
Result<std::int64_t> paint(const ClassImage& image,
                           const ImportOptions& options,
                           SourceLabels& source,
                           const std::string& first_name) {
  const GdalMessages messages;
  const std::string name = image.path.string();
  const auto dataset = open_raster(image.path, messages);
  if (!dataset) return forward_error(dataset);
  const auto mask = read_mask(**dataset, name, messages);
  if (!mask) return forward_error(mask);
  if (source.labels.empty()) {
    source.labels = Raster<ClassId>(mask->width(), mask->height(), kUnclassified);
    const auto placement = placement_of(**dataset, options.crs, name, messages);
    if (!placement) return forward_error(placement);
    source.placement = *placement;
  }
  if (mask->width() != source.labels.width() || mask->height() != source.labels.height()) {
    return fail(ErrorCode::kMalformed, "{}: is {} x {} pixels, but {} is {} x {}", name,
                mask->width(), mask->height(), first_name, source.labels.width(),
                source.labels.height());
  }
  std::int64_t count = 0;
  for (std::size_t i = 0; i < mask->size(); ++i) {
    const int value = mask->values()[i];
    // Smoothed edges: nearer to the inside value than to its opposite.
    if (std::abs(value - options.inside_value) >= 128) continue;
    source.labels.values()[i] = image.id;
    ++count;
  }
  return count;
}

}  // namespace

Result<SourceLabels> read_class_images(const fs::path& folder, const ImportOptions& options) {
  const auto paths = sorted_pngs(folder);
  if (!paths) return forward_error(paths);
  SourceLabels source;
  std::vector<ClassImage> images;
  for (const fs::path& path : *paths) {
    const std::optional<ClassId> id = class_of(path, options.remap);
    if (!id || *id == kUnclassified) {
      source.notices.push_back(
          fmt::format("{} stands for no class and is left out", path.filename().string()));
    } else {
      images.push_back({path, *id});
    }
  }
  if (images.empty()) {
    return fail(ErrorCode::kMalformed,
                "{}: holds no class image, which is called class<N>.png or <class name>.png",
                folder.string());
  }
  std::stable_sort(images.begin(), images.end(), [](const ClassImage& a, const ClassImage& b) {
    return position_in_painting_order(a.id) < position_in_painting_order(b.id);
  });
  for (const ClassImage& image : images) {
    const auto count = paint(image, options, source, images.front().path.string());
    if (!count) return forward_error(count);
    if (*count == 0) {
      source.notices.push_back(
          fmt::format("{} holds no cell of its class", image.path.filename().string()));
    }
  }
  return source;
}

Result<SourceLabels> read_label_image(const fs::path& path, const ImportOptions& options) {
  const GdalMessages messages;
  const std::string name = path.string();
  const auto dataset = open_raster(path, messages);
  if (!dataset) return forward_error(dataset);
  SourceLabels source;
  auto placement = placement_of(**dataset, options.crs, name, messages);
  if (!placement) return forward_error(placement);
  source.placement = std::move(*placement);
  auto ids = read_ids(**dataset, name, messages);
  if (!ids) return forward_error(ids);
  if (options.remap) {
    // GDAL knows the names of a GeoTIFF only once its place was asked for, as it was above.
    std::vector<std::string> names;
    for (char** entry = (*dataset)->GetRasterBand(1)->GetCategoryNames();
         entry != nullptr && *entry != nullptr; ++entry) {
      names.emplace_back(*entry);
    }
    source.labels = options.remap->with_names(names).apply(std::move(*ids));
    return source;
  }
  for (const ClassId id : ids->values()) {
    if (id < kClassCount || id == kUnclassified) continue;
    return fail(ErrorCode::kMalformed,
                "{}: id {} is no class; name the source's classes with --remap", name,
                static_cast<int>(id));
  }
  source.labels = std::move(*ids);
  return source;
}

}  // namespace nadir
