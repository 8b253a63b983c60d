// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace nadir {

/// Files and folders that a program keeps beside its output while it works: `NAME` + `infix` +
/// process id, such as "run.nadir.partial-4711". A program that is killed leaves them behind.

/// A process id says who is at work now, not who was: ids come round again, and in a container a
/// program may have the same one every time. So a file under a process's own name may be somebody
/// else's, left by a program that was killed; where it may be the last copy of something, take the
/// next number (made with O_EXCL) instead of replacing it.

/// What this process calls its own: "run.nadir.partial-4711", and "run.nadir.partial-4711-2" for
/// number 2. @param number  From 1.
[[nodiscard]] std::filesystem::path bystander_of(const std::filesystem::path& target,
                                                 std::string_view infix,
                                                 int number = 1);

/// Those beside `target` whose process is no more, whatever their number, sorted; they need not be
/// whole. Empty where the folder cannot be read. One whose id another process has by now is not
/// found. A process that this one may not see, on another machine that shares the
/// folder or outside this container, counts as gone: one output is written by one program at a
/// time.
[[nodiscard]] std::vector<std::filesystem::path> abandoned_bystanders(
    const std::filesystem::path& target, std::string_view infix);

}  // namespace nadir
