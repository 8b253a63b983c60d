// SPDX-License-Identifier: Apache-2.0
#include "core/flight/frame_list.h"

#include <algorithm>

#include "core/flight/text_fields.h"

namespace nadir {
namespace fs = std::filesystem;

Result<std::vector<ListedFile>> parse_frame_list(std::string_view text, const std::string& name) {
  std::vector<ListedFile> files;
  int number = 0;
  for (const std::string_view line : flight_text::lines_of(text)) {
    ++number;
    if (line.empty()) continue;
    const std::size_t end = line.find_first_of(" \t");
    const std::string_view time_word = line.substr(0, end);
    const auto time_s = flight_text::finite_number(time_word);
    if (!time_s) {
      return fail(ErrorCode::kMalformed, "{}: line {}: '{}' is not a finite time in seconds", name,
                  number, time_word.substr(0, 40));
    }
    if (end == std::string_view::npos) {
      return fail(ErrorCode::kMalformed, "{}: line {}: has a time but no file", name, number);
    }
    if (!files.empty() && !(*time_s > files.back().time_s)) {
      return fail(ErrorCode::kMalformed,
                  "{}: line {}: time {} s does not come after {} s of line {}", name, number,
                  *time_s, files.back().time_s, files.back().line);
    }
    files.push_back({*time_s, std::string(flight_text::trimmed(line.substr(end))), number});
  }
  return files;
}

Result<fs::path> path_inside(const fs::path& folder, const std::string& file) {
  const auto is_control = [](char letter) { return static_cast<unsigned char>(letter) < 0x20U; };
  if (std::any_of(file.begin(), file.end(), is_control)) {
    return fail(ErrorCode::kMalformed, "the file name holds control characters");
  }
  std::error_code error;
  const fs::path root = fs::absolute(folder, error).lexically_normal();
  if (error) return fail(ErrorCode::kIo, "{}: {}", folder.string(), error.message());
  const fs::path relative = (root / file).lexically_normal().lexically_relative(root);
  if (relative.empty() || relative == "." || *relative.begin() == "..") {
    return fail(ErrorCode::kMalformed, "{} lies outside the flight's folder", file);
  }
  return folder / relative;
}

std::optional<std::size_t> nearest_in_time(const std::vector<ListedFile>& files,
                                           double time_s,
                                           double tolerance_s) {
  const auto is_before = [](const ListedFile& file, double time) { return file.time_s < time; };
  const auto after = std::lower_bound(files.begin(), files.end(), time_s, is_before);
  auto nearest = after;
  if (after == files.end() ||
      (after != files.begin() && time_s - std::prev(after)->time_s <= after->time_s - time_s)) {
    if (after == files.begin()) return {};
    nearest = std::prev(after);
  }
  if (!(std::abs(nearest->time_s - time_s) <= tolerance_s)) return {};
  return static_cast<std::size_t>(nearest - files.begin());
}

double association_tolerance_s(const std::vector<ListedFile>& files) {
  constexpr double kLongest = 0.02;
  if (files.size() < 2) return kLongest;
  std::vector<double> periods;
  periods.reserve(files.size() - 1);
  for (std::size_t i = 1; i < files.size(); ++i) {
    periods.push_back(files[i].time_s - files[i - 1].time_s);
  }
  const auto middle = periods.begin() + static_cast<std::ptrdiff_t>(periods.size() / 2);
  std::nth_element(periods.begin(), middle, periods.end());
  return std::min(kLongest, 0.5 * *middle);
}

}  // namespace nadir
