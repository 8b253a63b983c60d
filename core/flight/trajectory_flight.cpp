// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <fstream>
#include <string>

#include "core/flight/flight_formats.h"
#include "core/flight/text_fields.h"
#include "core/geo/trajectory_file.h"

namespace nadir {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kTumColumns = 8;
constexpr std::size_t kKittiColumns = 12;

/// Numbers in the first line that is neither empty nor a comment; 0 where something there is no
/// number. Looks at the first bytes alone, so that a large binary file is told at once.
std::size_t column_count(const fs::path& file) {
  std::array<char, 4096> buffer{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(buffer.data(), buffer.size());
  const auto size = static_cast<std::size_t>(stream.gcount());
  for (const std::string_view line : flight_text::lines_of({buffer.data(), size})) {
    if (line.empty()) continue;
    const auto words = flight_text::words_of(line);
    // NaN counts as a number here, so that the reader can name the line.
    for (const std::string_view word : words) {
      if (word != "nan" && word != "inf" && !flight_text::finite_number(word)) return 0;
    }
    return words.size();
  }
  return 0;
}

}  // namespace

bool is_trajectory_file(const fs::path& file) {
  const std::size_t columns = column_count(file);
  return columns == kTumColumns || columns == kKittiColumns;
}

FlightResult open_trajectory_flight(const fs::path& file) {
  auto trajectory = read_trajectory(file);
  if (!trajectory) return forward_error(trajectory);
  FlightDescription flight;
  flight.name = file.stem().string();
  flight.format = column_count(file) == kKittiColumns ? "KITTI odometry" : "TUM trajectory";
  flight.path = file;
  flight.odometry = *std::move(trajectory);
  flight.odometry_source = file;
  return std::make_unique<UnlabelledFlight>(std::move(flight));
}

}  // namespace nadir
