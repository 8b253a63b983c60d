// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace nadir {

/// `step` of the random stream kWorldObjects: every kind of thing in a world draws numbers of its
/// own.
enum ObjectKind : std::uint32_t {
  kBuildingHeight = 1,
  kTrees,
  kPoles,
  kParkedCars,
  kMovingCars,
  kPedestrians,
};

}  // namespace nadir
