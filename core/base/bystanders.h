// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace nadir {

/// Files and folders that a program keeps beside its output while it works: `NAME` + `infix` +
/// process id, such as "run.nadir.partial-4711". A program that is killed leaves them behind.

/// What this process calls its own.
[[nodiscard]] std::filesystem::path bystander_of(const std::filesystem::path& target,
                                                 std::string_view infix);

/// Those beside `target` whose process is no more, sorted; they need not be whole. Empty where the
/// folder cannot be read. A process that this one may not see, on another machine that shares the
/// folder or outside this container, counts as gone: one output is written by one program at a
/// time.
[[nodiscard]] std::vector<std::filesystem::path> abandoned_bystanders(
    const std::filesystem::path& target, std::string_view infix);

}  // namespace nadir
