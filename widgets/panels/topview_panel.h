// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/action.h"
#include "widgets/kit/ui.h"
#include "widgets/panels/moment_model.h"
#include "widgets/panels/picture_area.h"
#include "widgets/panels/seen_moment.h"

namespace nadir {

struct TopviewPanelState {
  TextureOf texture_of;
  SeenMomentCache seen;
  enum class Shown { kSeen, kAgreement, kMapAtEstimate, kMapAtTruth };
  Shown shown = Shown::kSeen;
  PictureZoom zoom;
};

[[nodiscard]] inline MomentModel topview_panel_model(const Session& session) {
  return moment_model(session);
}

/// The topview of the moment, or what the map has in its place, as large as the panel; the vehicle is an arrow in it.
[[nodiscard]] Actions draw_topview_panel(kit::Ui& ui,
                                         const MomentModel& model,
                                         TopviewPanelState& state);

}  // namespace nadir
