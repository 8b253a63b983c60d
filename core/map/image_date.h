// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace nadir {

/// When an image was taken, as far as its file says. Overheads go stale, so people are shown it.
struct ImageDate {
  std::string day;  ///< ISO 8601, "2019-05-01".
  std::string
      source;  ///< Where that stands: "its acquisition time", "its name", in words for people.
  friend bool operator==(const ImageDate&, const ImageDate&) = default;
};

/// The day that a text begins with: "2019:05:01 10:11:12" (TIFF and EXIF), "2019-05-01T10:11:12Z", "2019/05/01", "20190501".
/// Nothing where there is none, or none that a calendar has between 1900 and 2099.
[[nodiscard]] std::optional<std::string> day_of(std::string_view text);
/// The first day in a file's name: eight digits, or year, month and day with - or _ or . between them, with no digit
/// before or behind: "ortho_2019-05-01_rgb.tif", "20190501_town.jp2". Years alone are left alone, for numbers are many.
[[nodiscard]] std::optional<std::string> day_in_name(std::string_view file_name);

}  // namespace nadir
