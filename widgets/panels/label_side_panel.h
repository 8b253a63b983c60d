// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/label/label_store.h"
#include "core/session/label_view.h"
#include "core/session/session.h"
#include "widgets/kit/ui.h"

namespace nadir {

/// What stands at the right while labels are drawn: objects, history, image, one of them in front.
struct LabelSideModel {
  LabelView view;
  const LabelDesk* desk = nullptr;  ///< Null: no labels are open yet. Stays until the next action.
};
[[nodiscard]] LabelSideModel label_side_model(const Session& session);

/// Kept from frame to frame: lists that are dear to make.
struct LabelSideState {
  std::string path;               ///< Of the document that the lists are of.
  std::int64_t revision = -1;     ///< Likewise.
  std::vector<ObjectId> objects;  ///< The top-most first.
  std::vector<LabelStep> steps;   ///< The newest first.
  std::string fault;              ///< Why there are no steps.
  std::string search;             ///< Of objects.
};

[[nodiscard]] Actions draw_label_side(kit::Ui& ui,
                                      const LabelSideModel& model,
                                      LabelSideState& state);

/// What is selected, with what can be done to it (label_selection_rows.cpp).
[[nodiscard]] Actions draw_label_selection(kit::Ui& ui, const LabelDesk& desk);
/// Metres along a line, around an area.
[[nodiscard]] double border_length_m(const LabelObject& object);
/// Square metres between the rings of an area or outline; of a line its length times its width.
[[nodiscard]] double ground_area_m2(const LabelObject& object);

}  // namespace nadir
