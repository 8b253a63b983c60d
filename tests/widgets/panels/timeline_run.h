// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/session/view_state.h"
#include "tests/core/session/made_run.h"
#include "widgets/panels/timeline.h"

namespace nadir {

/// A run of a timeline's model.
[[nodiscard]] inline TimelineRun timeline_run(std::shared_ptr<const RunDocument> document,
                                              bool is_active = true,
                                              int number = 1) {
  TimelineRun run;
  run.number = number;
  run.name = number == 1 ? "made" : "other";
  run.colour = number - 1;
  run.is_active = is_active;
  run.document = std::move(document);
  return run;
}

/// One run, all strips as a new window has them but all of them shown, the cursor at the start.
[[nodiscard]] inline TimelineModel timeline_of(std::shared_ptr<const RunDocument> document) {
  TimelineModel model;
  model.strips = default_layout().strips;
  for (StripLook& look : model.strips) look.is_visible = true;
  model.moments = document->worst_moments;
  model.runs = {timeline_run(std::move(document))};
  return model;
}

/// All actions of one kind, in order.
template <typename Asked>
[[nodiscard]] std::vector<Asked> all_of(const Actions& asked) {
  std::vector<Asked> found;
  for (const Action& action : asked) {
    if (const auto* const one = std::get_if<Asked>(&action)) found.push_back(*one);
  }
  return found;
}

}  // namespace nadir
