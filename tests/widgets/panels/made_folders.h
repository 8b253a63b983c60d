// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/session/typed_path.h"
#include "widgets/panels/file_browser.h"

namespace nadir {

/// A disk that is made up, so that nothing depends on the machine's: what boxes of files show.
struct MadeFolders {
  std::map<std::string, std::shared_ptr<FolderListing>> folders;

  MadeFolders() {
    add("/", "data", FileKind::kFolder);
    add("/data", "flights", FileKind::kFolder);
    add("/data", "maps", FileKind::kFolder);
    add("/data/flights", "2018", FileKind::kFolder);
    add("/data/flights", "loop", FileKind::kFlight);
    add("/data/flights", "town", FileKind::kMap);
    add("/data/flights", ".hidden.nadir", FileKind::kRun);
    add("/data/flights", "loop-2.nadir", FileKind::kRun);
    add("/data/flights", "loop-10.nadir", FileKind::kRun);
    add("/data/flights", "notes.txt", FileKind::kOther);
    add("/data/flights", "wide.toml", FileKind::kRunRecipe);
    add("/data/flights/2018", "old.nadir", FileKind::kRun);
    add("/data/maps", "country", FileKind::kMap);
  }
  void add(const std::string& folder, const std::string& name, FileKind kind) {
    auto& listing = folders[folder];
    if (!listing) listing = std::make_shared<FolderListing>();
    listing->folder = folder;
    FolderEntry entry;
    entry.name = name;
    entry.kind = kind;
    entry.is_folder =
        kind == FileKind::kFolder || kind == FileKind::kMap || kind == FileKind::kFlight;
    entry.bytes = 1000 * (name.size() + 1);
    entry.changed_s = 1.6e9 + 1000.0 * static_cast<double>(listing->entries.size());
    listing->entries.push_back(entry);
    std::sort(listing->entries.begin(), listing->entries.end(),
              [](const FolderEntry& a, const FolderEntry& b) {
                return stands_before(a, b, FileOrder::kName);
              });
  }
  /// As a FolderReader has it for what a box looks into.
  void show(const FileBrowserState& state, FileBrowserModel& model) const {
    model.home = "/home/ada";
    const std::string folder = read_typed_path(state.typed, state.folder, model.home).folder;
    const auto found = folders.find(folder);
    model.listing = found == folders.end() ? nullptr : found->second;
    model.fault = found == folders.end() ? folder + ": does not exist" : std::string();
  }
};

}  // namespace nadir
