// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <zlib.h>

#include <cstdint>
#include <string>
#include <vector>

namespace nadir {

struct PngChunk {
  std::string type, data;
  bool is_whole = false;     ///< Its checksum is right.
  std::size_t begin_at = 0;  ///< Of its length, in the file.
};

[[nodiscard]] inline std::uint32_t png_checksum(const std::string& bytes) {
  return static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

[[nodiscard]] inline std::uint32_t png_number(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    value = (value << 8U) | static_cast<unsigned char>(bytes.at(at + i));
  }
  return value;
}

[[nodiscard]] inline std::string png_bytes(std::uint32_t value) {
  return {static_cast<char>(value >> 24U), static_cast<char>(value >> 16U),
          static_cast<char>(value >> 8U), static_cast<char>(value)};
}

/// A chunk as it stands in a file.
[[nodiscard]] inline std::string png_chunk(const std::string& type, const std::string& data) {
  return png_bytes(static_cast<std::uint32_t>(data.size())) + type + data +
         png_bytes(png_checksum(type + data));
}

/// Chunks of a file that is known to be one; throws std::out_of_range where it is not.
[[nodiscard]] inline std::vector<PngChunk> png_chunks(const std::string& file) {
  std::vector<PngChunk> chunks;
  for (std::size_t at = 8; at < file.size();) {
    const std::size_t length = png_number(file, at);
    PngChunk chunk{file.substr(at + 4, 4), file.substr(at + 8, length), false, at};
    chunk.is_whole = png_number(file, at + 8 + length) == png_checksum(chunk.type + chunk.data);
    chunks.push_back(chunk);
    at += 12 + length;
  }
  return chunks;
}

/// The file with something put in front of its last chunk.
[[nodiscard]] inline std::string before_png_end(std::string file, const std::string& bytes) {
  constexpr std::size_t kEndChunk = 12;
  return file.insert(file.size() - kEndChunk, bytes);
}

}  // namespace nadir
