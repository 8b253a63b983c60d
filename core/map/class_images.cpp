// SPDX-License-Identifier: Apache-2.0
#include "core/map/class_images.h"

#include <gdal_priv.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>

#include "core/map/crs.h"

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

/// How the values of an image become brightness in [0, 255].
class Brightness {
 public:
  explicit Brightness(GDALRasterBand& band) : table_(band.GetColorTable()) {
    const char* bits = band.GetMetadataItem("NBITS", "IMAGE_STRUCTURE");
    const int type_bits = GDALGetDataTypeSizeBits(band.GetRasterDataType());
    const int known_bits = bits != nullptr ? std::atoi(bits) : type_bits;  // NOLINT(cert-err34-c)
    brightest_ = (1 << std::clamp(known_bits, 1, type_bits)) - 1;
  }

  [[nodiscard]] int of(std::int32_t value) const {
    if (table_ == nullptr) return std::clamp(value, 0, brightest_) * 255 / brightest_;
    GDALColorEntry entry{};
    table_->GetColorEntryAsRGB(value, &entry);
    return (entry.c1 + entry.c2 + entry.c3) / 3;
  }

 private:
  const GDALColorTable* table_;
  int brightest_ = 255;
};

Result<void> check_mask(GDALDataset& dataset, const std::string& name) {
  if (dataset.GetRasterCount() != 1) {
    return fail(ErrorCode::kUnsupported,
                "{}: a class image needs one channel, bright or dark, this has {}", name,
                dataset.GetRasterCount());
  }
  const GDALDataType type = dataset.GetRasterBand(1)->GetRasterDataType();
  if (type != GDT_Byte && type != GDT_UInt16) {
    return fail(ErrorCode::kUnsupported, "{}: a class image needs 8 or 16 bits, this has {}", name,
                GDALGetDataTypeName(type));
  }
  return {};
}

/// Whether two rasters of one size lie on one another, to a hundredth of a pixel.
bool are_same(const Placement& a, const Placement& b) {
  const double tolerance = 0.01 * a.crs_from_pixel.pixel_size().minCoeff();
  for (const double column : {0.0, static_cast<double>(a.width)}) {
    for (const double row : {0.0, static_cast<double>(a.height)}) {
      const Eigen::Vector2d corner(column, row);
      if (!((a.crs_from_pixel * corner - b.crs_from_pixel * corner).norm() <= tolerance)) {
        return false;
      }
    }
  }
  const OGRSpatialReference crs = crs_from_wkt(a.crs_wkt);
  return crs_from_wkt(b.crs_wkt).IsSame(&crs) != FALSE;
}

/// Painting of class images onto one another.
class Painter {
 public:
  explicit Painter(const ImportOptions& options) : options_(options) {}

  /// @returns how many cells belong to the class. @errors kMalformed: another size or place than
  /// the images before, kUnsupported, those of open_raster.
  Result<std::int64_t> paint(const ClassImage& image) {
    const GdalMessages messages;
    const std::string name = image.path.string();
    const auto dataset = open_raster(image.path, messages);
    if (!dataset) return forward_error(dataset);
    if (const auto checked = check_mask(**dataset, name); !checked) return forward_error(checked);
    if (const auto checked = take_size(**dataset, name); !checked) return forward_error(checked);
    auto placement = placement_of(**dataset, options_.crs, name, messages);
    if (!placement) return forward_error(placement);
    if (const auto checked = take_place(*placement, name); !checked) return forward_error(checked);
    return paint_cells(**dataset, image.id, name, messages);
  }

  [[nodiscard]] SourceLabels take(std::vector<std::string> notices) {
    return {std::move(labels_), std::move(placement_), std::move(notices)};
  }

 private:
  Result<void> take_size(GDALDataset& dataset, const std::string& name) {
    const int width = dataset.GetRasterXSize();
    const int height = dataset.GetRasterYSize();
    if (labels_.empty()) {
      labels_ = Raster<ClassId>(width, height, kUnclassified);
      sized_by_ = name;
    }
    if (width == labels_.width() && height == labels_.height()) return {};
    return fail(ErrorCode::kMalformed, "{}: is {} x {} pixels, but {} is {} x {}", name, width,
                height, sized_by_, labels_.width(), labels_.height());
  }

  /// One image with a place is enough for all.
  Result<void> take_place(const std::optional<Placement>& placement, const std::string& name) {
    if (!placement) return {};
    if (!placement_) {
      placement_ = placement;
      placed_by_ = name;
    }
    if (are_same(*placement_, *placement)) return {};
    return fail(ErrorCode::kMalformed, "{}: does not lie where {} lies", name, placed_by_);
  }

  Result<std::int64_t> paint_cells(GDALDataset& dataset,
                                   ClassId id,
                                   const std::string& name,
                                   const GdalMessages& messages) {
    const Brightness brightness(*dataset.GetRasterBand(1));
    const std::optional<double> no_data = no_data_of(dataset);
    const int inside = options_.inside_value.value_or(255);
    std::int64_t count = 0;
    const auto done = read_rows(dataset, name, messages,
                                [&](int row, std::span<const std::int32_t> values) -> Result<void> {
                                  ClassId* cell = labels_.row(row).data();
                                  for (const std::int32_t value : values) {
                                    // Smoothed edges: nearer to the inside value than to its
                                    // opposite. What is transparent is outside.
                                    const bool is_inside =
                                        std::abs(brightness.of(value) - inside) < 128 &&
                                        !(no_data && value == *no_data);
                                    if (is_inside) {
                                      *cell = id;
                                      ++count;
                                    }
                                    ++cell;
                                  }
                                  return {};
                                });
    if (!done) return forward_error(done);
    return count;
  }

  const ImportOptions& options_;
  Raster<ClassId> labels_;
  std::optional<Placement> placement_;
  std::string sized_by_, placed_by_;
};

}  // namespace

Result<SourceLabels> read_class_images(const fs::path& folder, const ImportOptions& options) {
  const auto paths = sorted_pngs(folder);
  if (!paths) return forward_error(paths);
  std::vector<std::string> notices;
  std::vector<ClassImage> images;
  std::string numbered;  // What was taken for what, by its number alone.
  for (const fs::path& path : *paths) {
    const std::optional<ClassId> id = class_of(path, options.remap);
    if (!id || *id == kUnclassified) {
      notices.push_back(
          fmt::format("{} stands for no class and is left out", path.filename().string()));
    } else {
      images.push_back({path, *id});
      if (!options.remap && number_in(plain_class_name(path.stem().string()))) {
        numbered += fmt::format("{}{} as {}", numbered.empty() ? "" : ", ",
                                path.filename().string(), class_info(*id).name);
      }
    }
  }
  if (!numbered.empty()) {
    notices.push_back("without --remap numbers were taken as this program's classes: " + numbered);
  }
  if (images.empty()) {
    return fail(ErrorCode::kMalformed,
                "{}: holds no class image, which is called class<N>.png or <class name>.png",
                folder.string());
  }
  std::stable_sort(images.begin(), images.end(), [](const ClassImage& a, const ClassImage& b) {
    return drawing_level(a.id) < drawing_level(b.id);
  });
  Painter painter(options);
  for (const ClassImage& image : images) {
    const auto count = painter.paint(image);
    if (!count) return forward_error(count);
    if (*count == 0) {
      notices.push_back(
          fmt::format("{} holds no cell of its class", image.path.filename().string()));
    }
  }
  return painter.take(std::move(notices));
}

}  // namespace nadir
