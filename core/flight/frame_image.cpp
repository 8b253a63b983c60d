// SPDX-License-Identifier: Apache-2.0
#include "core/flight/frame_image.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <opencv2/imgcodecs.hpp>

#include "core/base/require.h"
#include "core/flight/grey_image.h"

namespace nadir {
namespace {

using Bytes = std::span<const std::uint8_t>;

template <typename T>
inline constexpr int kMatType = CV_8UC1;
template <>
inline constexpr int kMatType<std::uint16_t> = CV_16UC1;

template <typename T>
Result<std::vector<T>> decode_png(Bytes bytes, const std::string& name, const ImageSize& size) {
  cv::Mat image;
  try {
    // OpenCV's Mat has no constant form; imdecode does not write to its input.
    const cv::Mat buffer(1, static_cast<int>(bytes.size()), CV_8UC1,
                         const_cast<std::uint8_t*>(bytes.data()));
    image = cv::imdecode(buffer, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    image.release();
  }
  if (image.empty() || image.type() != kMatType<T> || image.cols != size.width ||
      image.rows != size.height) {
    return fail(ErrorCode::kMalformed, "{}: is damaged and cannot be decoded", name);
  }
  std::vector<T> pixels;
  pixels.reserve(image.total());
  for (int row = 0; row < image.rows; ++row) {
    pixels.insert(pixels.end(), image.ptr<T>(row), image.ptr<T>(row) + image.cols);
  }
  return pixels;
}

/// OpenCV would stretch the values of a PGM so that its largest one becomes 255; ids and depths
/// must stay as they are.
template <typename T>
std::vector<T> decode_pgm(Bytes pixels, const ImageSize& size) {
  std::vector<T> values(static_cast<std::size_t>(size.width) *
                        static_cast<std::size_t>(size.height));
  for (std::size_t i = 0; i < values.size(); ++i) {
    if constexpr (sizeof(T) == 1) {
      values[i] = pixels[i];
    } else {
      values[i] = static_cast<T>((pixels[2 * i] << 8U) | pixels[2 * i + 1]);  // High byte first.
    }
  }
  return values;
}

template <typename T>
Result<std::vector<T>> decode(Bytes bytes, const std::string& name, const ImageSize& expected) {
  constexpr int kBits = 8 * sizeof(T);
  const bool is_portable_map = is_pgm(bytes);
  if (bytes.empty()) return fail(ErrorCode::kMalformed, "{}: is empty", name);
  if (!is_portable_map && !is_png(bytes)) {
    return fail(ErrorCode::kUnsupported, "{}: is neither a PNG nor a PGM image", name);
  }
  const auto header = is_portable_map ? check_pgm(bytes, name) : check_png(bytes, name);
  if (!header) return forward_error(header);
  if (ImageSize{header->width, header->height} != expected) {
    return fail(ErrorCode::kMalformed, "{}: is {} x {} pixels, but the camera has {} x {}", name,
                header->width, header->height, expected.width, expected.height);
  }
  if (header->bits != kBits) {
    return fail(ErrorCode::kMalformed, "{}: has {} bits a pixel, but {} must have {}", name,
                header->bits, kBits == 8 ? "labels" : "depth", kBits);
  }
  if (is_portable_map) return decode_pgm<T>(bytes.subspan(header->pixels_begin), expected);
  return decode_png<T>(bytes, name, expected);
}

Result<std::vector<std::uint8_t>> encode_png(const cv::Mat& image) {
  std::vector<std::uint8_t> bytes;
  try {
    if (cv::imencode(".png", image, bytes, {cv::IMWRITE_PNG_COMPRESSION, 1})) return bytes;
  } catch (const cv::Exception&) {
    bytes.clear();
  }
  return fail(ErrorCode::kIo, "PNG encoder: {} x {} pixels failed", image.cols, image.rows);
}

}  // namespace

Result<Raster<ClassId>> decode_label_image(Bytes bytes,
                                           const std::string& name,
                                           const ImageSize& expected) {
  auto ids = decode<ClassId>(bytes, name, expected);
  if (!ids) return forward_error(ids);
  const auto is_wrong = [](ClassId id) { return id >= kClassCount && id != kUnclassified; };
  const auto wrong = std::find_if(ids->begin(), ids->end(), is_wrong);
  if (wrong != ids->end()) {
    const auto at = static_cast<int>(wrong - ids->begin());
    return fail(ErrorCode::kMalformed,
                "{}: has id {} at column {}, row {}, which is no class (0 to {}, or 255)", name,
                static_cast<int>(*wrong), at % expected.width, at / expected.width,
                kClassCount - 1);
  }
  return Raster<ClassId>(expected.width, expected.height, *std::move(ids));
}

Result<Raster<float>> decode_depth_image(Bytes bytes,
                                         const std::string& name,
                                         const ImageSize& expected,
                                         double units_per_m) {
  NADIR_REQUIRE(units_per_m > 0.0);
  const auto units = decode<std::uint16_t>(bytes, name, expected);
  if (!units) return forward_error(units);
  Raster<float> depth_m(expected.width, expected.height);
  std::transform(units->begin(), units->end(), depth_m.data(),
                 [&](std::uint16_t value) { return static_cast<float>(value / units_per_m); });
  return depth_m;
}

Result<std::vector<std::uint8_t>> encode_label_png(const Raster<ClassId>& labels) {
  NADIR_REQUIRE(!labels.empty());
  return encode_png(
      cv::Mat(labels.height(), labels.width(), CV_8UC1, const_cast<ClassId*>(labels.data())));
}

Result<std::vector<std::uint8_t>> encode_depth_png(const Raster<float>& depth_m) {
  NADIR_REQUIRE(!depth_m.empty());
  constexpr float kUnitsPerM = 1000.0F;
  constexpr float kFarthest = 65535.0F;
  cv::Mat image(depth_m.height(), depth_m.width(), CV_16UC1);
  for (int row = 0; row < depth_m.height(); ++row) {
    std::transform(depth_m.row(row).begin(), depth_m.row(row).end(), image.ptr<std::uint16_t>(row),
                   [](float depth) {
                     const float units = std::round(depth * kUnitsPerM);
                     const bool is_depth = units > 0.0F && units <= kFarthest;  // False for NaN.
                     return is_depth ? static_cast<std::uint16_t>(units) : std::uint16_t{0};
                   });
  }
  return encode_png(image);
}

}  // namespace nadir
