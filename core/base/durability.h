// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/base/result.h"

namespace nadir::detail {

/// Waits until a file, or a folder and all that was written into it, is on the disk.
///
/// A folder is waited for with one syncfs(2), which also waits for what other programs have written
/// to the same file system. Asking for each file by itself would not, but every question costs a
/// commit of the file system's journal: for a flight of 800 frames (1,600 images, 176 MB) that is
/// 0.4 to 3 s on a virtual disk with ext4, and syncfs 0.1 s.
/// @errors kIo, such as a disk that fails or is full. A file system that cannot wait is no error.
[[nodiscard]] Result<void> wait_for_disk(const std::filesystem::path& path);

/// Waits until the names in the folder of `path` are on the disk, after it was made or renamed.
/// @errors as above.
[[nodiscard]] Result<void> wait_for_name(const std::filesystem::path& path);

/// Gives two files or folders each other's name in one step, so that at no time either is missing.
/// @returns false where the file system cannot do that.
[[nodiscard]] bool exchange_names(const std::filesystem::path& a, const std::filesystem::path& b);

/// Gives a file another name unless something has that one already, in one step; where the file system knows no way to do
/// that, it looks first. @errors kIo: something has it.
[[nodiscard]] Result<void> rename_without_replacing(const std::filesystem::path& from,
                                                    const std::filesystem::path& to);

/// Gives `fresh` the name of the folder `target` where they cannot be exchanged: `target` steps
/// aside first. Nothing is removed, and where `fresh` cannot follow, `target` gets its name back.
/// @param aside  What the old one is to be called; where that name is taken, such as after a crash
///   of a process of the same number, `aside`-2, `aside`-3 and so on.
/// @returns what the old one is called now. @errors kIo.
[[nodiscard]] Result<std::filesystem::path> replace_in_two_steps(
    const std::filesystem::path& fresh,
    const std::filesystem::path& target,
    const std::filesystem::path& aside);

}  // namespace nadir::detail
