// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/flight/flight_recording.h"

namespace nadir {

/// The frame nearest in time of those that have what is wanted, the earlier one of two equally near; none where none of
/// these is within a tenth of a second. O(log n), and the frames near by.
[[nodiscard]] const FlightFrame* nearest_frame(const FlightDescription& flight,
                                               double time_s,
                                               bool (*has_what_is_wanted)(const FlightFrame&));

}  // namespace nadir
