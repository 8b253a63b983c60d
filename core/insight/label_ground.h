// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/label/label_document.h"
#include "core/map/map_index.h"

namespace nadir {

/// The grid of a map's cells.
[[nodiscard]] LabelGrid grid_of(const OverheadMap& map);

/// A map with the labels of a document in place of its own, on the same cells. O(cells).
/// @errors kInvalidOptions: the document lies on another plane.
[[nodiscard]] Result<std::shared_ptr<const MapIndex>> labelled_ground(
    const OverheadMap& map, const LabelDocument& document);

}  // namespace nadir
