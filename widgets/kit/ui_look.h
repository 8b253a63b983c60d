// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "widgets/views/theme.h"

struct ImGuiStyle;

namespace nadir::kit {

/// Colours of the interface, from the theme's few: as Dear ImGui packs them (IM_COL32).
struct Look {
  std::uint32_t window = 0, panel = 0, raised = 0, hovered = 0, held = 0, plate = 0, line = 0,
                text = 0, muted = 0, faint = 0;
  std::uint32_t accent = 0, accent_hovered = 0, accent_soft = 0, on_accent = 0, good = 0,
                warning = 0, bad = 0, dimming = 0;
};

[[nodiscard]] std::uint32_t packed(Rgba colour);
/// `share` of `b` in `a`; the alpha of `a`.
[[nodiscard]] Rgba mixed(Rgba a, Rgba b, double share);
/// WCAG 2's contrast of two opaque colours, 1 to 21.
[[nodiscard]] double contrast(Rgba a, Rgba b);

[[nodiscard]] Look look_of(const Theme& theme);

/// Sizes and colours for what Dear ImGui draws itself: popups, scroll bars, inputs.
void set_style(ImGuiStyle& style, const Look& look, double scale);

}  // namespace nadir::kit
