// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geo/project_plane.h"
#include "core/run/run_file.h"

namespace nadir {

/// What can be drawn over what: coordinates mean the same place only on the same plane.

/// Whether a run's poses are on this plane, to a centimetre.
[[nodiscard]] bool is_on_plane(const RunHeader& run, const ProjectPlane& plane);

/// Whether two runs can be drawn over one map. Their poses are on one plane; and their maps are the same, by hash or name, or
/// else two of one place, for their plane has an origin that somebody has chosen, which 0 N 0 E is not.
[[nodiscard]] bool share_ground(const RunHeader& a, const RunHeader& b);

}  // namespace nadir
