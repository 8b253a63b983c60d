// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/session/worst_moments.h"
#include "widgets/canvas/canvas.h"
#include "widgets/kit/ui_parts.h"
#include "widgets/views/theme.h"

namespace nadir {

/// How a kind of worst moment is told from the others, in lists and on the timeline.
struct MomentKindLook {
  std::string_view name;     ///< "high NEES".
  std::string_view meaning;  ///< A sentence without a full stop.
  kit::Icon icon = kit::Icon::kNone;
  kit::TextLook look =
      kit::TextLook::kMuted;  ///< What is wrong is bad, what is doubtful a warning.
};
[[nodiscard]] const MomentKindLook& moment_kind_look(MomentKind kind);
/// As its kind; but of an estimate that "why here?" calls near the truth nothing is wrong, only doubtful.
[[nodiscard]] kit::TextLook moment_look(const WorstMoment& moment);

/// A mark on the timeline: its shape tells what its colour does.
enum class MomentMark { kFilledDiamond, kHollowDiamond, kDisc };
[[nodiscard]] MomentMark moment_mark(const WorstMoment& moment);
[[nodiscard]] Rgba mark_colour(MomentMark mark, const Theme& theme);
/// @param at  Its centre on the page. @param half_px  From there to its corners.
void draw_moment_mark(
    Canvas& canvas, const Eigen::Vector2d& at, double half_px, MomentMark mark, const Theme& theme);

/// What is marked, in words for people: "largest error of this stretch: 3.2 m off, 95 % ellipse 4.1 m".
[[nodiscard]] std::string moment_words(const WorstMoment& moment);

/// What the marks of the timeline mean, a line each; the first is a heading.
[[nodiscard]] std::vector<std::string> mark_key_lines();

/// Indices of moments from the most severe on; of equals the earlier first.
[[nodiscard]] std::vector<std::size_t> by_severity(std::span<const WorstMoment> moments);

/// "3.2 times what is worth a look": what a severity says; empty of what is right again.
[[nodiscard]] std::string severity_words(const WorstMoment& moment);

}  // namespace nadir
