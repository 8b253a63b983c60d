// SPDX-License-Identifier: Apache-2.0
#include "core/map/tile_source.h"

#include <gdal_alg.h>
#include <gdal_priv.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace nadir {
namespace {

/// A side of the lattice of places that stand for a tile which would cost too much.
constexpr int kSampledSide = 16;

/// Bytes, or numbers that a stretch is for.
template <typename Value>
constexpr GDALDataType kGdalType = GDT_Byte;
template <>
constexpr GDALDataType kGdalType<float> = GDT_Float32;
template <>
constexpr GDALDataType kGdalType<std::int32_t> = GDT_Int32;

tl::unexpected<Error> unreadable_tile(const TileSource& source,
                                      const TileWindow& window,
                                      const GdalMessages& messages) {
  return fail(ErrorCode::kMalformed, "{}: cannot be read at {} ({})", source.name, window.where,
              messages.text());
}

/// Some bands of a window, interleaved by pixel.
template <typename Value>
Result<std::vector<Value>> read_window(const TileSource& source,
                                       const TileWindow& window,
                                       std::vector<int> bands,
                                       GDALRIOResampleAlg resampling) {
  const std::size_t count = bands.size();
  std::vector<Value> values(count * static_cast<std::size_t>(window.width) *
                            static_cast<std::size_t>(window.height));
  const GdalMessages messages;
  GDALRasterIOExtraArg extra;
  INIT_RASTERIO_EXTRA_ARG(extra);
  extra.eResampleAlg = resampling;
  const auto size = static_cast<GSpacing>(sizeof(Value));
  const auto pixel = static_cast<GSpacing>(count) * size;
  const CPLErr error = source.on_plane->RasterIO(
      GF_Read, window.cells[0], window.cells[1], window.cells[2], window.cells[3], values.data(),
      window.width, window.height, kGdalType<Value>, static_cast<int>(count), bands.data(), pixel,
      pixel * window.width, size, &extra);
  if (error != CE_None || messages.has_failed()) return unreadable_tile(source, window, messages);
  return values;
}

std::vector<int> bands_of(const TileSource& source) {
  std::vector<int> bands = source.channels;
  if (source.alpha > 0) bands.push_back(source.alpha);
  return bands;
}

/// Pixels of the file, or of an overview, that a window costs.
double pixels_behind(const TileSource& source, const TileWindow& window) {
  GDALRasterBand& band = *source.on_plane->GetRasterBand(source.channels.front());
  const double cells = static_cast<double>(window.cells[2]) * window.cells[3];
  const double wanted_width =
      static_cast<double>(source.place.width) * window.width / window.cells[2];
  double least = cells;
  for (int i = 0; i < band.GetOverviewCount(); ++i) {
    GDALRasterBand* const overview = band.GetOverview(i);
    // GDAL takes one that is a little too coarse as well.
    if (overview == nullptr || overview->GetXSize() < 0.9 * wanted_width) continue;
    const double share = static_cast<double>(overview->GetXSize()) / source.place.width *
                         overview->GetYSize() / source.place.height;
    least = std::min(least, cells * share);
  }
  return least;
}

std::uint8_t stretched(double value, const Stretch& stretch) {
  const double share = (value - stretch.low) / (stretch.high - stretch.low);
  return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
}

/// One pixel's colour from the values of its bands.
template <typename Value>
ImagePixel pixel_of(const TileSource& source, const Value* values) {
  std::array<std::uint8_t, 3> colour{};
  std::uint8_t alpha = 255;
  const std::size_t channels = source.channels.size();
  if (source.alpha > 0) {
    alpha = static_cast<std::uint8_t>(std::lround(static_cast<double>(values[channels])));
  }
  for (std::size_t i = 0; i < colour.size(); ++i) {
    const std::size_t channel = std::min(i, channels - 1);
    const auto value = static_cast<double>(values[channel]);
    if (!std::isfinite(value)) return {0, 0, 0, 0};
    colour.at(i) = source.stretch.empty() ? static_cast<std::uint8_t>(values[channel])
                                          : stretched(value, source.stretch[channel]);
  }
  if (alpha == 0) return {0, 0, 0, 0};
  return {colour[0], colour[1], colour[2], alpha};
}

template <typename Value>
Result<ImageRaster> read_averaged(const TileSource& source, const TileWindow& window) {
  const std::vector<int> bands = bands_of(source);
  const auto values = read_window<Value>(source, window, bands, GRIORA_Average);
  if (!values) return forward_error(values);
  ImageRaster pixels(window.width, window.height);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    pixels.values()[i] = pixel_of(source, values->data() + i * bands.size());
  }
  return pixels;
}

