// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "widgets/kit/ui_parts.h"

// After kit's: the place of a window is nobody's business but these tests'.
#include <imgui.h>
#include <imgui_internal.h>

namespace nadir::kit {

/// Where the tooltip of the last frame lies; nothing where none shows.
[[nodiscard]] inline std::optional<Rect> tooltip_place() {
  for (const ImGuiWindow* const window : ImGui::GetCurrentContext()->Windows) {
    const bool is_tooltip = (window->Flags & ImGuiWindowFlags_Tooltip) != 0;
    if (is_tooltip && window->WasActive && !window->Hidden)
      return Rect{window->Pos.x, window->Pos.y, window->Size.x, window->Size.y};
  }
  return std::nullopt;
}

}  // namespace nadir::kit
