// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/label/label_document.h"

namespace nadir {

/// What is not the same in two versions of a document, for people to read and look at. The edit that makes one of the other is
/// difference() of core/label.

enum class DifferenceKind { kAdded, kRemoved, kChanged, kPaint, kValue };

struct LabelDifference {
  DifferenceKind kind = DifferenceKind::kChanged;
  ObjectId object = 0;               ///< Of paint and values none.
  ClassId class_id = kUnclassified;  ///< Of the object as it is, or was.
  bool is_moved = false;             ///< As a whole, without turning.
  bool is_reshaped = false;
  bool is_reclassed = false;  ///< Another class or kind.
  bool is_resized = false;    ///< Another width or thickness.
  bool is_reordered = false;  ///< Raised or lowered.
  bool is_renoted = false;
  PlaneBounds bounds;    ///< Of what was and what is; of a value empty.
  std::string sentence;  ///< "road area 12 moved by 3.2 m", without full stop.
};

/// Objects by their numbers, then paint by tiles, then values. Both documents are on the same plane and grid. O(all).
[[nodiscard]] std::vector<LabelDifference> differences(const LabelDocument& from,
                                                       const LabelDocument& to);

}  // namespace nadir
