// SPDX-License-Identifier: Apache-2.0
#include "core/topview/point_file_header.h"

#include <cstdint>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace nadir {
namespace {

constexpr std::uint64_t kMostPoints = 1ULL << 28U;
constexpr std::size_t kMostHeaderLines = 1000;

/// What a header promises.
struct Promise {
  std::uint64_t points = 0;
  std::uint64_t bytes_per_point = 0;
  bool is_binary = false;
  bool is_compressed = false;
};

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::optional<std::uint64_t> whole_number(const std::string& word) {
  if (word.empty() || word.size() > 10 || word.find_first_not_of("0123456789") != word.npos) {
    return std::nullopt;
  }
  return std::stoull(word);
}

/// PCD: one keyword a line; the header ends with DATA.
std::optional<Promise> read_pcd_header(std::istream& stream) {
  std::map<std::string, std::vector<std::string>> lines;
  std::string line;
  for (std::size_t i = 0; i < kMostHeaderLines && std::getline(stream, line); ++i) {
    const auto words = words_of(line);
    if (words.empty() || words[0][0] == '#') continue;
    lines[words[0]] = {words.begin() + 1, words.end()};
    if (words[0] == "DATA") break;
  }
  const std::size_t fields = lines["FIELDS"].size();
  const auto& counts = lines["COUNT"];
  if (fields == 0 || lines["SIZE"].size() != fields || lines["TYPE"].size() != fields ||
      (!counts.empty() && counts.size() != fields) || lines["POINTS"].size() != 1 ||
      lines["WIDTH"].size() != 1 || lines["HEIGHT"].size() != 1 || lines["DATA"].size() != 1) {
    return std::nullopt;
  }
  const auto points = whole_number(lines["POINTS"][0]);
  const auto width = whole_number(lines["WIDTH"][0]);
  const auto height = whole_number(lines["HEIGHT"][0]);
  if (!points || !width || !height || *width * *height != *points) return std::nullopt;
  Promise promise{.points = *points};
  for (std::size_t i = 0; i < fields; ++i) {
    const auto size = whole_number(lines["SIZE"][i]);
    const auto count = counts.empty() ? std::optional<std::uint64_t>(1) : whole_number(counts[i]);
    if (!size || !count || *size > 8 || *count > 4096) return std::nullopt;
    promise.bytes_per_point += *size * *count;
  }
  promise.is_compressed = lines["DATA"][0] == "binary_compressed";
  promise.is_binary = lines["DATA"][0] == "binary";
  return promise;
}

/// PLY: the header ends with end_header; only plain properties of the vertices count.
std::optional<Promise> read_ply_header(std::istream& stream) {
  static const std::map<std::string, std::uint64_t> sizes = {
      {"char", 1},  {"uchar", 1},  {"int8", 1},    {"uint8", 1},  {"short", 2}, {"ushort", 2},
      {"int16", 2}, {"uint16", 2}, {"int", 4},     {"uint", 4},   {"int32", 4}, {"uint32", 4},
      {"float", 4}, {"double", 8}, {"float32", 4}, {"float64", 8}};
  Promise promise;
  bool is_vertex = false;
  bool has_vertices = false;
  std::string line;
  if (!std::getline(stream, line) || words_of(line) != std::vector<std::string>{"ply"}) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < kMostHeaderLines && std::getline(stream, line); ++i) {
    const auto words = words_of(line);
    if (words.empty()) continue;
    if (words[0] == "end_header") return has_vertices ? std::optional(promise) : std::nullopt;
    if (words[0] == "format" && words.size() == 3) promise.is_binary = words[1] != "ascii";
    if (words[0] == "element" && words.size() == 3) {
      is_vertex = words[1] == "vertex";
      const auto count = whole_number(words[2]);
      if (!count) return std::nullopt;
      if (is_vertex) promise.points = *count;
      has_vertices = has_vertices || is_vertex;
    }
    if (words[0] == "property" && is_vertex) {
      const auto size = words.size() == 3 ? sizes.find(words[1]) : sizes.end();
      if (size == sizes.end()) return std::nullopt;
      promise.bytes_per_point += size->second;
    }
  }
  return std::nullopt;
}

/// Compressed PCD starts its data with two 32-bit numbers: compressed and uncompressed bytes.
bool has_whole_compressed_block(std::istream& stream, const Promise& promise, std::uint64_t left) {
  std::uint32_t sizes[2] = {0, 0};
  if (left < sizeof sizes || !stream.read(reinterpret_cast<char*>(sizes), sizeof sizes))
    return false;
  return sizes[0] <= left - sizeof sizes && sizes[1] == promise.points * promise.bytes_per_point;
}

}  // namespace

Result<void> check_point_file(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  if (ending != ".pcd" && ending != ".ply") {
    return fail(ErrorCode::kUnsupported, "{}: ends neither in .pcd nor in .ply", path.string());
  }
  std::error_code error;
  const std::uintmax_t file_bytes = std::filesystem::file_size(path, error);
  if (error) return fail(ErrorCode::kNotFound, "{}: does not exist", path.string());
  std::ifstream stream(path, std::ios::binary);
  const auto promise = ending == ".pcd" ? read_pcd_header(stream) : read_ply_header(stream);
  if (!promise || !stream) {
    return fail(ErrorCode::kMalformed, "{}: has no whole {} header", path.string(),
                ending == ".pcd" ? "PCD" : "PLY");
  }
  if (promise->points > kMostPoints) {
    return fail(ErrorCode::kUnsupported, "{}: claims {} points", path.string(), promise->points);
  }
  const auto header_bytes = static_cast<std::uint64_t>(stream.tellg());
  const std::uint64_t left = file_bytes > header_bytes ? file_bytes - header_bytes : 0;
  // A point written as text takes two characters at the least.
  const std::uint64_t least = promise->points * (promise->is_binary ? promise->bytes_per_point : 2);
  const bool is_whole =
      promise->is_compressed ? has_whole_compressed_block(stream, *promise, left) : left >= least;
  if (!is_whole) {
    return fail(ErrorCode::kMalformed,
                "{}: is cut short: {} points are promised, but only {} bytes follow", path.string(),
                promise->points, left);
  }
  return {};
}

}  // namespace nadir
