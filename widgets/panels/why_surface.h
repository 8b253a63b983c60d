// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "widgets/panels/why_panel.h"

namespace nadir {

/// The error surface around the estimate: its x-y cut with the particles on it, its cut along the heading, and the costs. A
/// click at a place asks to look there. @param model  With an answer.
void draw_surface(kit::Ui& ui, const WhyModel& model, WhyState& state, Actions& asked);

}  // namespace nadir
