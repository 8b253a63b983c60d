// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/session/action.h"
#include "core/session/session.h"
#include "widgets/kit/ui.h"
#include "widgets/panels/moment_inquiry.h"
#include "widgets/panels/picture_area.h"
#include "widgets/panels/seen_moment.h"

namespace nadir {

struct WhyModel {
  std::string run_name;     ///< Empty: no run.
  std::size_t colour = 0;   ///< Of run_colour().
  bool is_reading = false;  ///< Run or map are on their way.
  bool has_map = false;
  bool has_step = false;  ///< There is a step at the cursor, decoded or not.
  bool is_playing = false;
  bool is_computing = false;
  std::shared_ptr<const MomentAnswer>
      answer;  ///< Of this step, or of one before it while that is computed; may be null.
  bool is_answer_of_now = false;
  std::optional<WorstMoment> mark;  ///< That the timeline has at the answer's step.
};
/// Asks about the step at the cursor and takes what is known: call it only while the panel shows, for this is what makes
/// the computer work. While a run plays, no surfaces are made.
[[nodiscard]] WhyModel why_model(const Session& session, MomentInquiry& inquiry);

struct WhyState {
  TextureOf texture_of;
  bool shows_best_turn = false;  ///< Of all headings the best, instead of the estimate's.
  std::shared_ptr<const MomentAnswer> pictured;
  bool pictured_best_turn = false;
  Picture surface;
  SeenMomentCache seen;
  std::size_t shown_patch =
      0;  ///< 0 what fits the map, 1 seen, 2 map at the estimate, 3 map at the truth.
};

/// "Why here?": in words; error surface and what was seen, agreement by class, costs by class, mean costs, the surface's cuts,
/// modes. Sections fold, and stay as they were folded.
[[nodiscard]] Actions draw_why_panel(kit::Ui& ui, const WhyModel& model, WhyState& state);

/// A verdict in a few words for the panel's head, and how it is coloured: near the truth it is good, unless the timeline marks
/// the moment.
struct VerdictHead {
  std::string words;
  kit::TextLook look = kit::TextLook::kNormal;
};
[[nodiscard]] VerdictHead verdict_head(MomentVerdict verdict,
                                       const std::optional<WorstMoment>& mark = {});

}  // namespace nadir
