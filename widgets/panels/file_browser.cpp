// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/file_browser.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <filesystem>
#include <system_error>

#include "core/session/typed_path.h"
#include "widgets/panels/panel_text.h"

namespace nadir {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostFolders = 8, kMostRecentFiles = 12;

[[nodiscard]] std::string parent_of(const std::string& path) {
  return fs::path(path).parent_path().string();
}

[[nodiscard]] bool has_ending(std::string_view name, std::span<const std::string_view> endings) {
  return std::any_of(endings.begin(), endings.end(),
                     [name](std::string_view ending) { return name.ends_with(ending); });
}

[[nodiscard]] bool is_offered(const FolderEntry& entry,
                              const FileBrowserState& state,
                              const FileFilter& filter) {
  if (state.shows_all) return true;
  if (entry.name.starts_with('.')) return false;
  if (filter.is_for_saving) {
    return entry.kind == FileKind::kFolder ||
           (!entry.is_folder && has_ending(entry.name, filter.endings));
  }
  return entry.kind != FileKind::kOther;
}

}  // namespace

std::string working_folder() {
  std::error_code error;
  const fs::path folder = fs::current_path(error);
  return error || folder == folder.root_path() ? std::string() : folder.string();
}

std::string first_folder(std::span<const std::string> recents,
                         const std::string& home,
                         const std::string& working) {
  if (!recents.empty()) return parent_of(recents.front());
  if (!working.empty()) return working;
  return home.empty() ? "/" : home;
}

FileBrowserModel file_browser_model(std::span<const std::string> recents,
                                    const FileBrowserState& state,
                                    FolderReader& reader) {
  FileBrowserModel model;
  model.home = home_folder();
  if (!model.home.empty()) model.places.push_back({"Home", model.home});
  if (const std::string folder = working_folder(); !folder.empty() && folder != model.home) {
    model.places.push_back({"Working folder", folder});
  }
  model.places.push_back({"All of the disk", "/"});
  for (const std::string& path : recents) {
    const std::string folder = parent_of(path);
    const bool is_known =
        std::any_of(model.places.begin(), model.places.end(),
                    [&folder](const FilePlace& place) { return place.folder == folder; });
    if (!is_known && model.places.size() < kMostFolders) {
      model.places.push_back(
          {name_of(folder), folder, {}, kit::Icon::kFolder, name_of(parent_of(folder))});
    }
    if (model.recents.size() < kMostRecentFiles) {
      // Folders of one name are told apart.
      const std::string above = fs::path(folder).parent_path().filename().string();
      model.recents.push_back({name_of(path), folder, fs::path(path).filename().string(),
                               kit::Icon::kFile,
                               above.empty() ? name_of(folder) : above + "/" + name_of(folder)});
    }
  }
  if (!state.folder.empty()) {
    reader.look(read_typed_path(state.typed, state.folder, model.home).folder);
  }
  model.listing = reader.listing();
  model.fault = reader.fault();
  return model;
}

std::vector<const FolderEntry*> shown_entries(const FileBrowserModel& model,
                                              const FileBrowserState& state,
                                              const FileFilter& filter) {
  std::vector<const FolderEntry*> shown;
  if (!model.listing) return shown;
  const TypedPath typed = read_typed_path(state.typed, state.folder, model.home);
  for (const FolderEntry& entry : model.listing->entries) {
    const bool fits = filter.is_for_saving || (typed.is_path ? entry.name.starts_with(typed.last)
                                                             : has_words(entry.name, typed.last));
    if (fits && is_offered(entry, state, filter)) shown.push_back(&entry);
  }
  if (state.order != FileOrder::kName || state.is_reversed) {
    std::stable_sort(shown.begin(), shown.end(), [&state](const auto* a, const auto* b) {
      if (a->is_folder != b->is_folder) return a->is_folder;  // at the top in any order
      return state.is_reversed ? stands_before(*b, *a, state.order)
                               : stands_before(*a, *b, state.order);
    });
  }
  return shown;
}

void go_into(FileBrowserState& state, const std::string& folder) {
  state.folder = folder;
  state.typed.clear();
  state.chosen.clear();
  state.goes_on_typing = true;
}

std::string when_text(double since_1970_s) {
  const auto whole = static_cast<std::time_t>(since_1970_s);
  std::tm local{};
  if (::localtime_r(&whole, &local) == nullptr) return {};
  std::array<char, 32> text{};
  const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M", &local);
  return {text.data(), length};
}

}  // namespace nadir
