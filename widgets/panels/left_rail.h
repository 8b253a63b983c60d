// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/session/session.h"
#include "widgets/kit/ui.h"

namespace nadir {

/// One of the three ways to work with Nadir.
struct RailEntry {
  std::string name;
  kit::Icon icon = kit::Icon::kNone;
  std::string hint;     ///< What it is for.
  std::string why_not;  ///< Empty: it can be gone to.
  bool is_chosen = false;
  Action wish = {};  ///< That goes there.
};

struct LeftRailModel {
  std::vector<RailEntry> workspaces;
};

/// Width of the design.
inline constexpr double kLeftRailWidth = 64.0;

[[nodiscard]] LeftRailModel left_rail_model(const Session& session);

/// In a region as wide as kLeftRailWidth: the workspaces, and preferences and shortcuts at its foot.
[[nodiscard]] Actions draw_left_rail(kit::Ui& ui, const LeftRailModel& model);

}  // namespace nadir
