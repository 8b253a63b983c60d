// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/empty_state.h"

#include <fmt/format.h>

#include "widgets/panels/panel_text.h"

namespace nadir {

EmptyState no_run_state(const std::string& what) {
  return {kit::Icon::kFolderOpen,
          "No run is open",
          fmt::format("Open a recorded run to see {}.", what),
          "Open the demo",
          {},
          actions::OpenDemo{}};
}

EmptyState reading_state(const std::string& name) {
  return {
      kit::Icon::kClock, "Reading", fmt::format("{} is being read.", shortened(name, 60)), {}, {}};
}

EmptyState coming_state(const std::string& name) {
  return {kit::Icon::kClock,
          "Localising",
          fmt::format("{} shows here with its first step.", shortened(name, 60)),
          {},
          {}};
}

EmptyState no_match_state(const std::string& typed) {
  return {kit::Icon::kSearch,
          "Nothing found",
          fmt::format("Nothing has “{}” in it.", shortened(typed, 40)),
          {},
          {}};
}

Actions draw_empty_state(kit::Ui& ui, const EmptyState& state) {
  const std::string words =
      state.title.empty() ? state.sentence : fmt::format("{}\n{}", state.title, state.sentence);
  if (ui.empty_state(state.icon, words, state.button, state.shortcut) && state.action) {
    return {*state.action};
  }
  return {};
}

}  // namespace nadir
