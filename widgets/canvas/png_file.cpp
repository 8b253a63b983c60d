// SPDX-License-Identifier: Apache-2.0
#include "widgets/canvas/png_file.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "core/base/require.h"

namespace nadir {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
constexpr std::size_t kHeaderChunkEnd = 8 + 12 + 13;  ///< Signature, then IHDR with its frame.

std::string big_endian(std::uint32_t value) {
  return {static_cast<char>(value >> 24U), static_cast<char>(value >> 16U),
          static_cast<char>(value >> 8U), static_cast<char>(value)};
}

std::uint32_t from_big_endian(std::string_view four) {
  std::uint32_t value = 0;
  for (const char byte : four) value = (value << 8U) | static_cast<unsigned char>(byte);
  return value;
}

std::uint32_t checksum(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

std::string chunk(const std::string& type, const std::string& data) {
  return big_endian(static_cast<std::uint32_t>(data.size())) + type + data +
         big_endian(checksum(type + data));
}

std::string fact_chunks(const PngFacts& facts) {
  std::string chunks;
  if (facts.dpi > 0.0) {
    constexpr double kInchesPerMetre = 1.0 / 0.0254;
    constexpr char kMetres = 1;
    std::string density =
        big_endian(static_cast<std::uint32_t>(std::lround(facts.dpi * kInchesPerMetre)));
    density += density;
    density += kMetres;
    chunks += chunk("pHYs", density);
  }
  for (const auto& [keyword, text] : facts.texts) {
    NADIR_REQUIRE(!keyword.empty() && keyword.size() < 80);
    // Keyword, end; not compressed, by no method; no language, end; no translated keyword, end; text.
    std::string data = keyword;
    data.append(5, '\0');
    data += text;
    chunks += chunk("iTXt", data);
  }
  return chunks;
}

}  // namespace

std::string encode_png(const Raster<Rgba>& pixels, const PngFacts& facts) {
  const bool is_opaque = std::all_of(pixels.values().begin(), pixels.values().end(),
                                     [](Rgba pixel) { return pixel.alpha == 255; });
  cv::Mat image(pixels.height(), pixels.width(), is_opaque ? CV_8UC3 : CV_8UC4);
  for (int row = 0; row < pixels.height(); ++row) {
    unsigned char* out = image.ptr(row);
    for (const Rgba pixel : pixels.row(row)) {
      *out++ = pixel.blue;
      *out++ = pixel.green;
      *out++ = pixel.red;
      if (!is_opaque) *out++ = pixel.alpha;
    }
  }
  // Level 3 takes a third of the time of zlib's usual 6 for a tenth more bytes.
  constexpr int kLevel = 3;
  std::vector<unsigned char> file;
  cv::imencode(".png", image, file, {cv::IMWRITE_PNG_COMPRESSION, kLevel});
  std::string bytes(file.begin(), file.end());
  bytes.insert(kHeaderChunkEnd, fact_chunks(facts));
  return bytes;
}

Result<std::map<std::string, std::string>> parse_png_texts(std::string_view bytes,
                                                           const std::string& name) {
  if (bytes.substr(0, kSignature.size()) != kSignature) {
    return fail(ErrorCode::kMalformed, "{}: is not a PNG image", name);
  }
  std::map<std::string, std::string> texts;
  std::size_t at = kSignature.size();
  while (true) {
    constexpr std::size_t kFrame = 12;  // length, type, checksum
    if (bytes.size() - at < kFrame) return fail(ErrorCode::kMalformed, "{}: is cut short", name);
    const std::size_t length = from_big_endian(bytes.substr(at, 4));
    if (bytes.size() - at - kFrame < length) {
      return fail(ErrorCode::kMalformed, "{}: is cut short", name);
    }
    const std::string_view type = bytes.substr(at + 4, 4);
    if (type == "IEND") return texts;
    if (type == "iTXt") {
      if (checksum(bytes.substr(at + 4, 4 + length)) !=
          from_big_endian(bytes.substr(at + 8 + length, 4))) {
        return fail(ErrorCode::kMalformed, "{}: a text in it is damaged", name);
      }
      const std::string_view data = bytes.substr(at + 8, length);
      const std::size_t keyword_end = data.find('\0');
      // Compressed texts and those with a language are other people's; they are passed over.
      if (keyword_end != std::string_view::npos &&
          data.substr(keyword_end, 5) == std::string_view("\0\0\0\0\0", 5)) {
        texts.emplace(data.substr(0, keyword_end), data.substr(keyword_end + 5));
      }
    }
    at += kFrame + length;
  }
}

Result<std::map<std::string, std::string>> read_png_texts(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    return fail(ErrorCode::kMalformed, "{}: is a folder and not a PNG image", path.string());
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    return fail(ErrorCode::kNotFound, "{}: {}", path.string(),
                std::filesystem::exists(path, error) ? "cannot be read" : "does not exist");
  }
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  return parse_png_texts(bytes, path.string());
}

}  // namespace nadir
