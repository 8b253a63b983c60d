// SPDX-License-Identifier: Apache-2.0
#include "core/session/file_looks.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

namespace nadir {
namespace {

using namespace std::string_view_literals;

/// How a kind of file begins.
struct Beginning {
  std::string_view bytes;
  std::string_view words;
  std::size_t at = 0;  ///< Of the bytes in the file.
};
constexpr std::array kBeginnings = {
    Beginning{"\x89PNG"sv, "a PNG picture"},
    Beginning{"\xFF\xD8\xFF"sv, "a JPEG picture"},
    Beginning{"II*\0"sv, "a TIFF picture"},
    Beginning{"MM\0*"sv, "a TIFF picture"},
    Beginning{"II+\0"sv, "a TIFF picture"},
    Beginning{"GIF8"sv, "a GIF picture"},
    Beginning{"WEBP"sv, "a WebP picture", 8},
    Beginning{"BM"sv, "a BMP picture"},
    Beginning{"%PDF"sv, "a PDF document"},
    Beginning{"SQLite format 3"sv, "an SQLite database"},
    Beginning{"ftyp"sv, "a film", 4},
    Beginning{"\x1A\x45\xDF\xA3"sv, "a film"},
    Beginning{"#ROSBAG"sv, "a ROS bag"},
    Beginning{"\x89MCAP"sv, "a ROS 2 bag (MCAP)"},
    Beginning{"\x89HDF"sv, "an HDF5 file"},
    Beginning{"\x93NUMPY"sv, "a NumPy array"},
    Beginning{"# .PCD"sv, "a point cloud"},
    Beginning{"LASF"sv, "a point cloud"},
    Beginning{"ply\n"sv, "a point cloud"},
    Beginning{"PK\x03\x04"sv, "a ZIP archive"},
    Beginning{"\x1F\x8B"sv, "a compressed file"},
    Beginning{"BZh"sv, "a compressed file"},
    Beginning{"\xFD"
              "7zXZ"sv,
              "a compressed file"},
    Beginning{"ustar"sv, "a tar archive", 257},
    Beginning{"\x7F"
              "ELF"sv,
              "a program"},
    Beginning{"#!"sv, "a script"},
};

/// Control characters beside blanks and line breaks stand in no text.
bool is_text(std::string_view bytes) {
  return std::none_of(bytes.begin(), bytes.end(), [](char letter) {
    const auto code = static_cast<unsigned char>(letter);
    return code == 0x7F || (code < 0x20 && letter != '\t' && letter != '\n' && letter != '\r');
  });
}

}  // namespace

std::string looks_of_file(const std::filesystem::path& file) {
  constexpr std::size_t kEnough = 512;
  std::string begin(kEnough, '\0');
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return "unreadable";
  stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
  if (begin.empty()) return "empty";
  for (const Beginning& kind : kBeginnings) {
    if (begin.compare(std::min(kind.at, begin.size()), kind.bytes.size(), kind.bytes) == 0) {
      return std::string(kind.words);
    }
  }
  if (!is_text(begin)) return "data of a kind that Nadir does not know";
  const std::size_t first = begin.find_first_not_of(" \t\r\n");
  const char sign = first == std::string::npos ? ' ' : begin[first];
  if (sign == '{') return "a JSON text";
  if (sign == '<') return "an XML or HTML text";
  return "a text";
}

}  // namespace nadir
