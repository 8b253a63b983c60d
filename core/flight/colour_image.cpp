// SPDX-License-Identifier: Apache-2.0
#include "core/flight/colour_image.h"

#include <algorithm>
#include <array>
#include <opencv2/imgcodecs.hpp>

#include "core/base/require.h"
#include "core/base/staged_output.h"
#include "core/flight/grey_image.h"
#include "core/topview/camera_model.h"

namespace nadir {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::uintmax_t kLargestFile = 1U << 30U;
constexpr int kQuality = 85;

/// Whether a JPEG marker begins a frame header (SOF0 to SOF15; three numbers among them mean
/// something else), ITU-T T.81, table B.1.
bool is_frame_header(std::uint8_t marker) {
  return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

/// Walks through the segments of a JPEG up to its pixels, and looks for its end: libraries fill up
/// with grey what is missing. @errors kMalformed.
Result<void> check_jpeg(Bytes bytes, const std::string& name) {
  const auto cut_off = [&] {
    return fail(ErrorCode::kMalformed, "{}: is cut off after {} bytes", name, bytes.size());
  };
  const auto number_at = [&](std::size_t at) { return (bytes[at] << 8) | bytes[at + 1]; };
  bool has_size = false;
  for (std::size_t at = 2;;) {
    if (at + 4 > bytes.size()) return cut_off();
    if (bytes[at] != 0xFF) return fail(ErrorCode::kMalformed, "{}: is a damaged JPEG", name);
    const std::uint8_t marker = bytes[at + 1];
    if (marker == 0xFF) {  // Filling.
      ++at;
      continue;
    }
    const auto length = static_cast<std::size_t>(number_at(at + 2));
    if (length < 2 || at + 2 + length > bytes.size()) return cut_off();
    if (is_frame_header(marker)) {
      if (length < 8) return fail(ErrorCode::kMalformed, "{}: is a damaged JPEG", name);
      const int height = number_at(at + 5);
      const int width = number_at(at + 7);
      has_size = true;
      if (width < 1 || height < 1 || width > kLargestImageSide || height > kLargestImageSide) {
        return fail(ErrorCode::kMalformed, "{}: cannot be {} x {} pixels", name, width, height);
      }
    }
    at += 2 + length;
    if (marker != 0xDA) continue;
    if (!has_size) return fail(ErrorCode::kMalformed, "{}: is a damaged JPEG", name);
    constexpr std::array<std::uint8_t, 2> kEnd{0xFF, 0xD9};
    const Bytes pixels = bytes.subspan(at);
    const auto end = std::search(pixels.rbegin(), pixels.rend(), kEnd.rbegin(), kEnd.rend());
    if (end == pixels.rend()) return cut_off();
    return {};
  }
}

}  // namespace

bool is_jpeg(Bytes bytes) {
  return bytes.size() >= 3 && bytes[0] == 0xFF && bytes[1] == 0xD8 && bytes[2] == 0xFF;
}

Result<ColourRaster> decode_colour_image(Bytes bytes, const std::string& name) {
  if (bytes.empty()) return fail(ErrorCode::kMalformed, "{}: is empty", name);
  if (is_jpeg(bytes)) {
    if (const auto whole = check_jpeg(bytes, name); !whole) return forward_error(whole);
  } else if (is_png(bytes)) {
    if (const auto whole = check_any_png(bytes, name); !whole) return forward_error(whole);
  } else {
    return fail(ErrorCode::kUnsupported, "{}: is neither a JPEG nor a PNG image", name);
  }
  cv::Mat image;
  try {
    // OpenCV's Mat has no constant form; imdecode does not write to its input.
    const cv::Mat buffer(1, static_cast<int>(bytes.size()), CV_8UC1,
                         const_cast<std::uint8_t*>(bytes.data()));
    image = cv::imdecode(buffer, cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception&) {
    image.release();
  }
  if (image.empty() || image.type() != CV_8UC3) {
    return fail(ErrorCode::kMalformed, "{}: is damaged and cannot be decoded", name);
  }
  ColourRaster colours(image.cols, image.rows);
  for (int row = 0; row < image.rows; ++row) {
    const auto* const pixels = image.ptr<cv::Vec3b>(row);  // Blue, green, red.
    std::transform(pixels, pixels + image.cols, colours.row(row).begin(), [](const cv::Vec3b& bgr) {
      return Colour{bgr[2], bgr[1], bgr[0]};
    });
  }
  return colours;
}

Result<ColourRaster> read_colour_image(const std::filesystem::path& file) {
  const auto text = read_text_file(file, kLargestFile);
  if (!text) return forward_error(text);
  return decode_colour_image({reinterpret_cast<const std::uint8_t*>(text->data()), text->size()},
                             file.string());
}

Result<std::vector<std::uint8_t>> encode_colour_jpeg(const ColourRaster& image) {
  NADIR_REQUIRE(!image.empty());
  std::vector<std::uint8_t> bytes;
  try {
    cv::Mat pixels(image.height(), image.width(), CV_8UC3);
    for (int row = 0; row < image.height(); ++row) {
      std::transform(image.row(row).begin(), image.row(row).end(), pixels.ptr<cv::Vec3b>(row),
                     [](const Colour& c) { return cv::Vec3b(c.blue, c.green, c.red); });
    }
    if (cv::imencode(".jpg", pixels, bytes, {cv::IMWRITE_JPEG_QUALITY, kQuality})) return bytes;
  } catch (const cv::Exception&) {
    bytes.clear();
  }
  return fail(ErrorCode::kIo, "JPEG encoder: {} x {} pixels failed", image.width(), image.height());
}

}  // namespace nadir
