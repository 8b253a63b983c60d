// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/session/run_document.h"

namespace nadir {

/// Every step of a run as CSV (RFC 4180 with line feeds): one line of names with units, then one line a step. Poses are enu
/// in metres and radians, yaw counter-clockwise from east; errors are estimate minus truth. What is not known is empty.
/// Numbers are the shortest that give the same double again. O(n).
[[nodiscard]] std::string run_table(const RunDocument& run);

}  // namespace nadir
