// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/session/session.h"
#include "widgets/kit/ui.h"

namespace nadir {

/// What the window shows in place of a map while nothing is open.
struct WelcomeModel {
  std::vector<std::string> recents;  ///< Paths, newest first.
  std::string home;                  ///< The user's, to be written '~'; may be empty.
  /// A run that was cut short, to be gone on with: what it is, and what its button does.
  struct Offer {
    std::string text, button;
    Action action;
    int notice = 0;  ///< Number of the notice that made the offer; put away with it.
  };
  std::optional<Offer> offer;
  /// A flight that was opened by itself: what lacks is a map.
  struct LoneFlight {
    std::string name;
    std::string facts;              ///< "100 pictures in 25 s"; empty while it is read.
    std::string why_not;            ///< Why it can never be localised; empty: it can, on a map.
    std::vector<std::string> maps;  ///< Paths of those that may belong to it, the likeliest first.
  };
  std::optional<LoneFlight> flight;
  std::string busy;  ///< "making the demo": nothing can be begun until that is done; else empty.
  std::optional<JobStatus> work;  ///< The same, where it is what is waited for.
};

[[nodiscard]] WelcomeModel welcome_model(const Session& session);

/// In the region that the map has otherwise.
[[nodiscard]] Actions draw_welcome(kit::Ui& ui, const WelcomeModel& model);

}  // namespace nadir
