// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace nadir {

/// The last name of a path, without a run's ending: "loop" of "/flights/loop.nadir". Never empty for a path that is not.
[[nodiscard]] std::string name_of(const std::filesystem::path& path);

/// The folder that a path lies in, with '~' for the user's home.
/// @param home  Empty: none.
[[nodiscard]] std::string folder_of(const std::filesystem::path& path,
                                    const std::string& home = {});

/// The user's home; empty where there is none.
[[nodiscard]] std::string home_folder();

/// With "…" in the middle where it is longer than so many characters (not bytes; >= 3): both ends of a path tell most.
/// Text that is no UTF-8 is taken byte by byte.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t most_characters);

/// "212 MB", "1.4 GB": 10^6 and 10^9 bytes, as disks and system monitors count.
[[nodiscard]] std::string memory_text(std::size_t bytes);

/// "812 B", "4 kB", "212 MB": of a file.
[[nodiscard]] std::string file_size_text(std::uintmax_t bytes);

/// "a few seconds left", "12 s left", "3 min left", "2 h left".
[[nodiscard]] std::string left_text(double left_s);

/// Whether `words` contain all words of `typed`, each anywhere, in any case (ASCII). True for nothing typed.
[[nodiscard]] bool has_words(std::string_view words, std::string_view typed);

/// A label that shows `shown` and is found by `shown##told_apart_by`.
[[nodiscard]] std::string label_of(std::string_view shown, std::string_view told_apart_by);

}  // namespace nadir
