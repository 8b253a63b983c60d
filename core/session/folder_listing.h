// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/session/file_kind.h"

namespace nadir {

/// One name in a folder.
struct FolderEntry {
  std::string name;
  FileKind kind = FileKind::kOther;
  bool is_folder =
      false;  ///< Can be gone into; maps and flights are folders and can be opened too.
  std::uintmax_t bytes = 0;  ///< Of files.
  double changed_s = 0.0;    ///< Since 1970.
};

/// What a folder holds. Immutable.
struct FolderListing {
  std::filesystem::path folder;
  std::vector<FolderEntry> entries;  ///< By name, folders first.
  bool is_cut_short = false;         ///< There are more than kMostEntries.

  static constexpr std::size_t kMostEntries = 20'000;
  /// Null: there is no such name.
  [[nodiscard]] const FolderEntry* find(std::string_view name) const;
};

/// Looks into a folder, one look into each thing in it; may take long on a slow disk. What vanishes meanwhile is left out.
/// @param folder  Absolute. @errors kNotFound, kIo ("PATH: Permission denied"), kCancelled.
[[nodiscard]] Result<FolderListing> list_folder(const std::filesystem::path& folder,
                                                const WorkContext& context);

enum class FileOrder { kName, kKind, kChanged };
/// Whether `a` stands before `b`: folders first; names without regard to case, numbers in them by their value.
[[nodiscard]] bool stands_before(const FolderEntry& a, const FolderEntry& b, FileOrder order);

}  // namespace nadir
