// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tests/widgets/panels/made_folders.h"
#include "tests/widgets/panels/shown.h"
#include "widgets/panels/file_box.h"

namespace nadir {

/// A file box over folders that are made up.
struct BoxOnDisk : FileBoxModel {
  MadeFolders disk;
};
inline Actions draw_box_on_disk(kit::Ui& ui, BoxOnDisk& model, FileBoxState& state) {
  model.disk.show(state.files, model.files);
  return draw_file_box(ui, model, state);
}
using FileBoxOnDisk = Shown<BoxOnDisk, FileBoxState, draw_box_on_disk>;

struct BoxToOpen : FileBoxOnDisk {
  BoxToOpen() {
    model.use = FileBoxModel::Use::kOpen;
    model.first_folder = "/data/flights";
    model.files.places = {{"Home", "/home/ada"}, {"maps", "/data/maps"}};
    model.files.recents = {{"old", "/data/flights/2018", "old.nadir", kit::Icon::kFile}};
  }
};

struct BoxToSave : BoxToOpen {
  BoxToSave() {
    model.use = FileBoxModel::Use::kSaveRecipe;
    model.proposed_name = "loop-options.toml";
  }
};

/// The folder that a box shows.
[[nodiscard]] inline std::string folder_of_box(const FileBoxOnDisk& box) {
  return box.state.files.folder;
}

}  // namespace nadir
