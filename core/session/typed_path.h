// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace nadir {

/// What is typed where a file is chosen: words that a name is to have, or the path of something.
struct TypedPath {
  bool is_path = false;
  std::filesystem::path
      folder;        ///< Absolute: of a path, that before its last '/'; else the one that is shown.
  std::string last;  ///< Behind the last '/'; all of it where it is no path.
  [[nodiscard]] std::filesystem::path whole() const {
    return last.empty() ? folder : folder / last;
  }
};

/// A path has a '/' in it or begins with '~', the home; one that does not begin with either starts at `folder`.
/// @param folder  Shown, absolute. @param home  May be empty.
[[nodiscard]] TypedPath read_typed_path(std::string_view typed,
                                        const std::filesystem::path& folder,
                                        const std::string& home);

/// Longest beginning that all names have which begin with `begun`; `begun` where there is none.
[[nodiscard]] std::string completed_name(std::string_view begun,
                                         const std::vector<std::string>& names);

/// A name that is not taken yet: "moment.png", "moment-2.png", "moment-3.png".
[[nodiscard]] std::string free_name(const std::string& wanted,
                                    const std::vector<std::string>& taken);

/// As part of a file's name: what is neither letter, digit, '.', '-' nor '_' becomes a '-'.
[[nodiscard]] std::string as_file_name(std::string_view words);

}  // namespace nadir
