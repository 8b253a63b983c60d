// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace nadir {

/// One line of a TUM-style list: when, and which file as the list writes it.
struct ListedFile {
  double time_s = 0.0;
  std::string file;
  int line = 0;  ///< From 1, for messages.
};

/// Parses `time_s file` a line; `#` starts a comment line, file names may hold spaces. `name`
/// stands for the list in messages.
/// @errors kMalformed (list, line and fault): no time, no file, a time that is not finite, goes
/// back or repeats.
[[nodiscard]] Result<std::vector<ListedFile>> parse_frame_list(std::string_view text,
                                                               const std::string& name);

/// Where a listed file lies. Relative names are relative to `folder`; absolute ones and `..` are
/// fine as long as they end up inside it. Only the names are looked at: symbolic links inside the
/// folder are the owner's business.
/// @errors kMalformed where the file would lie outside, or its name holds control characters.
[[nodiscard]] Result<std::filesystem::path> path_inside(const std::filesystem::path& folder,
                                                        const std::string& file);

/// Index of the entry nearest to `time_s`, the earlier one of two equally near; nothing if it is
/// farther than `tolerance_s`. `files` is in order of time. O(log n).
[[nodiscard]] std::optional<std::size_t> nearest_in_time(const std::vector<ListedFile>& files,
                                                         double time_s,
                                                         double tolerance_s);

/// How far apart in time two images may be and still belong to one frame: half the median period of
/// `files`, 0.02 s at most.
[[nodiscard]] double association_tolerance_s(const std::vector<ListedFile>& files);

}  // namespace nadir
