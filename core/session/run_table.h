// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/session/run_document.h"

namespace nadir {

/// Every step of a run as CSV (RFC 4180 with line feeds): one line of names, then one line a step. A name ends with its unit
/// (`_m`, `_rad`, `_m2`, `_s`, `_ms`; counts, shares, NEES and 0/1 have none), before which stands its frame: `_enu` is the map's
/// project plane, x east, y north, yaw counter-clockwise from east. Errors are estimate minus truth; `time_s` is the
/// recording's clock, as in the run file, `elapsed_s` counts from the first step. What is not known is empty.
/// Numbers are the shortest that give the same double again. O(n).
[[nodiscard]] std::string run_table(const RunDocument& run);

}  // namespace nadir
