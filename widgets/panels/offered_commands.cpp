// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/offered_commands.h"

#include <algorithm>

namespace nadir {
namespace {

/// Asks one action whether it is on; the general case last, for all that do something once.
struct OnReader {
  const ViewState& view;
  const Playback& playback;
  using Answer = std::optional<bool>;

  Answer operator()(const actions::ShowLayer& asked) const {
    return view.map.layer(asked.layer).is_visible;
  }
  Answer operator()(const actions::ShowPanel& asked) const {
    return view.layout.shows(asked.panel);
  }
  Answer operator()(const actions::ShowStrip& asked) const {
    const auto& strips = view.layout.strips;
    return std::any_of(strips.begin(), strips.end(), [&](const StripLook& look) {
      return look.strip == asked.strip && look.is_visible;
    });
  }
  Answer operator()(const actions::Follow&) const { return view.map.is_following; }
  Answer operator()(const actions::SetUp& asked) const { return view.map.up == asked.up; }
  Answer operator()(const actions::UseTool& asked) const { return view.map.tool == asked.tool; }
  Answer operator()(const actions::LayTopview& asked) const {
    return view.map.topview_at == asked.at;
  }
  Answer operator()(const actions::MapOnly&) const { return view.layout.is_map_only; }
  Answer operator()(const actions::SplitView&) const { return view.map.is_split; }
  Answer operator()(const actions::SetTheme& asked) const {
    return view.appearance.theme == asked.theme;
  }
  Answer operator()(const actions::ReduceMotion&) const {
    return view.appearance.is_motion_reduced;
  }
  Answer operator()(const actions::SetSpeed& asked) const { return playback.speed == asked.speed; }
  template <class Other>
  Answer operator()(const Other&) const {
    return {};
  }
};

}  // namespace

std::optional<bool> is_on(const Action& action, const ViewState& view, const Playback& playback) {
  return std::visit(OnReader{view, playback}, action);
}

std::vector<OfferedCommand> offered_commands(const Session& session) {
  std::vector<OfferedCommand> offered;
  offered.reserve(session_commands().size());
  for (const Command& command : session_commands()) {
    OfferedCommand one{&command, why_not(command, session)};
    if (command.is_whole) {
      if (const auto action = parse_action(command.text)) {
        one.is_on = is_on(*action, session.view(), session.playback());
      }
    }
    offered.push_back(std::move(one));
  }
  return offered;
}

}  // namespace nadir
