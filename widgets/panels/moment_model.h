// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/session/session.h"
#include "widgets/kit/ui_parts.h"

namespace nadir {

/// The moment at the cursor as panels speak of it: of the active run.
struct MomentModel {
  std::string run_name;
  std::size_t colour = 0;                       ///< Of run_colour().
  std::shared_ptr<const RunDocument> document;  ///< Null: no run, or being read.
  std::optional<std::size_t> index;             ///< Of the step in the document.
  std::shared_ptr<const RunStep> step;          ///< With topview and particles; null until decoded.
  std::shared_ptr<const MapIndex> map;          ///< Null: none, or being read.
  std::shared_ptr<const CameraMoment> camera;   ///< Null: no frame, or not decoded yet.
  bool is_reading = false;                      ///< The run is open but not read yet.
  bool has_flight = false;        ///< The recording is open, so that there may be frames.
  bool has_camera_frame = false;  ///< This step has one, decoded or not.
  [[nodiscard]] bool has_step() const {
    return document && index && *index < document->steps.size();
  }
  /// The step without topview and particles. Only where has_step().
  [[nodiscard]] const RunStep& recorded() const { return document->steps[*index]; }
};
[[nodiscard]] MomentModel moment_model(const Session& session);

/// One line of numbers.
struct MomentFact {
  std::string label, digits, unit;
  kit::TextLook look = kit::TextLook::kNumber;
  kit::Hint hint = {};
};

/// Errors (where the truth is known), spread, sample size, agreement and NEES of a step, each with what it means.
/// @param index  Of a step of the document.
[[nodiscard]] std::vector<MomentFact> moment_facts(const RunDocument& document, std::size_t index);

/// "above 9.35", "within 9.35", "below 0.22": how the NEES of one step lies to its 95 % bounds (step_nees_bounds()). No verdict:
/// one step is no test of consistency.
/// @param nees  Not negative.
[[nodiscard]] std::string nees_words(double nees);
[[nodiscard]] kit::TextLook nees_look(double nees);

}  // namespace nadir
