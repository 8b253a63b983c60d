// SPDX-License-Identifier: Apache-2.0
#include "core/session/change_words.h"

#include <filesystem>

namespace nadir {
namespace {

std::string file_name(const std::string& path) {
  const std::filesystem::path file(path);
  return (file.has_filename() ? file.filename() : file.parent_path().filename()).string();
}

std::string shown_or_hidden(bool is_shown, std::string_view what) {
  return fmt::format("{} {}", is_shown ? "Show" : "Hide", what);
}

/// "error surface" of "error-surface".
std::string plain_words(std::string_view name) {
  std::string words(name);
  for (char& letter : words) {
    if (letter == '-') letter = ' ';
  }
  return words;
}

struct Titles {
  const ViewState& after;

  std::string operator()(const actions::OpenFile& one) const {
    return "Open " + file_name(one.path);
  }
  std::string operator()(const actions::CloseRun& /*one*/) const { return "Close run"; }
  std::string operator()(const actions::LookAt& /*one*/) const { return "Move map"; }
  std::string operator()(const actions::Zoom& /*one*/) const { return "Zoom"; }
  std::string operator()(const actions::Rotate& /*one*/) const { return "Turn map"; }
  std::string operator()(const actions::Fit& one) const {
    return fmt::format("Fit {}", enum_name(one.to));
  }
  std::string operator()(const actions::Follow& /*one*/) const {
    return after.map.is_following ? "Follow estimate" : "Stop following";
  }
  std::string operator()(const actions::SetUp& one) const {
    return fmt::format("Up: {}", enum_name(one.up));
  }
  std::string operator()(const actions::GoToPlace& /*one*/) const { return "Go to place"; }
  std::string operator()(const actions::LayTopview& one) const {
    return fmt::format("Topview at {}", enum_name(one.at));
  }
  std::string operator()(const actions::SelectParticle& /*one*/) const { return "Select particle"; }
  std::string operator()(const actions::MeasurePoint& one) const {
    return one.east_m ? "Measure" : "Measure anew";
  }
  std::string operator()(const actions::UseTool& one) const {
    return fmt::format("Tool {}", enum_name(one.tool));
  }
  std::string operator()(const actions::ShowLayer& one) const {
    return shown_or_hidden(after.map.layer(one.layer).is_visible,
                           plain_words(enum_name(one.layer)));
  }
  std::string operator()(const actions::SetLayerOpacity& one) const {
    return "Opacity of " + plain_words(enum_name(one.layer));
  }
  std::string operator()(const actions::SetLayerColour& one) const {
    return "Colour of " + plain_words(enum_name(one.layer));
  }
  std::string operator()(const actions::MoveLayer& one) const {
    return fmt::format("{} {}", one.places > 0 ? "Raise" : "Lower",
                       plain_words(enum_name(one.layer)));
  }
  std::string operator()(const actions::ShowPanel& one) const {
    return shown_or_hidden(after.layout.shows(one.panel),
                           fmt::format("panel {}", enum_name(one.panel)));
  }
  std::string operator()(const actions::MoveSplitter& /*one*/) const { return "Move splitter"; }
  std::string operator()(const actions::MapOnly& /*one*/) const {
    return after.layout.is_map_only ? "Map only" : "Show panels";
  }
  std::string operator()(const actions::SplitView& /*one*/) const {
    return after.map.is_split ? "Split view" : "One view";
  }
  std::string operator()(const actions::SaveLayout& one) const { return "Keep layout " + one.name; }
  std::string operator()(const actions::UseLayout& one) const { return "Layout " + one.name; }
  std::string operator()(const actions::SetTheme& one) const {
    return one.theme == LightOrDark::kDark ? "Dark theme" : "Light theme";
  }
  std::string operator()(const actions::SetScale& /*one*/) const { return "Interface scale"; }
  std::string operator()(const actions::ReduceMotion& /*one*/) const { return "Reduced motion"; }
  std::string operator()(const actions::SetMemory& /*one*/) const { return "Memory"; }
  std::string operator()(const actions::ShowStrip& one) const {
    return fmt::format("Strip {}", plain_words(enum_name(one.strip)));
  }
  std::string operator()(const actions::MoveStrip& one) const {
    return fmt::format("Move strip {}", plain_words(enum_name(one.strip)));
  }
  std::string operator()(const actions::SetStripHeight& one) const {
    return fmt::format("Height of strip {}", plain_words(enum_name(one.strip)));
  }
  std::string operator()(const actions::ActivateRun& one) const {
    return fmt::format("Go to run {}", one.run);
  }
  std::string operator()(const actions::ShowRun& one) const {
    const auto index = static_cast<std::size_t>(one.run - 1);
    return shown_or_hidden(index < after.runs.size() && after.runs[index].is_shown,
                           fmt::format("run {}", one.run));
  }
  std::string operator()(const actions::SetOption& one) const { return "Set " + one.name; }
  std::string operator()(const actions::UsePreset& one) const {
    return "Preset " + file_name(one.name);
  }
  std::string operator()(const actions::Rerun& /*one*/) const { return "Rerun"; }
  std::string operator()(const actions::ExportFigure& /*one*/) const { return "Export"; }
  std::string operator()(const actions::PasteView& /*one*/) const { return "Paste view"; }
  std::string operator()(const actions::AddBookmark& /*one*/) const { return "Bookmark"; }
  std::string operator()(const actions::EditBookmark& /*one*/) const { return "Note of bookmark"; }
  std::string operator()(const actions::RemoveBookmark& /*one*/) const { return "Remove bookmark"; }
  /// What changes no view.
  template <typename Other>
  std::string operator()(const Other& /*one*/) const {
    return std::string(Other::kHelp);
  }
};

struct MergeKeys {
  std::string operator()(const actions::LookAt& /*one*/) const { return "look"; }
  std::string operator()(const actions::Zoom& /*one*/) const { return "zoom"; }
  std::string operator()(const actions::Rotate& /*one*/) const { return "rotate"; }
  std::string operator()(const actions::SetLayerOpacity& one) const {
    return fmt::format("opacity {}", enum_name(one.layer));
  }
  std::string operator()(const actions::SetLabelOpacity& one) const {
    return fmt::format("label opacity {}", enum_name(one.layer));
  }
  std::string operator()(const actions::SetLayerColour& one) const {
    return fmt::format("colour {}", enum_name(one.layer));
  }
  std::string operator()(const actions::MoveSplitter& one) const {
    return fmt::format("splitter {}", enum_name(one.splitter));
  }
  std::string operator()(const actions::SetStripHeight& one) const {
    return fmt::format("height {}", enum_name(one.strip));
  }
  std::string operator()(const actions::SetScale& /*one*/) const { return "scale"; }
  std::string operator()(const actions::SetMemory& /*one*/) const { return "memory"; }
  std::string operator()(const actions::SetOption& one) const { return "option " + one.name; }
  std::string operator()(const actions::EditBookmark& one) const {
    return fmt::format("note {}", one.bookmark);
  }
  std::string operator()(const actions::Seek& /*one*/) const { return "seek"; }
  std::string operator()(const actions::SetSpeed& /*one*/) const { return "speed"; }
  std::string operator()(const actions::SetLoop& /*one*/) const { return "loop"; }
  template <typename Other>
  std::string operator()(const Other& /*one*/) const {
    return {};
  }
};

}  // namespace

std::string change_title(const Action& action, const ViewState& after) {
  return std::visit(Titles{after}, action);
}

std::string merge_key(const Action& action) { return std::visit(MergeKeys{}, action); }

}  // namespace nadir
