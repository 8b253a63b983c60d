// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/session/folder_reader.h"
#include "core/session/session.h"
#include "widgets/kit/ui.h"

namespace nadir {

/// Where to look for files: a folder, and perhaps a name in it.
struct FilePlace {
  std::string title, folder, name = {};
  kit::Icon icon = kit::Icon::kFolder;
  std::string detail =
      {};  ///< The end of the path of the folder that it is in; empty for those that need none.
};

/// The folder that boxes of files show. What takes a disk has been done by a FolderReader.
struct FileBrowserModel {
  std::vector<FilePlace>
      places;  ///< Home, the working folder, the whole disk, folders of what was open.
  std::vector<FilePlace> recents;                ///< What was open, newest first.
  std::string home;                              ///< May be empty.
  std::shared_ptr<const FolderListing> listing;  ///< Null: not read yet, or fault.
  std::string fault;                             ///< Why the folder cannot be shown.
};

/// Which names show.
struct FileFilter {
  bool is_for_saving =
      false;  ///< What is typed is a name, and does not choose among those there are.
  std::span<const std::string_view> endings = {};  ///< To be saved with; those files show.
};

/// Kept by the caller.
struct FileBrowserState {
  std::string folder = {};  ///< Absolute.
  std::string typed = {};   ///< Words, a name, or a path.
  std::string chosen = {};  ///< Name of the highlighted row; may be gone.
  FileOrder order = FileOrder::kName;
  bool is_reversed = false, shows_all = false;
  bool was_clicked = false;     ///< A row was: typing goes on once the mouse is let go for good.
  bool goes_on_typing = false;  ///< The field takes the keyboard, with `typed`, in the next frame.
  bool has_moved = false;       ///< By keys: the row is to be brought into sight.
};

/// @param recents  Paths, newest first.
[[nodiscard]] FileBrowserModel file_browser_model(std::span<const std::string> recents,
                                                  const FileBrowserState& state,
                                                  FolderReader& reader);

/// Where the program was started by a shell; empty where that is nowhere in particular, as when a desktop has started it in '/'.
[[nodiscard]] std::string working_folder();

/// Where to begin: the folder of what was opened last, else the working folder, else the home, else '/'.
[[nodiscard]] std::string first_folder(std::span<const std::string> recents,
                                       const std::string& home,
                                       const std::string& working = {});

/// The entries that show, in their order.
[[nodiscard]] std::vector<const FolderEntry*> shown_entries(const FileBrowserModel& model,
                                                            const FileBrowserState& state,
                                                            const FileFilter& filter);

/// Goes into a folder; what was typed is gone.
void go_into(FileBrowserState& state, const std::string& folder);

/// "2026-11-23 14:03", in the time of the place.
[[nodiscard]] std::string when_text(double since_1970_s);

// ---- Parts of a box, to be drawn below or beside each other.

/// Home, folders and files used lately. @returns the path of one that was double-clicked, to be opened; else empty.
[[nodiscard]] std::string draw_places(kit::Ui& ui,
                                      const FileBrowserModel& model,
                                      FileBrowserState& state);
/// The folder's path, to be clicked at, and a button that goes up.
void draw_way(kit::Ui& ui, const FileBrowserModel& model, FileBrowserState& state);
/// The field. Goes up, completes, and moves the highlight by keys. @returns what its keys have done.
[[nodiscard]] kit::TextEdit draw_name_field(kit::Ui& ui,
                                            const std::string& label,
                                            const std::string& placeholder,
                                            const FileBrowserModel& model,
                                            const FileFilter& filter,
                                            FileBrowserState& state);
/// The names, or why there are none. @returns the entry that was double-clicked; null: none.
[[nodiscard]] const FolderEntry* draw_names(kit::Ui& ui,
                                            const FileBrowserModel& model,
                                            const FileFilter& filter,
                                            FileBrowserState& state,
                                            double height);

}  // namespace nadir
