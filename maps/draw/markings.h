// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "maps/draw/town_layout.h"

namespace nadir::town {

/// Every painted shape of the town as a polygon, in the order in which it is drawn: centre and edge
/// lines of the streets, bays, stop lines, crossings, arrows, and what the layout gives as it is.
/// Lines are 0.2 m wide.
[[nodiscard]] std::vector<Painted> painted_shapes(const TownLayout& town);

}  // namespace nadir::town
