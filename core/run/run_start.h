// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "core/geo/rigid3.h"
#include "core/geo/trajectory.h"
#include "core/mcl/localiser.h"
#include "core/run/localise_flight.h"

namespace nadir::detail {

/// The filter before its first update, and the moment that this update's odometry counts from.
struct RunStart {
  Localiser localiser;
  int first_step = 0;
  double time_s = 0.0;
  Rigid2 odom_from_body;
  /// Where dead reckoning is laid; nothing where nobody knows.
  std::optional<Rigid2> enu_from_odom;
};

/// Whether flight, map and request are such that a run can go on from the moment of the request.
/// @param flight  Has odometry. @errors kInvalidOptions.
[[nodiscard]] Result<void> check_resume(const LocaliseRequest& request,
                                        const FlightDescription& flight,
                                        const ProjectPlane& plane);

/// A start with the particles of a recorded step. @param from  As check_resume() has found good.
/// @errors as Localiser::resume.
[[nodiscard]] Result<RunStart> start_after(const ResumePoint& from,
                                           const std::shared_ptr<const MapIndex>& map,
                                           const LocaliserOptions& options);

/// A start at the first frame that is used, at the prior of the request or at the truth. Dead reckoning is laid at the truth of
/// this frame, else at the mean of the prior.
/// @param time_s, first_odom_from_body  Of that frame.
/// @param truth  In the map's plane.
/// @errors kInvalidOptions: no prior and no truth; as Localiser::create.
[[nodiscard]] Result<RunStart> start_at(double time_s,
                                        const Rigid3& first_odom_from_body,
                                        const LocaliseRequest& request,
                                        const FlightDescription& flight,
                                        const std::optional<Trajectory>& truth,
                                        const std::shared_ptr<const MapIndex>& map);

}  // namespace nadir::detail