/// A single pixel of the file; clear where it holds nothing.
Result<ImagePixel> read_place(const TileSource& source,
                              const Eigen::Vector2d& pixel,
                              const TileWindow& window,
                              const GdalMessages& messages) {
  GDALDataset& file = *source.pixels;
  const double column = std::floor(pixel.x()), row = std::floor(pixel.y());
  if (!(column >= 0.0 && row >= 0.0 && column < file.GetRasterXSize() &&
        row < file.GetRasterYSize())) {
    return ImagePixel{0, 0, 0, 0};
  }
  const int x = static_cast<int>(column), y = static_cast<int>(row);
  std::array<float, 4> values{0.0F, 0.0F, 0.0F, 255.0F};
  std::uint8_t seen = 255;
  bool is_read =
      file.GetRasterBand(source.file_channels.front())
          ->GetMaskBand()
          ->RasterIO(GF_Read, x, y, 1, 1, &seen, 1, 1, GDT_Byte, 0, 0, nullptr) == CE_None;
  for (std::size_t i = 0; i < source.file_channels.size() && is_read; ++i) {
    is_read = file.GetRasterBand(source.file_channels[i])
                  ->RasterIO(GF_Read, x, y, 1, 1, &values.at(i), 1, 1, GDT_Float32, 0, 0,
                             nullptr) == CE_None;
  }
  if (!is_read || messages.has_failed()) return unreadable_tile(source, window, messages);
  values.at(source.file_channels.size()) = seen;
  return pixel_of(source, values.data());
}

Result<ImageRaster> read_sampled(const TileSource& source, const TileWindow& window) {
  ImageRaster lattice(kSampledSide, kSampledSide, ImagePixel{0, 0, 0, 0});
  const GdalMessages messages;
  for (int row = 0; row < kSampledSide; ++row) {
    for (int column = 0; column < kSampledSide; ++column) {
      const Eigen::Vector2d share((column + 0.5) / kSampledSide, (row + 0.5) / kSampledSide);
      const auto pixel = source.pixel_of_cell({window.cells[0] + share.x() * window.cells[2],
                                               window.cells[1] + share.y() * window.cells[3]});
      if (!pixel) continue;
      const auto read = read_place(source, *pixel, window, messages);
      if (!read) return forward_error(read);
      lattice.at(column, row) = *read;
    }
  }
  ImageRaster pixels(window.width, window.height);
  for (int row = 0; row < window.height; ++row) {
    for (int column = 0; column < window.width; ++column) {
      pixels.at(column, row) =
          lattice.at(column * kSampledSide / window.width, row * kSampledSide / window.height);
    }
  }
  return pixels;
}

