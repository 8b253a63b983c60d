// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace nadir {

/// A moment or a span of a run that somebody wants to find again.
struct Bookmark {
  double time_s = 0.0;                 ///< After the run's first step.
  std::string note;                    ///< May be empty and may have several lines.
  std::optional<double> until_s = {};  ///< End of the span, after time_s; nothing for a moment.
  friend bool operator==(const Bookmark&, const Bookmark&) = default;
};

/// Bookmarks are kept in order of time, then end, then note; none comes twice. All functions return such lists.
using Bookmarks = std::vector<Bookmark>;

/// With one more; the same list where it has it already. @param bookmark  Finite times, the end after the beginning.
[[nodiscard]] Bookmarks with_bookmark(Bookmarks bookmarks, const Bookmark& bookmark);
/// With another in place of the i-th. @param index  Below the number of bookmarks.
[[nodiscard]] Bookmarks with_bookmark_changed(Bookmarks bookmarks,
                                              std::size_t index,
                                              const Bookmark& bookmark);
/// Without the i-th. @param index  Below the number of bookmarks.
[[nodiscard]] Bookmarks without_bookmark(Bookmarks bookmarks, std::size_t index);

/// A list to which is done what has made `to` of `from`.
[[nodiscard]] Bookmarks with_changes(const Bookmarks& bookmarks,
                                     const Bookmarks& from,
                                     const Bookmarks& to);

/// Index of the first bookmark after a time, and of the last before it; a bookmark at the very time (to a microsecond) is
/// passed over. Nothing where there is none.
[[nodiscard]] std::optional<std::size_t> next_bookmark(std::span<const Bookmark> bookmarks,
                                                       double time_s);
[[nodiscard]] std::optional<std::size_t> previous_bookmark(std::span<const Bookmark> bookmarks,
                                                           double time_s);

/// "RUN.nadir.bookmarks.toml", beside the run.
[[nodiscard]] std::filesystem::path bookmarks_file(const std::filesystem::path& run);

/// Reads the side file of a run; without one there are no bookmarks.
/// @errors kMalformed: no TOML, unknown keys (names the nearest), a value that is missing or of another type, a span that
/// ends before it begins; kUnsupported: written by a newer version; kIo.
[[nodiscard]] Result<Bookmarks> read_bookmarks(const std::filesystem::path& run);

/// Writes the side file, whole or not at all. What another window has added to it or removed from it since `known` was
/// read is kept: the difference between `known` and `wanted` is what is done to the file. Where nothing is left, there is
/// no file.
/// @param known  As last read or written by the caller.
/// @returns what the file holds now.
/// @errors as read_bookmarks of the file that is there, which is then left as it is; kInvalidOptions: a time that is not
/// finite, a span that ends before it begins; kIo.
[[nodiscard]] Result<Bookmarks> write_bookmarks(const std::filesystem::path& run,
                                                const Bookmarks& wanted,
                                                const Bookmarks& known);

}  // namespace nadir
