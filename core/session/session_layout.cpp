// SPDX-License-Identifier: Apache-2.0
// How the window is divided and looks.
#include <algorithm>
#include <cmath>

#include "core/base/settings.h"
#include "core/session/session_core.h"

namespace nadir {
namespace {

constexpr const char* kDefaultLayout = "default";

Result<void> check_size(double size_pt, double least_pt, double most_pt) {
  if (size_pt >= least_pt && size_pt <= most_pt) return {};
  return fail(ErrorCode::kInvalidOptions, "a size of {:g} points is not in [{:g}, {:g}]", size_pt,
              least_pt, most_pt);
}

StripLook& strip_look(WindowLayout& layout, Strip strip) {
  return *std::find_if(layout.strips.begin(), layout.strips.end(),
                       [strip](const StripLook& look) { return look.strip == strip; });
}

}  // namespace

Result<void> Session::Implementation::perform(const actions::ShowPanel& action) {
  WindowLayout& layout = kept.view.layout;
  const auto column = column_of(action.panel);
  Panel* const tab = !column                    ? nullptr
                     : *column == Column::kLeft ? &layout.left_tab
                                                : &layout.right_tab;
  const bool is_in_front =
      layout.shows(action.panel) && !layout.is_map_only && (tab == nullptr || *tab == action.panel);
  // What is behind another tab, or behind the map, is brought forward by the key that hides it in front.
  const bool is_shown = switched(is_in_front, action.to);
  layout.is_shown.at(static_cast<std::size_t>(action.panel)) = is_shown;
  if (is_shown) {
    layout.is_map_only = false;
    if (tab != nullptr) *tab = action.panel;
  }
  layout = repaired(std::move(layout));
  return {};
}

Result<void> Session::Implementation::perform(const actions::MoveSplitter& action) {
  WindowLayout& layout = kept.view.layout;
  const bool is_timeline = action.splitter == Splitter::kTimeline;
  auto checked = is_timeline ? check_size(action.size_pt, kLeastTimelinePt, kMostTimelinePt)
                             : check_size(action.size_pt, kLeastColumnPt, kMostColumnPt);
  if (!checked) return checked;
  switch (action.splitter) {
    case Splitter::kLeft:
      layout.left_pt = action.size_pt;
      break;
    case Splitter::kRight:
      layout.right_pt = action.size_pt;
      break;
    case Splitter::kTimeline:
      layout.timeline_pt = action.size_pt;
      break;
  }
  return {};
}

Result<void> Session::Implementation::perform(const actions::MapOnly& action) {
  kept.view.layout.is_map_only = switched(kept.view.layout.is_map_only, action.to);
  return {};
}

Result<void> Session::Implementation::perform(const actions::SplitView& action) {
  const bool is_split = switched(kept.view.map.is_split, action.to);
  if (is_split && runs.size() < 2) {
    return fail(ErrorCode::kInvalidOptions, "a split view shows two runs: open a second one first");
  }
  kept.view.map.is_split = is_split;
  return {};
}

Result<void> Session::Implementation::perform(const actions::SaveLayout& action) {
  if (action.name.empty()) return fail(ErrorCode::kInvalidOptions, "a layout needs a name");
  if (action.name == kDefaultLayout) {
    return fail(ErrorCode::kInvalidOptions, "'default' is always as it is: take another name");
  }
  kept.layouts[action.name] = kept.view.layout;
  return {};
}

Result<void> Session::Implementation::perform(const actions::UseLayout& action) {
  if (action.name == kDefaultLayout) {
    kept.view.layout = default_layout();
    return {};
  }
  const auto found = kept.layouts.find(action.name);
  if (found == kept.layouts.end()) {
    std::vector<std::string> names = {kDefaultLayout};
    for (const auto& [name, layout] : kept.layouts) names.push_back(name);
    const std::string nearest = nearest_word(action.name, names);
    return fail(ErrorCode::kInvalidOptions, "there is no layout '{}'{}", action.name,
                nearest.empty() ? std::string() : fmt::format("; did you mean {}?", nearest));
  }
  kept.view.layout = found->second;
  return {};
}

Result<void> Session::Implementation::perform(const actions::SetTheme& action) {
  kept.view.appearance.theme = action.theme;
  return {};
}

Result<void> Session::Implementation::perform(const actions::SetScale& action) {
  const bool is_in_range = action.scale >= kLeastScale && action.scale <= kMostScale;
  if (action.scale != 0.0 && !is_in_range) {
    return fail(ErrorCode::kInvalidOptions,
                "a scale of {:g} is not in [{:g}, {:g}], nor 0 for the screen's own", action.scale,
                double{kLeastScale}, double{kMostScale});
  }
  kept.view.appearance.scale = action.scale;
  return {};
}

Result<void> Session::Implementation::perform(const actions::ReduceMotion& action) {
  bool& is_reduced = kept.view.appearance.is_motion_reduced;
  is_reduced = switched(is_reduced, action.to);
  return {};
}

Result<void> Session::Implementation::perform(const actions::SetMemory& action) {
  if (action.megabytes < kLeastMemoryMegabytes || action.megabytes > kMostMemoryMegabytes) {
    return fail(ErrorCode::kInvalidOptions, "a memory of {} MB is not in [{}, {}]",
                action.megabytes, int{kLeastMemoryMegabytes}, int{kMostMemoryMegabytes});
  }
  kept.memory_megabytes = action.megabytes;
  return {};
}

Result<void> Session::Implementation::perform(const actions::ShowStrip& action) {
  StripLook& look = strip_look(kept.view.layout, action.strip);
  look.is_visible = switched(look.is_visible, action.to);
  return {};
}

Result<void> Session::Implementation::perform(const actions::MoveStrip& action) {
  std::vector<StripLook>& strips = kept.view.layout.strips;
  const StripLook moved = strip_look(kept.view.layout, action.strip);
  const auto from = std::find(strips.begin(), strips.end(), moved) - strips.begin();
  // Up is towards the first.
  const std::int64_t to = std::clamp<std::int64_t>(std::int64_t{from} - action.places, 0,
                                                   static_cast<std::int64_t>(strips.size()) - 1);
  strips.erase(strips.begin() + from);
  strips.insert(strips.begin() + to, moved);
  return {};
}

Result<void> Session::Implementation::perform(const actions::SetStripHeight& action) {
  if (auto checked = check_size(action.height_pt, kLeastStripPt, kMostStripPt); !checked) {
    return checked;
  }
  strip_look(kept.view.layout, action.strip).height_pt = action.height_pt;
  return {};
}

Result<void> Session::Implementation::perform(const actions::ShowOverlay& action) {
  overlay = action.overlay;
  return {};
}

}  // namespace nadir
