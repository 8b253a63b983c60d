// SPDX-License-Identifier: Apache-2.0
#include "core/flight/nearest_frame.h"

#include <algorithm>
#include <cmath>

namespace nadir {

const FlightFrame* nearest_frame(const FlightDescription& flight,
                                 double time_s,
                                 bool (*has_what_is_wanted)(const FlightFrame&)) {
  constexpr double kNearS = 0.1;
  constexpr double kLookedAtS = 1.1 * kNearS;  // rounding loses none
  const auto first = std::lower_bound(
      flight.frames.begin(), flight.frames.end(), time_s - kLookedAtS,
      [](const FlightFrame& frame, double limit_s) { return frame.time_s < limit_s; });
  const FlightFrame* nearest = nullptr;
  double nearest_s = kNearS;
  for (auto frame = first; frame != flight.frames.end(); ++frame) {
    if (frame->time_s > time_s + kLookedAtS) break;
    const double away_s = std::abs(frame->time_s - time_s);
    if (!has_what_is_wanted(*frame) || !(away_s <= nearest_s)) continue;
    if (nearest != nullptr && away_s == nearest_s) continue;  // the earlier one
    nearest = &*frame;
    nearest_s = away_s;
  }
  return nearest;
}

}  // namespace nadir
