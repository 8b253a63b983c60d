// SPDX-License-Identifier: Apache-2.0
#include "core/flight/grey_image.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/topview/camera_model.h"

namespace nadir {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::array<std::uint8_t, 8> kPngSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::uint32_t kLargestSide = kLargestImageSide;

/// The checksum of PNG, annex D of ISO/IEC 15948: polynomial 0xEDB88320, a table of 256 words.
constexpr std::array<std::uint32_t, 256> make_crc_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < table.size(); ++byte) {
    std::uint32_t crc = byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1U) != 0 ? 0xEDB88320U ^ (crc >> 1U) : crc >> 1U;
    table[byte] = crc;
  }
  return table;
}
constexpr std::array<std::uint32_t, 256> kCrcTable = make_crc_table();

std::uint32_t crc_of(Bytes bytes) {
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const std::uint8_t byte : bytes) crc = kCrcTable[(crc ^ byte) & 0xFFU] ^ (crc >> 8U);
  return ~crc;
}

std::uint32_t word_at(Bytes bytes, std::size_t at) {
  return (static_cast<std::uint32_t>(bytes[at]) << 24U) |
         (static_cast<std::uint32_t>(bytes[at + 1]) << 16U) |
         (static_cast<std::uint32_t>(bytes[at + 2]) << 8U) | bytes[at + 3];
}

/// What the first part of a PNG says.
struct PngHeader {
  std::uint32_t width = 0, height = 0;
  int bits = 0;
  int colour_type = 0;
};

Result<PngHeader> read_ihdr(Bytes data, const std::string& name) {
  constexpr std::size_t kLength = 13;
  if (data.size() != kLength) {
    return fail(ErrorCode::kMalformed, "{}: is a damaged PNG without a header", name);
  }
  return PngHeader{word_at(data, 0), word_at(data, 4), data[8], data[9]};
}

Result<void> check_size(const PngHeader& header, const std::string& name) {
  const auto [width, height, bits, colour_type] = header;
  if (width >= 1 && height >= 1 && width <= kLargestSide && height <= kLargestSide) return {};
  return fail(ErrorCode::kMalformed, "{}: cannot be {} x {} pixels", name, width, height);
}

Result<void> check_grey(const PngHeader& header, const std::string& name) {
  if (header.colour_type != 0) {
    return fail(ErrorCode::kMalformed, "{}: {}, but it must be grey", name,
                header.colour_type == 3   ? "has a palette"
                : header.colour_type == 4 ? "has transparency"
                                          : "is in colour");
  }
  if (header.bits != 8 && header.bits != 16) {
    return fail(ErrorCode::kMalformed, "{}: has {} bits a pixel, not 8 or 16", name, header.bits);
  }
  return {};
}

/// Walks through all parts. `check` looks at the header before the rest is looked at.
template <typename Check>
Result<PngHeader> walk_png(Bytes bytes, const std::string& name, Check check) {
  const auto cut_off = [&] {
    return fail(ErrorCode::kMalformed, "{}: is cut off after {} bytes", name, bytes.size());
  };
  constexpr std::size_t kFrame = 12;  // Length, type and checksum around the data of a part.
  std::optional<PngHeader> header;
  for (std::size_t at = kPngSignature.size();;) {
    if (at > bytes.size() || bytes.size() - at < kFrame) return cut_off();
    const std::size_t length = word_at(bytes, at);
    if (length > bytes.size() - at - kFrame) return cut_off();
    const std::string type(bytes.begin() + static_cast<std::ptrdiff_t>(at + 4),
                           bytes.begin() + static_cast<std::ptrdiff_t>(at + 8));
    if (crc_of(bytes.subspan(at + 4, length + 4)) != word_at(bytes, at + 8 + length)) {
      return fail(ErrorCode::kMalformed, "{}: is damaged, for a checksum is wrong", name);
    }
    if (!header) {
      const auto read = read_ihdr(type == "IHDR" ? bytes.subspan(at + 8, length) : Bytes(), name);
      if (!read) return forward_error(read);
      header = *read;
      if (const auto good = check(*header); !good) return forward_error(good);
      if (const auto good = check_size(*header, name); !good) return forward_error(good);
    }
    if (type == "IEND") return *header;
    at += length + kFrame;
  }
}

/// The next number of a PGM header; `#` starts a comment up to the end of the line. Nothing where
/// there is none.
std::optional<int> next_number(Bytes bytes, std::size_t& at) {
  const auto is_space = [](std::uint8_t byte) {
    return byte == ' ' || (byte >= '\t' && byte <= '\r');
  };
  while (at < bytes.size() && (is_space(bytes[at]) || bytes[at] == '#')) {
    if (bytes[at] == '#') {
      while (at < bytes.size() && bytes[at] != '\n') ++at;
    } else {
      ++at;
    }
  }
  constexpr int kTooLarge = 1'000'000;
  int number = 0;
  const std::size_t begin = at;
  for (; at < bytes.size() && bytes[at] >= '0' && bytes[at] <= '9'; ++at) {
    number = std::min(kTooLarge, number * 10 + (bytes[at] - '0'));
  }
  if (at == begin) return {};
  return number;
}

}  // namespace

bool is_png(Bytes bytes) {
  // A file that is cut off inside its signature is still a PNG that is cut off.
  const std::size_t length = std::min(bytes.size(), kPngSignature.size());
  return length >= 4 &&
         std::equal(kPngSignature.begin(),
                    kPngSignature.begin() + static_cast<std::ptrdiff_t>(length), bytes.begin());
}

bool is_pgm(Bytes bytes) { return bytes.size() >= 2 && bytes[0] == 'P' && bytes[1] == '5'; }

Result<GreyImageHeader> check_png(Bytes bytes, const std::string& name) {
  const auto header =
      walk_png(bytes, name, [&](const PngHeader& found) { return check_grey(found, name); });
  if (!header) return forward_error(header);
  return GreyImageHeader{static_cast<int>(header->width), static_cast<int>(header->height),
                         header->bits};
}

Result<void> check_any_png(Bytes bytes, const std::string& name) {
  const auto header = walk_png(bytes, name, [](const PngHeader&) { return Result<void>(); });
  if (!header) return forward_error(header);
  return {};
}

Result<GreyImageHeader> check_pgm(Bytes bytes, const std::string& name) {
  std::size_t at = 2;
  std::array<int, 3> numbers{};
  constexpr std::array<std::string_view, 3> kNames{"width", "height", "largest value"};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto number = next_number(bytes, at);
    const int largest = i == 2 ? 65535 : kLargestImageSide;
    if (!number || *number < 1 || *number > largest) {
      return fail(ErrorCode::kMalformed, "{}: has no valid {} in its PGM header", name, kNames[i]);
    }
    numbers[i] = *number;
  }
  const auto [width, height, largest] = numbers;
  const GreyImageHeader header{width, height, largest > 255 ? 16 : 8, at + 1};
  const std::size_t size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                           static_cast<std::size_t>(header.bits / 8);
  if (header.pixels_begin > bytes.size() || bytes.size() - header.pixels_begin < size) {
    return fail(ErrorCode::kMalformed, "{}: is cut off after {} bytes", name, bytes.size());
  }
  return header;
}

}  // namespace nadir