/// Values of a band, and whether they stand for something, read from an overview or from the band itself.
Result<std::vector<float>> sampled_values(GDALDataset& pixels,
                                          int band_number,
                                          const std::string& name,
                                          const GdalMessages& messages) {
  constexpr int kMostSide = 512;
  GDALRasterBand& whole = *pixels.GetRasterBand(band_number);
  GDALRasterBand* band = &whole;
  if (const int levels = whole.GetOverviewCount();
      levels > 0 && whole.GetOverview(levels - 1) != nullptr) {
    band = whole.GetOverview(levels - 1);
  }
  const int width = band->GetXSize(), height = band->GetYSize();
  const bool is_quick = std::int64_t{width} * height <= kQuickPixels;
  const int columns = std::min(width, is_quick ? kMostSide : kSampledSide);
  const int rows = std::min(height, is_quick ? kMostSide : kSampledSide);
  const auto count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  std::vector<float> values(count);
  std::vector<std::uint8_t> seen(count);
  const auto read = [&](GDALRasterBand& from, GDALDataType type, void* into, std::size_t size) {
    if (is_quick) {
      return from.RasterIO(GF_Read, 0, 0, width, height, into, columns, rows, type, 0, 0,
                           nullptr) == CE_None;
    }
    for (std::size_t i = 0; i < count; ++i) {
      const auto column = static_cast<std::int64_t>(i) % columns,
                 row = static_cast<std::int64_t>(i) / columns;
      if (from.RasterIO(GF_Read, static_cast<int>((2 * column + 1) * width / (2 * columns)),
                        static_cast<int>((2 * row + 1) * height / (2 * rows)), 1, 1,
                        static_cast<std::byte*>(into) + i * size, 1, 1, type, 0, 0,
                        nullptr) != CE_None) {
        return false;
      }
    }
    return true;
  };
  if (!read(*band, GDT_Float32, values.data(), sizeof(float)) ||
      !read(*band->GetMaskBand(), GDT_Byte, seen.data(), 1) || messages.has_failed()) {
    return fail(ErrorCode::kMalformed, "{}: cannot be read ({})", name, messages.text());
  }
  std::vector<float> found;
  for (std::size_t i = 0; i < count; ++i) {
    if (seen[i] > 0 && std::isfinite(values[i])) found.push_back(values[i]);
  }
  return found;
}

}  // namespace

void GdalTransformerCloser::operator()(void* transformer) const {
  GDALDestroyTransformer(transformer);
}

Result<Raster<std::int32_t>> TileSource::read_numbers(const TileWindow& window) const {
  const std::lock_guard lock(mutex);
  auto values = read_window<std::int32_t>(*this, window, {1}, GRIORA_NearestNeighbour);
  if (!values) return forward_error(values);
  return Raster<std::int32_t>(window.width, window.height, std::move(*values));
}

Result<ImageRaster> TileSource::read_colours(const TileWindow& window) const {
  const std::lock_guard lock(mutex);
  if (is_waiting) return ImageRaster(window.width, window.height, ImagePixel{0, 0, 0, 0});
  const GdalMessages messages;  // looking for overviews has some too
  if (on_plane_from_pixels != nullptr &&
      pixels_behind(*this, window) > static_cast<double>(kQuickPixels)) {
    return read_sampled(*this, window);
  }
  return stretch.empty() ? read_averaged<std::uint8_t>(*this, window)
                         : read_averaged<float>(*this, window);
}

std::optional<Eigen::Vector2d> TileSource::pixel_of_cell(const Eigen::Vector2d& cell) const {
  if (on_plane_from_pixels == nullptr) return std::nullopt;
  double x = cell.x(), y = cell.y(), z = 0.0;
  int is_done = FALSE;
  const GdalMessages messages;
  GDALGenImgProjTransform(on_plane_from_pixels.get(), TRUE, 1, &x, &y, &z, &is_done);
  if (is_done == FALSE || !std::isfinite(x) || !std::isfinite(y)) return std::nullopt;
  return Eigen::Vector2d(x, y);
}

Result<Stretch> stretch_of_band(GDALDataset& pixels,
                                int band,
                                const std::string& name,
                                const GdalMessages& messages) {
  constexpr double kDarkest = 0.02, kLightest = 0.98;
  auto values = sampled_values(pixels, band, name, messages);
  if (!values) return forward_error(values);
  if (values->empty()) return Stretch{0.0, 65535.0};
  const auto at_share = [&](double share) {
    const auto index = static_cast<std::ptrdiff_t>(share * static_cast<double>(values->size() - 1));
    std::nth_element(values->begin(), values->begin() + index, values->end());
    return static_cast<double>((*values)[static_cast<std::size_t>(index)]);
  };
  Stretch stretch{at_share(kDarkest), at_share(kLightest)};
  if (!(stretch.high > stretch.low)) {  // one value everywhere is middle grey
    stretch = {stretch.low - 1.0, stretch.low + 1.0};
  }
  return stretch;
}

}  // namespace nadir
