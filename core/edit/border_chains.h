// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/label/label_document.h"

namespace nadir {

/// Borders of objects cut where they part: what is done to a chain is done to all that share it. Private to this module.

/// From one place where borders part, or a line ends, to the next; both are in it. Or a whole ring that shares all or nothing:
/// then its first place is not repeated.
struct BorderChain {
  Ring places;
  bool is_loop = false;
  bool is_selected = false;  ///< At least one of the selected objects has it.
};
struct ChainUse {
  std::size_t chain = 0;
  bool is_reversed = false;
};
struct ChainedObject {
  const LabelObject* object = nullptr;
  std::vector<std::vector<ChainUse>> rings;
};
struct ChainedBorders {
  std::vector<BorderChain> chains;
  std::vector<ChainedObject> objects;  ///< The selected ones, and all that share a place with one.
};
[[nodiscard]] ChainedBorders chained_borders(const LabelDocument& document,
                                             std::span<const LabelObject* const> selected);

/// A chain changed: its ends stay unless it is a loop. Strength is from 0, nothing, to 1.
using ReshapeChain = std::function<Ring(const BorderChain& chain, double strength)>;
/// Changes all chains of the selected objects, with less strength where an object would otherwise become unsound.
[[nodiscard]] Result<LabelEdit> reshape_borders(const LabelDocument& document,
                                                std::span<const ObjectId> objects,
                                                const char* title,
                                                const ReshapeChain& reshape);

}  // namespace nadir
