// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <string_view>

#include "core/base/field.h"
#include "core/base/result.h"

namespace nadir {

/// What something on the disk is to Nadir. Maps and most flights are folders, told by what they hold.
enum class FileKind {
  kFolder,
  kRun,
  kMap,
  kFlight,
  kFigureRecipe,
  kRunRecipe,
  kFigure,
  kLabels,  ///< An overhead image or a labelling document: what labels can be drawn on.
  kOther
};
template <>
struct EnumNames<FileKind> {
  static constexpr std::array<std::string_view, 9> kNames = {
      "folder", "run", "map", "flight", "figure recipe", "recipe", "figure", "image", "other"};
};

/// Whether it can be opened, rather than gone into or left alone.
[[nodiscard]] constexpr bool can_be_opened(FileKind kind) {
  return kind != FileKind::kFolder && kind != FileKind::kOther;
}

/// Largest recipe that is read.
inline constexpr std::uintmax_t kMostRecipeBytes = 1U << 20U;

/// What a path that a user names stands for: of a map.toml or flight.toml its folder.
struct FileToOpen {
  FileKind kind = FileKind::kOther;
  std::filesystem::path path;
};
/// @param path  Absolute. @errors kNotFound; kMalformed, kUnsupported: what it claims to be it is not, or nothing that opens.
[[nodiscard]] Result<FileToOpen> file_to_open(const std::filesystem::path& path);

/// What a list calls it: reads at most a few kilobytes, and takes what is damaged for what it claims to be. A folder that is
/// no flight is a folder, a picture without a recipe kOther.
[[nodiscard]] FileKind kind_at_a_glance(const std::filesystem::path& path, bool is_folder);

}  // namespace nadir
