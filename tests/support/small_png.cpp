// SPDX-License-Identifier: Apache-2.0
#include "tests/support/small_png.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <optional>
#include <vector>

namespace nadir {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// As PNG counts them.
enum class ColourType : std::uint8_t { kRgb = 2, kPalette = 3, kRgba = 6 };

void append_number(std::string& file, std::uint32_t value) {
  for (const unsigned shift : {24U, 16U, 8U, 0U}) file += static_cast<char>(value >> shift);
}

void append_chunk(std::string& file, const std::string& type, const std::string& data) {
  append_number(file, static_cast<std::uint32_t>(data.size()));
  const std::string framed = type + data;
  file += framed;
  append_number(file,
                static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(framed.data()),
                                                 static_cast<uInt>(framed.size()))));
}

std::string compressed(const Bytes& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string packed(size, '\0');
  NADIR_REQUIRE(compress2(reinterpret_cast<Bytef*>(packed.data()), &size, bytes.data(),
                          static_cast<uLong>(bytes.size()), Z_BEST_COMPRESSION) == Z_OK);
  packed.resize(size);
  return packed;
}

/// Which of three neighbours is nearest to the gradient through them (PNG specification, 9.4).
int paeth(int left, int above, int above_left) {
  const int guess = left + above - above_left;
  const int to_left = std::abs(guess - left), to_above = std::abs(guess - above),
            to_corner = std::abs(guess - above_left);
  if (to_left <= to_above && to_left <= to_corner) return left;
  return to_above <= to_corner ? above : above_left;
}

/// A row by one of PNG's five filters, its number in front. @param above  The row before, zeros above the first.
Bytes filtered(const Bytes& row, const Bytes& above, std::size_t pixel_bytes, std::uint8_t filter) {
  Bytes out = {filter};
  for (std::size_t i = 0; i < row.size(); ++i) {
    const bool has_left = i >= pixel_bytes;
    const int left = has_left ? row[i - pixel_bytes] : 0;
    const int corner = has_left ? above[i - pixel_bytes] : 0;
    const std::array<int, 5> guesses = {0, left, above[i], (left + above[i]) / 2,
                                        paeth(left, above[i], corner)};
    out.push_back(static_cast<std::uint8_t>(row[i] - guesses.at(filter)));
  }
  return out;
}

/// Small where a filter has left little: what the specification recommends to choose by.
long size_of(const Bytes& bytes) {
  long sum = 0;
  for (const std::uint8_t byte : bytes) sum += std::min<int>(byte, 256 - byte);
  return sum;
}

std::string file_of(const Raster<Rgba>& pixels,
                    ColourType type,
                    const std::string& palette,
                    const std::vector<Bytes>& rows,
                    std::size_t pixel_bytes) {
  Bytes plain, chosen;
  Bytes above(rows.front().size(), 0);
  for (const Bytes& row : rows) {
    const Bytes as_is = filtered(row, above, pixel_bytes, 0);
    plain.insert(plain.end(), as_is.begin(), as_is.end());
    Bytes best = as_is;
    for (std::uint8_t filter = 1; filter < 5; ++filter) {
      Bytes other = filtered(row, above, pixel_bytes, filter);
      if (size_of(other) < size_of(best)) best = std::move(other);
    }
    chosen.insert(chosen.end(), best.begin(), best.end());
    above = row;
  }
  std::string packed = compressed(plain);
  if (type != ColourType::kPalette) {  // neighbours in a palette have nothing to do with each other
    std::string other = compressed(chosen);
    if (other.size() < packed.size()) packed = std::move(other);
  }
  std::string file = "\x89PNG\r\n\x1a\n";
  std::string header;
  append_number(header, static_cast<std::uint32_t>(pixels.width()));
  append_number(header, static_cast<std::uint32_t>(pixels.height()));
  constexpr char kBits = 8;
  header += {kBits, static_cast<char>(type), 0, 0, 0};
  append_chunk(file, "IHDR", header);
  if (!palette.empty()) append_chunk(file, "PLTE", palette);
  append_chunk(file, "IDAT", packed);
  append_chunk(file, "IEND", "");
  return file;
}

std::array<std::uint8_t, 4> channels(const Rgba& pixel) {
  return {pixel.red, pixel.green, pixel.blue, pixel.alpha};
}

/// The colours with their places in a palette; nothing where there are too many, or one that is not opaque.
std::optional<std::map<std::array<std::uint8_t, 4>, std::uint8_t>> palette_of(
    const Raster<Rgba>& pixels) {
  std::map<std::array<std::uint8_t, 4>, std::uint8_t> places;
  for (const Rgba& pixel : pixels.values()) {
    if (pixel.alpha != 255) return std::nullopt;
    places.emplace(channels(pixel), std::uint8_t{0});
    if (places.size() > 256) return std::nullopt;
  }
  std::uint8_t next = 0;
  for (auto& [colour, place] : places) place = next++;
  return places;
}

std::uint8_t nearest_of_five(std::uint8_t value) {
  constexpr int kSteps = 4;
  const int step = (value * kSteps + 127) / 255;
  return static_cast<std::uint8_t>((step * 255 + kSteps / 2) / kSteps);
}

}  // namespace

Raster<Rgba> in_few_colours(Raster<Rgba> pixels) {
  constexpr std::size_t kShare = 1000;
  std::map<std::array<std::uint8_t, 4>, std::size_t> counts;
  for (const Rgba& pixel : pixels.values()) ++counts[channels(pixel)];
  for (Rgba& pixel : pixels.values()) {
    if (counts[channels(pixel)] * kShare >= pixels.size()) continue;
    pixel = {nearest_of_five(pixel.red), nearest_of_five(pixel.green), nearest_of_five(pixel.blue),
             pixel.alpha};
  }
  return pixels;
}

std::string small_png(const Raster<Rgba>& pixels) {
  NADIR_REQUIRE(!pixels.empty());
  std::vector<Bytes> rows(static_cast<std::size_t>(pixels.height()));
  if (const auto places = palette_of(pixels)) {
    std::string palette;
    for (const auto& [colour, place] : *places) palette.append(colour.begin(), colour.end() - 1);
    for (int row = 0; row < pixels.height(); ++row) {
      for (const Rgba& pixel : pixels.row(row)) {
        rows[static_cast<std::size_t>(row)].push_back(places->at(channels(pixel)));
      }
    }
    return file_of(pixels, ColourType::kPalette, palette, rows, 1);
  }
  const bool is_opaque = std::all_of(pixels.values().begin(), pixels.values().end(),
                                     [](const Rgba& pixel) { return pixel.alpha == 255; });
  const std::size_t pixel_bytes = is_opaque ? 3 : 4;
  for (int row = 0; row < pixels.height(); ++row) {
    Bytes& bytes = rows[static_cast<std::size_t>(row)];
    for (const Rgba& pixel : pixels.row(row)) {
      const auto all = channels(pixel);
      bytes.insert(bytes.end(), all.begin(),
                   all.begin() + static_cast<std::ptrdiff_t>(pixel_bytes));
    }
  }
  return file_of(pixels, is_opaque ? ColourType::kRgb : ColourType::kRgba, "", rows, pixel_bytes);
}

}  // namespace nadir
