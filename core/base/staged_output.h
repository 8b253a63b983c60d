// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace nadir {

/// An output file or folder that appears under its own name only when it is whole.
///
/// Write to path(), then commit(). Until then everything lies beside the target in
/// `NAME.partial-PID`; without commit the destructor removes it, so that a failure or Ctrl+C leaves
/// what was there before and no half-written output. What a killed program left there of the same
/// output goes when the next one begins.
///
/// A power cut leaves the old output or the new one, whole: commit waits for the disk before it
/// renames, and for the new name after it (milliseconds for a file, see durability.h for folders).
/// Where the file system cannot exchange two folders in one step, the old one may then be called
/// `NAME.replaced-PID`.
///
/// What may be replaced is asked at the start, before any work, and again by commit, which may come
/// hours later.
class StagedOutput {
 public:
  /// A look at a filled folder that is to give way. @errors why it stays, in one sentence.
  using FolderCheck = std::function<Result<void>(const std::filesystem::path& folder)>;

  /// Replaces an existing file on commit, never a folder. @errors kIo: the parent folder is missing
  /// or not writable.
  [[nodiscard]] static Result<StagedOutput> file(const std::filesystem::path& target);
  /// Makes an empty folder to fill. A target that exists is replaced on commit only if it is empty or holds `marker`, the
  /// file by which an output of this kind is known, and, where `own_entries` are given, nothing but those; without them
  /// the caller sees to what else is there. `check`, where given, has the last word on a filled folder.
  /// @errors kIo: as above, or the target holds something else, which is then left alone and named; those of `check`.
  [[nodiscard]] static Result<StagedOutput> folder(
      const std::filesystem::path& target,
      std::string_view marker,
      std::span<const std::string_view> own_entries = {},
      FolderCheck check = {});

  StagedOutput(StagedOutput&& other) noexcept;
  StagedOutput& operator=(StagedOutput&& other) = delete;
  ~StagedOutput();

  [[nodiscard]] const std::filesystem::path& path() const { return staged_; }
  /// Renames to the target when all is on the disk. @errors kIo, and those of file() and folder() where something else
  /// has come to stand there meanwhile; the staged output is then removed by the destructor.
  [[nodiscard]] Result<void> commit();
  /// The same for a file() that must not replace anything. @errors kIo also where something has its name by now.
  [[nodiscard]] Result<void> commit_as_new();
  /// Several files that belong together, in their order: all get their names, or where one of them cannot, all have what was
  /// there before. Between the first and the last another program, or a power cut, may see some of them.
  /// @errors as commit().
  [[nodiscard]] static Result<void> commit_all(std::span<StagedOutput> files);

 private:
  /// Which folders may give way.
  struct FolderRule {
    std::string name;  ///< The target as the caller wrote it, for messages.
    std::string marker;
    std::vector<std::string> own_entries;
    FolderCheck check;
  };

  StagedOutput(std::filesystem::path target, std::optional<FolderRule> rule)
      : target_(std::move(target)), rule_(std::move(rule)) {}

  [[nodiscard]] Result<void> check_replaceable() const;
  [[nodiscard]] Result<void> check_whole() const;
  [[nodiscard]] Result<bool> take_name();
  void give_name_back(bool has_replaced);
  [[nodiscard]] Result<void> replace_folder();

  std::filesystem::path target_;
  std::optional<FolderRule> rule_;  ///< Nothing for a file.
  std::filesystem::path staged_;    ///< Empty before it is made, and once committed or moved from.
};

/// Writes a whole text file by way of StagedOutput. @errors kIo (folder missing, not writable, disk
/// full).
[[nodiscard]] Result<void> write_text_file(const std::filesystem::path& path,
                                           std::string_view text);

/// Reads a whole file. @errors kNotFound, kIo, or kUnsupported where it is larger than `max_bytes`.
[[nodiscard]] Result<std::string> read_text_file(const std::filesystem::path& path,
                                                 std::uintmax_t max_bytes = 1ULL << 30U);

}  // namespace nadir
