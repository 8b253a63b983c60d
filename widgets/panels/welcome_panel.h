// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/session/session.h"
#include "widgets/kit/ui.h"
#include "widgets/panels/command_palette.h"

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
  std::string busy;  ///< "making the demo": nothing can be begun until that is done; else empty.
};

[[nodiscard]] WelcomeModel welcome_model(const Session& session);

/// In the region that the map has otherwise. @param palette  Where opening a file by its path begins.
[[nodiscard]] Actions draw_welcome(kit::Ui& ui, const WelcomeModel& model, PaletteState& palette);

}  // namespace nadir
