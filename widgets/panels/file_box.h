// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "widgets/panels/file_browser.h"

namespace nadir {

/// Asks for a file: one to be opened, or where a recipe is to be saved.
struct FileBoxModel {
  enum class Use { kClosed, kOpen, kSaveRecipe };
  Use use = Use::kClosed;
  FileBrowserModel files;
  std::string first_folder;   ///< Where it begins unless it was left elsewhere since.
  std::string proposed_name;  ///< For saving.
};

struct FileBoxState {
  FileBrowserState files = {};
  FileBoxModel::Use use = FileBoxModel::Use::kClosed;  ///< As in the last frame.
  std::string asked_about = {};  ///< A file that is there already: Enter once more replaces it.
  std::string begun_in = {};     ///< The model's first folder when it was opened last.
};

/// Call in every frame. @param reader  Only of this box.
[[nodiscard]] FileBoxModel file_box_model(const Session& session,
                                          const FileBoxState& state,
                                          FolderReader& reader);

/// Lies over the window where the model says so; call it in every frame.
[[nodiscard]] Actions draw_file_box(kit::Ui& ui, const FileBoxModel& model, FileBoxState& state);

/// Where what is typed would be saved, and what stands in the way.
struct SavePlace {
  std::string file = {};     ///< Absolute, with an ending; empty: no name is typed.
  std::string why_not = {};  ///< Why it cannot be there; empty: it can.
  bool replaces = false;     ///< There is such a file now.
};
/// @param endings  The first is taken where none of them is typed. None: it is a folder.
[[nodiscard]] SavePlace save_place(const FileBrowserModel& model,
                                   const FileBrowserState& state,
                                   std::span<const std::string_view> endings);

}  // namespace nadir
