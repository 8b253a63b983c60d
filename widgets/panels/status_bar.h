// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/session/session.h"
#include "widgets/kit/ui.h"

namespace nadir {

/// A point of the map in all the ways in which people write places.
struct PlaceReadOut {
  std::string class_name;  ///< "road"; "outside of the map".
  std::optional<Rgba> class_colour;
  double east_m = 0.0, north_m = 0.0;
  std::string geodetic, utm, mgrs;  ///< May be empty.
};

struct StatusBarModel {
  std::optional<PlaceReadOut> place;  ///< Under the pointer.
  std::string hint;                   ///< Said where there is none.
  bool is_recording = false;          ///< The active run is being written.
  std::string saving_fault = {};      ///< Why what is open could not be kept; empty: it is.
  bool keeps_session = true;          ///< False: only preferences are, whatever is open.
  std::string incomplete;  ///< How the active run was stopped before its end; empty: it was not.
  std::size_t memory_used_bytes = 0;  ///< For what is decoded of runs and flights.
  std::size_t drawn_bytes = 0;        ///< For what is drawn: the map's tiles, pictures of panels.
  int memory_megabytes = 0;           ///< Most that may be used for what is decoded.
  std::vector<JobStatus> jobs;        ///< The newest last.
};

/// Height of the design.
inline constexpr double kStatusBarHeight = 28.0;

/// @param cursor_in_enu_m  Under the pointer, where that is over the map.
[[nodiscard]] StatusBarModel status_bar_model(
    const Session& session, const std::optional<Eigen::Vector2d>& cursor_in_enu_m);

/// The read-outs of a point.
[[nodiscard]] PlaceReadOut place_read_out(const OverheadMap& map,
                                          const Eigen::Vector2d& point_in_enu_m);

/// In a region as high as kStatusBarHeight. Read-outs give way from the right where it is narrow.
[[nodiscard]] Actions draw_status_bar(kit::Ui& ui, const StatusBarModel& model);

}  // namespace nadir
