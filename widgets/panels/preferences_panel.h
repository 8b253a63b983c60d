// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/session/session.h"
#include "widgets/kit/ui.h"

namespace nadir {

struct PreferencesModel {
  bool is_open = false;
  Appearance appearance;
  int memory_megabytes = 256;
  std::size_t memory_used_bytes = 0;
  std::vector<std::string> layout_names;
};

struct PreferencesState {
  std::string layout_name = {};  ///< Being typed.
  std::string refused_size = {},
              refused_memory = {};  ///< Typed and not taken, until it is corrected.
  bool is_open = false;
};

[[nodiscard]] PreferencesModel preferences_model(const Session& session);

/// Lies over the window where the model says so; call it in every frame. Everything takes effect at once.
[[nodiscard]] Actions draw_preferences(kit::Ui& ui,
                                       const PreferencesModel& model,
                                       PreferencesState& state);

}  // namespace nadir
