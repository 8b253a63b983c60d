// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "widgets/panels/why_panel.h"

namespace nadir {

/// Beside each other, the x-y cut of the error surface around the estimate with the particles on it, where a click asks to look
/// at a place, and what was seen. @param model  With an answer.
void draw_surface_and_patch(kit::Ui& ui, const WhyModel& model, WhyState& state, Actions& asked);

/// The surface's cut along the heading, and its costs. @param model  With an answer.
void draw_surface_cuts(kit::Ui& ui, const WhyModel& model);

}  // namespace nadir
