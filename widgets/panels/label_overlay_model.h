// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/desk/label_desk.h"
#include "widgets/views/label_overlay.h"

namespace nadir {

/// Where the hand is over the map, and how far it reaches: a few pixels, by the zoom.
struct LabelHand {
  Eigen::Vector2d in_enu_m = Eigen::Vector2d::Zero();
  double reach_m = 0.0;
};

/// What lies over the map of a desk: selection, corners, what the hand is over, the tool at work. What a brush has painted
/// so far is no part of it, for paint is seen in the labels themselves. @param hand  Nothing: it is elsewhere.
[[nodiscard]] LabelOverlay label_overlay_of(const LabelDesk& desk,
                                            const std::optional<LabelHand>& hand);

/// How objects that are coming cover the ground, such as those of LabelDesk::coming_move(): of a line its whole width, of an
/// outline its rim. What has width 0 is a guide, which is not filled.
[[nodiscard]] std::vector<LabelOverlay::Coming> coming_shapes(std::span<const LabelObject> objects);

}  // namespace nadir
