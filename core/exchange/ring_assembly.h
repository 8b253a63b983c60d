// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/label/label_object.h"

namespace nadir {

/// How ways become areas. Private to this module.

/// Nodes of a way by their numbers.
using NodeChain = std::vector<std::int64_t>;

/// Ways joined where they end in the same node, in either direction; each that comes back to its start is a ring, and the
/// others are open. Each way is in exactly one. Where several ways go on, the first of them does. O(nodes).
[[nodiscard]] std::vector<NodeChain> join_ways(std::vector<NodeChain> ways);

/// Rings as areas: a border and the holes directly in it; what lies in a hole is an area again. O(places log places), and the
/// number of rings around each ring.
/// @param rings  Not empty ones, in any order. @errors kCancelled.
[[nodiscard]] Result<std::vector<std::vector<Ring>>> areas_of(std::vector<Ring> rings,
                                                              const WorkContext& context = {});

}  // namespace nadir
