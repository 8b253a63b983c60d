// SPDX-License-Identifier: Apache-2.0
// Boxes that ask for files.
#include "tests/widgets/panels/panel_scene_parts.h"
#include "widgets/panels/export_box.h"
#include "widgets/panels/file_box.h"

namespace nadir::scenes {
namespace {

/// A folder with something of every kind in it.
FileBrowserModel folder() {
  auto listing = std::make_shared<FolderListing>();
  listing->folder = "/home/ada/flights";
  const auto add = [&listing](const char* name, FileKind kind, bool is_folder, double bytes) {
    FolderEntry entry;
    entry.name = name;
    entry.kind = kind;
    entry.is_folder = is_folder;
    entry.bytes = static_cast<std::uintmax_t>(bytes);
    entry.changed_s = 1.6e9 + 4.0e5 * static_cast<double>(listing->entries.size());
    listing->entries.push_back(entry);
  };
  add("2018", FileKind::kFolder, true, 0.0);
  add("loop", FileKind::kFlight, true, 0.0);
  add("proving-ground", FileKind::kMap, true, 0.0);
  add("loop medium 7.nadir", FileKind::kRun, false, 48.2e6);
  add("loop medium 8.nadir", FileKind::kRun, false, 51.9e6);
  add("moment.svg", FileKind::kFigure, false, 812e3);
  add("wide.toml", FileKind::kRunRecipe, false, 402.0);
  FileBrowserModel model;
  model.home = "/home/ada";
  model.places = {
      {"Home", "/home/ada"}, {"All of the disk", "/"}, {"flights", "/home/ada/flights"}};
  model.recents = {
      {"loop medium 7", "/home/ada/flights", "loop medium 7.nadir", kit::Icon::kFile, "flights"}};
  model.listing = listing;
  return model;
}

FileBoxModel file_box(FileBoxModel::Use use) {
  FileBoxModel model;
  model.use = use;
  model.files = folder();
  model.first_folder = "/home/ada/flights";
  model.proposed_name = "wide.toml";
  return model;
}

FileBoxState chosen_in_box(const std::string& name, FileBoxModel::Use use) {
  FileBoxState state;
  state.use = use;
  state.files.folder = "/home/ada/flights";
  state.files.chosen = name;
  if (use == FileBoxModel::Use::kSaveRecipe) state.files.typed = "wide.toml";
  return state;
}

ExportModel exports() {
  ExportModel model;
  model.is_open = true;
  for (const ExportKind& kind : export_kinds()) {
    model.rows.push_back({&kind, kind.name == "compare" ? "show a second run first" : ""});
  }
  model.files = folder();
  model.first_folder = "/home/ada/flights";
  model.proposed = "loop-medium-7-moment-42.3s";
  model.file = "/home/ada/flights/loop-medium-7-moment-42.3s.png";
  model.sentence =
      "Draws figure ‘moment’ of loop medium 7 at 42.3 s into "
      "~/flights/loop-medium-7-moment-42.3s.png.";
  model.left_out = "Not in it: the error surface and 2 other runs.";
  return model;
}

const auto kDrawExport = [](kit::Ui& ui, const ExportModel& model, ExportState& state) {
  PaletteState palette;
  return draw_export_box(ui, model, state, palette);
};

}  // namespace

void add_file_scenes(std::vector<PanelScene>& scenes) {
  using Use = FileBoxModel::Use;
  const Eigen::Vector2d box(880.0, 560.0);
  scenes.push_back(overlay("open-box", "file_box", box, file_box(Use::kOpen),
                           chosen_in_box("loop medium 7.nadir", Use::kOpen), draw_file_box));
  scenes.push_back(variant(overlay("save-box", "file_box", box, file_box(Use::kSaveRecipe),
                                   chosen_in_box("", Use::kSaveRecipe), draw_file_box)));
  scenes.push_back(
      overlay("export-box", "export_box", {1000.0, 560.0}, exports(), ExportState{}, kDrawExport));
  FileBoxModel nowhere = file_box(Use::kOpen);
  nowhere.files.listing = nullptr;
  nowhere.files.fault = "/home/ada/flights: Permission denied";
  scenes.push_back(without_data(overlay("open-box-fault", "file_box", box, nowhere,
                                        chosen_in_box("", Use::kOpen), draw_file_box)));
}

}  // namespace nadir::scenes
